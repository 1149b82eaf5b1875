// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sensotwin::robot::llrp {

/// LLRP 1.0.1, 14.2.1.
enum class StatusCode : std::uint16_t {
  kSuccess = 0,
  kParameterError = 100,
  kFieldError = 101,
  kUnexpectedParameter = 102,
  kMissingParameter = 103,
  kDuplicateParameter = 104,
  kOverflowParameter = 105,
  kOverflowField = 106,
  kUnknownParameter = 107,
  kUnknownField = 108,
  kUnsupportedMessage = 109,
  kUnsupportedVersion = 110,
  kUnsupportedParameter = 111,
  kInParameterError = 200,  ///< 200 to 209: the same as 100 to 111, of a parameter inside a parameter
  kInFieldError = 201,
  kInUnexpectedParameter = 202,
  kInMissingParameter = 203,
  kInDuplicateParameter = 204,
  kInOverflowParameter = 205,
  kInOverflowField = 206,
  kInUnknownParameter = 207,
  kInUnknownField = 208,
  kInUnsupportedParameter = 209,
  kInvalidField = 300,
  kFieldOutOfRange = 301,
  kDeviceError = 401,
};

struct FieldError {
  static constexpr std::uint16_t kType = 288;
  std::uint16_t field{0};
  StatusCode code{};
  bool operator==(const FieldError&) const = default;
};

struct ParameterError {
  static constexpr std::uint16_t kType = 289;
  std::uint16_t parameter{0};
  StatusCode code{};
  std::optional<FieldError> field_error{};
  std::vector<ParameterError> inner{};  ///< one at most
  bool operator==(const ParameterError&) const = default;
};

/// How a request fared. Every response carries one; an ERROR_MESSAGE is nothing else.
struct LlrpStatus {
  static constexpr std::uint16_t kType = 287;
  StatusCode code{StatusCode::kSuccess};
  std::string description{};  ///< UTF-8
  std::optional<FieldError> field_error{};
  std::optional<ParameterError> parameter_error{};
  [[nodiscard]] bool ok() const { return code == StatusCode::kSuccess; }
  bool operator==(const LlrpStatus&) const = default;
};

}  // namespace sensotwin::robot::llrp
