// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "robot/topology/hallway_config.hpp"

namespace sensotwin::robot {

/// What a wall at one side looks like.
struct WallSide {
  /// From the middle of the robot, filtered; nothing where no wall is.
  std::optional<double> distance_m{};
  /// Way driven since the wall ended, where nothing is seen in its place; 0 beside a wall.
  double open_for_m{0.0};
};

/// Where a robot in a hallway heads and what is beside it: dead reckoning, held by compass and walls.
///
///   heading += turn by the wheels;  + kCompass (compass - heading);  + kWall (slope of a wall - heading off
///   the axis)
///
/// A wall that is seen over a stretch of way without a jump says by how much the robot's way is off it; so do
/// both. A compass far off what the wheels say is near iron and is not believed.
class HallwayTracker {
 public:
  explicit HallwayTracker(const HallwayConfig& config);

  void step(const HallwaySensed& sensed);
  /// The hallway's direction from now on: walls are parallel to it. Ways are counted anew.
  void enter(CompassPoint axis);
  /// In a junction, on turning: no wall is to be trusted.
  void leave() { axis_.reset(); }
  /// A tag has told that all this time it faced another way, so many quarter turns to the right of what was
  /// thought.
  void correct(int quarter_turns_right);

  /// Counter-clockwise from the plan's north, in (-pi, pi]. Nothing before the first compass reading.
  [[nodiscard]] std::optional<double> heading_rad() const { return heading_rad_; }
  /// Of the heading, counter-clockwise from the axis. \pre enter() and a heading
  [[nodiscard]] double off_axis_rad() const;
  [[nodiscard]] std::optional<CompassPoint> axis() const { return axis_; }
  /// Since enter().
  [[nodiscard]] double way_m() const { return way_m_; }
  [[nodiscard]] const WallSide& left() const { return flanks_[0].wall; }
  [[nodiscard]] const WallSide& right() const { return flanks_[1].wall; }
  /// Free way ahead of the shell, as far as the forward sonars see; nothing: no echo.
  [[nodiscard]] std::optional<double> ahead_m() const { return ahead_m_; }
  /// The width of this hallway: measured, or as configured.
  [[nodiscard]] double width_m() const { return width_m_; }
  /// Left of the hallway's middle, m; by one wall where only one is seen, nothing where none is.
  [[nodiscard]] std::optional<double> left_of_middle_m() const;

 private:
  struct Sight {
    double way_m;
    double distance_m;
    double off_axis_rad;  ///< that the robot headed then, as far as it knew
  };
  /// What is remembered of one side.
  struct Flank {
    WallSide wall{};
    std::optional<double> candidate_m{};  ///< perhaps a wall: seen so far off, for so many readings
    std::size_t seen{0};
    double seen_at_m{0.0};          ///< way at the last sight of the wall
    double moved_m{0.0};            ///< towards this side since the last reading, by the wheels
    std::array<Sight, 24> trail{};  ///< its last sights
    std::size_t sights{0};
  };

  void take_compass(double compass_rad);
  void take_ranges(const SonarRanges& ranges_m);
  void take_side(Flank& flank, const std::optional<double>& range_m);
  void see_wall(Flank& flank, double distance_m);
  void look_for_wall(Flank& flank, const std::optional<double>& nearest_m);
  void take_slope(std::size_t side);

  HallwayConfig config_;
  std::optional<double> heading_rad_;
  std::optional<CompassPoint> axis_;
  double way_m_{0.0};
  double width_m_;
  std::array<Flank, 2> flanks_{};  ///< left, right
  std::optional<double> ahead_m_;
};

}  // namespace sensotwin::robot
