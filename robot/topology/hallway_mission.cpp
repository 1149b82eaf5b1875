// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_mission.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sensotwin::robot {
namespace {

/// Half hallways that may be looked for a first tag in, each way. Chosen: there and back once, and once more.
constexpr int kSearches = 4;
/// Times that it goes back for a tag in a mission before it gives up. Chosen: one tag in ten missed makes one
/// or two.
constexpr int kLooks = 8;
/// A hallway that leaves within so much of the one it came by leads straight on. Chosen: the walls lead it
/// round that much.
constexpr double kStraight_rad = rad_from_deg(15.0);

}  // namespace

HallwayMission::HallwayMission(HallwayMissionConfig config)
    : config_(std::move(config)), walk_(config_.robot), script_(run()) {}

HallwayCommand HallwayMission::step(const HallwaySensed& sensed) {
  return walk_.step(sensed, script_, [this] { return done(); });
}

Task<> HallwayMission::run() {
  status_.place = config_.start;
  if (!status_.place) {
    const double axis_rad = yaw_rad_of(nearest_point(*walk_.tracker().heading_rad()));
    const bool found = co_await find_place(axis_rad);
    if (!found) {
      stop(HallwayEventKind::kLost);
      co_return;
    }
  }
  while (*status_.place != config_.goal) {
    const std::optional<Step> step = next_step();
    if (!step) {
      co_return;
    }
    const bool went = co_await go_on(step->from, step->exit, step->to);
    if (!went) {
      stop(HallwayEventKind::kLost);
      co_return;
    }
  }
  co_await walk_.pilot().brake();
  status_.arrived = true;
  say(HallwayEventKind::kGoal, config_.goal);
}

Task<bool> HallwayMission::find_place(double axis_rad) {
  for (int i = 0; i < kSearches; ++i) {
    co_await walk_.pilot().turn_to(axis_rad);
    HallwayLeg leg;
    leg.heading = nearest_point(axis_rad);
    leg.axis_rad = axis_rad;
    const HallwayPassage passage = co_await walk_.along(leg, *this);
    if (passage.end == PassageEnd::kArrived) {
      say(HallwayEventKind::kPlaced, passage.at.node, passage.at.from);
      co_await come_to(passage, std::nullopt);
      co_return true;
    }
    axis_rad = wrap_angle(axis_rad + kPi);
  }
  co_return false;
}

std::optional<HallwayMission::Step> HallwayMission::next_step() {
  const auto route = plan_route(config_.map, *status_.place, config_.goal, blocked_);
  if (route) {
    say(HallwayEventKind::kRoute, config_.goal, {}, route->cost);
    const RouteStep first = route->steps.front();
    return Step{first.from, first.exit, first.to};
  }
  if (route.error() == RouteError::kNoWay) {
    stop(HallwayEventKind::kNoWay);
    return std::nullopt;
  }
  const auto frontier = nearest_unknown(config_.map, *status_.place, heading_, blocked_);
  if (!config_.explore || !frontier) {
    stop(HallwayEventKind::kOnlyByUnknown);
    return std::nullopt;
  }
  if (frontier->route.steps.empty()) {
    return Step{frontier->node, frontier->exit, std::nullopt};
  }
  const RouteStep first = frontier->route.steps.front();
  return Step{first.from, first.exit, first.to};
}

Task<bool> HallwayMission::go_on(NodeIndex from, CompassPoint exit, std::optional<NodeIndex> to) {
  HallwayLeg leg = leg_of(from, exit);
  const double beyond_m = std::exchange(beyond_m_, 0.0);
  if (leg.length_m) {
    *leg.length_m -= beyond_m;
  }
  co_await walk_.pilot().turn_to(leg.axis_rad);
  status_.leaving = exit;
  status_.heading_for = to;
  say(HallwayEventKind::kLeft, from, exit);
  HallwayPassage passage = co_await walk_.along(leg, *this);
  passage.way_m += beyond_m;
  if (passage.end == PassageEnd::kBlocked) {
    say(HallwayEventKind::kBlocked, from, exit);
    blocked_.block(config_.map, from, exit);
    const double home_rad = wrap_angle(leg.axis_rad + kPi);
    co_await walk_.pilot().turn_to(home_rad);
    const HallwayLeg way_back{std::nullopt, opposite(exit), home_rad, from, passage.way_m};
    passage = co_await walk_.along(way_back, *this);
    status_.heading_for = from;
  }
  while (passage.end == PassageEnd::kArrived && passage.doubtful && !leads_on(passage)) {
    if (++looks_ > kLooks) {
      co_return false;
    }
    passage = co_await look_again(passage);
  }
  if (passage.end != PassageEnd::kArrived) {
    // Nothing where a place should be: any tag will do, and it may have gone past the one it seeks.
    const double back_rad = wrap_angle(walk_.tracker().axis_rad().value_or(leg.axis_rad) + kPi);
    const bool found = co_await find_place(back_rad);
    co_return found;
  }
  if (!to && status_.leaving == exit && !status_.heading_for && !unsure_) {
    learn(leg, passage);
  }
  co_await come_to(passage, status_.heading_for);
  co_return true;
}

bool HallwayMission::leads_on(const HallwayPassage& passage) const {
  const auto route = plan_route(config_.map, passage.at.node, config_.goal, blocked_);
  if (unsure_ || !route || route->steps.empty()) {
    return false;
  }
  const CompassPoint exit = route->steps.front().exit;
  const double bend_rad =
      wrap_angle(config_.map.node(passage.at.node).bearing_rad(exit) - *walk_.tracker().axis_rad());
  return exit == opposite(passage.at.from) && std::abs(bend_rad) < kStraight_rad;
}

void HallwayMission::learn(const HallwayLeg& leg, const HallwayPassage& passage) {
  const Side& far = config_.map.node(passage.at.node).side(passage.at.from);
  const bool straight = passage.at.from == opposite(leg.heading) && passage.at.node != *leg.from &&
                        far.hallway != Hallway::kLeadsTo && !far.bearing_rad &&
                        !config_.map.node(*leg.from).side(leg.heading).bearing_rad;
  if (!straight) {
    blocked_.block(config_.map, *leg.from, leg.heading);
    return;
  }
  const double length_m = passage.way_m + passage.to_middle_m;
  config_.map.connect(*leg.from, leg.heading, passage.at.node, length_m);
  say(HallwayEventKind::kExplored, passage.at.node, passage.at.from, length_m);
}

Task<HallwayPassage> HallwayMission::look_again(HallwayPassage doubted) {
  say(HallwayEventKind::kLooksAgain, doubted.at.node, doubted.at.from);
  const double home_rad = wrap_angle(*walk_.tracker().axis_rad() + kPi);
  const Side& side = config_.map.node(doubted.at.node).side(doubted.at.from);
  const double advanced_m = std::max(0.0, doubted.to_middle_m);
  co_await walk_.pilot().advance(advanced_m);
  co_await walk_.pilot().turn_to(home_rad);
  HallwayLeg back;
  back.heading = doubted.at.from;
  back.axis_rad = home_rad;
  back.behind_m = tag_to_middle_m(doubted.at.node, doubted.at.from) + walk_.config().tag_reach_m +
                  std::abs(doubted.to_middle_m);
  if (side.hallway == Hallway::kLeadsTo) {
    back.to = side.to;
    back.length_m = doubted.way_m + advanced_m;
  }
  doubted_ = doubted.at;
  const HallwayPassage passage = co_await walk_.along(back, *this);
  doubted_.reset();
  co_return passage;
}

Task<> HallwayMission::come_to(HallwayPassage passage, std::optional<NodeIndex> meant) {
  if (meant && *meant != passage.at.node) {
    say(HallwayEventKind::kElsewhere, passage.at.node, passage.at.from);
  }
  unsure_ = passage.doubtful;
  if (unsure_) {
    say(HallwayEventKind::kGoesOn, passage.at.node, passage.at.from);
    beyond_m_ = std::max(0.0, -passage.to_middle_m);
    passage.to_middle_m += beyond_m_;
  }
  if (passage.to_middle_m < 0.0) {
    const double back_rad = wrap_angle(*walk_.tracker().axis_rad() + kPi);
    walk_.tracker().enter(back_rad);
    co_await walk_.pilot().face_axis();
  }
  co_await walk_.pilot().advance(std::abs(passage.to_middle_m));
  status_.place = passage.at.node;
  heading_ = opposite(passage.at.from);
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
  const double to_middle_m = tag_to_middle_m(met->node, met->from);
  const bool not_yet_there = unsure_ && leg.from == met->node && met->from == opposite(leg.heading);
  unsure_ = false;
  const bool just_left =
      leg.from == met->node && walk_.tracker().along_m() < 2.0 * to_middle_m && !not_yet_there;
  const bool ran_over = leg.to == met->node && leg.length_m && walk_.tracker().along_m() > *leg.length_m &&
                        met->from != opposite(leg.heading);
  const bool leaving = just_left || ran_over || met->from == leg.heading;
  const CompassPoint heading = leaving ? met->from : opposite(met->from);
  if (heading != leg.heading) {
    say(HallwayEventKind::kTurnedWrong, met->node, met->from);
    const double out_rad = config_.map.node(met->node).bearing_rad(met->from);
    const double truly_rad = leaving ? out_rad : wrap_angle(out_rad + kPi);
    walk_.tracker().correct(wrap_angle(truly_rad - leg.axis_rad));
    blocked_.clear();  // whatever it met, it met elsewhere
  }
  if (!leaving) {
    say(HallwayEventKind::kArrived, met->node, met->from);
    return HallwayPassage{PassageEnd::kArrived, *met, to_middle_m + walk_.config().tag_reach_m, 0.0};
  }
  if (heading == leg.heading && run_past(leg, *met)) {
    say(HallwayEventKind::kArrived, met->node, met->from);
    return HallwayPassage{PassageEnd::kArrived, *met, walk_.config().tag_reach_m - to_middle_m, 0.0};
  }
  if (heading != leg.heading || leg.from != met->node) {
    // The place ahead is another one than was thought.
    leg = leg_of(met->node, met->from);
    if (leg.length_m) {
      *leg.length_m -= to_middle_m;
    }
    walk_.tracker().enter(leg.axis_rad);
    status_.place = met->node;
    status_.leaving = leg.heading;
    status_.heading_for = leg.to;
  }
  return std::nullopt;
}

bool HallwayMission::run_past(const HallwayLeg& leg, const Arrival& met) const {
  if (doubted_ && doubted_->node == met.node && doubted_->from == met.from) {
    return true;
  }
  if (leg.to != met.node || leg.from == met.node) {
    return false;
  }
  const auto route = plan_route(config_.map, met.node, config_.goal, blocked_);
  return !route || route->steps.empty() || route->steps.front().exit != met.from;
}

std::optional<HallwayPassage> HallwayMission::by_sonar(const HallwayLeg& leg) {
  const HallwayConfig& robot = walk_.config();
  const double way_m = walk_.tracker().along_m();
  if (!leg.to ||
      (leg.length_m && way_m < *leg.length_m * (1.0 - robot.length_slack) - robot.length_slack_m)) {
    return std::nullopt;
  }
  std::optional<double> to_middle_m = seen_ahead_m(leg);
  bool doubtful = unsure_ || walk_.tracker().compass_astray() || (walk_.hindered() && !leg.length_m);
  if (leg.length_m) {
    const double sure_m = *leg.length_m * robot.sure_slack + robot.sure_slack_m;
    if (!to_middle_m && way_m > *leg.length_m + sure_m) {
      to_middle_m = *leg.length_m - way_m;  // no sonar sees it, and it has to be behind
      doubtful = true;
    }
    doubtful = doubtful || std::abs(way_m + to_middle_m.value_or(0.0) - *leg.length_m) > sure_m;
  }
  if (!to_middle_m) {
    return std::nullopt;
  }
  const Arrival arrival{*leg.to, opposite(leg.heading)};
  if (!doubtful) {
    say(HallwayEventKind::kTagMissed, arrival.node, arrival.from);
  }
  return HallwayPassage{PassageEnd::kArrived, arrival, *to_middle_m, 0.0, doubtful};
}

std::optional<double> HallwayMission::seen_ahead_m(const HallwayLeg& leg) const {
  const auto leads = [&](int turn) {
    return config_.map.node(*leg.to).side(turned_right(leg.heading, turn)).hallway != Hallway::kNone;
  };
  std::optional<double> to_middle_m =
      walk_.opening_ahead_m(leads(-1), leads(1), tag_to_middle_m(*leg.to, opposite(leg.heading)));
  if (!to_middle_m && !leads(0)) {
    to_middle_m = walk_.end_ahead_m();
  }
  return to_middle_m;
}

HallwayLeg HallwayMission::leg_of(NodeIndex from, CompassPoint exit) const {
  const Side& side = config_.map.node(from).side(exit);
  const double bearing_rad = config_.map.node(from).bearing_rad(exit);
  if (side.hallway != Hallway::kLeadsTo) {
    return {from, exit, bearing_rad, std::nullopt, std::nullopt};
  }
  return {from, exit, bearing_rad, side.to, side.length_m, tag_to_middle_m(side.to, opposite(exit))};
}

double HallwayMission::tag_to_middle_m(NodeIndex node, CompassPoint side) const {
  return config_.map.node(node).side(side).tag_m.value_or(walk_.config().tag_to_middle_m);
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
