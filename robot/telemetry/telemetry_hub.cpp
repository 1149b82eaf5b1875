// SPDX-License-Identifier: MIT
#include "robot/telemetry/telemetry_hub.hpp"

#include <utility>

namespace sensotwin::robot {
namespace {

/// Between two looks into the box. Chosen: as often as the eye follows a robot; a hundred browsers are then
/// written to a thousand times a second.
constexpr std::chrono::milliseconds kSpreadEvery{100};
/// Messages in the box at most: the loop empties it itself then, rather than lose one. A robot fills a few in
/// a tenth of a second, a twin at full speed some thousand. Chosen.
constexpr std::size_t kBoxMost = 50'000;
/// Of one write to a client. Chosen: what a socket takes at once.
constexpr std::size_t kBatch_bytes = 64 * 1024;

class LogStream : public EventStream {
 public:
  LogStream(const TelemetryLog& log, std::string_view last_event_id)
      : log_(log), last_(log.number_of(last_event_id)), fresh_(last_ == 0) {}

  std::string next(std::chrono::milliseconds patience) override {
    log_.wait(last_, patience);
    TelemetryLog::Batch batch = log_.after(last_, kBatch_bytes);
    last_ = batch.last;
    if (std::exchange(fresh_, false)) {
      // Whatever the page has drawn is of another run, or it has drawn nothing yet.
      batch.text.insert(0, "retry: 1000\ndata: {\"k\":\"reset\"}\n\n");
    }
    return std::move(batch.text);
  }
  [[nodiscard]] bool ended() const override { return log_.closed(); }

 private:
  const TelemetryLog& log_;
  std::uint64_t last_;
  bool fresh_;
};

}  // namespace

TelemetryHub::TelemetryHub(std::string epoch) : log_(std::move(epoch)), spreader_([this] { spread(); }) {}

TelemetryHub::~TelemetryHub() {
  {
    const std::lock_guard lock(end_mutex_);
    ending_ = true;
  }
  end_.notify_all();
  spreader_.join();
  log_.close();
}

void TelemetryHub::publish(TelemetryMessage message) {
  bool full = false;
  {
    const std::lock_guard lock(box_mutex_);
    box_.push_back(std::move(message));
    full = box_.size() >= kBoxMost;
  }
  if (full) {
    empty_box();
  }
}

void TelemetryHub::empty_box() {
  const std::lock_guard order(spreading_);
  taken_.clear();
  {
    const std::lock_guard lock(box_mutex_);
    taken_.swap(box_);
  }
  log_.append(taken_);
}

void TelemetryHub::flush() {
  empty_box();
}

void TelemetryHub::spread() {
  std::unique_lock lock(end_mutex_);
  while (!ending_) {
    end_.wait_for(lock, kSpreadEvery, [this] { return ending_; });
    lock.unlock();
    empty_box();
    lock.lock();
  }
}

std::unique_ptr<EventStream> TelemetryHub::stream(std::string_view last_event_id) const {
  return std::make_unique<LogStream>(log_, last_event_id);
}

}  // namespace sensotwin::robot
