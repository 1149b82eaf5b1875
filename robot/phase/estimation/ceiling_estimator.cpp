// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/ceiling_estimator.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace sensotwin::robot {
namespace {

/// A tag's innovations are averaged over about this many reads (algorithms study, A.4: 20).
constexpr double kMisfitMemory = 0.05;
constexpr int kRejectedInARow = 10;  ///< drop at once. Chosen: half a second of both ports
/// A tag whose reads only ever tell their own offset is known too badly to be learned from: sought anew.
/// Chosen: half a second of both ports, twice.
constexpr int kOffsetsInARow = 40;
/// Noise is learned over about this many reads. Chosen: a second of three tags.
constexpr double kNoiseMemory = 0.01;
/// Squared differences of innovations count up to this many variances: a few reads half a turn off among a
/// hundred are not taken for noise, and noise three times what it should be is still learned.
constexpr double kNoiseClip = 9.0;
constexpr double kMisfitClip = 25.0;  ///< the same of squared innovations: five sigma
/// A tag whose place is not certain yet and runs off beyond this is sought anew. Chosen: beyond a bank's
/// reach.
constexpr double kFarthest_m = 14.0;
/// Certain: one sigma of its place. Chosen: less than a robot.
constexpr double kCertain_m = 0.15;
constexpr double kBankMisfit = 5.0;  ///< a bank that explains its reads this badly is begun anew
constexpr double kBankWay_m = 6.0;   ///< and one that has not settled after this way. Chosen: two ceilings
/// A bank's covariance times this when its tag joins the filter: both have used the same odometry. Chosen.
constexpr double kPromotedInflation = 6.0;
constexpr double kMoved_m = 0.15;  ///< found this far from where it was, and beyond three sigma: moved
constexpr double kMovedSigmas = 3.0;

EstimatorConfig with_caution(EstimatorConfig config) {
  config.reader.noise.echo_rad *= config.echo_caution;
  return config;
}

Pose2 between(const Pose2& X_OA, const Pose2& X_OB) {
  return X_OA.inverse() * X_OB;
}

}  // namespace

CeilingEstimator::CeilingEstimator(const EstimatorConfig& config, std::vector<ListedTag> tags)
    : config_(with_caution(config)),
      listed_(std::move(tags)),
      by_epc_(listed_.size()),
      watched_(listed_.size()),
      filter_(config_.reader, config_.wheels, config_.compass),
      bank_owner_(config.banks, -1) {
  std::iota(by_epc_.begin(), by_epc_.end(), 0);
  const auto epc_of = [this](int id) { return listed_[static_cast<std::size_t>(id)].epc; };
  std::sort(by_epc_.begin(), by_epc_.end(), [&](int a, int b) { return epc_of(a) < epc_of(b); });
  banks_.reserve(config.banks);
  for (std::size_t i = 0; i < config.banks; ++i) {
    banks_.emplace_back(config_.reader, config_.wheels);
  }
  events_.reserve(kMostEvents);
  wiring_known_ = !config.check_wiring || config_.reader.antennas.size() < 2;
}

std::optional<int> CeilingEstimator::index_of(const Epc& epc) const {
  const auto at = std::lower_bound(by_epc_.begin(), by_epc_.end(), epc, [this](int id, const Epc& wanted) {
    return listed_[static_cast<std::size_t>(id)].epc < wanted;
  });
  if (at == by_epc_.end() || listed_[static_cast<std::size_t>(*at)].epc != epc) {
    return std::nullopt;
  }
  return *at;
}

void CeilingEstimator::attend(std::span<const int> tags) {
  for (Watched& tag : watched_) {
    tag.attended = false;
  }
  for (const int id : tags) {
    watched_[static_cast<std::size_t>(id)].attended = true;
  }
  for (int id = 0; id < this->tags(); ++id) {
    const Watched& tag = watched_[static_cast<std::size_t>(id)];
    if (!tag.attended && tag.bank >= 0 && !filter_.knows(id)) {
      release_bank(id);
    }
  }
}

void CeilingEstimator::step(const PhaseSensed& sensed) {
  now_ = sensed.stamp;
  const WheelStep counted = wheel_step(config_.wheels, sensed.counts_left, sensed.counts_right);
  const WheelStep way = filter_.corrected(counted);
  reckoning_.drive(now_, way);
  way_m_ += std::abs(way.forward_m) + filter_.antenna_arm_m() * std::abs(way.turn_rad);
  filter_.drive(counted);
  if (sensed.bump_left || sensed.bump_right) {
    filter_.touch();
  }
  for (std::size_t i = 0; i < banks_.size(); ++i) {
    if (bank_owner_[i] >= 0) {
      banks_[i].drive(way, reckoning_.pose());
    }
  }
  if (sensed.compass_rad) {
    filter_.correct_by_compass(*sensed.compass_rad);
  }
  for (const UhfRead& read : sensed.reads) {
    use(read);
  }
  if (sensed.floor_tag) {
    fix_on_floor_tag(*sensed.floor_tag);
  }
  watch_wiring();
}

void CeilingEstimator::use(const UhfRead& read) {
  const std::optional<int> id = index_of(read.epc);
  if (!id || read.antenna < 1 || read.antenna > config_.reader.antennas.size()) {
    return;
  }
  Watched& tag = watched_[static_cast<std::size_t>(*id)];
  tag.heard = read.at;
  heard_ = read.at;
  const Pose2 X_OR_then = reckoning_.pose_at(read.at);
  if (filter_.knows(*id)) {
    track(*id, read, between(reckoning_.pose(), X_OR_then));
    if (tag.bank >= 0) {
      banks_[static_cast<std::size_t>(tag.bank)].read(read, X_OR_then, noise_scale2_);
    }
  } else if (tag.attended) {
    if (tag.kept && make_room(*id) && filter_.restore(*id, tag.last_M_m, tag.last_covariance)) {
      tag.kept = false;
      tag.misfit = 1.0;
      track(*id, read, between(reckoning_.pose(), X_OR_then));
    } else if (!tag.kept) {
      seek(*id, read, X_OR_then);
    }
  }
}

void CeilingEstimator::seek(int id, const UhfRead& read, const Pose2& X_OR_then) {
  Watched& tag = watched_[static_cast<std::size_t>(id)];
  if (tag.bank < 0) {
    const auto free = std::find(bank_owner_.begin(), bank_owner_.end(), -1);
    if (free == bank_owner_.end()) {
      return;
    }
    *free = id;
    tag.bank = static_cast<int>(free - bank_owner_.begin());
    banks_[static_cast<std::size_t>(tag.bank)].clear();
  }
  TagBank& bank = banks_[static_cast<std::size_t>(tag.bank)];
  if (bank.empty() || bank.misfit() > kBankMisfit || bank.driven_m() > kBankWay_m) {
    bank.begin(reckoning_.pose(), listed_[static_cast<std::size_t>(id)].height_m, filter_.port_offsets_rad(),
               filter_.port_offset_variances(), !wiring_known_);
  }
  bank.read(read, X_OR_then, noise_scale2_);
  if (bank.settled(reckoning_.pose()) && make_room(id)) {
    promote(id);
  }
}

void CeilingEstimator::promote(int id) {
  Watched& tag = watched_[static_cast<std::size_t>(id)];
  const TagBank::Candidate found = banks_[static_cast<std::size_t>(tag.bank)].place();
  const Pose2 X_RO = reckoning_.pose().inverse();
  Eigen::Matrix2d turn;
  turn << std::cos(X_RO.yaw_rad), -std::sin(X_RO.yaw_rad), std::sin(X_RO.yaw_rad), std::cos(X_RO.yaw_rad);
  filter_.add({.id = id,
               .p_R_m = X_RO * found.p_O_m,
               .covariance_R_m2 = kPromotedInflation * turn * found.covariance_m2 * turn.transpose(),
               .height_m = listed_[static_cast<std::size_t>(id)].height_m,
               .height_sigma_m = config_.height_sigma_m});
  tag.misfit = 1.0;
  tag.certain = false;
  tag.rejected_in_a_row = 0;
  tag.offsets_in_a_row = 0;
  tag.has_innovation.fill(false);
  say(EstimatorEventKind::kTagFound, id);
  if (wiring_known_) {
    release_bank(id);
  }
}

void CeilingEstimator::track(int id, const UhfRead& read, const Pose2& X_now_then) {
  Watched& tag = watched_[static_cast<std::size_t>(id)];
  const JointFilter::Outcome outcome = filter_.read(id, read, X_now_then, noise_scale2_, config_.gate_sigmas);
  const std::size_t port = read.antenna - 1u;
  if (outcome.fate == JointFilter::Fate::kOffsetSet) {
    tag.has_innovation[port] = false;
    if (++tag.offsets_in_a_row > kOffsetsInARow) {
      drop(id);
    }
    return;
  }
  tag.offsets_in_a_row = 0;
  learn_noise(tag, read, outcome);
  if (!tag.certain) {
    become_certain(id);
  }
  const double fit = outcome.innovation_rad * outcome.innovation_rad / outcome.variance;
  tag.misfit += kMisfitMemory * (std::min(fit, kMisfitClip) - tag.misfit);
  tag.rejected_in_a_row = outcome.fate == JointFilter::Fate::kRejected ? tag.rejected_in_a_row + 1 : 0;
  const bool gone = (filter_.tag_M_m(id).head<2>() - pose().p_m).norm() > kFarthest_m;
  if (tag.misfit > config_.misfit_limit || tag.rejected_in_a_row > kRejectedInARow ||
      (gone && !tag.certain)) {
    drop(id);
  }
}

void CeilingEstimator::become_certain(int id) {
  Watched& tag = watched_[static_cast<std::size_t>(id)];
  const Eigen::Matrix2d covariance = filter_.tag_covariance(id).topLeftCorner<2, 2>();
  tag.certain = covariance.trace() < kCertain_m * kCertain_m;
  if (!tag.certain || !tag.was_known) {
    return;
  }
  tag.was_known = false;
  const double moved_m = (filter_.tag_M_m(id) - tag.last_M_m).head<2>().norm();
  const double spread2 = covariance.trace() + tag.last_covariance.topLeftCorner<2, 2>().trace();
  if (moved_m > kMoved_m && moved_m * moved_m > kMovedSigmas * kMovedSigmas * spread2) {
    say(EstimatorEventKind::kTagMoved, id, moved_m);
  }
}

void CeilingEstimator::learn_noise(Watched& tag, const UhfRead& read, const JointFilter::Outcome& outcome) {
  const std::size_t port = read.antenna - 1u;
  // Successive innovations share whatever is wrong with the state; their difference is the reads' own noise,
  // and the echoes' change between the two.
  if (tag.has_innovation[port]) {
    const double difference = config_.reader.wrap(outcome.innovation_rad - tag.last_innovation[port]);
    const PhaseNoise& noise = config_.reader.noise;
    const double kept = noise.echo_kept({.way_m = way_m_ - tag.way_at_innovation_m[port],
                                         .hop_hz = read.frequency_hz - tag.hz_at_innovation[port]});
    const double expected = 2.0 * (outcome.noise + noise.echo_rad * noise.echo_rad * (1.0 - kept));
    const double ratio = std::min(difference * difference / expected, kNoiseClip);
    noise_scale2_ += kNoiseMemory * noise_scale2_ * (ratio - 1.0);
    noise_scale2_ = std::clamp(noise_scale2_, 1.0, config_.most_noise_scale * config_.most_noise_scale);
  }
  tag.last_innovation[port] = outcome.innovation_rad;
  tag.way_at_innovation_m[port] = way_m_;
  tag.hz_at_innovation[port] = read.frequency_hz;
  tag.has_innovation[port] = true;
}

void CeilingEstimator::drop(int id) {
  Watched& tag = watched_[static_cast<std::size_t>(id)];
  if (tag.certain) {
    tag.was_known = true;
    tag.last_M_m = filter_.tag_M_m(id);
    tag.last_covariance = filter_.tag_covariance(id);
    say(EstimatorEventKind::kTagLost, id);
  }
  filter_.remove(id);
  if (tag.bank >= 0) {
    // It was kept for the wiring's sake and is as wrong as the filter.
    settled_evidence_ += banks_[static_cast<std::size_t>(tag.bank)].exchange_evidence();
    release_bank(id);
  }
  ++drops_;
  doubt_wiring();
}

void CeilingEstimator::seek_anew(int tag) {
  if (filter_.knows(tag)) {
    drop(tag);
  }
  release_bank(tag);
}

void CeilingEstimator::release_bank(int id) {
  Watched& tag = watched_[static_cast<std::size_t>(id)];
  if (tag.bank >= 0) {
    banks_[static_cast<std::size_t>(tag.bank)].clear();
    bank_owner_[static_cast<std::size_t>(tag.bank)] = -1;
    tag.bank = -1;
  }
}

bool CeilingEstimator::make_room(int wanted) {
  if (filter_.tags() < JointFilter::kMostTags) {
    return true;
  }
  // The farthest that nobody attends to is set aside.
  int farthest = -1;
  double distance_m = -1.0;
  for (int s = 0; s < filter_.tags(); ++s) {
    const int id = filter_.id_in_slot(s);
    const double away_m = (filter_.tag_M_m(id).head<2>() - pose().p_m).norm();
    if (id != wanted && !watched_[static_cast<std::size_t>(id)].attended && away_m > distance_m) {
      farthest = id;
      distance_m = away_m;
    }
  }
  if (farthest < 0) {
    return false;
  }
  Watched& tag = watched_[static_cast<std::size_t>(farthest)];
  tag.last_M_m = filter_.tag_M_m(farthest);
  tag.last_covariance = filter_.tag_covariance(farthest);
  tag.kept = true;
  filter_.remove(farthest);
  release_bank(farthest);
  return true;
}

void CeilingEstimator::fix_on_floor_tag(const Epc& epc) {
  const std::optional<int> id = index_of(epc);
  if (!id) {
    return;
  }
  // Coming upon a disc of radius r from anywhere: the tag is pi/4 r ahead on average, give or take r/4; and
  // beside the way, evenly across the disc (algorithms study, A.4).
  const double r = config_.floor_radius_m;
  const Pose2 X_MR = pose();
  if (!filter_.knows(*id)) {
    if (!watched_[static_cast<std::size_t>(*id)].attended || !make_room(*id)) {
      return;
    }
    filter_.add({.id = *id,
                 .p_R_m = {0.785 * r, 0.0},
                 .covariance_R_m2 = Eigen::Vector2d{0.0625 * r * r, 0.34 * r * r}.asDiagonal(),
                 .height_m = listed_[static_cast<std::size_t>(*id)].height_m,
                 .height_sigma_m = config_.height_sigma_m});
    watched_[static_cast<std::size_t>(*id)].kept = false;
    watched_[static_cast<std::size_t>(*id)].misfit = 1.0;
    if (wiring_known_) {
      release_bank(*id);
    }
    say(EstimatorEventKind::kTagFound, *id);
    return;
  }
  filter_.fix_over(*id, -0.785 * r * X_MR.direction(), X_MR.direction(), 0.25 * r, 0.58 * r);
}

TagEstimate CeilingEstimator::tag(int id) const {
  const Watched& tag = watched_[static_cast<std::size_t>(id)];
  TagEstimate estimate;
  estimate.heard = tag.heard;
  estimate.height_m = listed_[static_cast<std::size_t>(id)].height_m;
  if (filter_.knows(id)) {
    estimate.knowledge = TagKnowledge::kTracked;
    estimate.p_M_m = filter_.tag_M_m(id).head<2>();
    estimate.height_m = filter_.tag_M_m(id).z();
    estimate.covariance_m2 = filter_.tag_covariance(id).topLeftCorner<2, 2>();
  } else if (tag.kept) {
    estimate.knowledge = TagKnowledge::kKept;
    estimate.p_M_m = tag.last_M_m.head<2>();
    estimate.covariance_m2 = tag.last_covariance.topLeftCorner<2, 2>();
  } else if (tag.bank >= 0 && !banks_[static_cast<std::size_t>(tag.bank)].empty()) {
    const TagBank::Candidate sought = banks_[static_cast<std::size_t>(tag.bank)].place();
    const Pose2 X_MO = pose() * reckoning_.pose().inverse();
    Eigen::Matrix2d turn;
    turn << std::cos(X_MO.yaw_rad), -std::sin(X_MO.yaw_rad), std::sin(X_MO.yaw_rad), std::cos(X_MO.yaw_rad);
    estimate.knowledge = TagKnowledge::kSought;
    estimate.p_M_m = X_MO * sought.p_O_m;
    estimate.covariance_m2 = turn * sought.covariance_m2 * turn.transpose();
  }
  return estimate;
}

void CeilingEstimator::say(EstimatorEventKind kind, int tag, double distance_m) {
  if (events_.size() < kMostEvents) {
    events_.push_back({now_, kind, tag, distance_m});
  }
}

}  // namespace sensotwin::robot
