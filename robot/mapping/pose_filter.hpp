// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/mapping/pose_track.hpp"

namespace sensotwin::robot {

/// A tag's read zone: a disc on the floor.
struct ReadZone {
  Vec2 tag_M_m{0.0, 0.0};
  double radius_m{0.08};
  double rim_sigma_m{0.003};  ///< how well a crossing of the rim is timed, as a distance
  double tag_sigma_m{0.005};  ///< how well the tag was laid
};

/// Where the robot is on its own map: a few beliefs (PoseTrack) with weights.
///
/// A reader says when a tag comes and goes, not on which side it passes. The way between the two rim
/// crossings is a chord of the zone, known to millimetres from the encoders; half its length h puts the tag
/// at q = sqrt(radius^2 - h^2) beside its middle, to the left or to the right. So the end of a pass fixes the
/// place along the way, and the place across it up to a mirror image. Each belief splits in two; what comes
/// next (another chord, a tag that does not answer) tells which was right. Passing tags off their middle on
/// purpose keeps the images apart.
class PoseFilter {
 public:
  PoseFilter(const OdometryModel& odometry, const CompassModel& compass);

  void reset(const Pose2& X_MR, double position_sigma_m, double yaw_sigma_rad);
  /// \param contact_yaw_R_rad  where on the shell the body touches something in this control step, if it does
  void drive(int counts_left, int counts_right, std::optional<double> contact_yaw_R_rad = std::nullopt);

  /// A tag answers for the first time: the rim was crossed `late_m` of way ago.
  void enter_zone(double late_m);
  /// The tag that answered since enter_zone() is this one: corrects along the way of entry.
  void identify_zone(const ReadZone& zone);
  /// It ceased to answer, `late_m` of way ago: corrects along and across.
  void leave_zone(const ReadZone& zone, double late_m);
  /// The robot has driven along `along_M` past the place of a tag that should have answered, and none did.
  void miss_zone(const ReadZone& zone, const Vec2& along_M);
  /// The antenna is over this tag, somewhere in its zone, though no belief expected it: all are doubted, then
  /// drawn there. How far off they were also tells how wrong the heading was.
  void find_at(const ReadZone& zone);
  /// \param reading_rad  counter-clockwise from north
  void correct_by_compass(double reading_rad);

  /// Of the belief with the greatest weight.
  [[nodiscard]] const Pose2& pose() const { return beliefs_.front().track.pose(); }
  [[nodiscard]] double across_sigma_m();
  /// The greater of the standard deviations along and across.
  [[nodiscard]] double position_sigma_m();
  [[nodiscard]] double yaw_sigma_rad() { return beliefs_.front().track.yaw_sigma_rad(); }
  /// Metres travelled by the encoders' word since construction, never reset.
  [[nodiscard]] double path_length_m() const { return path_length_m_; }
  [[nodiscard]] double turned_rad() const { return turned_rad_; }
  /// Pose by encoders alone, from nominal geometry: for the log.
  [[nodiscard]] const Pose2& odometry() const { return X_OR_; }

 private:
  struct Belief {
    PoseTrack track;
    double log_weight{0.0};
  };
  void settle_weights();
  /// The antenna was on the rim of this zone when the robot was `since_m` from where it is now.
  static void correct_rim(Belief& belief, const ReadZone& zone, const Vec2& since_m);
  void correct_chord(Belief& belief, const ReadZone& zone, double late_m, std::vector<Belief>& out) const;

  OdometryModel model_;
  std::vector<Belief> beliefs_;  ///< never empty, the heaviest first
  Pose2 X_OR_;
  double path_length_m_{0.0};
  double turned_rad_{0.0};
};

}  // namespace sensotwin::robot
