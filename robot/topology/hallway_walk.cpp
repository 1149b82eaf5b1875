// SPDX-License-Identifier: MIT
#include "robot/topology/hallway_walk.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sensotwin::robot {
namespace {

/// What a sonar of 15 degrees does not see of an opening at each of its ends, in parts of the distance.
constexpr double kConeTangent = 0.268;
/// Back from what was touched. Chosen: the forward sonars see it from there.
constexpr double kBackOff_m = 0.10;
/// So long it looks again whether what is ahead is the end of the hallway. Chosen: five rounds.
constexpr Duration kSecondLook{std::chrono::milliseconds{500}};
/// So far off the hallway's direction nobody gets by following it. Chosen: half a quarter turn.
constexpr double kAstray_rad = 0.25 * kPi;
/// Within so much way it is the same thing that stands there. Chosen: a piece of furniture.
constexpr double kSameThing_m = 1.0;

}  // namespace

void HallwayWalk::take(const HallwaySensed& sensed) {
  step_.sensed = sensed;
  tracker_.step(sensed);
  if (const std::optional<double> turned_rad = tracker_.take_turned_rad()) {
    say(HallwayEventKind::kTurnedByHand, {}, {}, *turned_rad);
  }
  if (sensed.tag) {
    tag_ = sensed.tag;
  }
}

Task<HallwayPassage> HallwayWalk::along(HallwayLeg leg, PlaceWatcher& watcher) {
  tracker_.enter(leg.axis_rad);
  waited_m_ = -kSameThing_m;
  hindered_ = false;
  tag_.reset();
  // Of the leg as it stands: a tag may set it right.
  const auto longest_m = [&] {
    return leg.length_m ? *leg.length_m * (1.0 + config_.length_slack) + config_.overshoot_m
                        : config_.longest_m;
  };
  HallwayPassage passage;
  while (tracker_.along_m() < longest_m()) {
    if (std::abs(tracker_.off_axis_rad()) > kAstray_rad) {
      co_await pilot_.face_axis();
    }
    const double along_m = tracker_.along_m();
    const bool in_place = along_m < leg.behind_m || (leg.length_m && along_m > *leg.length_m - leg.ahead_m);
    pilot_.follow(config_.speed_mps, !in_place);
    co_await step_.next;
    const std::optional<TagNumber> tag = std::exchange(tag_, std::nullopt);
    std::optional<HallwayPassage> found = tag ? watcher.by_tag(leg, *tag) : std::nullopt;
    if (!found) {
      found = watcher.by_sonar(leg);
    }
    if (found) {
      found->way_m = tracker_.along_m();
      co_return *found;
    }
    if (pilot_.in_the_way() && !pilot_.bumped()) {
      // The end of a hallway may not have answered in one round.
      co_await pilot_.brake();
      const Instant until = step_.sensed.stamp + kSecondLook;
      while (!found && step_.sensed.stamp < until) {
        co_await step_.next;
        found = watcher.by_sonar(leg);
      }
      if (found) {
        found->way_m = tracker_.along_m();
        co_return *found;
      }
    }
    if (pilot_.in_the_way()) {
      hindered_ = true;
      const bool gone = co_await past_obstacle();
      if (!gone) {
        passage.end = PassageEnd::kBlocked;
        break;
      }
    }
  }
  co_await pilot_.brake();
  passage.way_m = tracker_.along_m();
  co_return passage;
}

Task<bool> HallwayWalk::past_obstacle() {
  if (pilot_.bumped()) {
    say(HallwayEventKind::kBumped);
    co_await pilot_.back(kBackOff_m);
  }
  co_await pilot_.brake();
  // What did not go away a moment ago is furniture.
  if (tracker_.way_m() > waited_m_ + kSameThing_m || tracker_.way_m() < waited_m_) {
    say(HallwayEventKind::kWaiting);
    co_await pilot_.wait(config_.patience);
  }
  waited_m_ = tracker_.way_m();
  if (!pilot_.in_the_way()) {
    co_return true;
  }
  // The side with more room between the robot and its wall first.
  const bool left_first = tracker_.left_of_middle_m().value_or(0.0) >= 0.0;
  for (const bool left : {left_first, !left_first}) {
    const bool passed = co_await pilot_.pass_on(left);
    if (passed) {
      say(HallwayEventKind::kWentRound);
      co_return true;
    }
  }
  co_return false;
}

std::optional<double> HallwayWalk::opening_ahead_m(bool left, bool right, double edge_to_middle_m) const {
  const WallSide none;
  const WallSide& on_left = left ? tracker_.left() : none;
  const WallSide& on_right = right ? tracker_.right() : none;
  const WallSide& wider = on_left.open_for_m > on_right.open_for_m ? on_left : on_right;
  if (wider.open_for_m <= config_.opening_m) {
    return std::nullopt;
  }
  // The edge was seen for so long after it had been passed.
  const double since_edge_m = wider.open_for_m + kConeTangent * wider.last_m.value_or(0.0);
  return std::max(0.0, edge_to_middle_m - since_edge_m);
}

std::optional<double> HallwayWalk::end_ahead_m() const {
  if (!pilot_.in_the_way() || pilot_.bumped() || !tracker_.wall_ahead()) {
    return std::nullopt;
  }
  return std::max(0.0, tracker_.ahead_m().value_or(0.0) + config_.radius_m - 0.5 * tracker_.width_m());
}

void HallwayWalk::say(HallwayEventKind kind, std::string place, std::optional<CompassPoint> side,
                      double value) {
  log_.add({step_.sensed.stamp, kind, std::move(place), side, value});
}

}  // namespace sensotwin::robot
