// SPDX-License-Identifier: MIT
#include "robot/drivers/uhf_reader.hpp"

#include <algorithm>
#include <cassert>
#include <numbers>
#include <type_traits>
#include <utility>

namespace sensotwin::robot {
namespace {

using llrp::MessageType;

/// How often the decoder's room may be filled in one step: 256 KiB. More is a backlog, and is worked off in
/// the next steps instead of holding up this one.
constexpr int kFillsPerStep = 4;
constexpr double kPhaseStep_rad = 2.0 * std::numbers::pi / 4096.0;
constexpr std::uint16_t kPhaseMask = 0x0FFF;

}  // namespace

UhfReader::UhfReader(ByteLink& link, UhfReaderConfig config)
    : link_(link), config_(std::move(config)), retry_after_(config_.first_retry) {
  assert(!config_.antennas.empty());
  assert(config_.report_every > 0);
  assert(config_.keepalive_s > 0.0);
}

void UhfReader::step(Instant now) {
  assert(now >= now_);
  now_ = now;
  reads_.clear();
  if (status_ == UhfReaderStatus::kShutDown) {
    return;
  }
  if (!link_.is_up()) {
    if (status_ != UhfReaderStatus::kDown) {
      fail(UhfReaderFault::kLinkLost);
      status_ = UhfReaderStatus::kDown;
    }
    return;
  }
  if (status_ == UhfReaderStatus::kDown) {
    begin_connection();
  }
  receive();
  watch();
}

void UhfReader::begin_connection() {
  decoder_.reset();
  awaited_.reset();
  status_ = UhfReaderStatus::kGreeting;
  greet_by_ = now_ + config_.greeting_timeout;
}

void UhfReader::receive() {
  for (int i = 0; i < kFillsPerStep; ++i) {
    const auto room = decoder_.room();
    const std::size_t n = link_.read(room);
    decoder_.received(n);
    while (const auto frame = decoder_.next()) {
      if (*frame) {
        take(**frame);
      } else {
        last_fault_ = UhfReaderFault::kCorruptStream;
        ++health_.faults[static_cast<std::size_t>(last_fault_)];
      }
    }
    if (n < room.size()) {
      break;
    }
  }
  health_.bytes_skipped = decoder_.bytes_skipped();
  health_.clock_restarts = clock_.restarts();
}

void UhfReader::take(const llrp::Frame& frame) {
  const auto message = llrp::decode(frame);
  if (!message) {
    ++health_.messages_bad;
    return;
  }
  last_heard_ = now_;
  take(*message, frame.header.id);
}

void UhfReader::take(const llrp::Message& message, std::uint32_t id) {
  if (const auto* report = std::get_if<llrp::RoAccessReport>(&message)) {
    take(*report);
  } else if (std::holds_alternative<llrp::Keepalive>(message)) {
    ++health_.keepalives;
    static_cast<void>(send(llrp::KeepaliveAck{}, id));
  } else if (const auto* event = std::get_if<llrp::ReaderEventNotification>(&message)) {
    take(event->event);
  } else {
    std::visit(
        [&](const auto& answer) {
          if constexpr (requires { answer.status; }) {
            take_answer(message, answer.status, id);
          } else {
            ++health_.messages_unexpected;
          }
        },
        message);
  }
}

void UhfReader::take(const llrp::ReaderEvent& event) {
  if (event.utc) {
    clock_.learn(event.utc->us, now_);
  }
  if (event.connection_close) {
    fail(UhfReaderFault::kClosedByReader);
  } else if (event.connection_attempt) {
    if (event.connection_attempt->status == llrp::ConnectionAttempt::kSuccess) {
      begin_setup();
    } else if (event.connection_attempt->status != llrp::ConnectionAttempt::kAnotherAttempted) {
      fail(UhfReaderFault::kBusy);
    }
  }
}

void UhfReader::take(const llrp::RoAccessReport& report) {
  if (status_ == UhfReaderStatus::kWaiting && last_fault_ == UhfReaderFault::kSilent) {
    status_ = UhfReaderStatus::kReading;  // it was the line, not the reader
  }
  for (const llrp::TagReport& tag : report.tags) {
    if (tag.last_seen_utc_us) {
      clock_.learn(*tag.last_seen_utc_us, now_);
    }
  }
  for (const llrp::TagReport& tag : report.tags) {
    const bool ours = tag.ro_spec_id.value_or(kRoSpecId) == kRoSpecId;
    if (status_ != UhfReaderStatus::kReading || !ours) {
      ++health_.reads_unasked;
    } else if (!tag.results.empty()) {
      const auto result = memory_result(tag, memory_op_);
      if (result && memory_spec_) {
        finish_memory(*result);
      }
    } else {
      take(tag);
    }
  }
}

void UhfReader::take(const llrp::TagReport& tag) {
  const bool complete = tag.epc_96 && tag.antenna_id && tag.channel_index && tag.last_seen_utc_us &&
                        (tag.impinj_rssi || tag.peak_rssi_dbm);
  const std::size_t channel = complete ? *tag.channel_index : 0u;
  if (channel == 0 || channel > channels_hz_.size()) {
    ++health_.reads_incomplete;
    return;
  }
  if (was_given({*tag.last_seen_utc_us, *tag.antenna_id, *tag.epc_96})) {
    ++health_.reads_repeated;
    return;
  }
  UhfRead& read = reads_.emplace_back();
  read.at = clock_.at(*tag.last_seen_utc_us);
  read.epc = *tag.epc_96;
  read.antenna = *tag.antenna_id;
  read.channel = *tag.channel_index;
  read.frequency_hz = channels_hz_[channel - 1];
  read.has_phase = tag.phase_angle.has_value();
  read.phase_rad = read.has_phase ? (tag.phase_angle->value & kPhaseMask) * kPhaseStep_rad : 0.0;
  read.rssi_dbm = tag.impinj_rssi ? tag.impinj_rssi->value * 0.01 : *tag.peak_rssi_dbm;
  ++health_.reads;
}

bool UhfReader::was_given(const ReadKey& key) {
  if (std::ranges::find(given_, key) != given_.end()) {
    return true;
  }
  given_[given_next_] = key;
  given_next_ = (given_next_ + 1) % given_.size();
  return false;
}

void UhfReader::watch() {
  switch (status_) {
    case UhfReaderStatus::kGreeting:
      if (now_ >= greet_by_) {
        ++health_.greetings_missed;
        begin_setup();
      }
      break;
    case UhfReaderStatus::kWaiting:
      if (now_ >= retry_at_) {
        begin_setup();
      }
      break;
    case UhfReaderStatus::kReading:
      if (now_ - last_heard_ > from_s(config_.keepalive_s * config_.silent_after_keepalives)) {
        decoder_.reset();  // what is held is a message that never ends
        fail(UhfReaderFault::kSilent);
      } else if (memory_by_ && now_ >= *memory_by_ && !awaited_) {
        memory_by_.reset();
        ask(Step::kMemoryDelete);
      }
      break;
    default:
      break;
  }
  if (awaited_ && now_ >= awaited_->deadline) {
    if (awaited_->step >= Step::kMemoryAdd) {
      awaited_.reset();
      finish_memory(Unexpected{UhfMemoryError::kNoAnswer});
    } else {
      fail(UhfReaderFault::kNoAnswer);
    }
  }
}

void UhfReader::fail(UhfReaderFault fault) {
  last_fault_ = fault;
  ++health_.faults[static_cast<std::size_t>(fault)];
  awaited_.reset();
  if (memory_spec_) {
    finish_memory(Unexpected{UhfMemoryError::kConnectionLost});
  }
  status_ = UhfReaderStatus::kWaiting;
  retry_at_ = now_ + retry_after_;
  retry_after_ = std::min(2 * retry_after_, config_.last_retry);
}

bool UhfReader::send(const llrp::Message& message, std::uint32_t id) {
  return link_.write(llrp::encode(message, id));
}

void UhfReader::shut_down() {
  static_cast<void>(send(llrp::DeleteRoSpec{kRoSpecId}, next_id_++));
  static_cast<void>(send(llrp::CloseConnection{}, next_id_++));
  awaited_.reset();
  reads_.clear();
  status_ = UhfReaderStatus::kShutDown;
}

}  // namespace sensotwin::robot
