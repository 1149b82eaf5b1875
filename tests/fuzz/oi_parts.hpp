// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "robot/base/bytes.hpp"
#include "robot/wire/oi_opcodes.hpp"

/// Parts of the fuzzer `oi`. All throw PropertyBroken.
namespace sensotwin::fuzz {

void oi_commands(robot::ByteView input, const robot::oi::OpcodeTable& table);
void oi_frames(robot::ByteView input, std::size_t piece);
void oi_payload(robot::ByteView input);
void oi_answers(robot::ByteView input);
void oi_driver(robot::ByteView input, std::size_t piece, bool sci);

}  // namespace sensotwin::fuzz
