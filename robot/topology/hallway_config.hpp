// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "robot/base/geometry.hpp"
#include "robot/base/time.hpp"
#include "robot/topology/hallway_io.hpp"

namespace sensotwin::robot {

/// What it keeps to in a hallway.
enum class HallwayLine : std::uint8_t {
  kMiddle,  ///< between the walls
  kLeft,    ///< at HallwayConfig::wall_m from the left wall
  kRight,   ///< from the right wall
};

/// How the robot is built and how it behaves in hallways. What the two pages of the paper at hand leave open
/// (sonar layout, tag range, speed) is assumed, as algorithms study, D, lists it.
struct HallwayConfig {
  double wheel_base_m{0.235};                     ///< Create 2 Open Interface 2016, packet 20
  double metres_per_count{kPi * 0.0720 / 508.8};  ///< same, packet 43
  double wheel_ratio{1.0};  ///< right wheel's diameter over the left's; metres_per_count is of their mean
  double radius_m{0.17};    ///< same: the shell

  /// Where each rangefinder looks, counter-clockwise from forward, left to right: two to each side, square to
  /// the wall and 30 degrees ahead of that, three forward. Assumed.
  std::array<double, kSonars> sonar_bearings_rad{0.5 * kPi,  kPi / 3.0,  kPi / 9.0, 0.0,
                                                 -kPi / 9.0, -kPi / 3.0, -0.5 * kPi};
  double sonar_radius_m{0.15};  ///< of the ring they stand on. Chosen: on the shell
  double sonar_range_m{5.0};    ///< Tsukiyama, section 4

  /// The plan's north, counter-clockwise from magnetic north.
  double plan_north_rad{0.0};
  /// From a tag to the middle of its place, and how near a tag is read. Assumed: it hangs where the hallway
  /// meets the junction, half a hallway's width off its middle; algorithms study, D: 0.3 to 1 m.
  double tag_to_middle_m{1.0};
  double tag_reach_m{0.3};
  double hallway_width_m{2.0};  ///< until the first has been measured. Algorithms study, D: 1.5 to 2.5 m

  HallwayLine follow{HallwayLine::kMiddle};
  double wall_m{0.6};  ///< to the wall that is followed; at most half the width. Chosen: the robot and a hand

  double speed_mps{0.3};          ///< Chosen: 60 % of the Roomba's 0.5 m/s leaves room to correct
  double turn_radps{1.5};         ///< Chosen: a quarter turn a second
  double acceleration_mps2{0.5};  ///< Chosen: wheels do not slip

  /// A hallway is open where no wall is seen over so much way. A doorway of 0.9 m looks some 0.4 m wide to a
  /// sonar with a cone of 30 degrees, a hallway of 1.5 m a metre. Chosen: between them.
  double opening_m{0.65};
  /// Nearer than this ahead something is in the way: it stops. Chosen: the braking way at 0.3 m/s is 0.09 m.
  double stop_m{0.40};
  /// So long it waits for what stands in the way to leave: people do. Chosen.
  Duration patience{std::chrono::seconds{8}};
  /// The map's lengths are from middle to middle, off a plan: wrong by so much. Chosen: a tape measure over a
  /// plan.
  double length_slack{0.10};
  double length_slack_m{1.0};
  /// A place that the sonars see so far from where the map and the wheels have it is not believed before its
  /// tag is read, and one that should have come by so much way is looked for behind. Chosen: half of the
  /// above.
  double sure_slack{0.05};
  double sure_slack_m{0.5};
  /// Without a place for so much way beyond what the map says, it is lost. Chosen.
  double overshoot_m{6.0};
  /// The longest way to a place when the map gives no length. Chosen: a long hallway.
  double longest_m{120.0};
};

}  // namespace sensotwin::robot
