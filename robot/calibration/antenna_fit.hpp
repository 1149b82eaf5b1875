// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/calibration/antenna_log.hpp"
#include "robot/calibration/wheel_fit.hpp"
#include "robot/phase/estimation/phase_model.hpp"

namespace sensotwin::robot {

/// One port of the reader, as it was measured.
struct FittedPort {
  std::size_t port{1};
  std::size_t reads{0};
  Measured forward_m;  ///< antenna in R
  Measured left_m;
  Measured cable_delay_s;     ///< reader and cable, counted once
  Measured phase_offset_rad;  ///< against port 1, at the middle of the band
};

struct AntennaFit {
  std::vector<FittedPort> ports;
  std::size_t channels{0};   ///< heard
  double band_hz{0.0};       ///< from the lowest of them to the highest; a delay needs some
  bool delays_known{false};  ///< the band was wide enough for them; else they are as told
  Vec2 tag_O_m{0.0, 0.0};    ///< from the first spot, the robot's first heading along x
  double spread_rad{0.0};    ///< of a read's phase about the fit: noise and echoes
};

/// What is held true before: the robot file's reader, and how far its figures may be off.
struct AntennaPrior {
  PhaseReaderModel reader;
  double tag_height_m{3.0};
  double mount_sigma_m{0.02};  ///< of an antenna's place. Chosen: a folding rule and the middle of a patch
  double tag_within_m{1.0};    ///< of the first spot. 1 sigma. Chosen
  double delay_max_s{150e-9};  ///< twice the longest found (data study, 3.4: 35 to 75 ns)
};

/// Fits antennas and cables to the phases of one tag, heard while the robot turned under it at two spots.
///
/// Of one port, read at pose X on frequency f (phase_model.hpp; s the sign of the reader's phase):
///
///     phase = s (2 pi f / c) way(X, antenna, tag) + s 2 pi (f - centre) delay + offset + tag's own phase
///
/// Turning carries the antenna round a circle, and the way goes up and down with it by r_antenna r_tag / h
/// (each way): which says where the tag is and how far round the port's antenna sits against the others. How
/// far out it sits only a second spot says, at a distance known from the wheels. The mean over the turn is
/// what does not depend on where the antenna is: its difference from port 1's is the offset, and how it
/// changes from channel to channel the delay.
///
/// Least squares by Gauss and Newton from a grid of delays and of places for the tag. What is left over is
/// not drawn anew with each read: echoes stay while the antenna moves by some centimetres, on all channels
/// nearly alike. So the standard deviations are those of a jackknife that leaves out a quarter of a turn at a
/// time (B. Efron, The Jackknife, the Bootstrap and Other Resampling Plans, SIAM 1982, section 3.1), and
/// beside it a part of the spread that stays the same wherever the robot turns.
///
/// \returns nothing when a port was hardly heard, or no place of the tag explains the phases
[[nodiscard]] std::optional<AntennaFit> fit_antennas(const std::vector<PlacedRead>& reads,
                                                     const AntennaPrior& prior);

}  // namespace sensotwin::robot
