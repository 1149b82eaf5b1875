// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_survey.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sensotwin::robot {
namespace {

/// Along the first hallway, each way. Chosen: there and back.
constexpr int kFirstTries = 2;
constexpr std::size_t kLeft = 0;
constexpr std::size_t kAhead = 1;
constexpr std::size_t kRight = 2;
/// Of the sonars: square to the left, ahead, square to the right.
constexpr std::array<std::size_t, 3> kLook{0, 3, 6};
constexpr std::array<int, 3> kLookTurn{-1, 0, 1};

/// A unit step on the plan: x east, y north.
Vec2 towards(CompassPoint point) {
  const double yaw_rad = yaw_rad_of(point);
  return {-std::round(std::sin(yaw_rad)), std::round(std::cos(yaw_rad))};
}

HallwayLeg leg_by(CompassPoint heading) {
  HallwayLeg leg;
  leg.heading = heading;
  leg.axis_rad = yaw_rad_of(heading);
  return leg;
}

}  // namespace

HallwaySurvey::HallwaySurvey(const HallwaySurveyConfig& config)
    : config_(config), walk_(config.robot), script_(run()) {}

HallwayCommand HallwaySurvey::step(const HallwaySensed& sensed) {
  return walk_.step(sensed, script_, [this] { return done(); });
}

Task<> HallwaySurvey::run() {
  const bool begun = co_await begin();
  bool well = begun;
  while (well) {
    const std::optional<Frontier> frontier = nearest_unknown(map_, *here_, heading_, blocked_);
    if (!frontier) {
      break;
    }
    HallwayLeg leg = leg_by(frontier->exit);
    leg.from = here_;
    if (!frontier->route.steps.empty()) {
      const RouteStep first = frontier->route.steps.front();
      leg = leg_by(first.exit);
      leg.from = here_;
      leg.to = first.to;
      leg.length_m = map_.node(first.from).side(first.exit).length_m;
    }
    well = co_await go(leg);
  }
  co_await walk_.pilot().brake();
  whole_ = well;
  lost_ = !well;
  say(well ? HallwayEventKind::kMapWhole : HallwayEventKind::kLost);
}

Task<bool> HallwaySurvey::begin() {
  heading_ = nearest_point(*walk_.tracker().heading_rad());
  for (int i = 0; i < kFirstTries; ++i) {
    co_await walk_.pilot().turn_to(yaw_rad_of(heading_));
    const HallwayLeg leg = leg_by(heading_);
    const HallwayPassage passage = co_await walk_.along(leg, *this);
    if (passage.end == PassageEnd::kArrived) {
      co_await come_to_first(passage);
      co_return true;
    }
    heading_ = opposite(heading_);
  }
  co_return false;
}

Task<> HallwaySurvey::come_to_first(HallwayPassage passage) {
  co_await walk_.pilot().advance(passage.to_middle_m);
  OpenSides open = co_await look();
  here_ = map_.add("n1", Vec2{0.0, 0.0});
  CompassPoint tag_side = opposite(heading_);
  if (open[kAhead] && !open[kLeft] && !open[kRight]) {
    // A hallway goes through and nothing else: the tag was of the place behind, which it has come from.
    tag_side = heading_;
    heading_ = opposite(heading_);
    co_await walk_.pilot().turn_to(yaw_rad_of(heading_));
    walk_.tracker().enter(yaw_rad_of(heading_));
    co_await walk_.pilot().advance(2.0 * config_.robot.tag_to_middle_m);
    open = co_await look();
  }
  map_.set_hallway(*here_, opposite(heading_), Hallway::kUnknown);
  note(open);
  if (new_tag_) {
    map_.add_tag(*here_, tag_side, *new_tag_);
    new_tag_.reset();
  }
}

Task<bool> HallwaySurvey::go(HallwayLeg leg) {
  co_await walk_.pilot().turn_to(leg.axis_rad);
  heading_ = leg.heading;
  say(HallwayEventKind::kLeft, leg.heading);
  new_tag_.reset();
  HallwayPassage passage = co_await walk_.along(leg, *this);
  if (passage.end == PassageEnd::kBlocked && !leg.to && passage.way_m > 2.0 * walk_.tag_to_middle_m()) {
    // Nobody and nothing that went away or could be passed: the end of the hallway, its tag not read.
    passage.end = PassageEnd::kArrived;
    passage.to_middle_m = walk_.config().stop_m + walk_.config().radius_m - 0.5 * walk_.tracker().width_m();
    say(HallwayEventKind::kTagMissed, opposite(leg.heading));
  }
  if (passage.end == PassageEnd::kBlocked) {
    say(HallwayEventKind::kBlocked, leg.heading);
    blocked_.block(map_, *leg.from, leg.heading);
    const double way_m = passage.way_m;
    heading_ = opposite(leg.heading);
    leg = {std::nullopt, heading_, yaw_rad_of(heading_), leg.from, way_m};
    co_await walk_.pilot().turn_to(leg.axis_rad);
    passage = co_await walk_.along(leg, *this);
  }
  if (passage.end != PassageEnd::kArrived) {
    co_return false;
  }
  co_await come_to(leg, passage);
  co_return true;
}

Task<> HallwaySurvey::come_to(HallwayLeg leg, HallwayPassage passage) {
  co_await walk_.pilot().advance(passage.to_middle_m);
  const CompassPoint side = opposite(leg.heading);
  const double length_m = passage.way_m + passage.to_middle_m;
  if (leg.to) {
    here_ = leg.to;
    co_return;
  }
  Vec2 at_m{0.0, 0.0};
  if (leg.from) {
    at_m = *map_.node(*leg.from).at_m + length_m * towards(leg.heading);
  }
  std::optional<NodeIndex> place;
  if (!new_tag_ && passage.at.from == side && passage.at.node < map_.nodes().size()) {
    place = passage.at.node;
  } else {
    place = place_at(at_m, side);
  }
  const bool fresh = !place;
  here_ = place ? *place : map_.add("n" + std::to_string(map_.nodes().size() + 1), at_m);
  if (leg.from && *leg.from != *here_) {
    map_.connect(*leg.from, leg.heading, *here_, length_m);
  }
  if (new_tag_) {
    map_.add_tag(*here_, side, *new_tag_);
    new_tag_.reset();
  }
  if (fresh) {
    const OpenSides open = co_await look();
    note(open);
  }
}

Task<HallwaySurvey::OpenSides> HallwaySurvey::look() {
  std::array<std::vector<double>, kLook.size()> seen;
  const Instant until = walk_.step().sensed.stamp + config_.look;
  while (walk_.step().sensed.stamp < until) {
    co_await walk_.step().next;
    if (const auto& ranges = walk_.step().sensed.ranges_m) {
      for (std::size_t i = 0; i < kLook.size(); ++i) {
        seen[i].push_back((*ranges)[kLook[i]].value_or(config_.robot.sonar_range_m));
      }
    }
  }
  const double wall_m = 0.5 * walk_.tracker().width_m() - config_.robot.sonar_radius_m;
  OpenSides open{};
  for (std::size_t i = 0; i < kLook.size(); ++i) {
    std::vector<double>& ranges = seen[i];
    const auto middle = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() / 2);
    std::nth_element(ranges.begin(), middle, ranges.end());
    open[i] = !ranges.empty() && *middle > wall_m + config_.open_m;
  }
  co_return open;
}

void HallwaySurvey::note(const OpenSides& open) {
  for (std::size_t i = 0; i < open.size(); ++i) {
    const CompassPoint side = turned_right(heading_, kLookTurn[i]);
    if (open[i] && map_.node(*here_).side(side).hallway == Hallway::kNone) {
      map_.set_hallway(*here_, side, Hallway::kUnknown);
    }
  }
}

std::optional<HallwayPassage> HallwaySurvey::by_tag(HallwayLeg& leg, TagNumber tag) {
  const HallwayPassage arrival{
      PassageEnd::kArrived, {map_.nodes().size(), opposite(leg.heading)}, walk_.tag_to_middle_m(), 0.0};
  const bool just_left = leg.from && walk_.tracker().way_m() < 2.0 * config_.robot.tag_to_middle_m;
  const std::optional<Arrival> met = map_.place_of(tag);
  say(HallwayEventKind::kTag, leg.heading, static_cast<double>(tag));
  if (just_left) {
    if (!met) {
      map_.add_tag(*leg.from, leg.heading, tag);
    }
    return std::nullopt;
  }
  if (!met) {
    new_tag_ = tag;
    // Of a place that is known, by a side whose tag was missed before.
    return arrival;
  }
  if (met->from != opposite(leg.heading)) {
    return std::nullopt;
  }
  HallwayPassage known = arrival;
  known.at = *met;
  return known;
}

std::optional<HallwayPassage> HallwaySurvey::by_sonar(const HallwayLeg& leg) {
  const HallwayConfig& robot = config_.robot;
  const double way_m = walk_.tracker().way_m();
  const bool due = !leg.length_m || way_m > *leg.length_m * (1.0 - robot.length_slack) - robot.length_slack_m;
  if (way_m < 1.5 * robot.tag_to_middle_m || !due) {
    return std::nullopt;
  }
  std::optional<double> to_middle_m = walk_.opening_ahead_m(true, true, 0.5 * walk_.tracker().width_m());
  if (!to_middle_m && leg.to) {
    to_middle_m = walk_.end_ahead_m();
  }
  if (!to_middle_m) {
    return std::nullopt;
  }
  say(HallwayEventKind::kTagMissed, opposite(leg.heading));
  return HallwayPassage{
      PassageEnd::kArrived, {map_.nodes().size(), opposite(leg.heading)}, *to_middle_m, 0.0};
}

std::optional<NodeIndex> HallwaySurvey::place_at(const Vec2& at_m, CompassPoint side) const {
  std::optional<NodeIndex> nearest;
  double nearest_m = config_.same_place_m;
  for (NodeIndex i = 0; i < map_.nodes().size(); ++i) {
    const double away_m = (*map_.node(i).at_m - at_m).norm();
    if (away_m < nearest_m && map_.node(i).side(side).hallway != Hallway::kLeadsTo) {
      nearest = i;
      nearest_m = away_m;
    }
  }
  return nearest;
}

void HallwaySurvey::say(HallwayEventKind kind, std::optional<CompassPoint> side, double value) {
  walk_.say(kind, here_ ? map_.node(*here_).name : std::string{}, side, value);
}

}  // namespace sensotwin::robot
