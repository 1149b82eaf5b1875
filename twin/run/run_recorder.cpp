// SPDX-License-Identifier: MIT
#include "twin/run/run_recorder.hpp"

#include "robot/record/program_events.hpp"
#include "twin/run/run_parts.hpp"

namespace sensotwin::twin {
namespace {

/// Ticks between two points of the drawn trajectory. Chosen: 0.105 s, 3 cm at 0.3 m/s.
constexpr int kPointEvery = 7;

}  // namespace

RunRecorder::RunRecorder(robot::RunFolder& folder, int trace_every)
    : trace_(folder.stream("trace.csv"), trace_every),
      events_(folder.stream("events.jsonl")),
      point_every_(kPointEvery) {}

void RunRecorder::record(MappingTwin& twin) {
  const world::RoombaInputs& inputs = twin.inputs();
  energy_wh_ -= 1e-6 * inputs.battery_ma * inputs.battery_mv * robot::to_s(robot::kTick) / 3600.0;
  record_events(twin);
  record_bump(twin);
  record_row(twin);
}

void RunRecorder::record_events(MappingTwin& twin) {
  robot::record_events(twin.program(), events_, [this](const robot::MissionEvent& event) {
    if (event.kind == robot::MissionEventKind::kTileFound) {
      found_.push_back({robot::to_s(event.stamp), event.tile, event.tag});
    }
  });
}

void RunRecorder::record_bump(const MappingTwin& twin) {
  const bool bumped = twin.inputs().bump_left || twin.inputs().bump_right;
  if (bumped && !bumped_) {
    events_.add(twin.now(), "bump", {{"left", twin.inputs().bump_left}, {"right", twin.inputs().bump_right}});
  }
  bumped_ = bumped;
}

void RunRecorder::record_row(MappingTwin& twin) {
  const robot::MappingProgram& program = twin.program();
  if (until_point_-- == 0) {
    until_point_ = point_every_ - 1;
    trajectory_.push_back({twin.world().X_WR().p_m, robot::to_s(twin.now())});
  }
  TraceRow row = row_of(twin);
  row.X_OR_odometry = program.mission().navigator().filter().odometry();
  if (program.mission().map().visited_count() > 0) {
    row.X_MR_estimate = program.mission().navigator().pose();
  }
  trace_.add(row);
}

void RunRecorder::finish() {
  trace_.finish();
  events_.finish();
}

}  // namespace sensotwin::twin
