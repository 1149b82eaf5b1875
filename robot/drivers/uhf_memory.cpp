// SPDX-License-Identifier: MIT
#include "robot/drivers/uhf_memory.hpp"

namespace sensotwin::robot {
namespace {

[[nodiscard]] UhfMemoryError error_of(llrp::ReadResult result) {
  switch (result) {
    case llrp::ReadResult::kNoResponse:
      return UhfMemoryError::kNoResponse;
    case llrp::ReadResult::kReaderError:
      return UhfMemoryError::kReaderError;
    default:
      return UhfMemoryError::kTagError;
  }
}

[[nodiscard]] UhfMemoryError error_of(llrp::WriteResult result) {
  switch (result) {
    case llrp::WriteResult::kMemoryOverrun:
      return UhfMemoryError::kMemoryOverrun;
    case llrp::WriteResult::kMemoryLocked:
      return UhfMemoryError::kMemoryLocked;
    case llrp::WriteResult::kInsufficientPower:
      return UhfMemoryError::kInsufficientPower;
    case llrp::WriteResult::kNoResponse:
      return UhfMemoryError::kNoResponse;
    case llrp::WriteResult::kReaderError:
      return UhfMemoryError::kReaderError;
    default:
      return UhfMemoryError::kTagError;
  }
}

}  // namespace

std::optional<UhfMemoryResult> memory_result(const llrp::TagReport& report, std::uint16_t op) {
  for (const llrp::C1G2OpResult& result : report.results) {
    if (const auto* read = std::get_if<llrp::C1G2ReadResult>(&result); read && read->op == op) {
      if (read->result == llrp::ReadResult::kSuccess) {
        return UhfMemoryAnswer{read->words, 0};
      }
      return Unexpected{error_of(read->result)};
    }
    if (const auto* write = std::get_if<llrp::C1G2WriteResult>(&result); write && write->op == op) {
      if (write->result == llrp::WriteResult::kSuccess) {
        return UhfMemoryAnswer{{}, write->words_written};
      }
      return Unexpected{error_of(write->result)};
    }
  }
  return std::nullopt;
}

}  // namespace sensotwin::robot
