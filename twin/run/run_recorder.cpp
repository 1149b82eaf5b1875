// SPDX-License-Identifier: MIT
#include "twin/run/run_recorder.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <variant>

#include "robot/wire/tag_record.hpp"

namespace sensotwin::twin {
namespace {

/// Ticks between two points of the drawn trajectory. Chosen: 0.105 s, 3 cm at 0.3 m/s.
constexpr int kPointEvery = 7;

std::string_view name_of(robot::MissionEventKind kind) {
  switch (kind) {
    case robot::MissionEventKind::kTileFound:
      return "tile_found";
    case robot::MissionEventKind::kTileWritten:
      return "tile_written";
    case robot::MissionEventKind::kWriteFailed:
      return "write_failed";
    case robot::MissionEventKind::kPassageSeen:
      return "passage_blocked_by_light";
    case robot::MissionEventKind::kPassageBumped:
      return "passage_blocked_by_touch";
    case robot::MissionEventKind::kTagMissed:
      return "tag_missed";
    case robot::MissionEventKind::kTagRecovered:
      return "tag_recovered";
    case robot::MissionEventKind::kTagGivenUp:
      return "tag_given_up";
    case robot::MissionEventKind::kDetourBegun:
      return "detour_begun";
    case robot::MissionEventKind::kDetourDone:
      return "detour_done";
    case robot::MissionEventKind::kUnreachable:
      return "tile_unreachable";
    case robot::MissionEventKind::kDisplaced:
      return "displaced";
    case robot::MissionEventKind::kLost:
      return "lost";
    case robot::MissionEventKind::kDone:
      break;
  }
  return "map_complete";
}

std::string text_of(robot::TagUid uid) {
  return fmt::format("{:016X}", uid);
}

}  // namespace

RunRecorder::RunRecorder(RunFolder& folder, int trace_every)
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
  robot::MissionLog& log = twin.program().mission().log();
  if (!log.empty()) {
    for (const robot::MissionEvent& event : log.take()) {
      if (event.kind == robot::MissionEventKind::kTileFound) {
        found_.push_back({robot::to_s(event.stamp), event.tile, event.tag});
      }
      if (event.tag != 0) {
        events_.add(event.stamp, name_of(event.kind),
                    {{"column", event.tile.column}, {"row", event.tile.row}, {"tag", text_of(event.tag)}});
      } else {
        events_.add(event.stamp, name_of(event.kind),
                    {{"column", event.tile.column}, {"row", event.tile.row}});
      }
    }
  }
  for (const robot::ObjectSeen& object : twin.program().take_objects()) {
    const bool furniture = std::holds_alternative<robot::ObjectRecord>(object.record);
    events_.add(object.stamp, furniture ? "furniture_seen" : "landmark_seen",
                {{"tag", text_of(object.tag)},
                 {"x_m", object.X_MR.p_m.x()},
                 {"y_m", object.X_MR.p_m.y()},
                 {"yaw_rad", object.X_MR.yaw_rad}});
  }
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
  TraceRow row;
  row.now = twin.now();
  row.X_WR = twin.world().X_WR();
  row.X_OR_odometry = program.mission().navigator().filter().odometry();
  if (program.mission().map().visited_count() > 0) {
    row.X_MR_estimate = program.mission().navigator().pose();
  }
  row.command_left_mps = program.wheels().left_mps;
  row.command_right_mps = program.wheels().right_mps;
  row.bump_left = twin.inputs().bump_left;
  row.bump_right = twin.inputs().bump_right;
  if (program.floor_reader().tag()) {
    row.tag = program.floor_reader().tag()->uid;
  }
  trace_.add(row);
}

void RunRecorder::finish() {
  trace_.finish();
  events_.finish();
}

}  // namespace sensotwin::twin
