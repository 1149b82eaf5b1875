// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/base/result.hpp"
#include "robot/wire/llrp/report.hpp"

namespace sensotwin::robot {

/// What came of reading or writing the user memory of a tag.
struct UhfMemoryAnswer {
  std::vector<std::uint16_t> words;  ///< read; empty after a write
  std::uint16_t words_written{0};
};

enum class UhfMemoryError : std::uint8_t {
  kTagNotSeen,      ///< the tag was not read within the time
  kRefused,         ///< the reader would not take the AccessSpec
  kNoAnswer,        ///< the reader did not answer a request
  kConnectionLost,  ///< in the middle of it; a write may have happened
  kTagError,        ///< the tag said no, for no reason it gives
  kNoResponse,      ///< the tag fell silent in the exchange; a write may have happened
  kMemoryOverrun,   ///< beyond the end of the bank
  kMemoryLocked,
  kInsufficientPower,  ///< too far away to write
  kReaderError,
};

using UhfMemoryResult = Result<UhfMemoryAnswer, UhfMemoryError>;

/// The outcome of operation `op` that a report tells; nothing when it tells of none.
[[nodiscard]] std::optional<UhfMemoryResult> memory_result(const llrp::TagReport& report, std::uint16_t op);

}  // namespace sensotwin::robot
