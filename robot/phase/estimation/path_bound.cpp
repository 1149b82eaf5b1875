// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/path_bound.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "robot/phase/estimation/joint_filter.hpp"
#include "robot/phase/estimation/path_shape.hpp"

namespace sensotwin::robot {
namespace {

constexpr double kNothingKnown_m = 30.0;
/// A robot that starts under its first tag does not know so before it has moved.
constexpr double kFirstWay_m = 0.2;
constexpr double kSameHeading_rad = 1e-6;
constexpr double kSampled_m = 0.02;  ///< way between two looks at the error. Chosen: a thousand on 20 m

struct Squares {
  double sum_m2{0.0};
  std::size_t count{0};
  void add(const Squares& other) {
    sum_m2 += other.sum_m2;
    count += other.count;
  }
  [[nodiscard]] double rms_m() const {
    return count > 0 ? std::sqrt(sum_m2 / static_cast<double>(count)) : 0.0;
  }
};

std::vector<Vec2> flat_in_start(const PathBoundTask& task) {
  const Pose2 X_MW = task.X_WR_start.inverse();
  std::vector<Vec2> places;
  for (const Eigen::Vector3d& tag : task.tags_m) {
    places.push_back(X_MW * Vec2{tag.x(), tag.y()});
  }
  return places;
}

/// The ideal drive: turns on the spot, drives along the path, and reads as it goes. In M.
class BoundDrive {
 public:
  explicit BoundDrive(const PathBoundTask& task)
      : task_(task),
        places_M_m_(flat_in_start(task)),
        shape_({task.path, task.circle_left, task.circle_radius_m, task.circle_laps}, places_M_m_, task.route,
               Vec2{0.0, 0.0}),
        filter_(task.reader, task.wheels, CompassTrust{}) {}

  PathBound run() {
    PathBound bound;
    Squares first;
    Squares second;
    for (leg_ = 0; leg_ < shape_.legs(); ++leg_) {
      squares_ = {};
      attend();
      for (const Vec2& point : shape_.points_m(leg_)) {
        drive_to(point);
      }
      bound.leg_rms_m.push_back(squares_.rms_m());
      (2 * leg_ <= shape_.legs() - 1 ? first : second).add(squares_);
    }
    bound.first_half_rms_m = first.rms_m();
    bound.second_half_rms_m = second.rms_m();
    first.add(second);
    bound.rms_m = first.rms_m();
    return bound;
  }

 private:
  void attend() {
    window_.clear();
    const auto last = static_cast<std::ptrdiff_t>(task_.route.size()) - 1;
    const auto here = std::min(static_cast<std::ptrdiff_t>(leg_), last);
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
    const auto i = static_cast<std::size_t>(id);
    const bool room =
        filter_.add({.id = id,
                     .p_R_m = X_MR_.inverse() * places_M_m_[i],
                     .covariance_R_m2 = kNothingKnown_m * kNothingKnown_m * Eigen::Matrix2d::Identity(),
                     .height_m = task_.tags_m[i].z(),
                     .height_sigma_m = task_.height_sigma_m});
    assert(room);
    static_cast<void>(room);
  }

  void drive_to(const Vec2& point) {
    const Vec2 to = point - X_MR_.p_m;
    double way = to.norm();
    if (way == 0.0) {
      return;
    }
    const double tick_s = to_s(kTick);
    double turn = wrap_angle(std::atan2(to.y(), to.x()) - X_MR_.yaw_rad);
    const double most_rad = task_.turn_radps * tick_s;
    while (std::abs(turn) > most_rad) {
      const double part = std::clamp(turn, -most_rad, most_rad);
      move({0.0, part}, tick_s);
      turn -= part;
    }
    if (std::abs(turn) > kSameHeading_rad) {
      move({0.0, turn}, 0.0);
    }
    while (way > 0.0) {
      const double part = std::min(way, task_.speed_mps * tick_s);
      move({part, 0.0}, part / task_.speed_mps);
      way -= part;
      driven_m_ += part;
      unseen_m_ += part;
      if (unseen_m_ >= kSampled_m) {
        unseen_m_ -= kSampled_m;
        sample();
      }
    }
  }

  void move(const WheelStep& step, double duration_s) {
    BoundMotion motion{now_s_, now_s_ + duration_s, task_.X_WR_start * X_MR_, {}};
    filter_.drive(step);
    X_MR_ = advanced(X_MR_, step);
    now_s_ = motion.end_s;
    motion.X_WR_end = task_.X_WR_start * X_MR_;
    if (duration_s == 0.0) {
      return;
    }
    if (task_.hear) {
      for (const BoundRead& heard : task_.hear(motion)) {
        if (filter_.knows(static_cast<int>(heard.tag))) {
          filter_.inform(static_cast<int>(heard.tag), heard.read);
        }
      }
    } else {
      since_round_s_ += duration_s;
      read_round();
    }
  }

  void read_round() {
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
      UhfRead read;
      read.antenna = static_cast<std::uint16_t>(port + 1);
      for (int s = 0; s < filter_.tags(); ++s) {
        filter_.inform(filter_.id_in_slot(s), read);
      }
    }
    ++rounds_;
  }

  void sample() {
    if (leg_ == 0 || driven_m_ < kFirstWay_m) {
      return;
    }
    const PathShape::Beside beside = shape_.beside(leg_, X_MR_.p_m);
    std::vector<JointFilter::TagPull> pulls;
    for (const PathShape::Pull& pull : beside.by_places) {
      pulls.push_back({static_cast<int>(pull.place), pull.by_place});
    }
    const double sigma_m = filter_.sigma_m(beside.by_robot, pulls);
    squares_.add({sigma_m * sigma_m, 1});
  }

  const PathBoundTask& task_;
  std::vector<Vec2> places_M_m_;
  PathShape shape_;
  JointFilter filter_;
  Pose2 X_MR_;
  std::vector<int> window_;
  std::size_t leg_{0};
  std::size_t rounds_{0};
  double now_s_{0.0};
  double since_round_s_{0.0};
  double driven_m_{0.0};
  double unseen_m_{0.0};
  Squares squares_;
};

}  // namespace

PathBound posterior_bound(const PathBoundTask& task) {
  assert(!task.route.empty());
  return BoundDrive(task).run();
}

}  // namespace sensotwin::robot
