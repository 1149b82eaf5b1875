// SPDX-License-Identifier: MIT
#include "robot/phase/estimation/phase_model.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::robot {
namespace {

constexpr double kLightSpeed_mps = 299792458.0;

/// One straight leg between a point on the robot and the tag.
struct Leg {
  double length_m;
  Eigen::Vector3d by_pose;
  Eigen::Vector3d by_tag;
};

Leg leg(const Eigen::Vector3d& end_R_m, const Pose2& X_MR, const Eigen::Vector3d& tag_M_m, double c,
        double s) {
  // The end as seen from the robot's middle, in directions of M.
  const double ex = c * end_R_m.x() - s * end_R_m.y();
  const double ey = s * end_R_m.x() + c * end_R_m.y();
  const Eigen::Vector3d way{tag_M_m.x() - X_MR.p_m.x() - ex, tag_M_m.y() - X_MR.p_m.y() - ey,
                            tag_M_m.z() - end_R_m.z()};
  const double length = way.norm();
  const Eigen::Vector3d unit = way / length;
  return {length, {-unit.x(), -unit.y(), unit.x() * ey - unit.y() * ex}, unit};
}

Eigen::Vector3d moved(const Pose2& X, const Eigen::Vector3d& p) {
  const Vec2 flat = X * Vec2{p.x(), p.y()};
  return {flat.x(), flat.y(), p.z()};
}

}  // namespace

double PhaseNoise::variance(double distance_m, double rssi_dbm) const {
  const double far = per_m_rad * distance_m;
  const double weak = at_50dbm_rad > 0.0 ? at_50dbm_rad * std::pow(10.0, -(rssi_dbm + 50.0) / 20.0) : 0.0;
  return floor_rad * floor_rad + far * far + weak * weak;
}

double PhaseNoise::echo_kept(const Apart& apart) const {
  const double turn_rad = 2.0 * kPi * echo_delay_s * apart.hop_hz;
  return std::exp(-apart.way_m / echo_length_m - 0.5 * turn_rad * turn_rad);
}

double PhaseNoise::echo_as_noise(const Apart& apart) const {
  // A standing antenna hears the same echo again and again: its reads count as one in a millimetre at least.
  const double kept = echo_kept({std::max(apart.way_m, 1e-3), apart.hop_hz});
  return echo_rad * echo_rad * (1.0 + kept) / (1.0 - kept);
}

double PhaseReaderModel::wave_number(double frequency_hz) const {
  return 2.0 * kPi * (frequency_hz > 0.0 ? frequency_hz : centre_hz) / kLightSpeed_mps;
}

double PhaseReaderModel::wrap(double rad) const {
  return pi_ambiguous ? std::remainder(rad, kPi) : wrap_angle(rad);
}

std::vector<AntennaMount> antenna_pair(double spacing_m, double height_m) {
  AntennaMount left;
  left.at_R_m = {0.0, spacing_m / 2.0, height_m};
  AntennaMount right;
  right.at_R_m = {0.0, -spacing_m / 2.0, height_m};
  return {left, right};
}

WayEnds way_ends(const PhaseReaderModel& model, std::size_t antenna, const Pose2& X_now_then) {
  const Eigen::Vector3d& at_R_m = model.antennas[antenna].at_R_m;
  const Eigen::Vector3d receiver = moved(X_now_then, at_R_m);
  return {model.monostatic ? receiver : moved(X_now_then, model.transmitter_R_m), receiver};
}

WayLength way_length(const WayEnds& ends, const Pose2& X_MR, const Eigen::Vector3d& tag_M_m) {
  const double c = std::cos(X_MR.yaw_rad);
  const double s = std::sin(X_MR.yaw_rad);
  const Leg back = leg(ends.receiver_R_m, X_MR, tag_M_m, c, s);
  const Leg out =
      ends.transmitter_R_m == ends.receiver_R_m ? back : leg(ends.transmitter_R_m, X_MR, tag_M_m, c, s);
  return {out.length_m + back.length_m, back.length_m, out.by_pose + back.by_pose, out.by_tag + back.by_tag};
}

}  // namespace sensotwin::robot
