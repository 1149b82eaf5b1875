// SPDX-License-Identifier: MIT
#include "twin/run/hallway_recorder.hpp"

#include <cmath>
#include <cstdlib>

#include "robot/record/program_events.hpp"
#include "robot/topology/hallway_route.hpp"
#include "twin/run/run_parts.hpp"

namespace sensotwin::twin {
namespace {

/// Ticks between two points that are drawn. Chosen: 0.105 s, 3 cm at 0.3 m/s.
constexpr int kPointEvery = 7;
/// Of the map's lengths. Chosen: a quarter of a hallway's width.
constexpr double kSameLength_m = 0.5;

/// The place of `found` that has the tags of a drawn one, if they agree.
std::vector<std::optional<robot::NodeIndex>> matched(const robot::HallwayMap& drawn,
                                                     const robot::HallwayMap& found, int& differences) {
  std::vector<std::optional<robot::NodeIndex>> same(drawn.nodes().size());
  for (robot::NodeIndex i = 0; i < drawn.nodes().size(); ++i) {
    for (const robot::CompassPoint side : robot::kCompassPoints) {
      for (const robot::TagNumber tag : drawn.node(i).side(side).tags) {
        const auto place = found.place_of(tag);
        const bool right = place && place->from == side && (!same[i] || *same[i] == place->node);
        differences += right ? 0 : 1;
        if (right) {
          same[i] = place->node;
        }
      }
    }
  }
  return same;
}

}  // namespace

int differences(const robot::HallwayMap& drawn, const robot::HallwayMap& found) {
  int count = std::abs(static_cast<int>(drawn.nodes().size()) - static_cast<int>(found.nodes().size()));
  const auto same = matched(drawn, found, count);
  for (robot::NodeIndex i = 0; i < drawn.nodes().size(); ++i) {
    if (!same[i]) {
      continue;
    }
    for (const robot::CompassPoint point : robot::kCompassPoints) {
      const robot::Side& should = drawn.node(i).side(point);
      const robot::Side& is = found.node(*same[i]).side(point);
      const bool leads = should.hallway == robot::Hallway::kLeadsTo;
      const bool right =
          is.hallway == should.hallway &&
          (!leads || (same[should.to] && is.to == *same[should.to] &&
                      std::abs(is.length_m.value_or(0.0) - should.length_m.value_or(0.0)) < kSameLength_m));
      count += right ? 0 : 1;
    }
  }
  return count;
}

HallwayRecorder::HallwayRecorder(const Scene& scene, robot::RunFolder& folder, int trace_every,
                                 bool keep_points)
    : scene_(scene),
      trace_(folder.stream("trace.csv"), trace_every),
      events_(folder.stream("events.jsonl")),
      keep_points_(keep_points) {
  const HallwaySection& mission = *scene.mission.hallway;
  result_.mission = mission.survey ? "survey" : "go";
  const robot::HallwayMap& map = scene.hallways.map;
  if (mission.survey) {
    return;
  }
  // From the place nearest to where it truly starts.
  robot::NodeIndex start = 0;
  const auto away_m = [&](robot::NodeIndex i) {
    return (*map.node(i).at_m - scene.robot.X_WR_start.p_m).norm();
  };
  for (robot::NodeIndex i = 1; i < map.nodes().size(); ++i) {
    start = away_m(i) < away_m(start) ? i : start;
  }
  if (const auto route = robot::plan_route(map, start, *map.find(mission.to)); route && map.lengths_known()) {
    result_.shortest_m = route->cost;
  }
}

void HallwayRecorder::record(HallwayTwin& twin) {
  const Vec2 p_m = twin.world().X_WR().p_m;
  if (last_m_) {
    result_.length_m += (p_m - *last_m_).norm();
  }
  last_m_ = p_m;
  robot::record_events(twin.program(), events_, [this](const robot::HallwayEvent& event) { count(event); });
  record_row(twin);
  if (keep_points_ && until_point_-- <= 0) {
    until_point_ = kPointEvery - 1;
    driven_.push_back({p_m, robot::to_s(twin.now())});
  }
}

void HallwayRecorder::count(const robot::HallwayEvent& event) {
  using Kind = robot::HallwayEventKind;
  result_.tags_read += event.kind == Kind::kTag || event.kind == Kind::kStrangeTag ? 1 : 0;
  result_.tags_missed += event.kind == Kind::kTagMissed ? 1 : 0;
  result_.turned_wrong += event.kind == Kind::kTurnedWrong ? 1 : 0;
  result_.blocked += event.kind == Kind::kBlocked ? 1 : 0;
  result_.explored += event.kind == Kind::kExplored ? 1 : 0;
  result_.went_round += event.kind == Kind::kWentRound ? 1 : 0;
}

void HallwayRecorder::record_row(const HallwayTwin& twin) {
  trace_.add(row_of(twin));
}

void HallwayRecorder::finish() {
  trace_.finish();
  events_.finish();
}

HallwayResult HallwayRecorder::result(const HallwayTwin& twin) const {
  HallwayResult result = result_;
  const robot::HallwayMap& map = scene_.hallways.map;
  result.minutes = robot::to_s(twin.now()) / 60.0;
  result.shoved = static_cast<int>(twin.world().contacts().shoves);
  result.wall_contacts = static_cast<int>(twin.world().contacts().wall);
  result.places = static_cast<int>(twin.program().map().nodes().size());
  result.detour = result.shortest_m > 0.0 ? result.length_m / result.shortest_m : 0.0;
  bool there = true;
  if (scene_.mission.hallway->survey) {
    result.map_differences = differences(map, twin.program().map());
  } else {
    const robot::NodeIndex goal = *map.find(scene_.mission.hallway->to);
    result.end_error_m = (*map.node(goal).at_m - twin.world().X_WR().p_m).norm();
    there = result.end_error_m < 0.5 * scene_.hallways.width_m;
  }
  result.arrived = twin.program().arrived() && there ? 1 : 0;
  return result;
}

}  // namespace sensotwin::twin
