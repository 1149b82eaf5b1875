// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/path_bound.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "robot/phase/estimation/joint_filter.hpp"

namespace sensotwin::robot {
namespace {

constexpr double kNothingKnown_m = 30.0;
/// A robot that starts under its first tag does not know so before it has moved.
constexpr double kFirstWay_m = 0.2;
constexpr double kSameHeading_rad = 1e-6;

/// The ideal drive: turns on the spot, drives straight, and reads as it goes.
class BoundDrive {
 public:
  explicit BoundDrive(const PathBoundTask& task)
      : task_(task), filter_(task.reader, task.wheels, CompassTrust{}), X_MR_({}), bound_() {}

  PathBound run() {
    const Pose2 X_MW = task_.X_WR_start.inverse();
    for (const Eigen::Vector3d& tag : task_.tags_m) {
      const Vec2 flat = X_MW * Vec2{tag.x(), tag.y()};
      tags_M_m_.emplace_back(flat.x(), flat.y(), tag.z());
    }
    double squares = 0.0;
    std::size_t samples = 0;
    for (leg_ = 0; leg_ < task_.route.size(); ++leg_) {
      leg_squares_ = 0.0;
      leg_samples_ = 0;
      attend();
      drive_leg();
      bound_.leg_rms_m.push_back(
          leg_samples_ > 0 ? std::sqrt(leg_squares_ / static_cast<double>(leg_samples_)) : 0.0);
      squares += leg_squares_;
      samples += leg_samples_;
    }
    bound_.rms_m = samples > 0 ? std::sqrt(squares / static_cast<double>(samples)) : 0.0;
    return bound_;
  }

 private:
  [[nodiscard]] const Eigen::Vector3d& tag(std::size_t leg) const { return tags_M_m_[task_.route[leg]]; }

  void attend() {
    window_.clear();
    const auto last = static_cast<std::ptrdiff_t>(task_.route.size()) - 1;
    const auto here = static_cast<std::ptrdiff_t>(leg_);
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(here - 1 - task_.tags_behind, 0);
         i <= std::min(here + task_.tags_ahead, last); ++i) {
      const int id = static_cast<int>(task_.route[static_cast<std::size_t>(i)]);
      if (std::find(window_.begin(), window_.end(), id) == window_.end()) {
        window_.push_back(id);
      }
    }
    for (const int id : window_) {
      if (!filter_.knows(id)) {
        make_room();
        add(id);
      }
    }
  }

  void make_room() {
    for (int s = 0; filter_.tags() == JointFilter::kMostTags && s < filter_.tags(); ++s) {
      const int id = filter_.id_in_slot(s);
      if (std::find(window_.begin(), window_.end(), id) == window_.end()) {
        filter_.remove(id);
      }
    }
  }

  void add(int id) {
    const Eigen::Vector3d& p = tags_M_m_[static_cast<std::size_t>(id)];
    const Vec2 p_R_m = X_MR_.inverse() * Vec2{p.x(), p.y()};
    const bool room =
        filter_.add({.id = id,
                     .p_R_m = p_R_m,
                     .covariance_R_m2 = kNothingKnown_m * kNothingKnown_m * Eigen::Matrix2d::Identity(),
                     .height_m = p.z(),
                     .height_sigma_m = task_.height_sigma_m});
    assert(room);
    static_cast<void>(room);
  }

  void drive_leg() {
    const Vec2 to = tag(leg_).head<2>() - X_MR_.p_m;
    if (to.norm() == 0.0) {
      return;
    }
    const double step_s = to_s(kTick);
    double turn = wrap_angle(std::atan2(to.y(), to.x()) - X_MR_.yaw_rad);
    while (std::abs(turn) > kSameHeading_rad) {
      const double part = std::clamp(turn, -task_.turn_radps * step_s, task_.turn_radps * step_s);
      move({0.0, part});
      turn -= part;
    }
    double way = to.norm();
    while (way > 0.0) {
      const double part = std::min(way, task_.speed_mps * step_s);
      move({part, 0.0});
      way -= part;
      sample();
    }
  }

  void move(const WheelStep& step) {
    filter_.drive(step);
    X_MR_ = advanced(X_MR_, step);
    since_round_s_ += to_s(kTick);
    const double period_s = task_.slot_s > 0.0 ? task_.slot_s : 1.0 / task_.rate_hz;
    if (since_round_s_ < period_s) {
      return;
    }
    since_round_s_ -= period_s;
    const std::size_t ports = task_.reader.antennas.size();
    for (std::size_t port = 0; port < ports; ++port) {
      if (task_.slot_s > 0.0 && port != rounds_ % ports) {
        continue;
      }
      for (int s = 0; s < filter_.tags(); ++s) {
        UhfRead read;
        read.antenna = static_cast<std::uint16_t>(port + 1);
        filter_.inform(filter_.id_in_slot(s), read);
      }
    }
    ++rounds_;
  }

  void sample() {
    driven_m_ += task_.speed_mps * to_s(kTick);
    if (leg_ == 0 || driven_m_ < kFirstWay_m) {
      return;
    }
    const Vec2 from = tag(leg_ - 1).head<2>();
    const Vec2 way = tag(leg_).head<2>() - from;
    const Vec2 along = way.normalized();
    const double part = along.dot(X_MR_.p_m - from) / way.norm();
    const double sigma =
        filter_.across_sigma_m({-along.y(), along.x()}, static_cast<int>(task_.route[leg_ - 1]),
                               static_cast<int>(task_.route[leg_]), part);
    leg_squares_ += sigma * sigma;
    ++leg_samples_;
  }

  const PathBoundTask& task_;
  JointFilter filter_;
  Pose2 X_MR_;
  PathBound bound_;
  std::vector<Eigen::Vector3d> tags_M_m_;
  std::vector<int> window_;
  std::size_t leg_{0};
  std::size_t rounds_{0};
  double since_round_s_{0.0};
  double driven_m_{0.0};
  double leg_squares_{0.0};
  std::size_t leg_samples_{0};
};

}  // namespace

PathBound posterior_bound(const PathBoundTask& task) {
  assert(!task.route.empty());
  return BoundDrive(task).run();
}

}  // namespace sensotwin::robot
