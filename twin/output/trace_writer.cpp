// SPDX-License-Identifier: MIT
#include "twin/output/trace_writer.hpp"

#include <cassert>
#include <utility>

#include "robot/output/text_format.hpp"

namespace sensotwin::twin {
namespace {

constexpr std::string_view kHeader =
    "t_s,truth_x_m,truth_y_m,truth_yaw_rad,odometry_x_m,odometry_y_m,odometry_yaw_rad,"
    "estimate_x_m,estimate_y_m,estimate_yaw_rad,command_left_mps,command_right_mps,bump,tag\n";

// Twelve numbers of at most 20 characters, bump, tag, fourteen separators.
constexpr std::size_t kRowSizeMax = 12 * 20 + 1 + 16 + 14;

char* put_cell(char* to, double value) {
  to = robot::put_fixed<5>(to, value);
  *to++ = ',';
  return to;
}

char* put_pose(char* to, const robot::Pose2& pose) {
  to = put_cell(to, pose.p_m.x());
  to = put_cell(to, pose.p_m.y());
  return put_cell(to, pose.yaw_rad);
}

}  // namespace

TraceWriter::TraceWriter(robot::OutputFile file, int every) : file_(std::move(file)), every_(every) {
  assert(every >= 1);
  file_.append(kHeader);
}

void TraceWriter::add(const TraceRow& row) {
  if (until_next_ > 0) {
    --until_next_;
    return;
  }
  until_next_ = every_ - 1;
  char* const begin = file_.room(kRowSizeMax);
  char* to = robot::put_fixed<3>(begin, robot::to_s(row.now));
  *to++ = ',';
  to = put_pose(to, row.X_WR);
  to = put_pose(to, row.X_OR_odometry);
  if (row.X_MR_estimate) {
    to = put_pose(to, *row.X_MR_estimate);
  } else {
    *to++ = ',';
    *to++ = ',';
    *to++ = ',';
  }
  to = put_cell(to, row.command_left_mps);
  to = put_cell(to, row.command_right_mps);
  *to++ = static_cast<char>('0' + (row.bump_right ? 1 : 0) + (row.bump_left ? 2 : 0));
  *to++ = ',';
  if (row.tag) {
    to = robot::put_uid(to, *row.tag);
  }
  *to++ = '\n';
  file_.commit(static_cast<std::size_t>(to - begin));
}

}  // namespace sensotwin::twin
