// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "robot/base/random.hpp"
#include "robot/topology/hallway_io.hpp"
#include "robot/topology/hallway_mission.hpp"

namespace sensotwin::robot {

/// What may go wrong on the way.
struct HallwayFaults {
  double tags_missed{0.0};  ///< share of passages over a tag in which it is not read
  double compass_sigma_rad{rad_from_deg(1.0)};
  double range_sigma_m{0.01};
  double ranges_lost{0.01};
  double wheel_base_error{0.01};  ///< of the true base, 1 sigma
  std::vector<Vec2> boxes_m;      ///< discs of 0.25 m that stand about
};

/// A robot and a building for tests where there is no world: hallways of one width between the places of a
/// map, sonars as rays (walls answer from any angle), wheels that roll as they are told.
class KinematicHallways {
 public:
  /// \pre each place of the map has a position, and hallways run along the axes
  KinematicHallways(const HallwayMap& map, double width_m, const Pose2& X_WR, HallwayFaults faults,
                    RandomStream random);

  [[nodiscard]] HallwaySensed sense();
  void drive(const HallwayCommand& command);

  [[nodiscard]] const Pose2& X_WR() const { return X_WR_; }
  [[nodiscard]] double way_m() const { return way_m_; }
  /// Steps in which the shell overlapped a wall or a box; such a step does not move it.
  [[nodiscard]] int touches() const { return touches_; }
  /// The box that stands nearest to a point is gone.
  void clear_boxes() { faults_.boxes_m.clear(); }
  void turn_compass(double rad) { compass_off_rad_ = rad; }
  /// To the left, and no wheel tells of it.
  void turn_by_hand(double rad) { X_WR_.yaw_rad = wrap_angle(X_WR_.yaw_rad + rad); }

 private:
  struct Strip {
    Vec2 low_m;
    Vec2 high_m;
  };
  struct Spot {
    Vec2 at_m;
    TagNumber tag;
  };
  [[nodiscard]] bool free(const Vec2& p_m) const;
  [[nodiscard]] bool room_at(const Vec2& p_m) const;
  [[nodiscard]] std::optional<double> range_m(double bearing_rad) const;

  std::vector<Strip> strips_;
  std::vector<Spot> spots_;
  std::set<TagNumber> over_;
  Pose2 X_WR_;
  HallwayFaults faults_;
  RandomStream random_;
  HallwayConfig config_;
  double base_m_;
  Instant now_{};
  int tick_{0};
  double left_counts_{0.0};
  double right_counts_{0.0};
  double way_m_{0.0};
  int touches_{0};
  bool bumped_{false};
  double compass_off_rad_{0.0};
};

}  // namespace sensotwin::robot
