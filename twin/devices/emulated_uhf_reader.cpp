// SPDX-License-Identifier: MIT
#include "twin/devices/emulated_uhf_reader.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

#include "twin/devices/uhf_requests.hpp"

namespace sensotwin::twin {
namespace llrp = robot::llrp;
using llrp::MessageType;
using llrp::StatusCode;

EmulatedUhfReader::EmulatedUhfReader(UhfReaderSettings settings, UserMemory memory)
    : settings_(std::move(settings)),
      config_(uhf_factory_configuration(settings_)),
      ro_spec_(settings_, *this),
      access_(std::move(memory)),
      entries_(settings_),
      link_(*this, settings_.redial_after) {
  assert(!settings_.channels_hz.empty());
  assert(settings_.rssi_step_db > 0.0);
}

void EmulatedUhfReader::step(robot::Instant now) {
  assert(now >= now_);
  ro_spec_.step(now);
  now_ = now;
  if (closing_ && out_.empty()) {
    disconnect();
  }
  if (connected_ && next_keepalive_ && *next_keepalive_ <= now) {
    // One more behind half a megabyte that nobody takes would keep nothing alive.
    if (out_bytes_ <= settings_.buffer_bytes) {
      put(llrp::Keepalive{}, next_id_++);
      ++tally_.keepalives;
    }
    next_keepalive_ = now + std::chrono::milliseconds{config_.keepalive->period_ms};
  }
  link_.step(now);
}

bool EmulatedUhfReader::report(const RadioReading& reading) {
  now_ = std::max(now_, reading.at);
  ro_spec_.step(now_);
  if (!ro_spec_.reads(reading.antenna)) {
    return false;
  }
  ++tally_.readings;
  run_access(reading);
  if (entries_.add(reading, ro_spec_.context())) {
    flush_report();
  }
  ro_spec_.observe(reading);
  return true;
}

void EmulatedUhfReader::run_access(const RadioReading& reading) {
  const ReadingContext context = ro_spec_.context();
  auto outcome = access_.try_on(reading, context.ro_spec_id, config_.access_report->trigger);
  if (!outcome) {
    return;
  }
  llrp::TagReport entry = entries_.entry_of(reading, context);
  entry.results = std::move(outcome->results);
  if (entry.access_spec_id) {
    entry.access_spec_id = outcome->access_spec_id;
  }
  if (outcome->report == llrp::AccessReportTrigger::kWithRoReport) {
    entries_.add(std::move(entry));
  } else {
    put_or_lose(llrp::RoAccessReport{{std::move(entry)}, {}}, settings_.report_latency);
  }
}

bool EmulatedUhfReader::connect() {
  llrp::ReaderEvent event = event_now();
  if (is_connected()) {
    event.connection_attempt = llrp::ConnectionAttemptEvent{llrp::ConnectionAttempt::kAnotherAttempted};
    if (out_bytes_ <= settings_.buffer_bytes) {  // the first one may have stopped reading long ago
      put(llrp::ReaderEventNotification{std::move(event)}, next_id_++);
    }
    return false;
  }
  disconnect();
  connected_ = true;
  ++tally_.connections;
  event.connection_attempt = llrp::ConnectionAttemptEvent{llrp::ConnectionAttempt::kSuccess};
  put(llrp::ReaderEventNotification{std::move(event)}, next_id_++);
  holding_ = config_.events_and_reports->hold_upon_reconnect;
  if (config_.keepalive->trigger == llrp::KeepaliveTrigger::kPeriodic) {
    next_keepalive_ = now_ + std::chrono::milliseconds{config_.keepalive->period_ms};
  }
  return true;
}

robot::Bytes EmulatedUhfReader::refusal() {
  llrp::ReaderEvent event = event_now();
  event.connection_attempt = llrp::ConnectionAttemptEvent{llrp::ConnectionAttempt::kClientInitiatedExists};
  return llrp::encode(llrp::ReaderEventNotification{std::move(event)}, next_id_++);
}

void EmulatedUhfReader::disconnect() {
  connected_ = closing_ = extended_ = holding_ = false;
  in_.reset();
  out_.clear();
  out_bytes_ = sent_of_first_ = 0;
  held_.clear();
  next_keepalive_.reset();
}

void EmulatedUhfReader::close() {
  if (!connected_ || closing_) {
    return;
  }
  llrp::ReaderEvent event = event_now();
  event.connection_close = llrp::ConnectionCloseEvent{};
  put(llrp::ReaderEventNotification{std::move(event)}, next_id_++);
  closing_ = true;
}

void EmulatedUhfReader::receive(robot::ByteView bytes) {
  while (connected_ && !closing_ && !bytes.empty()) {
    const auto room = in_.room();
    const std::size_t n = std::min(room.size(), bytes.size());
    std::copy_n(bytes.begin(), n, room.begin());
    in_.received(n);
    bytes = bytes.subspan(n);
    while (!closing_) {
      const auto frame = in_.next();
      if (!frame) {
        break;
      }
      if (*frame) {
        handle(**frame);
        // A client that asks on and on and never reads would fill the memory: it is thrown out.
        closing_ = closing_ || out_bytes_ > 2 * settings_.buffer_bytes;
      } else {
        // Nobody knows where the next message begins: say so and close, as a real Speedway does.
        close();
      }
    }
  }
}

std::size_t EmulatedUhfReader::send(std::span<std::uint8_t> into) {
  std::size_t moved = 0;
  while (moved < into.size() && !out_.empty() && out_.front().due <= now_) {
    const robot::Bytes& first = out_.front().bytes;
    const std::size_t n = std::min(into.size() - moved, first.size() - sent_of_first_);
    std::copy_n(first.begin() + static_cast<std::ptrdiff_t>(sent_of_first_), n,
                into.begin() + static_cast<std::ptrdiff_t>(moved));
    moved += n;
    sent_of_first_ += n;
    if (sent_of_first_ == first.size()) {
      out_bytes_ -= first.size();
      out_.pop_front();
      sent_of_first_ = 0;
    }
  }
  return moved;
}

void EmulatedUhfReader::put(const llrp::Message& message, std::uint32_t id, robot::Duration latency) {
  // Bytes leave in order: nothing overtakes a report that is still on its way.
  const robot::Instant earliest = out_.empty() ? now_ : out_.back().due;
  out_.push_back({std::max(now_ + latency, earliest), llrp::encode(message, id)});
  out_bytes_ += out_.back().bytes.size();
}

void EmulatedUhfReader::put_or_lose(const llrp::Message& message, robot::Duration latency) {
  const bool is_report = std::holds_alternative<llrp::RoAccessReport>(message);
  tally_.reports += is_report ? 1 : 0;
  const bool full = holding_ && held_.size() >= settings_.buffer_bytes / 100;  // an entry has about 100 bytes
  if (!connected_ || closing_ || full || out_bytes_ > settings_.buffer_bytes) {
    tally_.reports_lost += is_report ? 1 : 0;
  } else if (holding_) {
    held_.push_back(message);
  } else {
    put(message, next_id_++, latency);
  }
}

void EmulatedUhfReader::put_event(llrp::EventKind kind, llrp::ReaderEvent event) {
  if (config_.events->states[static_cast<std::size_t>(kind)].on) {
    put_or_lose(llrp::ReaderEventNotification{std::move(event)});
  }
}

void EmulatedUhfReader::flush_report() {
  // A client without the extensions is not sent their fields, whatever the ROSpec of an earlier one says.
  std::vector<llrp::TagReport> tags = entries_.take();
  if (!extended_) {
    for (llrp::TagReport& tag : tags) {
      tag.phase_angle.reset();
      tag.impinj_rssi.reset();
      tag.doppler.reset();
    }
  }
  put_or_lose(llrp::RoAccessReport{std::move(tags), {}}, settings_.report_latency);
}

llrp::ReaderEvent EmulatedUhfReader::event_now() const {
  llrp::ReaderEvent event;
  event.utc = llrp::UtcTimestamp{entries_.utc_us(now_)};
  return event;
}

void EmulatedUhfReader::ro_spec_started(std::uint32_t id) {
  const auto& spec = *ro_spec_.spec();
  entries_.set_spec(spec.report ? *spec.report : *config_.ro_report);
  llrp::ReaderEvent event = event_now();
  event.ro_spec = llrp::RoSpecEvent{llrp::RoSpecEventKind::kStart, id, 0};
  put_event(llrp::EventKind::kRoSpec, std::move(event));
}

void EmulatedUhfReader::ai_spec_ended(std::uint32_t id, std::uint16_t spec_index) {
  if (entries_.spec().trigger == llrp::RoReportTrigger::kTagsOrEndOfAiSpec && !entries_.empty()) {
    flush_report();
  }
  llrp::ReaderEvent event = event_now();
  event.ai_spec = llrp::AiSpecEvent{llrp::AiSpecEventKind::kEnd, id, spec_index, {}};
  put_event(llrp::EventKind::kAiSpec, std::move(event));
}

void EmulatedUhfReader::ro_spec_ended(std::uint32_t id) {
  if (entries_.spec().trigger != llrp::RoReportTrigger::kNone && !entries_.empty()) {
    flush_report();
  }
  llrp::ReaderEvent event = event_now();
  event.ro_spec = llrp::RoSpecEvent{llrp::RoSpecEventKind::kEnd, id, 0};
  put_event(llrp::EventKind::kRoSpec, std::move(event));
}

}  // namespace sensotwin::twin
