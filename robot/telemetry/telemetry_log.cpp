// SPDX-License-Identifier: MIT
#include "robot/telemetry/telemetry_log.hpp"

#include <charconv>
#include <utility>

namespace sensotwin::robot {

TelemetryLog::TelemetryLog(std::string epoch, std::size_t most) : epoch_(std::move(epoch)), most_(most) {}

void TelemetryLog::append(std::span<TelemetryMessage> messages) {
  if (messages.empty()) {
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    for (TelemetryMessage& message : messages) {
      append_one(message);
    }
  }
  news_.notify_all();
}

void TelemetryLog::append_one(TelemetryMessage& message) {
  const auto known = newest_.find(message.key);
  if (known == newest_.end() && newest_.size() >= most_) {
    ++dropped_;
    return;
  }
  ++last_;
  std::string event = "id: " + epoch_ + "." + std::to_string(last_) + "\ndata: " + message.json + "\n\n";
  if (known == newest_.end()) {
    newest_.emplace(message.key, last_);
  } else {
    entries_.erase(std::exchange(known->second, last_));
  }
  entries_.emplace_hint(entries_.end(), last_, Entry{std::move(message.key), std::move(event)});
}

TelemetryLog::Batch TelemetryLog::after(std::uint64_t last, std::size_t bytes) const {
  const std::lock_guard lock(mutex_);
  Batch batch{.text = {}, .last = last};
  for (auto each = entries_.upper_bound(last); each != entries_.end() && batch.text.size() < bytes; ++each) {
    batch.text += each->second.event;
    batch.last = each->first;
  }
  return batch;
}

void TelemetryLog::wait(std::uint64_t last, std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  news_.wait_for(lock, patience, [&] { return closed_ || last_ > last; });
}

void TelemetryLog::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  news_.notify_all();
}

bool TelemetryLog::closed() const {
  const std::lock_guard lock(mutex_);
  return closed_;
}

std::uint64_t TelemetryLog::last() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

std::uint64_t TelemetryLog::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

std::uint64_t TelemetryLog::number_of(std::string_view event_id) const {
  if (!event_id.starts_with(epoch_) || !event_id.substr(epoch_.size()).starts_with('.')) {
    return 0;
  }
  event_id.remove_prefix(epoch_.size() + 1);
  std::uint64_t number = 0;
  const char* const end = event_id.data() + event_id.size();
  const auto [stop, error] = std::from_chars(event_id.data(), end, number);
  return error == std::errc{} && stop == end && number <= last() ? number : 0;
}

}  // namespace sensotwin::robot
