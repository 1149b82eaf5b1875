// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "robot/telemetry/telemetry_log.hpp"
#include "robot/telemetry/web/http.hpp"

namespace sensotwin::robot {

/// Between a robot's loop and whoever watches it. The loop drops a message into a box; a thread of the hub's
/// own empties the box into the log now and then, and those who serve browsers read the log. The loop shares
/// a lock with that one thread, for as long as it takes to append to or to exchange a vector, and never with
/// a browser.
class TelemetryHub {
 public:
  /// \param epoch  as TelemetryLog's
  explicit TelemetryHub(std::string epoch);
  ~TelemetryHub();
  TelemetryHub(const TelemetryHub&) = delete;
  TelemetryHub& operator=(const TelemetryHub&) = delete;

  /// By the robot's loop.
  void publish(TelemetryMessage message);
  /// What was published so far is in the log when it returns. Not for the robot's loop.
  void flush();

  /// A client's stream, from behind the event that it got last. Outlived by the hub.
  [[nodiscard]] std::unique_ptr<EventStream> stream(std::string_view last_event_id) const;
  [[nodiscard]] const TelemetryLog& log() const { return log_; }

 private:
  void spread();
  void empty_box();

  TelemetryLog log_;
  std::mutex box_mutex_;
  std::vector<TelemetryMessage> box_;
  std::mutex spreading_;  ///< one empties the box at a time, so that order is kept
  std::vector<TelemetryMessage> taken_;
  std::mutex end_mutex_;
  std::condition_variable end_;
  bool ending_{false};
  std::thread spreader_;
};

}  // namespace sensotwin::robot
