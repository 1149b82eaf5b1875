// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_mission.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sensotwin::robot {
namespace {

/// Half hallways that may be looked for a first tag in, each way. Chosen: there and back once, and once more.
constexpr int kSearches = 4;

}  // namespace

HallwayMission::HallwayMission(HallwayMissionConfig config)
    : config_(std::move(config)), walk_(config_.robot), script_(run()) {}

HallwayCommand HallwayMission::step(const HallwaySensed& sensed) {
  return walk_.step(sensed, script_, [this] { return done(); });
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
  co_await walk_.pilot().brake();
  status_.arrived = true;
  say(HallwayEventKind::kGoal, config_.goal);
}

Task<bool> HallwayMission::find_place() {
  CompassPoint heading = nearest_point(*walk_.tracker().heading_rad());
  for (int i = 0; i < kSearches; ++i) {
    co_await walk_.pilot().turn_to(heading);
    const HallwayLeg leg{std::nullopt, heading, std::nullopt, std::nullopt};
    const HallwayPassage passage = co_await walk_.along(leg, *this);
    if (passage.end == PassageEnd::kArrived) {
      say(HallwayEventKind::kPlaced, passage.at.node, passage.at.from);
      co_await come_to(passage, std::nullopt);
      co_return true;
    }
    heading = opposite(heading);
  }
  co_return false;
}

Task<bool> HallwayMission::go_on(RouteStep step) {
  co_await walk_.pilot().turn_to(step.exit);
  status_.leaving = step.exit;
  status_.heading_for = step.to;
  say(HallwayEventKind::kLeft, step.from, step.exit);
  const HallwayLeg leg = leg_of(step.from, step.exit);
  HallwayPassage passage = co_await walk_.along(leg, *this);
  if (passage.end == PassageEnd::kBlocked) {
    say(HallwayEventKind::kBlocked, step.from, step.exit);
    blocked_.block(config_.map, step.from, step.exit);
    const CompassPoint home = opposite(step.exit);
    co_await walk_.pilot().turn_to(home);
    const HallwayLeg way_back{std::nullopt, home, step.from, passage.way_m};
    passage = co_await walk_.along(way_back, *this);
    status_.heading_for = step.from;
  }
  if (passage.end != PassageEnd::kArrived) {
    // Nothing where a place should be: any tag will do.
    const bool found = co_await find_place();
    co_return found;
  }
  co_await come_to(passage, status_.heading_for);
  co_return true;
}

Task<> HallwayMission::come_to(HallwayPassage passage, std::optional<NodeIndex> meant) {
  if (meant && *meant != passage.at.node) {
    say(HallwayEventKind::kElsewhere, passage.at.node, passage.at.from);
  }
  co_await walk_.pilot().advance(passage.to_middle_m);
  status_.place = passage.at.node;
  status_.leaving.reset();
  status_.heading_for.reset();
}

std::optional<HallwayPassage> HallwayMission::by_tag(HallwayLeg& leg, TagNumber tag) {
  const std::optional<Arrival> met = config_.map.place_of(tag);
  if (!met) {
    say(HallwayEventKind::kStrangeTag, {}, {}, static_cast<double>(tag));
    return std::nullopt;
  }
  say(HallwayEventKind::kTag, met->node, met->from);
  const bool just_left =
      leg.from == met->node && walk_.tracker().way_m() < 2.0 * walk_.config().tag_to_middle_m;
  const bool ran_over = leg.to == met->node && leg.length_m && walk_.tracker().way_m() > *leg.length_m &&
                        met->from != opposite(leg.heading);
  const bool leaving = just_left || ran_over || met->from == leg.heading;
  const CompassPoint heading = leaving ? met->from : opposite(met->from);
  if (heading != leg.heading) {
    say(HallwayEventKind::kTurnedWrong, met->node, met->from);
    walk_.tracker().correct(quarter_turns_right(leg.heading, heading));
    blocked_.clear();  // whatever it met, it met elsewhere
  }
  if (!leaving) {
    say(HallwayEventKind::kArrived, met->node, met->from);
    return HallwayPassage{PassageEnd::kArrived, *met, walk_.tag_to_middle_m(), 0.0};
  }
  if (heading != leg.heading || leg.from != met->node) {
    // The place ahead is another one than was thought.
    leg = leg_of(met->node, met->from);
    if (leg.length_m) {
      *leg.length_m -= walk_.config().tag_to_middle_m;
    }
    walk_.tracker().enter(leg.heading);
    status_.place = met->node;
    status_.leaving = leg.heading;
    status_.heading_for = leg.to;
  }
  return std::nullopt;
}

std::optional<HallwayPassage> HallwayMission::by_sonar(const HallwayLeg& leg) {
  const HallwayConfig& robot = walk_.config();
  const double way_m = walk_.tracker().way_m();
  // Not the junction that it is just leaving.
  if (!leg.to || way_m < 1.5 * robot.tag_to_middle_m ||
      (leg.length_m && way_m < *leg.length_m * (1.0 - robot.length_slack) - robot.length_slack_m)) {
    return std::nullopt;
  }
  const auto leads = [&](int turn) {
    return config_.map.node(*leg.to).side(turned_right(leg.heading, turn)).hallway != Hallway::kNone;
  };
  std::optional<double> to_middle_m = walk_.opening_ahead_m(leads(-1), leads(1));
  if (!to_middle_m && !leads(0)) {
    to_middle_m = walk_.end_ahead_m();
  }
  if (!to_middle_m) {
    return std::nullopt;
  }
  const Arrival arrival{*leg.to, opposite(leg.heading)};
  say(HallwayEventKind::kTagMissed, arrival.node, arrival.from);
  return HallwayPassage{PassageEnd::kArrived, arrival, *to_middle_m, 0.0};
}

HallwayLeg HallwayMission::leg_of(NodeIndex from, CompassPoint exit) const {
  const Side& side = config_.map.node(from).side(exit);
  if (side.hallway != Hallway::kLeadsTo) {
    return {from, exit, std::nullopt, std::nullopt};
  }
  return {from, exit, side.to, side.length_m};
}

void HallwayMission::say(HallwayEventKind kind, std::optional<NodeIndex> place,
                         std::optional<CompassPoint> side, double value) {
  walk_.say(kind, place ? config_.map.node(*place).name : std::string{}, side, value);
}

void HallwayMission::stop(HallwayEventKind why) {
  status_.stopped = true;
  say(why, config_.goal);
}

}  // namespace sensotwin::robot
