// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "robot/base/geometry.hpp"
#include "robot/base/time.hpp"
#include "robot/output/output_file.hpp"

namespace sensotwin::twin {

/// What was true and what the robot believed at the end of one tick.
struct TraceRow {
  robot::Instant now{};
  robot::Pose2 X_WR{};                          ///< truth
  robot::Pose2 X_OR_odometry{};                 ///< O: the pose at power-on; drifts
  std::optional<robot::Pose2> X_MR_estimate{};  ///< M: the robot's own map; absent until it has one
  double command_left_mps{0.0};
  double command_right_mps{0.0};
  bool bump_left{false};
  bool bump_right{false};
  std::optional<std::uint64_t> tag{};  ///< UID in the floor reader's field, as the robot read it
};

/// trace.csv: one header line, then one line for every n-th row handed over, the first included (RFC 4180
/// with line feeds). Metres and radians with five decimals, 10 micrometres, finer than any sensor here;
/// seconds with three. `bump` is 0 none, 1 right, 2 left, 3 both, as in the Open Interface's packet 7. A cell
/// is empty when the robot has no such value. A tag that is in the field between two lines only is in
/// events.jsonl, not here.
class TraceWriter {
 public:
  /// \param file   not yet written to  \param every  write each n-th row, n >= 1
  TraceWriter(robot::OutputFile file, int every);

  /// About 0.2 microseconds for a written row. \throws OutputError
  void add(const TraceRow& row);
  /// \throws OutputError
  void finish() { file_.finish(); }

 private:
  robot::OutputFile file_;
  int every_;
  int until_next_{0};
};

}  // namespace sensotwin::twin
