// SPDX-License-Identifier: MIT
#include "twin/output/trace_writer.hpp"

#include <gmock/gmock.h>

#include <ctime>
#include <limits>

#include "tests/robot/output/temporary_folder.hpp"

namespace sensotwin::twin {
namespace {

using robot::from_s;
using robot::Instant;

TEST(TraceWriter, WritesHeaderAndRowsAsDocumented) {
  const TemporaryFolder folder;
  TraceWriter trace(robot::OutputFile(folder / "trace.csv"), 1);
  trace.add({.now = Instant{from_s(0.015)},
             .X_WR = {{1.0, -2.5}, 0.5},
             .X_OR_odometry = {{0.25, 0.0}, -0.125},
             .command_left_mps = 0.2,
             .command_right_mps = -0.2,
             .bump_left = true});
  trace.add({.now = Instant{from_s(0.030)},
             .X_MR_estimate = robot::Pose2{{0.508, 0.0}, 0.0},
             .bump_right = true,
             .tag = 0xE00401001234ABCDu});
  trace.finish();
  EXPECT_EQ(content_of(folder / "trace.csv"),
            "t_s,truth_x_m,truth_y_m,truth_yaw_rad,odometry_x_m,odometry_y_m,odometry_yaw_rad,"
            "estimate_x_m,estimate_y_m,estimate_yaw_rad,command_left_mps,command_right_mps,bump,tag\n"
            "0.015,1.00000,-2.50000,0.50000,0.25000,0.00000,-0.12500,,,,0.20000,-0.20000,2,\n"
            "0.030,0.00000,0.00000,0.00000,0.00000,0.00000,0.00000,0.50800,0.00000,0.00000,0.00000,0.00000,1,"
            "E00401001234ABCD\n");
}

TEST(TraceWriter, KeepsEveryNthRowBeginningWithTheFirst) {
  const TemporaryFolder folder;
  TraceWriter trace(robot::OutputFile(folder / "trace.csv"), 4);
  for (int tick = 0; tick < 10; ++tick) {
    trace.add({.now = Instant{tick * robot::kTick}});
  }
  trace.finish();
  const std::string text = content_of(folder / "trace.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 3);
  EXPECT_THAT(text, ::testing::HasSubstr("\n0.000,"));
  EXPECT_THAT(text, ::testing::HasSubstr("\n0.060,"));
  EXPECT_THAT(text, ::testing::HasSubstr("\n0.120,"));
}

// Processor time, system calls included, so that a busy machine does not fail it. The limit is six times what
// one row costs (RowCost below): a return to printf-like formatting, 1.5 microseconds, does not go unnoticed.
TEST(TraceWriter, WritesARowInLessThanAMicrosecond) {
  constexpr int kRows = 200'000;
  const TemporaryFolder folder;
  TraceWriter trace(robot::OutputFile(folder / "trace.csv"), 1);
  TraceRow row{.X_WR = {{1.23456, 2.34567}, 0.5}, .X_OR_odometry = {{1.2, 2.3}, 0.4}, .tag = 1};
  row.X_MR_estimate = row.X_WR;
  const std::clock_t begin = std::clock();
  for (int tick = 0; tick < kRows; ++tick) {
    row.now = Instant{tick * robot::kTick};
    row.X_WR.p_m.x() += 0.0031;
    trace.add(row);
  }
  trace.finish();
  const double row_us = 1e6 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / kRows;
  RecordProperty("RowCost_ns", static_cast<int>(1000.0 * row_us));
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
  EXPECT_LT(row_us, 1.0);
#endif
}

}  // namespace
}  // namespace sensotwin::twin
