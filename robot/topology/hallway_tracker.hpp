// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "robot/topology/hallway_config.hpp"

namespace sensotwin::robot {

/// What a wall at one side looks like.
struct WallSide {
  /// From the middle of the robot, filtered; nothing where no wall is.
  std::optional<double> distance_m{};
  /// Way driven since the wall ended, where nothing is seen in its place; 0 beside a wall, and before the
  /// first wall: what has always been open is no opening.
  double open_for_m{0.0};
  /// Where the wall was last seen, from the middle of the robot, kept up by the wheels; nothing before the
  /// first.
  std::optional<double> last_m{};
};

/// Where a robot in a hallway heads and what is beside it: dead reckoning, held by compass and walls.
///
///   heading += turn by the wheels;  + kCompass (compass - heading);  + kWall (slope of a wall - heading off
///   the axis)
///
/// Nothing need be known of the hallway's width: it is measured where both walls are seen, and where one is,
/// before that, the robot stays as far from it as it was.
///
/// A wall that is seen over a stretch of way without a jump says by how much the robot's way is off it; so do
/// both. A compass far off what the wheels say is near iron and is not believed; but where the robot stands
/// the field does not change, and a compass that goes over to another direction there says that somebody
/// turned the robot.
class HallwayTracker {
 public:
  explicit HallwayTracker(const HallwayConfig& config);

  void step(const HallwaySensed& sensed);
  /// The hallway's direction from now on: walls are parallel to it. Ways are counted anew.
  /// \param axis_rad  counter-clockwise from the plan's north
  void enter(double axis_rad);
  /// In a junction, on turning: no wall is to be trusted.
  void leave() { axis_rad_.reset(); }
  /// A tag has told that all this time it faced another way, so far to the left of what was thought.
  void correct(double left_rad);

  /// Counter-clockwise from the plan's north, in (-pi, pi]. Nothing before the first compass reading.
  [[nodiscard]] std::optional<double> heading_rad() const { return heading_rad_; }
  /// Of the heading, counter-clockwise from the axis. \pre enter() and a heading
  [[nodiscard]] double off_axis_rad() const;
  [[nodiscard]] std::optional<double> axis_rad() const { return axis_rad_; }
  /// Since enter(): driven, and of that along the hallway.
  [[nodiscard]] double way_m() const { return way_m_; }
  [[nodiscard]] double along_m() const { return along_m_; }
  /// Whether the compass says another thing than wheels and walls at present.
  [[nodiscard]] bool compass_astray() const { return astray_readings_ > 0; }
  /// By how much to the left somebody has turned it where it stood, once each time.
  [[nodiscard]] std::optional<double> take_turned_rad() { return std::exchange(turned_rad_, std::nullopt); }
  [[nodiscard]] const WallSide& left() const { return flanks_[0].wall; }
  [[nodiscard]] const WallSide& right() const { return flanks_[1].wall; }
  /// Free way ahead of the shell, as far as the forward sonars see; nothing: no echo.
  [[nodiscard]] std::optional<double> ahead_m() const { return ahead_m_; }
  /// Whether what is ahead is flat and wide: the wall at the end of a hallway rather than somebody in it.
  [[nodiscard]] bool wall_ahead() const { return wall_ahead_; }
  /// The width of this hallway as measured; before that, of the last one, and in the first as configured.
  [[nodiscard]] double width_m() const { return width_m_; }
  /// Left of the hallway's middle, m; by one wall where only one is seen, nothing where none is.
  [[nodiscard]] std::optional<double> left_of_middle_m() const;
  /// Left of the line that is to be followed: the middle, or at its distance from one wall.
  [[nodiscard]] std::optional<double> left_of_line_m() const;

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
    std::optional<double> first_m{};  ///< how far the first wall was, once it was firm
  };

  void take_compass(double compass_rad);
  /// \param off_rad  of a reading far off the heading
  void take_astray(double off_rad);
  void take_ranges(const SonarRanges& ranges_m);
  void take_ahead(const SonarRanges& ranges_m);
  void measure_width();
  /// Whether a flank's wall has been gone along.
  [[nodiscard]] static bool firm(const Flank& flank);
  void take_side(Flank& flank, const std::optional<double>& range_m);
  void see_wall(Flank& flank, double distance_m);
  void look_for_wall(Flank& flank, const std::optional<double>& nearest_m);
  /// By how much more to the left the robot heads than it thinks, as one wall's slope tells.
  [[nodiscard]] std::optional<double> turn_by_wall_rad(std::size_t side) const;
  void take_slopes();

  HallwayConfig config_;
  std::optional<double> heading_rad_;
  double compass_ahead_rad_{0.0};  ///< mean of what the compass says beyond the heading
  std::optional<double> axis_rad_;
  double way_m_{0.0};
  double along_m_{0.0};
  double path_m_{0.0};              ///< driven ever, either way
  std::optional<double> agreed_m_;  ///< of that, at the last compass reading that agreed with the wheels
  double agreed_rad_{0.0};          ///< what that said beyond the heading
  bool stood_{false};               ///< when the compass first said another thing
  double astray_rad_{0.0};          ///< what it says since, and in how many readings alike
  std::size_t astray_readings_{0};
  std::optional<double> turned_rad_;
  double width_m_;
  bool measured_{false};           ///< the width, in this hallway
  std::array<Flank, 2> flanks_{};  ///< left, right
  std::optional<double> ahead_m_;
  bool wall_ahead_{false};
};

}  // namespace sensotwin::robot
