// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_mission.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sensotwin::robot {
namespace {

/// The map's lengths are from middle to middle and drawn on a plan. Chosen: what a tape measure over a plan
/// is off.
constexpr double kLengthSlack = 0.10;
constexpr double kLengthSlack_m = 1.5;
/// Half hallways that may be looked for a first tag in, each way. Chosen: there and back once, and once more.
constexpr int kSearches = 4;
/// What a sonar of 15 degrees does not see of an opening at each of its ends, in parts of the distance.
constexpr double kConeTangent = 0.268;

}  // namespace

HallwayMission::HallwayMission(HallwayMissionConfig config)
    : config_(std::move(config)),
      tracker_(config_.robot),
      pilot_(config_.robot, tracker_, step_),
      script_(run()) {}

HallwayCommand HallwayMission::step(const HallwaySensed& sensed) {
  step_.sensed = sensed;
  tracker_.step(sensed);
  if (sensed.tag) {
    tag_ = sensed.tag;
  }
  // Without a compass it does not know which way it faces.
  if (!done() && tracker_.heading_rad()) {
    if (started_) {
      step_.next.resume();
    } else {
      started_ = true;
      script_.start();
    }
  }
  if (done()) {
    step_.command = {};
  }
  return step_.command;
}

Task<> HallwayMission::run() {
  status_.place = config_.start;
  if (!status_.place) {
    const bool found = co_await find_place();
    if (!found) {
      stop(HallwayEventKind::kLost);
      co_return;
    }
  }
  while (*status_.place != config_.goal) {
    const auto route = plan_route(config_.map, *status_.place, config_.goal, blocked_);
    if (!route) {
      stop(route.error() == RouteError::kNoWay ? HallwayEventKind::kNoWay : HallwayEventKind::kOnlyByUnknown);
      co_return;
    }
    say(HallwayEventKind::kRoute, config_.goal, {}, route->cost);
    const RouteStep first = route->steps.front();
    const bool went = co_await go_on(first);
    if (!went) {
      stop(HallwayEventKind::kLost);
      co_return;
    }
  }
  co_await pilot_.brake();
  status_.arrived = true;
  say(HallwayEventKind::kGoal, config_.goal);
}

Task<bool> HallwayMission::find_place() {
  CompassPoint heading = nearest_point(*tracker_.heading_rad());
  for (int i = 0; i < kSearches; ++i) {
    co_await pilot_.turn_to(heading);
    const Leg leg{std::nullopt, heading, std::nullopt, std::nullopt};
    const Passage passage = co_await go_along(leg);
    if (passage.end == End::kArrived) {
      say(HallwayEventKind::kPlaced, passage.at.node, passage.at.from);
      co_await come_to(passage, std::nullopt);
      co_return true;
    }
    heading = opposite(heading);
  }
  co_return false;
}

Task<bool> HallwayMission::go_on(RouteStep step) {
  co_await pilot_.turn_to(step.exit);
  status_.leaving = step.exit;
  status_.heading_for = step.to;
  say(HallwayEventKind::kLeft, step.from, step.exit);
  const Leg leg = leg_of(step.from, step.exit);
  Passage passage = co_await go_along(leg);
  if (passage.end == End::kBlocked) {
    say(HallwayEventKind::kBlocked, step.from, step.exit);
    blocked_.block(config_.map, step.from, step.exit);
    const double way_m = tracker_.way_m();
    const CompassPoint home = opposite(step.exit);
    co_await pilot_.turn_to(home);
    const Leg way_back{std::nullopt, home, step.from, way_m};
    passage = co_await go_along(way_back);
    status_.heading_for = step.from;
  }
  if (passage.end != End::kArrived) {
    // Nothing where a place should be: any tag will do.
    const bool found = co_await find_place();
    co_return found;
  }
  co_await come_to(passage, status_.heading_for);
  co_return true;
}

Task<HallwayMission::Passage> HallwayMission::go_along(Leg leg) {
  tracker_.enter(leg.heading);
  tag_.reset();
  const double longest_m = leg.length_m ? *leg.length_m * (1.0 + kLengthSlack) + config_.robot.overshoot_m
                                        : config_.robot.longest_m;
  while (tracker_.way_m() < longest_m) {
    pilot_.follow(config_.robot.speed_mps);
    co_await step_.next;
    if (const std::optional<Passage> passage = by_tag(leg)) {
      co_return *passage;
    }
    if (const std::optional<Passage> passage = by_sonar(leg)) {
      say(HallwayEventKind::kTagMissed, passage->at.node, passage->at.from);
      co_return *passage;
    }
    if (pilot_.in_the_way()) {
      const bool gone = co_await deal_with_obstacle();
      if (!gone) {
        co_return Passage{End::kBlocked, {}, 0.0};
      }
    }
  }
  co_await pilot_.brake();
  co_return Passage{End::kLost, {}, 0.0};
}

Task<bool> HallwayMission::deal_with_obstacle() {
  if (pilot_.bumped()) {
    say(HallwayEventKind::kBumped, status_.place);
    co_await pilot_.back(0.10);
  }
  co_await pilot_.brake();
  say(HallwayEventKind::kWaiting, status_.place);
  co_await pilot_.wait(config_.robot.patience);
  if (!pilot_.in_the_way()) {
    co_return true;
  }
  // The side with more room between the robot and its wall first.
  const bool left_first = tracker_.left_of_middle_m().value_or(0.0) >= 0.0;
  for (const bool left : {left_first, !left_first}) {
    const bool passed = co_await pilot_.pass_on(left);
    if (passed) {
      say(HallwayEventKind::kWentRound, status_.place);
      co_return true;
    }
  }
  co_return false;
}

Task<> HallwayMission::come_to(Passage passage, std::optional<NodeIndex> meant) {
  if (meant && *meant != passage.at.node) {
    say(HallwayEventKind::kElsewhere, passage.at.node, passage.at.from);
  }
  co_await pilot_.advance(passage.to_middle_m);
  status_.place = passage.at.node;
  status_.leaving.reset();
  status_.heading_for.reset();
}

std::optional<HallwayMission::Passage> HallwayMission::by_tag(Leg& leg) {
  const std::optional<TagNumber> tag = std::exchange(tag_, std::nullopt);
  if (!tag) {
    return std::nullopt;
  }
  const std::optional<Arrival> met = config_.map.place_of(*tag);
  if (!met) {
    say(HallwayEventKind::kStrangeTag, {}, {}, static_cast<double>(*tag));
    return std::nullopt;
  }
  say(HallwayEventKind::kTag, met->node, met->from);
  const bool just_left = leg.from == met->node && tracker_.way_m() < 2.0 * config_.robot.tag_to_middle_m;
  const bool ran_over = leg.to == met->node && leg.length_m && tracker_.way_m() > *leg.length_m &&
                        met->from != opposite(leg.heading);
  const bool leaving = just_left || ran_over || met->from == leg.heading;
  const CompassPoint heading = leaving ? met->from : opposite(met->from);
  if (heading != leg.heading) {
    say(HallwayEventKind::kTurnedWrong, met->node, met->from);
    tracker_.correct(quarter_turns_right(leg.heading, heading));
    blocked_.clear();  // whatever it met, it met elsewhere
  }
  if (!leaving) {
    say(HallwayEventKind::kArrived, met->node, met->from);
    return Passage{End::kArrived, *met, config_.robot.tag_to_middle_m};
  }
  if (heading != leg.heading || leg.from != met->node) {
    // The place ahead is another one than was thought.
    leg = leg_of(met->node, met->from);
    if (leg.length_m) {
      *leg.length_m -= config_.robot.tag_to_middle_m;
    }
    tracker_.enter(leg.heading);
    status_.place = met->node;
    status_.leaving = leg.heading;
    status_.heading_for = leg.to;
  }
  return std::nullopt;
}

bool HallwayMission::place_is_due(const Leg& leg, double slack_m) const {
  return !leg.length_m || tracker_.way_m() > *leg.length_m * (1.0 - kLengthSlack) - slack_m;
}

std::optional<HallwayMission::Passage> HallwayMission::by_sonar(const Leg& leg) const {
  // Not the junction that it is just leaving.
  if (!leg.to || tracker_.way_m() < 1.5 * config_.robot.tag_to_middle_m ||
      !place_is_due(leg, kLengthSlack_m)) {
    return std::nullopt;
  }
  const Arrival arrival{*leg.to, opposite(leg.heading)};
  const HallwayNode& node = config_.map.node(*leg.to);
  const auto leads = [&](int turn) {
    return node.side(turned_right(leg.heading, turn)).hallway != Hallway::kNone;
  };
  const double open_m =
      std::max(leads(-1) ? tracker_.left().open_for_m : 0.0, leads(1) ? tracker_.right().open_for_m : 0.0);
  if (open_m > config_.robot.opening_m) {
    const double half_m = 0.5 * tracker_.width_m();
    // The edge was seen for so long after it had been passed.
    const double since_edge_m = open_m + kConeTangent * half_m;
    return Passage{End::kArrived, arrival, std::max(0.0, 0.5 * config_.robot.hallway_width_m - since_edge_m)};
  }
  if (!leads(0) && pilot_.in_the_way() && !pilot_.bumped()) {
    const double to_middle_m =
        tracker_.ahead_m().value_or(0.0) + config_.robot.radius_m - 0.5 * config_.robot.hallway_width_m;
    return Passage{End::kArrived, arrival, std::max(0.0, to_middle_m)};
  }
  return std::nullopt;
}

HallwayMission::Leg HallwayMission::leg_of(NodeIndex from, CompassPoint exit) const {
  const Side& side = config_.map.node(from).side(exit);
  if (side.hallway != Hallway::kLeadsTo) {
    return {from, exit, std::nullopt, std::nullopt};
  }
  return {from, exit, side.to, side.length_m};
}

void HallwayMission::say(HallwayEventKind kind, std::optional<NodeIndex> place,
                         std::optional<CompassPoint> side, double value) {
  log_.add({step_.sensed.stamp, kind, place ? config_.map.node(*place).name : std::string{}, side, value});
}

void HallwayMission::stop(HallwayEventKind why) {
  status_.stopped = true;
  say(why, config_.goal);
}

}  // namespace sensotwin::robot
