// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"
#include "robot/wire/llrp/decode_error.hpp"
#include "robot/wire/llrp/frame.hpp"
#include "robot/wire/llrp/messages.hpp"

/// LLRP 1.0.1 with Impinj's extension, both directions: the client's and the reader's messages alike. No I/O,
/// no time; memory in proportion to the message.
namespace sensotwin::robot::llrp {

/// Reads one message. Parameters may come in any order inside their parent; reserved bits of fields are
/// ignored. \returns the message (it owns what it holds), or where and how it is wrong: any Fault
[[nodiscard]] Result<Message, DecodeError> decode(const Frame& frame);

/// Writes one message, header included, parameters in the order of the specification. \pre no parameter is
/// longer than 65535 bytes \param version  other than 1 only to tell somebody that his is not spoken
[[nodiscard]] Bytes encode(const Message& message, std::uint32_t id, std::uint8_t version = kVersion);
/// The same, behind what `out` holds already.
void encode(const Message& message, std::uint32_t id, Bytes& out, std::uint8_t version = kVersion);

}  // namespace sensotwin::robot::llrp
