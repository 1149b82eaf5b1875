// SPDX-License-Identifier: MIT
#pragma once

#include "robot/base/geometry.hpp"
#include "robot/mapping/light_bumper.hpp"
#include "robot/mapping/pose_filter.hpp"

namespace sensotwin::robot {

/// How fast the robot goes about its work.
struct Pace {
  double speed_mps{0.3};   ///< chosen: 2 s a tile with its starts and stops
  double turn_radps{1.8};  ///< chosen: a quarter turn in a second; 0.21 m/s at the wheels
  /// Every tile move is given at least this long, every new tag this long more, the robot standing still for
  /// what is left of it. Zero: as fast as it goes. 3.4 s and 4.4 s are the paper's platform (algorithms
  /// study, B.2).
  double tile_s{0.0};
  double tag_s{0.0};
};

/// All that the mapping mission is told about its own body and its work. Nothing about the room.
struct MappingConfig {
  double tile_m{0.508};  ///< edge of a carpet tile, 20 inches (SensoBot, III.A)
  Pace pace;
  OdometryModel odometry;
  CompassModel compass;
  LightBumper light_bumper;
  double body_radius_m{0.17};
  double read_radius_m{0.08};  ///< of the floor antenna's zone
  /// A tag's coming and going is noticed this much late: half a reader poll and half a control step.
  double rim_delay_s{0.013};
  double rim_sigma_m{0.003};  ///< a rim crossing's place: 0.3 m/s times what is uncertain of the delay
  double tag_sigma_m{0.005};  ///< where the tag was laid
  double acceleration_mps2{0.8};
  double turn_acceleration_radps2{8.0};
  /// Tags are passed this far to the left of their middle, so that the width of the pass tells the side
  /// (PoseFilter).
  double aim_left_m{0.035};
  /// Something standing closer than this to the robot's way stops the body even if its idea of its own place
  /// is 3.5 cm wrong.
  double sure_clearance_m{0.135};
  double back_off_m{0.02};  ///< after a bump. Chosen: until the switch lets go
  /// Slower here: on detours and when looking for a lost tag.
  double careful_speed_mps{0.15};
};

}  // namespace sensotwin::robot
