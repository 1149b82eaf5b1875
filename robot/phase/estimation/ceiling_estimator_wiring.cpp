// SPDX-License-Identifier: MIT
// Whether the cables of ports 1 and 2 are exchanged: how that is judged, and doubted again.
#include <cmath>
#include <utility>

#include "robot/phase/estimation/ceiling_estimator.hpp"

namespace sensotwin::robot {
namespace {

/// The wiring is judged when the reads are this much likelier one way (natural logarithm). Chosen: five reads
/// that fit nothing at all do not decide.
constexpr double kWiringEvidence = 25.0;
/// Every dropped tag is a doubt whether it was judged rightly, and an antenna's way of this length leaves a
/// third of it. Chosen: about the way on which a bank settles and its tag is found to be wrong.
constexpr double kDoubtWay_m = 8.0;
/// So many doubts open the question anew. Measured over 20 seeds of line_at_90 and 8 of the hallway with the
/// profile impinj_r420: judged rightly, at most four tags are dropped in 46 m; judged wrongly, one in 3 m.
constexpr double kMostDoubt = 2.5;

}  // namespace

void CeilingEstimator::watch_wiring() {
  if (!config_.check_wiring) {
    return;
  }
  if (!wiring_known_) {
    judge_wiring();
  } else if (swapped_ && wiring_doubt_ > kMostDoubt) {
    // Only this is doubted: that the cables are as given is likely before anything is heard.
    reopen_wiring();
  }
}

void CeilingEstimator::doubt_wiring() {
  wiring_doubt_ = 1.0 + wiring_doubt_ * std::exp(-(way_m_ - doubted_at_m_) / kDoubtWay_m);
  doubted_at_m_ = way_m_;
}

void CeilingEstimator::judge_wiring() {
  double evidence = settled_evidence_;
  for (std::size_t i = 0; i < banks_.size(); ++i) {
    if (bank_owner_[i] >= 0) {
      evidence += banks_[i].exchange_evidence();
    }
  }
  if (std::abs(evidence) < kWiringEvidence) {
    return;
  }
  wiring_known_ = true;
  wiring_doubt_ = 0.0;
  swapped_ = evidence > 0.0;
  say(swapped_ ? EstimatorEventKind::kCablesSwapped : EstimatorEventKind::kWiringAsGiven, -1);
  for (int id = 0; id < tags(); ++id) {
    if (swapped_ && filter_.knows(id)) {
      filter_.remove(id);  // of the mirrored world
    }
    if (swapped_ || filter_.knows(id)) {
      release_bank(id);
    }
  }
  if (swapped_) {
    exchange_mounts();
  }
}

void CeilingEstimator::reopen_wiring() {
  say(EstimatorEventKind::kWiringDoubted, -1);
  wiring_known_ = false;
  wiring_doubt_ = 0.0;
  settled_evidence_ = 0.0;
  swapped_ = false;
  exchange_mounts();
  // What was learned of places was learned in the world as it was taken to be.
  for (int id = 0; id < tags(); ++id) {
    if (filter_.knows(id)) {
      filter_.remove(id);
    }
    Watched& tag = watched_[static_cast<std::size_t>(id)];
    tag.kept = false;
    tag.was_known = false;
    release_bank(id);
  }
}

void CeilingEstimator::exchange_mounts() {
  std::swap(config_.reader.antennas[0].at_R_m, config_.reader.antennas[1].at_R_m);
}

}  // namespace sensotwin::robot
