// SPDX-License-Identifier: MIT
#include "robot/drivers/tag_write.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace sensotwin::robot {

TagWrite::TagWrite(Job job) : job_(std::move(job)) {
  assert(!job_.data.empty() && job_.data.size() % kBlockBytes == 0);
  assert(job_.attempts >= 1 && job_.blocks_per_command >= 1);
}

ByteView TagWrite::piece() const {
  const std::size_t size = std::min(job_.blocks_per_command * kBlockBytes, job_.data.size() - offset_);
  return ByteView{job_.data}.subspan(offset_, size);
}

bool TagWrite::last_piece() const {
  return offset_ + piece().size() == job_.data.size();
}

CardCommand TagWrite::command() const {
  assert(!outcome_);
  const auto block = static_cast<std::uint16_t>(job_.first_block + offset_ / kBlockBytes);
  switch (stage_) {
    case Stage::kUpdate:
      return UpdateBinary{block, piece()};
    case Stage::kReadBack:
      return ReadBinary{block, static_cast<std::uint8_t>(piece().size())};
    case Stage::kIdentify:
    case Stage::kIdentifyAgain:
      break;
  }
  return GetUid{};
}

void TagWrite::answered(const CardResponse& response) {
  assert(!outcome_);
  if (response.status.ok()) {
    advance(response);
    return;
  }
  const CardStatus meaning = response.status.meaning();
  const bool may_pass = meaning == CardStatus::kMemoryFailure || meaning == CardStatus::kOperationFailed ||
                        meaning == CardStatus::kDataMayBeCorrupt;
  if (may_pass) {
    try_again({WriteFailure::kRefused, response.status});
  } else {
    end(WriteFailure::kRefused, response.status);
  }
}

void TagWrite::advance(const CardResponse& response) {
  switch (stage_) {
    case Stage::kIdentify:
    case Stage::kIdentifyAgain: {
      const auto uid = decode_uid(response.data, job_.uid_order);
      if (!uid || *uid != job_.uid) {
        end(WriteFailure::kTagLeft);
      } else if (stage_ == Stage::kIdentifyAgain) {
        outcome_ = WriteDone{attempt_};
      } else {
        stage_ = Stage::kUpdate;
      }
      return;
    }
    case Stage::kUpdate:
      if (last_piece()) {
        stage_ = Stage::kReadBack;
        offset_ = 0;
      } else {
        stage_ = Stage::kIdentify;
        offset_ += piece().size();
      }
      return;
    case Stage::kReadBack:
      break;
  }
  if (!std::equal(response.data.begin(), response.data.end(), piece().begin(), piece().end())) {
    try_again({WriteFailure::kVerifyFailed, {}});
  } else if (last_piece()) {
    stage_ = Stage::kIdentifyAgain;
  } else {
    offset_ += piece().size();
  }
}

void TagWrite::failed(CardError error) {
  assert(!outcome_);
  switch (error) {
    case CardError::kRemoved:
      end(WriteFailure::kTagLeft);
      return;
    case CardError::kReaderGone:
      end(WriteFailure::kReaderGone);
      return;
    case CardError::kTimeout:
      break;
  }
  try_again({WriteFailure::kTimeout, {}});
}

void TagWrite::try_again(WriteError error) {
  if (attempt_ == job_.attempts) {
    end(error.failure, error.status);
    return;
  }
  ++attempt_;
  stage_ = Stage::kIdentify;
  offset_ = 0;
}

void TagWrite::end(WriteFailure failure, StatusWord status) {
  outcome_ = Unexpected{WriteError{failure, status}};
}

}  // namespace sensotwin::robot
