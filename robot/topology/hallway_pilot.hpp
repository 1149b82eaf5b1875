// SPDX-License-Identifier: MIT
#pragma once

#include "robot/base/task.hpp"
#include "robot/topology/hallway_tracker.hpp"

namespace sensotwin::robot {

/// One control step's input and output, shared by everything that runs in it.
struct HallwayStep {
  HallwaySensed sensed;
  HallwayCommand command;
  StepSignal next;
};

/// Moves a robot through hallways: keeps to their middle, turns in junctions, passes what stands in the way.
class HallwayPilot {
 public:
  HallwayPilot(const HallwayConfig& config, HallwayTracker& tracker, HallwayStep& step)
      : config_(config), tracker_(tracker), step_(step) {}

  /// One step along the hallway: sets the wheel command. \param speed_mps  towards which the speed is ramped
  /// \param by_walls  or straight on
  void follow(double speed_mps, bool by_walls = true);

  Task<> brake();
  /// On the spot, until it heads there. \param heading_rad  counter-clockwise from the plan's north
  Task<> turn_to(double heading_rad);
  /// Along the hallway again, that it goes on along.
  Task<> face_axis();
  /// So far along the hallway, or until something is nearer ahead than the shell's own clearance.
  Task<> advance(double way_m);
  /// Straight back, blind.
  Task<> back(double way_m);
  Task<> wait(Duration time);
  /// Swings out to the side of what stands ahead and past it, when there is room; else back to where it was.
  /// \param left  which side to try
  /// \returns whether it got past
  Task<bool> pass_on(bool left);

  [[nodiscard]] bool bumped() const { return step_.sensed.bump_left || step_.sensed.bump_right; }
  /// Something stands so near ahead that it has to stop.
  [[nodiscard]] bool in_the_way() const {
    return bumped() || tracker_.ahead_m().value_or(config_.sonar_range_m) < config_.stop_m;
  }

 private:
  void command(double speed_mps, double turn_radps);
  [[nodiscard]] double ramped(double speed_mps) const;
  Task<> turn_by_heading(double heading_rad);

  const HallwayConfig& config_;
  HallwayTracker& tracker_;
  HallwayStep& step_;
  double speed_mps_{0.0};
  bool straight_on_{false};  ///< while something is passed: walls do not matter
};

}  // namespace sensotwin::robot
