// SPDX-License-Identifier: MIT
#include "robot/wire/llrp/decode_error.hpp"

#include <array>
#include <string>
#include <utility>

namespace sensotwin::robot::llrp {
namespace {

struct FaultEntry {
  std::string_view name;
  StatusCode in_message;
  StatusCode in_parameter;
};

[[nodiscard]] const FaultEntry& entry_of(Fault fault) {
  using S = StatusCode;
  // LLRP has no code for a length that lies: its own parameter is in error then.
  static constexpr std::array<FaultEntry, 13> kEntries{{
      {"unsupported version", S::kUnsupportedVersion, S::kUnsupportedVersion},
      {"unknown message", S::kUnsupportedMessage, S::kUnsupportedMessage},
      {"truncated field", S::kFieldError, S::kInvalidField},
      {"trailing bytes", S::kOverflowField, S::kInOverflowField},
      {"bad parameter length", S::kOverflowParameter, S::kInOverflowParameter},
      {"bad parameter header", S::kUnknownParameter, S::kInUnknownParameter},
      {"unknown parameter", S::kUnknownParameter, S::kInUnknownParameter},
      {"unsupported parameter", S::kUnsupportedParameter, S::kInUnsupportedParameter},
      {"unexpected parameter", S::kUnexpectedParameter, S::kInUnexpectedParameter},
      {"missing parameter", S::kMissingParameter, S::kInMissingParameter},
      {"duplicate parameter", S::kDuplicateParameter, S::kInDuplicateParameter},
      {"bad field", S::kFieldError, S::kInvalidField},
      {"nested too deep", S::kOverflowParameter, S::kInOverflowParameter},
  }};
  return kEntries[static_cast<std::size_t>(fault)];
}

}  // namespace

std::string_view name_of(Fault fault) {
  return entry_of(fault).name;
}

LlrpStatus status_of(const DecodeError& error) {
  const FaultEntry& entry = entry_of(error.fault);
  LlrpStatus status;
  status.code = entry.in_message;
  status.description = std::string{entry.name};
  const bool about_a_field = error.fault == Fault::kBadField || error.fault == Fault::kTruncated;
  if (error.path_size == 0) {
    if (about_a_field) {
      status.field_error = FieldError{error.field, StatusCode::kInvalidField};
    }
    return status;
  }
  // From the innermost out: only it names the fault, those around it say that something in them is wrong.
  ParameterError chain;
  for (std::size_t i = error.path_size; i-- > 0;) {
    ParameterError outer;
    outer.parameter = error.path[i];
    if (i + 1 == error.path_size) {
      outer.code = about_a_field ? StatusCode::kInFieldError : entry.in_parameter;
      if (about_a_field) {
        outer.field_error = FieldError{error.field, StatusCode::kInvalidField};
      }
    } else {
      outer.code = StatusCode::kInParameterError;
      outer.inner.push_back(std::move(chain));
    }
    chain = std::move(outer);
  }
  status.code = StatusCode::kParameterError;
  status.parameter_error = std::move(chain);
  return status;
}

}  // namespace sensotwin::robot::llrp
