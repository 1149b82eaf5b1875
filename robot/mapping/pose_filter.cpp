// SPDX-License-Identifier: MIT
#include "robot/mapping/pose_filter.hpp"

#include <algorithm>
#include <cmath>

#include "robot/base/rolled_wheels.hpp"

namespace sensotwin::robot {
namespace {

/// Beliefs kept at most, and the weight (of the best one's) below which one is dropped. Chosen: three
/// undecided passes make eight images; those below one in two hundred were never right in 10 000 simulated
/// passes.
constexpr std::size_t kBeliefs = 6;
const double kNegligible = std::log(1.0 / 200.0);
/// Beliefs closer than this are one.
constexpr double kSame_m = 0.012;
constexpr double kSame_rad = 0.02;
/// Below this the two mirror images are one, and the pass was within this of the middle: q^2 = r^2 - h^2 is
/// known to 2 h 3 mm = (2.2 cm)^2.
constexpr double kOffMiddle_m = 0.022;
/// A belief that gave a reading less than this is wrong, not unlucky: about five standard deviations of 1 cm.
constexpr double kSurprise = -0.5 * 25.0 + 4.6;
constexpr double kDoubt = 4.0;
/// Standard deviation per axis, in radii, of a place that is anywhere in a disc: a half.
constexpr double kSomewhereInZone = 0.5;
/// Log weight of a belief by which the antenna went well through the zone of a tag that did not answer.
const double kSilentTag = std::log(0.02);

}  // namespace

PoseFilter::PoseFilter(const OdometryModel& odometry, const CompassModel& compass)
    : model_(odometry), beliefs_{{PoseTrack(odometry, compass), 0.0}} {
  beliefs_.reserve(2 * kBeliefs);
}

void PoseFilter::reset(const Pose2& X_MR, double position_sigma_m, double yaw_sigma_rad) {
  beliefs_.resize(1, beliefs_[0]);
  beliefs_[0].log_weight = 0.0;
  beliefs_[0].track.reset(X_MR, position_sigma_m, yaw_sigma_rad);
}

void PoseFilter::drive(int counts_left, int counts_right, std::optional<double> contact_yaw_R_rad) {
  if (counts_left == 0 && counts_right == 0) {
    return;
  }
  const auto [left_m, right_m] = rolled_m(model_, counts_left, counts_right);
  const double d_m = (left_m + right_m) / 2.0;
  const double dyaw = (right_m - left_m) / model_.wheel_base_m;
  const double yaw = X_OR_.yaw_rad + dyaw / 2.0;
  X_OR_.p_m += d_m * Vec2{std::cos(yaw), std::sin(yaw)};
  X_OR_.yaw_rad = wrap_angle(X_OR_.yaw_rad + dyaw);
  path_length_m_ += std::abs(d_m);
  turned_rad_ += std::abs(dyaw);
  for (Belief& belief : beliefs_) {
    belief.track.drive(left_m, right_m, contact_yaw_R_rad);
  }
}

void PoseFilter::enter_zone(double late_m) {
  for (Belief& belief : beliefs_) {
    belief.track.mark(late_m);
  }
}

void PoseFilter::identify_zone(const ReadZone& zone) {
  for (Belief& belief : beliefs_) {
    correct_rim(belief, zone, belief.track.since_mark_m());
  }
  settle_weights();
}

void PoseFilter::correct_rim(Belief& belief, const ReadZone& zone, const Vec2& since_m) {
  // On the rim the antenna was `radius` from the tag, along the line of sight.
  const Vec2 from_tag = belief.track.pose().p_m - since_m - zone.tag_M_m;
  if (from_tag.norm() < 0.01) {
    return;
  }
  const Vec2 sight = from_tag.normalized();
  const Vec2 across{-sight.y(), sight.x()};
  // The rim bends: an uncertain place across the line of sight makes the distance along it uncertain too.
  const double bend = std::pow(belief.track.position_sigma_m(across), 2) / zone.radius_m;
  const double sigma = std::hypot(std::hypot(zone.rim_sigma_m, zone.tag_sigma_m), bend);
  const double value = sight.dot(zone.tag_M_m + since_m) + zone.radius_m;
  const double likelihood = belief.track.correct_position(sight, value, sigma);
  belief.log_weight += likelihood;
  if (likelihood < kSurprise) {
    belief.track.doubt(kDoubt);
    belief.track.correct_position(sight, value, sigma);
  }
}

void PoseFilter::correct_chord(Belief& belief, const ReadZone& zone, double late_m,
                               std::vector<Belief>& out) const {
  const Vec2 late = late_m * belief.track.pose().direction();
  if (belief.track.touched_since_mark()) {
    correct_rim(belief, zone, late);  // the chord is not what the wheels counted
    out.push_back(belief);
    return;
  }
  const Vec2 chord = belief.track.since_mark_m() - late;
  const double half = chord.norm() / 2.0;
  if (half < zone.radius_m / 4.0) {
    out.push_back(belief);  // in and out on the same side: says little
    return;
  }
  const Vec2 along = chord.normalized();
  const Vec2 left{-along.y(), along.x()};
  const double q2 = zone.radius_m * zone.radius_m - half * half;
  const bool off_middle = q2 > kOffMiddle_m * kOffMiddle_m;
  const double q = off_middle ? std::sqrt(q2) : 0.0;
  const double across_sigma =
      off_middle ? std::hypot(half / q * zone.rim_sigma_m, zone.tag_sigma_m) : kOffMiddle_m;
  const double along_sigma = std::hypot(zone.rim_sigma_m, zone.tag_sigma_m);
  const double along_value = along.dot(zone.tag_M_m + late) + half;
  for (const double side : {1.0, -1.0}) {
    Belief image = belief;
    const double across_value = left.dot(zone.tag_M_m + late) + side * q;
    double likelihood = image.track.correct_position(left, across_value, across_sigma);
    likelihood += image.track.correct_position(along, along_value, along_sigma);
    image.log_weight += likelihood;
    if (likelihood < 2.0 * kSurprise) {
      image.track = belief.track;
      image.track.doubt(kDoubt);
      image.track.correct_position(left, across_value, across_sigma);
      image.track.correct_position(along, along_value, along_sigma);
    }
    out.push_back(image);
    if (!off_middle) {
      break;
    }
  }
}

void PoseFilter::leave_zone(const ReadZone& zone, double late_m) {
  std::vector<Belief> images;
  images.reserve(2 * beliefs_.size());
  for (Belief& belief : beliefs_) {
    correct_chord(belief, zone, late_m, images);
  }
  beliefs_ = std::move(images);
  settle_weights();
}

void PoseFilter::miss_zone(const ReadZone& zone, const Vec2& along_M) {
  for (Belief& belief : beliefs_) {
    const Vec2 off = belief.track.pose().p_m - zone.tag_M_m;
    const double across = std::abs(along_M.x() * off.y() - along_M.y() * off.x());
    if (across < zone.radius_m - 0.01) {
      belief.log_weight += kSilentTag;
      belief.track.doubt(2.0);
    }
  }
  settle_weights();
}

void PoseFilter::find_at(const ReadZone& zone) {
  for (Belief& belief : beliefs_) {
    belief.track.doubt(kDoubt);
    for (const Vec2& axis : {Vec2{1.0, 0.0}, Vec2{0.0, 1.0}}) {
      belief.log_weight +=
          belief.track.correct_position(axis, axis.dot(zone.tag_M_m), kSomewhereInZone * zone.radius_m);
    }
  }
  settle_weights();
}

void PoseFilter::correct_by_compass(double reading_rad) {
  for (Belief& belief : beliefs_) {
    belief.log_weight += belief.track.correct_by_compass(reading_rad);
  }
  if (beliefs_.size() > 1) {
    settle_weights();
  }
}

void PoseFilter::settle_weights() {
  std::stable_sort(beliefs_.begin(), beliefs_.end(),
                   [](const Belief& a, const Belief& b) { return a.log_weight > b.log_weight; });
  const double top = beliefs_.front().log_weight;
  std::vector<Belief> kept;
  kept.reserve(2 * kBeliefs);
  for (Belief& belief : beliefs_) {
    belief.log_weight -= top;
    if (belief.log_weight < kNegligible || kept.size() == kBeliefs) {
      break;
    }
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Belief& other) {
      return (other.track.pose().p_m - belief.track.pose().p_m).norm() < kSame_m &&
             std::abs(wrap_angle(other.track.pose().yaw_rad - belief.track.pose().yaw_rad)) < kSame_rad;
    });
    if (!known) {
      kept.push_back(std::move(belief));
    }
  }
  beliefs_ = std::move(kept);
}

double PoseFilter::position_sigma_m() {
  const double yaw = pose().yaw_rad;
  return std::max(across_sigma_m(), beliefs_.front().track.position_sigma_m({std::cos(yaw), std::sin(yaw)}));
}

double PoseFilter::across_sigma_m() {
  const double yaw = pose().yaw_rad;
  return beliefs_.front().track.position_sigma_m({-std::sin(yaw), std::cos(yaw)});
}

}  // namespace sensotwin::robot
