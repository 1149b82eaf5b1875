// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "robot/wire/llrp/status.hpp"

namespace sensotwin::robot::llrp {

/// What can be wrong with a message whose frame is sound.
enum class Fault : std::uint8_t {
  kUnsupportedVersion,    ///< the header says another version than 1
  kUnknownMessage,        ///< no LLRP 1.0.1 message has this type
  kTruncated,             ///< a field goes on beyond the end of its parameter or message
  kTrailingBytes,         ///< bytes are left over after the last field
  kBadParameterLength,    ///< a TLV length below 4, or beyond what contains it
  kBadParameterHeader,    ///< reserved bits set, or a TLV header with the number of a TV parameter
  kUnknownParameter,      ///< no LLRP 1.0.1 parameter has this type (a TV of unknown type has no known end)
  kUnsupportedParameter,  ///< LLRP has it, this codec leaves it out: RF surveys, client request operations
  kUnexpectedParameter,   ///< known, but not allowed here
  kMissingParameter,      ///< a mandatory one is not there
  kDuplicateParameter,    ///< allowed once, came twice
  kBadField,              ///< a value outside its enumeration, or a reserved id
  kTooDeep,               ///< parameters nested deeper than any LLRP message does
};
[[nodiscard]] std::string_view name_of(Fault fault);

/// Where a message went wrong, and how.
struct DecodeError {
  static constexpr std::size_t kMaxPath = 12;

  Fault fault{};
  /// Types of the parameters around the fault, outermost first, the faulty one last; empty when it is the
  /// message.
  std::array<std::uint16_t, kMaxPath> path{};
  std::size_t path_size{0};
  std::uint16_t field{0};   ///< of the innermost parameter, counted from 1; 0 when no field is meant
  std::size_t position{0};  ///< byte of the message body

  bool operator==(const DecodeError&) const = default;
};

/// How a reader tells a client of it: 100 M_ParameterError or 101 M_FieldError with the chain of parameters
/// (LLRP 1.0.1, 14.2), 109 and 110 for the message as a whole.
[[nodiscard]] LlrpStatus status_of(const DecodeError& error);

}  // namespace sensotwin::robot::llrp
