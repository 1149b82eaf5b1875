// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/drivers/uhf_read.hpp"

namespace sensotwin::robot {

/// One antenna on the robot, as the robot knows it. Frame: R, z above the floor.
struct AntennaMount {
  Eigen::Vector3d at_R_m{0.0, 0.0, 0.1};
  double cable_delay_s{0.0};  ///< reader and cable, counted once, as calibrated (data study, 3.4)
  /// Phase of this port against port 1, and how well it is known. Unknown (more than about one radian):
  /// learned from the first reads.
  double phase_offset_rad{0.0};
  double phase_offset_sigma_rad{0.0};
};

/// Standard deviation of one read's phase that the robot reckons with:
///
///   sigma^2 = floor^2 + (per_m d)^2 + (at_50dbm 10^(-(RSSI + 50) / 20))^2
///
/// and beside it what echoes bend, which reads nearby share: a Gauss-Markov process over the antenna's way,
/// and over frequency.
///
/// | symbol        | meaning                                                  | unit  |
/// |---------------|----------------------------------------------------------|-------|
/// | floor, per_m  | read noise, growing with the distance d of the tag       | rad, rad/m |
/// | at_50dbm      | read noise that follows RSSI (data study, 3.5)           | rad   |
/// | echo          | root mean square of what echoes add to a read's phase    | rad   |
/// | echo_length   | way over which it becomes another                        | m     |
/// | echo_delay    | spread of the echoes' delays: the frequency, the same    | s     |
struct PhaseNoise {
  double floor_rad{0.0};
  double per_m_rad{0.024};  ///< algorithms study, A.0: the paper's measurements
  double at_50dbm_rad{0.0};
  double echo_rad{0.0};
  /// Fringes of a direct and a reflected wave are a half to one wavelength apart on the floor; their phase is
  /// another after a sixth of that.
  double echo_length_m{0.05};
  double echo_delay_s{0.0};
  /// Of the read itself.
  [[nodiscard]] double variance(double distance_m, double rssi_dbm) const;
  /// What two reads of a tag by one antenna have apart.
  struct Apart {
    double way_m{0.0};  ///< of the antenna
    double hop_hz{0.0};
  };
  /// Correlation of their echoes.
  [[nodiscard]] double echo_kept(const Apart& apart) const;
  /// Variance of the echo if it were independent from read to read and had to say as little in sum. \param
  /// apart  from the last read
  [[nodiscard]] double echo_as_noise(const Apart& apart) const;
};

/// Reader and antennas as the robot knows them.
struct PhaseReaderModel {
  std::vector<AntennaMount> antennas;  ///< port 1 first. At most kMostAntennas
  bool monostatic{false};              ///< the same antenna sends and receives; else `transmitter_R_m` sends
  Eigen::Vector3d transmitter_R_m{0.0, 0.0, 0.1};
  double phase_sign{1.0};           ///< +1: the reported phase grows with distance; -1: falls
  bool pi_ambiguous{false};         ///< a phase may be reported half a turn off
  double centre_hz{915e6};          ///< where a tag's own phase is counted
  double cable_delay_sigma_s{0.0};  ///< of each antenna's cable_delay_s; matters where channels change
  PhaseNoise noise;

  static constexpr std::size_t kMostAntennas = 4;  ///< ports of a Speedway R420 (data study, 3.8)
  /// Wave number, rad/m. A reader that does not say its frequency is at the centre.
  [[nodiscard]] double wave_number(double frequency_hz) const;
  /// Difference of two phases, as small as its ambiguity lets it be: within half a turn, or a quarter.
  [[nodiscard]] double wrap(double rad) const;
  /// How wide `wrap` is: pi, or pi / 2.
  [[nodiscard]] double half_period_rad() const { return pi_ambiguous ? kPi / 2.0 : kPi; }
};

/// Two antennas, left and right of the robot's middle: the geometry of the algorithms study, A.0.
[[nodiscard]] std::vector<AntennaMount> antenna_pair(double spacing_m, double height_m);

/// Length of the way from transmitter over tag to receiver, and how it changes. At zero slant distance of
/// both, undefined.
struct WayLength {
  double length_m{0.0};
  double slant_m{0.0};                     ///< tag to the receiving antenna
  Eigen::Vector3d by_pose{0.0, 0.0, 0.0};  ///< d length / d (x, y, yaw) of the robot
  Eigen::Vector3d by_tag{0.0, 0.0, 0.0};   ///< d length / d (x, y, z) of the tag
};

/// Where a read's wave left the robot and came back, in R. For a read made a moment ago, where the antennas
/// then were as seen from the robot now: the read is so used at its own time.
struct WayEnds {
  Eigen::Vector3d transmitter_R_m{0.0, 0.0, 0.1};
  Eigen::Vector3d receiver_R_m{0.0, 0.0, 0.1};
};

/// \param antenna  port - 1  \param X_now_then  pose of the robot at the read, in its present frame
[[nodiscard]] WayEnds way_ends(const PhaseReaderModel& model, std::size_t antenna, const Pose2& X_now_then);

[[nodiscard]] WayLength way_length(const WayEnds& ends, const Pose2& X_MR, const Eigen::Vector3d& tag_M_m);

}  // namespace sensotwin::robot
