// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "robot/output/event_log.hpp"
#include "robot/output/run_folder.hpp"
#include "robot/sensobot/devices.hpp"
#include "robot/settings/robot_file.hpp"
#include "robot/settings/robot_program.hpp"

namespace sensotwin::robot {

/// How a run went, beside what its program knows.
struct RunFigures {
  std::string outcome;  ///< "done", "not_arrived", "interrupted", "device_lost", "time_limit" ...
  double run_s{0.0};
  std::uint64_t steps{0};
  std::uint64_t steps_late{0};  ///< begun more than a step after they were due
  double latest_step_s{0.0};    ///< how late the latest was
  std::uint64_t journal_bytes{0};
  bool journal_complete{true};  ///< false: it could not be written to the end
};

/// Writes events.jsonl while a program runs, then its map and summary.
class RobotRecorder {
 public:
  /// \throws OutputError
  RobotRecorder(const RobotFile& robot, RunFolder& folder);

  /// After each step. \throws OutputError
  void record(RobotProgram& program);
  /// Told of every event from now on.
  void listen(EventLog::Listener listener) { events_.set_listener(std::move(listener)); }
  /// A device came or went. \throws OutputError
  void record(Instant now, const DeviceState& device);
  /// Completes the folder. \returns summary.json's text. \throws OutputError
  [[nodiscard]] std::string finish(RobotProgram& program, const RunFigures& figures);
  [[nodiscard]] int tags_reached() const { return tags_reached_; }
  [[nodiscard]] int tags_skipped() const { return tags_skipped_; }
  /// "12 tiles", "tag 3 of 5": how far it is, for people.
  [[nodiscard]] std::string progress(RobotProgram& program) const;

 private:
  [[nodiscard]] std::string name_of(const Epc& epc) const;

  const RobotFile& robot_;
  RunFolder& folder_;
  EventLog events_;
  int tags_reached_{0};
  int tags_skipped_{0};
};

}  // namespace sensotwin::robot
