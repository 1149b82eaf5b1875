// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "robot/phase/estimation/ceiling_mission.hpp"

namespace sensotwin::robot {
namespace {

constexpr double kSearching_radps = 1.0;
/// A search: once round on the spot, then once round a circle of this radius. Chosen: another quarter
/// wavelength of echoes at every step, within reach of any hallway.
constexpr double kSearchRadius_m = 0.3;
constexpr double kSearching_mps = 0.1;
/// A tag that did not answer once while the robot turned round so often is missing.
constexpr int kSilentTurns = 2;
/// One sigma of a place that is not relied on without reads. Chosen: the robot's radius.
constexpr double kHardly_m = 0.17;
constexpr double kUnconfirmed_s = 2.0;  ///< and is not driven to for longer. Chosen: a turn, and 0.2 m
/// The order is judged when the robot is this far on its way, if not before. Chosen: twice the width of a
/// door.
constexpr double kOrderWay_m = 2.0;
/// A doubt must last: a wrong guess of a place does not. Chosen: ten hops of an R420 (data study, 3.8).
constexpr double kOrderDoubted_s = 2.0;
constexpr double kOrderSigmas = 3.0;  ///< chosen: as kMovedSigmas of the estimator
/// On one leg. Chosen: most legs need none; a tag that shows itself and hides that often is not found.
constexpr int kMostLooks = 40;
/// A tag read this long ago is still in hearing. Chosen: ten rounds of four ports of an R420 (data
/// study, 3.8).
constexpr double kInHearing_s = 1.0;

}  // namespace

const char* say(CeilingEventKind kind) {
  switch (kind) {
    case CeilingEventKind::kTagFound:
      return "a tag's place is known";
    case CeilingEventKind::kTagReached:
      return "reached a tag";
    case CeilingEventKind::kTagMissing:
      return "the next tag is not heard";
    case CeilingEventKind::kTagSilent:
      return "the next tag is silent and driven to by its estimate";
    case CeilingEventKind::kTagSkipped:
      return "skipped a tag";
    case CeilingEventKind::kTagLost:
      return "a tag's reads do not fit its place any more";
    case CeilingEventKind::kTagMoved:
      return "a tag was moved";
    case CeilingEventKind::kOrderDoubtful:
      return "two tags of the list seem exchanged";
    case CeilingEventKind::kOrderExchanged:
      return "goes on with the two exchanged";
    case CeilingEventKind::kReaderSilent:
      return "the reader is silent";
    case CeilingEventKind::kReaderBack:
      return "the reader is heard again";
    case CeilingEventKind::kCablesSwapped:
      return "the antenna cables are swapped, left for right";
    case CeilingEventKind::kCablesDoubted:
      return "perhaps the antenna cables are not swapped after all: seeks all tags anew";
    case CeilingEventKind::kBump:
      return "bumped into something";
    case CeilingEventKind::kSearching:
      return "searches for the next tag";
    case CeilingEventKind::kOffPath:
      return "is too far from the path, or does not know it well enough";
    case CeilingEventKind::kStopped:
      return "stopped for good";
    case CeilingEventKind::kArrived:
      return "arrived";
  }
  return "";
}

void CeilingMission::hear_estimator() {
  for (const EstimatorEvent& event : estimator_.events()) {
    switch (event.kind) {
      case EstimatorEventKind::kTagFound:
        note(CeilingEventKind::kTagFound, event.tag);
        break;
      case EstimatorEventKind::kTagLost:
        note(CeilingEventKind::kTagLost, event.tag);
        break;
      case EstimatorEventKind::kTagMoved:
        note(CeilingEventKind::kTagMoved, event.tag, event.distance_m);
        break;
      case EstimatorEventKind::kCablesSwapped:
        note(CeilingEventKind::kCablesSwapped);
        break;
      case EstimatorEventKind::kWiringAsGiven:
        break;
      case EstimatorEventKind::kWiringDoubted:
        note(CeilingEventKind::kCablesDoubted);
        looks_ = 0;
        break;
    }
  }
  estimator_.forget_events();
}

void CeilingMission::watch_reader(const PhaseSensed& sensed) {
  const Instant last = estimator_.heard().value_or(leg_since_);
  // On the way to a first tag whose place is not known, hearing none is no wonder: the robot looks for it.
  const bool expected = leg_ > 0 || estimator_.tag(route_[destination()]).knowledge >= TagKnowledge::kTracked;
  const bool silent = !sensed.reader_up || (expected && to_s(now_ - last) > config_.faults.silent_after_s);
  if (silent && !reader_silent_) {
    silent_since_ = last;
    blind_m_ = 0.0;
    reader_silence_said_ = false;
  }
  reader_was_up_ = reader_was_up_ || sensed.reader_up;
  // One that is still being set up when the mission begins has not fallen silent.
  const bool late = reader_was_up_ || to_s(now_ - silent_since_) > config_.faults.silent_after_s;
  if (silent && late && !reader_silence_said_) {
    reader_silence_said_ = true;
    note(CeilingEventKind::kReaderSilent);
  }
  if (!silent && reader_silent_) {
    if (reader_silence_said_) {
      note(CeilingEventKind::kReaderBack, std::nullopt, to_s(now_ - silent_since_));
    }
    leg_since_ = now_;
    if (mode_ == CeilingMode::kWaiting) {
      mode_ = CeilingMode::kDriving;
    }
  }
  reader_silent_ = silent;
  reader_up_ = sensed.reader_up;
  if (!silent) {
    return;
  }
  blind_m_ += std::abs(step_m_);
  if (blind_m_ > config_.faults.blind_way_m && mode_ != CeilingMode::kBackingOff) {
    if (leg_ == 0 && reader_up_) {
      // It drove where it took the first tag to be, and hears nothing there: the place was wrong.
      estimator_.seek_anew(route_[destination()]);
      reader_silent_ = false;
      return;
    }
    mode_ = CeilingMode::kWaiting;
  }
  if (to_s(now_ - silent_since_) > config_.faults.give_up_s) {
    finish(false);
  }
}

void CeilingMission::watch_destination() {
  if (reader_silent_ || mode_ == CeilingMode::kFinished || mode_ == CeilingMode::kSearching) {
    return;
  }
  const TagEstimate sought = estimator_.tag(route_[destination()]);
  const Instant since = last_chance(sought);
  const double unheard_s = to_s(now_ - since);
  // One whose place was hardly known would be heard where it is made for.
  if (sought.knowledge == TagKnowledge::kTracked && unheard_s > kUnconfirmed_s &&
      sought.covariance_m2.trace() > kHardly_m * kHardly_m) {
    estimator_.seek_anew(route_[destination()]);
    return;
  }
  if (unheard_s < config_.faults.missing_after_s) {
    if (sought.heard && *sought.heard == since) {
      silent_said_ = false;
    }
    return;
  }
  // One whose place is not known is looked for (look()).
  const bool known = sought.knowledge == TagKnowledge::kTracked || sought.knowledge == TagKnowledge::kKept;
  if (known && !silent_said_) {
    silent_said_ = true;
    note(CeilingEventKind::kTagSilent, route_[destination()]);
  }
}

void CeilingMission::lose_tag(OnTagFault action) {
  switch (action) {
    case OnTagFault::kSearch:
      note(CeilingEventKind::kSearching, route_[destination()]);
      mode_ = CeilingMode::kSearching;
      searched_rad_ = 0.0;
      break;
    case OnTagFault::kSkip:
      skip();
      break;
    case OnTagFault::kStop:
      finish(false);
      break;
  }
}

void CeilingMission::skip() {
  note(CeilingEventKind::kTagSkipped, route_[destination()]);
  ++skipped_;
  if (is_last()) {
    // The end of the path is not to be had.
    finish(false);
    return;
  }
  begin_leg(leg_ + 1);
  mode_ = config_.follower.stop_at_corners ? CeilingMode::kTurning : CeilingMode::kDriving;
}

WheelSpeeds CeilingMission::search() {
  const TagEstimate sought = estimator_.tag(route_[destination()]);
  if (sought.heard && to_s(now_ - *sought.heard) < 1.0) {
    mode_ = CeilingMode::kDriving;
    leg_since_ = now_;
    silent_said_ = false;
    return drive();
  }
  searched_rad_ += std::abs(step_rad_);
  if (searched_rad_ < 2.0 * kPi) {
    return wheels_for(config_.follower, 0.0, kSearching_radps);
  }
  if (searched_rad_ < 4.0 * kPi) {
    return wheels_for(config_.follower, kSearching_mps, kSearching_mps / kSearchRadius_m);
  }
  skip();
  return {};
}

bool CeilingMission::in_hearing(const TagEstimate& tag) const {
  return tag.heard && to_s(now_ - *tag.heard) < kInHearing_s;
}

bool CeilingMission::guesses(const TagEstimate& sought) const {
  if (sought.knowledge >= TagKnowledge::kTracked) {
    return false;
  }
  return (leg_ == 0 && looking_.running()) || to_s(now_ - last_chance(sought)) > kInHearing_s;
}

Instant CeilingMission::last_chance(const TagEstimate& sought) const {
  return sought.heard ? std::max(*sought.heard, leg_since_) : leg_since_;
}

WheelSpeeds CeilingMission::look(const TagEstimate& sought) {
  if (!looking_.running()) {
    if (leg_ == 0 && in_hearing(sought)) {
      // Nothing is known yet, and only a way tells it.
      return wheels_for(config_.follower, config_.follower.speed_mps, 0.0);
    }
    if (leg_ == 0 && to_s(now_ - leg_since_) < kInHearing_s) {
      return {};  // the reader has hardly begun
    }
    looking_.begin();
    ++looks_;
  }
  mode_ = CeilingMode::kLooking;
  const std::optional<TagSearch::Move> move = looking_.step({step_m_, step_rad_}, loudest_dbm_);
  // Where other tags are heard and this one is in no heading, a way will hardly help.
  const bool hopeless =
      (looking_.silent_turns() >= kSilentTurns && estimator_.heard()) || looks_ > kMostLooks;
  if (move && !hopeless) {
    return wheels_for(config_.follower, move->speed_mps, move->turn_radps);
  }
  looking_.end();
  leg_since_ = now_;
  note(CeilingEventKind::kTagMissing, route_[destination()]);
  lose_tag(config_.faults.on_missing);
  return {};
}

void CeilingMission::watch_order() {
  if (config_.faults.order_factor <= 0.0 || order_judged_ || !from_ || leg_ + 1 >= route_.size()) {
    return;
  }
  const auto i = static_cast<std::ptrdiff_t>(leg_);
  const std::optional<Vec2> here = place_of(route_[*from_]);
  const std::optional<Vec2> next = place(i);
  const std::optional<Vec2> after = place(i + 1);
  if (!here || !next || !after || route_[leg_ + 1] == route_[*from_]) {
    return;
  }
  const double next_m = (*next - *here).norm();
  const double after_m = (*after - *here).norm();
  const double factor = config_.faults.order_factor;
  const double doubt_m = kOrderSigmas * (spread_m(route_[leg_]) + factor * spread_m(route_[leg_ + 1]));
  if (next_m < factor * after_m + doubt_m) {
    order_doubted_s_ = 0.0;
    // Far on its way the best guess decides; but to exchange the two it is not good enough.
    const bool late = (estimator_.pose().p_m - origin_M_m_).norm() > kOrderWay_m;
    order_judged_ = next_m < factor * after_m - (late ? 0.0 : doubt_m);
    if (late && !order_judged_) {
      note(CeilingEventKind::kOrderDoubtful, route_[leg_]);
      finish(false);
    }
    return;
  }
  order_doubted_s_ += to_s(now_ - before_);
  if (order_doubted_s_ < kOrderDoubted_s) {
    return;  // the first guess of a place may be wrong
  }
  order_judged_ = true;
  note(CeilingEventKind::kOrderDoubtful, route_[leg_]);
  if (config_.faults.on_order == OnTagFault::kStop) {
    finish(false);
  } else if (config_.faults.on_order == OnTagFault::kSkip) {
    std::swap(route_[leg_], route_[leg_ + 1]);
    std::swap(config_.route[leg_], config_.route[leg_ + 1]);
    note(CeilingEventKind::kOrderExchanged, route_[leg_]);
    attend();
  }
}

double CeilingMission::spread_m(int tag) const {
  return std::sqrt(estimator_.tag(tag).covariance_m2.trace());
}

bool CeilingMission::doubts_order() const {
  return config_.faults.order_factor > 0.0 && !order_judged_ && from_ && leg_ + 1 < route_.size() &&
         route_[leg_ + 1] != route_[*from_] && order_looked_rad_ < 2.0 * kPi;
}

void CeilingMission::watch_corridor() {
  if (!config_.faults.corridor_half_width_m || leg_ == 0 || mode_ == CeilingMode::kFinished) {
    return;
  }
  const CeilingStatus s = status();
  if (!s.path) {
    return;
  }
  if (std::abs(s.path->across_m) > *config_.faults.corridor_half_width_m) {
    note(CeilingEventKind::kOffPath, std::nullopt, s.path->across_m);
    finish(false);
  }
}

}  // namespace sensotwin::robot
