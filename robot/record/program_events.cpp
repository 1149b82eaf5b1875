// SPDX-License-Identifier: MIT
#include "robot/record/program_events.hpp"

#include <string_view>
#include <variant>

#include "robot/output/text_format.hpp"
#include "robot/wire/tag_record.hpp"

namespace sensotwin::robot {
namespace {

std::string_view name_of(MissionEventKind kind) {
  switch (kind) {
    case MissionEventKind::kTileFound:
      return "tile_found";
    case MissionEventKind::kTileWritten:
      return "tile_written";
    case MissionEventKind::kWriteFailed:
      return "write_failed";
    case MissionEventKind::kPassageSeen:
      return "passage_blocked_by_light";
    case MissionEventKind::kPassageBumped:
      return "passage_blocked_by_touch";
    case MissionEventKind::kTagMissed:
      return "tag_missed";
    case MissionEventKind::kTagRecovered:
      return "tag_recovered";
    case MissionEventKind::kTagGivenUp:
      return "tag_given_up";
    case MissionEventKind::kDetourBegun:
      return "detour_begun";
    case MissionEventKind::kDetourDone:
      return "detour_done";
    case MissionEventKind::kUnreachable:
      return "tile_unreachable";
    case MissionEventKind::kDisplaced:
      return "displaced";
    case MissionEventKind::kLost:
      return "lost";
    case MissionEventKind::kDone:
      break;
  }
  return "map_complete";
}

std::string_view name_of(LandmarkKind kind) {
  switch (kind) {
    case LandmarkKind::kDoorOpeningSide:
      return "door, opening side";
    case LandmarkKind::kDoorFixedSide:
      return "door, fixed side";
    case LandmarkKind::kFrontDoorOpeningSide:
      return "front door, opening side";
    case LandmarkKind::kFrontDoorFixedSide:
      return "front door, fixed side";
    case LandmarkKind::kWindowLeft:
      return "window, left";
    case LandmarkKind::kWindowRight:
      return "window, right";
    case LandmarkKind::kPowerOutlet:
      return "power outlet";
    case LandmarkKind::kClosetLeft:
      return "closet, left";
    case LandmarkKind::kClosetRight:
      break;
  }
  return "closet, right";
}

}  // namespace

void record_events(MappingProgram& program, EventLog& events,
                   const std::function<void(const MissionEvent&)>& seen) {
  MissionLog& log = program.mission().log();
  if (!log.empty()) {
    for (const MissionEvent& event : log.take()) {
      seen(event);
      if (event.tag != 0) {
        events.add(event.stamp, name_of(event.kind),
                   {{"column", event.tile.column}, {"row", event.tile.row}, {"tag", uid_text(event.tag)}});
      } else {
        events.add(event.stamp, name_of(event.kind),
                   {{"column", event.tile.column}, {"row", event.tile.row}});
      }
    }
  }
  for (const ObjectSeen& object : program.take_objects()) {
    const Pose2& X_MR = object.X_MR;
    const std::string tag = uid_text(object.tag);
    if (const auto* furniture = std::get_if<ObjectRecord>(&object.record)) {
      events.add(object.stamp, "furniture_seen",
                 {{"tag", tag},
                  {"x_m", X_MR.p_m.x()},
                  {"y_m", X_MR.p_m.y()},
                  {"yaw_rad", X_MR.yaw_rad},
                  {"category", furniture->category},
                  {"length", furniture->length},
                  {"width", furniture->width},
                  {"color", furniture->color}});
      continue;
    }
    const auto* landmark = std::get_if<LandmarkRecord>(&object.record);
    events.add(object.stamp, "landmark_seen",
               {{"tag", tag},
                {"x_m", X_MR.p_m.x()},
                {"y_m", X_MR.p_m.y()},
                {"yaw_rad", X_MR.yaw_rad},
                {"kind", landmark != nullptr ? name_of(landmark->kind) : "carpet"}});
  }
}

void record_events(PhaseProgram& program, EventLog& events,
                   const std::function<std::string(const Epc&)>& name_of_tag,
                   const std::function<void(const PhaseEvent&)>& seen) {
  for (const PhaseEvent& event : program.take_events()) {
    seen(event);
    events.add(event.stamp, event.name,
               {{"tag", event.tag ? name_of_tag(*event.tag) : std::string{}}, {"value", event.value}});
  }
}

void record_events(HallwayProgram& program, EventLog& events,
                   const std::function<void(const HallwayEvent&)>& seen) {
  for (const HallwayEvent& event : program.take_events()) {
    seen(event);
    events.add(event.stamp, name_of(event.kind),
               {{"place", event.place},
                {"side", event.side ? std::string(1, letter_of(*event.side)) : std::string{}},
                {"value", event.value}});
  }
}

}  // namespace sensotwin::robot
