// SPDX-License-Identifier: MIT
#include "robot/drivers/tag_reader.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace sensotwin::robot {
namespace {

/// Chosen: some seconds of the busiest field; who does not look for that long has no use for more.
constexpr std::size_t kEventsKept = 64;

/// The data that a tag's copy in `held` (blocks from `held_first` on) shares with what was written is
/// renewed.
void renew(Bytes& held, std::size_t held_first, const TagWrite::Job& job) {
  for (std::size_t i = 0; i < job.data.size(); ++i) {
    const std::size_t address = job.first_block * kBlockBytes + i;
    const std::size_t held_begin = held_first * kBlockBytes;
    if (address >= held_begin && address - held_begin < held.size()) {
      held[address - held_begin] = job.data[i];
    }
  }
}

}  // namespace

TagReader::TagReader(CardLink& link, TagReaderConfig config) : link_(link), config_(config) {
  assert(config_.blocks_per_command >= 1 && config_.blocks_per_command * kBlockBytes <= 255);
  assert(config_.write_attempts >= 1);
}

void TagReader::step(Instant now) {
  assert(now >= now_);
  now_ = now;
  // First the answer: it belongs to the tag that was in the field until now.
  fetch_answer();
  const CardPresence presence = link_.presence();
  watch_link(presence);
  watch_field(presence);
  begin_next();
}

void TagReader::watch_link(CardPresence presence) {
  const bool connected = presence != CardPresence::kNoReader;
  if (connected == health_.connected) {
    return;
  }
  health_.connected = connected;
  if (!connected) {
    ++health_.vanished;
    if (write_ && !write_->outcome()) {
      write_->failed(CardError::kReaderGone);
      finish_write();
    }
  } else if (ever_connected_) {
    ++health_.returned;
  }
  ever_connected_ = ever_connected_ || connected;
}

void TagReader::watch_field(CardPresence presence) {
  if (presence != CardPresence::kPresent) {
    forget_tag();
  } else if (!entered_) {
    entered_ = now_;
    emit(TagEntered{now_});
  }
}

void TagReader::forget_tag() {
  if (!entered_) {
    return;
  }
  entered_.reset();
  if (write_) {
    write_->failed(CardError::kRemoved);
    finish_write();
  }
  if (purpose_ != Purpose::kNothing) {
    purpose_ = Purpose::kDiscarded;
  }
  emit(TagLeft{tag_ ? std::optional{tag_->uid} : std::nullopt, now_});
  tag_.reset();
  reading_.clear();
  read_over_ = false;
}

void TagReader::fetch_answer() {
  if (purpose_ == Purpose::kNothing) {
    return;
  }
  const std::optional<Answer> answer = link_.poll();
  if (answer) {
    on_answer(std::exchange(purpose_, Purpose::kNothing), *answer);
  } else if (purpose_ != Purpose::kDiscarded && now_ - begun_ > config_.exchange_limit) {
    // The link is still busy with it; a late answer must not be taken for that of a later command.
    on_answer(std::exchange(purpose_, Purpose::kDiscarded), Answer{Unexpected{CardError::kTimeout}});
  }
}

void TagReader::on_answer(Purpose purpose, const Answer& answer) {
  if (purpose == Purpose::kDiscarded) {
    return;
  }
  if (!answer) {
    health_.removed += answer.error() == CardError::kRemoved ? 1u : 0u;
    health_.timeouts += answer.error() == CardError::kTimeout ? 1u : 0u;
    if (purpose == Purpose::kWrite) {
      write_->failed(answer.error());
      finish_write();
    }
    if (answer.error() != CardError::kTimeout) {
      forget_tag();
    }
    return;
  }
  const auto response = decode_response(*answer);
  if (!response) {
    ++health_.malformed;
    if (purpose == Purpose::kWrite) {
      write_->failed(CardError::kTimeout);  // no usable answer: as good as none
      finish_write();
    }
    return;
  }
  switch (purpose) {
    case Purpose::kIdentify:
      on_identified(*response);
      return;
    case Purpose::kRead:
      on_read(*response);
      return;
    case Purpose::kWrite:
      write_->answered(*response);
      finish_write();
      return;
    case Purpose::kNothing:
    case Purpose::kDiscarded:
      return;
  }
}

void TagReader::on_identified(const CardResponse& response) {
  if (!response.status.ok()) {
    ++health_.refused;
    return;
  }
  const auto uid = decode_uid(response.data, config_.uid_order);
  if (!uid) {
    ++health_.malformed;
    health_.reversed_uid += uid.error() == UidError::kReversed ? 1u : 0u;
    return;
  }
  tag_ = TagInField{*uid, *entered_, std::nullopt};
  read_over_ = config_.read_blocks == 0;
  emit(TagIdentified{*uid, now_});
}

std::size_t TagReader::read_piece_bytes() const {
  const std::size_t missing = config_.read_blocks * kBlockBytes - reading_.size();
  return std::min(missing, config_.blocks_per_command * kBlockBytes);
}

void TagReader::on_read(const CardResponse& response) {
  if (!response.status.ok()) {
    ++health_.refused;
  } else if (response.data.size() != read_piece_bytes()) {
    ++health_.malformed;
    return;  // asked again
  } else {
    reading_.insert(reading_.end(), response.data.begin(), response.data.end());
    if (read_piece_bytes() != 0) {
      return;
    }
    tag_->data = std::exchange(reading_, {});
  }
  read_over_ = true;
  emit(TagDataRead{tag_->uid, now_, response.status});
}

void TagReader::finish_write() {
  if (!write_ || !write_->outcome()) {
    return;
  }
  const Result<WriteDone, WriteError> result = *write_->outcome();
  const TagWrite::Job job = write_->job();
  write_.reset();
  if (result && tag_ && tag_->data) {
    renew(*tag_->data, config_.read_first_block, job);
  } else if (tag_) {
    // Read before or during the write, or of a tag that may hold anything now: read it again.
    tag_->data.reset();
    reading_.clear();
    read_over_ = config_.read_blocks == 0;
  }
  emit(WriteOutcome{job.uid, job.first_block, result, now_});
  // A stranger answered, or nobody: what we know of the field is no longer true, and is found out afresh.
  if (!result && result.error().failure == WriteFailure::kTagLeft) {
    forget_tag();
  }
}

void TagReader::begin_next() {
  if (!entered_ || purpose_ != Purpose::kNothing) {
    return;
  }
  if (!tag_) {
    begin(GetUid{}, Purpose::kIdentify);
  } else if (write_) {
    begin(write_->command(), Purpose::kWrite);
  } else if (!read_over_) {
    const std::size_t block = config_.read_first_block + reading_.size() / kBlockBytes;
    begin(ReadBinary{static_cast<std::uint16_t>(block), static_cast<std::uint8_t>(read_piece_bytes())},
          Purpose::kRead);
  }
}

void TagReader::begin(const CardCommand& command, Purpose purpose) {
  if (!link_.begin(encode(command))) {
    return;  // the card left since presence() was asked; the next step sees it
  }
  purpose_ = purpose;
  begun_ = now_;
  ++health_.exchanges;
}

bool TagReader::write(TagUid uid, std::uint8_t first_block, ByteView data) {
  assert(!data.empty() && data.size() % kBlockBytes == 0);
  if (write_ || !tag_ || tag_->uid != uid) {
    return false;
  }
  write_.emplace(TagWrite::Job{uid, first_block, Bytes(data.begin(), data.end()), config_.write_attempts,
                               config_.blocks_per_command, config_.uid_order});
  return true;
}

std::optional<TagEvent> TagReader::next_event() {
  if (events_.empty()) {
    return std::nullopt;
  }
  const TagEvent event = events_.front();
  events_.pop_front();
  return event;
}

void TagReader::emit(const TagEvent& event) {
  if (events_.size() == kEventsKept) {
    events_.pop_front();
    ++health_.events_lost;
  }
  events_.push_back(event);
}

}  // namespace sensotwin::robot
