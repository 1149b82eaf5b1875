// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "robot/calibration/wheel_log.hpp"
#include "robot/mapping/pose_track.hpp"

namespace sensotwin::robot {

/// A figure and its standard deviation.
struct Measured {
  double value{0.0};
  double sigma{0.0};
};

/// What is held true before the drive: where the fit begins, and how far from there it may go.
struct WheelPrior {
  OdometryModel wheels{};  ///< as the robot file tells them; the scatter of what changes on the way
  double tile_m{0.508};
  double read_radius_m{0.08};
  double rim_sigma_m{0.003};     ///< a rim crossing's place: the step that it falls into
  double tag_sigma_m{0.005};     ///< where a tag was laid, each way. Data study; chosen: hand-laid
  double notice_delay_s{0.013};  ///< tags are noticed this much late
  double notice_sigma_s{0.0};    ///< with this scatter
};

/// How far apart the robot and its own word of where it is are after a lap, as UMBmark takes it: the mean
/// over the laps of one direction, the greater of both directions (Borenstein and Feng 1996, eq. 2.3).
struct ClosureError {
  double before_m{0.0};  ///< by the wheels as they were told
  double after_m{0.0};   ///< by the fitted ones, on the same laps
};

/// What the drive says of the wheels and of the antenna under the robot.
struct WheelFit {
  Measured wheel_base_m;
  Measured metres_per_count;  ///< mean of both wheels
  Measured wheel_ratio;       ///< right wheel's diameter over the left's
  Measured read_radius_m;
  Measured notice_delay_s;
  ClosureError closure;
  std::array<std::size_t, 2> laps{};  ///< counter-clockwise, clockwise
  std::size_t crossings{0};
  std::size_t outliers{0};  ///< crossings that fit nowhere, and count little
  /// The greatest of the three wheels' figures, as parts of the value: as it is, and as it would be if the
  /// tags lay exactly on their grid. More laps make the second smaller, a longer side the first.
  double relative_sigma{0.0};
  double relative_sigma_of_laps{0.0};
  /// Mean square of what is left over, in its standard deviation: 1 when the world is as assumed.
  double misfit{0.0};
};

/// Fits the wheels to a drive over tags that lie on a grid.
///
/// A lap round a square tells wheel base and unequal wheels apart when it is driven both ways round: a base
/// that is told wrongly turns too far, or not far enough, in every corner of both; a wheel that is larger
/// than the other bends the sides inwards in one and outwards in the other (UMBmark: J. Borenstein, L. Feng,
/// Measurement and Correction of Systematic Odometry Errors in Mobile Robots, IEEE Trans. Robotics and
/// Automation 12(6), 1996). UMBmark measures the end of each lap with a ruler; here every tag on the way is a
/// ruler: where the antenna enters and leaves its read zone it is on a circle round it, so that the chord's
/// middle says how far along the robot is and its length how far aside. That is more than twenty rulers a
/// lap, and errors that are drawn anew on the way do not add up over it.
///
/// Unknown: mean scale, ratio, base; the zone's radius and the reader's delay; each tag's own place about its
/// grid point; the pose at each crossing. Measured: between two crossings, the way by the counts,
///
///     dl = 2 / (1 + ratio) c N_l,  dr = 2 ratio / (1 + ratio) c N_r,  d = (dl + dr) / 2,
///     dyaw = (dr - dl) / b          (c metres per count, ratio = D_r / D_l; the paper's eq. 5.10 to 5.12)
///
/// with the scatter of OdometryModel; at a crossing, |antenna - tag| = radius, the antenna where it was one
/// delay earlier. Least squares by Gauss and Newton, crossings beyond three deviations weighed down (Huber);
/// the standard deviations are those of the normal equations, times the misfit where that is above 1.
///
/// The antenna is under the middle of the axle (docs/hardware.md). \returns nothing when the log has too few
/// crossings for its unknowns, or the equations do not converge
[[nodiscard]] std::optional<WheelFit> fit_wheels(const WheelLog& log, const WheelPrior& prior);

}  // namespace sensotwin::robot
