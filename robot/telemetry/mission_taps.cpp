// SPDX-License-Identifier: MIT
// What each kind of mission shows of itself, step by step.
#include <utility>

#include "robot/output/text_format.hpp"
#include "robot/telemetry/program_tap.hpp"

namespace sensotwin::robot {
namespace {

std::string_view state_of(const TileMap& map, Tile tile) {
  return map.color(tile) == TileColor::kBlack ? "closed" : "open";
}

unsigned blocked_sides(const TileMap& map, Tile tile) {
  unsigned sides = 0;
  for (const Direction side : kDirections) {
    if (map.passage(tile, side) == Passage::kBlocked) {
      sides |= 1U << static_cast<unsigned>(side);
    }
  }
  return sides;
}

/// A number on a plan, or the unique number of an ISO 15693 tag, which begins with E0.
std::string number_text(TagNumber tag) {
  return tag >> 56U == 0xE0 ? uid_text(tag) : std::to_string(tag);
}

/// `,"base_frames":...`: what went wrong on the wires so far.
template <class Program>
void append_links(std::string& to, const Program& program) {
  const LinkHealth& base = program.base().health();
  const ReaderHealth& floor = program.floor_reader().health();
  append_json_fields(
      to, {{"frames", static_cast<std::int64_t>(base.frames_good)},
           {"frames_corrupt", static_cast<std::int64_t>(base.frames_corrupt)},
           {"frames_missed", static_cast<std::int64_t>(base.frames_missed)},
           {"card_exchanges", static_cast<std::int64_t>(floor.exchanges)},
           {"card_failed", static_cast<std::int64_t>(floor.removed + floor.timeouts)},
           {"compass_corrupt", static_cast<std::int64_t>(program.sensor_board().health().bad_checksum)}});
}

}  // namespace

void ProgramTap::after_step(Instant now, const MappingProgram& program) {
  sense(now, program.base().fresh());
  const TileMap& map = program.mission().map();
  if (std::exchange(changed_, false)) {
    show_tiles(program);
    sample(now, "tiles", static_cast<double>(map.visited_count()));
  }
  if (map.visited_count() > 0) {
    pose(now, program.mission().navigator().pose());
  }
  if (status_is_due(now, program.done())) {
    const MissionCounts& counts = program.mission().counts();
    std::string body;
    append_json_fields(body, {{"t", to_s(now)},
                              {"tiles", static_cast<std::int64_t>(map.visited_count())},
                              {"visits", counts.visits},
                              {"given_up", counts.tiles_given_up},
                              {"bumps", counts.bumps},
                              {"written", counts.writes_verified},
                              {"metres", program.mission().navigator().filter().path_length_m()},
                              {"done", program.done()}});
    append_links(body, program);
    publish("status", "status", body);
  }
}

void ProgramTap::show_tiles(const MappingProgram& program) {
  const TileMap& map = program.mission().map();
  for (const auto& [tile, tag] : map.tiles()) {
    show_tile(tile, {std::string(state_of(map, tile)), blocked_sides(map, tile), written_.contains(tile)},
              tag);
    for (const Direction side : kDirections) {
      const Tile beside = neighbour(tile, side);
      if (map.visited(beside)) {
        continue;
      }
      if (map.unreachable(beside)) {
        show_tile(beside, {"given_up", 0, false}, 0);
      } else if (tiles_.contains(beside)) {
        show_tile(beside, {"unknown", 0, false}, 0);  // reconsidered
      }
    }
  }
}

void ProgramTap::show_tile(const Tile& tile, const ShownTile& shown, TagUid tag) {
  const auto [known, is_new] = tiles_.try_emplace(tile, shown);
  if (!is_new && known->second == shown) {
    return;
  }
  known->second = shown;
  std::string body;
  append_json_fields(body,
                     {{"c", tile.column}, {"w", tile.row}, {"s", shown.state}, {"b", shown.blocked_sides}});
  if (tag != 0) {
    append_json_fields(body, {{"tag", uid_text(tag)}, {"written", shown.written}});
    if (const auto found = found_s_.find(tile); found != found_s_.end()) {
      append_json_fields(body, {{"t", found->second}});
    }
  }
  publish("tile/" + std::to_string(tile.column) + "," + std::to_string(tile.row), "tile", body);
}

void ProgramTap::after_step(Instant now, const HallwayProgram& program) {
  sense(now, program.base().fresh());
  if (std::exchange(changed_, false)) {
    show_places(program);
  }
  if (believed_.turn.is_now()) {
    show_way(program);
  }
  if (status_is_due(now, program.done())) {
    std::string body;
    append_json_fields(body, {{"t", to_s(now)},
                              {"places", static_cast<std::int64_t>(program.map().nodes().size())},
                              {"done", program.done()},
                              {"arrived", program.arrived()}});
    append_links(body, program);
    publish("status", "status", body);
  }
}

void ProgramTap::show_places(const HallwayProgram& program) {
  for (const HallwayNode& node : program.map().nodes()) {
    std::string body;
    append_json_fields(body, {{"name", node.name}});
    if (node.at_m) {
      append_json_fields(body, {{"x", node.at_m->x()}, {"y", node.at_m->y()}});
    }
    body += ",\"sides\":{\"-\":0";
    for (const CompassPoint point : kCompassPoints) {
      const Side& side = node.side(point);
      body += std::string(",\"") + letter_of(point) +
              "\":{\"h\":" + std::to_string(static_cast<int>(side.hallway));
      if (side.hallway == Hallway::kLeadsTo) {
        append_json_fields(body,
                           {{"to", program.map().node(side.to).name}, {"m", side.length_m.value_or(0.0)}});
      }
      body += ",\"tags\":[";
      for (const TagNumber tag : side.tags) {
        body += (body.back() == '[' ? "\"" : ",\"") + number_text(tag) + "\"";
      }
      body += "]}";
    }
    body += '}';
    publish_changed("place/" + node.name, "place", body);
  }
}

void ProgramTap::show_way(const HallwayProgram& program) {
  std::string body;
  const auto place = program.place();
  append_json_fields(body, {{"place", place ? program.map().node(*place).name : std::string{}},
                            {"way_m", program.tracker().way_m()}});
  if (const auto heading = program.tracker().heading_rad()) {
    append_json_fields(body, {{"heading", *heading}});
  }
  if (const auto axis_rad = program.tracker().axis_rad()) {
    append_json_fields(body, {{"axis", *axis_rad}});
  }
  if (const HallwayMission* mission = program.mission()) {
    const HallwayStatus& status = mission->status();
    if (status.leaving) {
      append_json_fields(body, {{"leaving", std::string(1, letter_of(*status.leaving))}});
    }
    if (status.heading_for) {
      append_json_fields(body, {{"to", program.map().node(*status.heading_for).name}});
    }
  }
  publish_changed("way", "way", body);
}

void ProgramTap::after_step(Instant now, const PhaseProgram& program) {
  sense(now, program.base().fresh());
  // The fuzzy controller knows no place: what it drove by its wheels is shown instead.
  pose(now, program.estimate().value_or(program.odometry()));
  if (!status_is_due(now, program.done())) {
    return;
  }
  std::string body;
  const std::size_t leg = program.leg();
  append_json_fields(body, {{"t", to_s(now)},
                            {"leg", static_cast<std::int64_t>(leg)},
                            {"legs", static_cast<std::int64_t>(card_.destinations.size())},
                            {"to", leg < card_.destinations.size() ? card_.destinations[leg] : std::string{}},
                            {"estimated", program.estimate().has_value()},
                            {"done", program.done()},
                            {"arrived", program.arrived()},
                            {"reads", static_cast<std::int64_t>(program.uhf_reader().health().reads)}});
  append_links(body, program);
  publish("status", "status", body);
  if (const CeilingMission* ceiling = program.ceiling()) {
    show_ceiling(*ceiling);
    const Eigen::Matrix3d covariance = ceiling->estimator().pose_covariance();
    body.clear();
    append_json_fields(body, {{"xx", covariance(0, 0)}, {"xy", covariance(0, 1)}, {"yy", covariance(1, 1)}});
    publish_changed("sure", "sure", body);
  }
}

void ProgramTap::show_ceiling(const CeilingMission& mission) {
  for (std::size_t i = 0; i < card_.destinations.size(); ++i) {
    const TagEstimate tag = mission.estimator().tag(mission.tag_of(i));
    if (tag.knowledge < TagKnowledge::kTracked) {
      continue;
    }
    std::string body;
    append_json_fields(body, {{"name", card_.destinations[i]},
                              {"x", tag.p_M_m.x()},
                              {"y", tag.p_M_m.y()},
                              {"xx", tag.covariance_m2(0, 0)},
                              {"xy", tag.covariance_m2(0, 1)},
                              {"yy", tag.covariance_m2(1, 1)},
                              {"kept", tag.knowledge == TagKnowledge::kKept}});
    publish_changed("ceiling/" + card_.destinations[i], "ceiling", body);
  }
}

}  // namespace sensotwin::robot
