// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/robot/phase/kinematic_robot.hpp"

namespace sensotwin::robot::testing {

/// One of the paper's experiments: where its tags hang, the ordered list that the robot is given, where it
/// starts. Coordinates of the algorithms study, A.1; the paper prints only those of the first two (section
/// V.A) and draws the rest. Frame: W.
struct PhaseExperiment {
  std::string name;
  std::vector<KinematicTag> tags;
  /// Indices into `tags`. Leg i ends at tag order[i]; leg 0 comes from the start. Where the robot starts
  /// under a tag, that tag is first, and leg 0 has no length.
  std::vector<std::size_t> order;
  Pose2 X_WR_start;

  /// The list that a mission is given.
  [[nodiscard]] std::vector<Epc> destinations() const;
};

/// "Following a line segment" (V.A) at an initial orientation of 90 (E1) and 0 degrees (E2).
[[nodiscard]] PhaseExperiment line_at_90();
[[nodiscard]] PhaseExperiment line_at_0();
/// "Following a complex path with acute angles" (V.B), in three readings of its figure (E3).
[[nodiscard]] PhaseExperiment star();
[[nodiscard]] PhaseExperiment triangle();
[[nodiscard]] PhaseExperiment zigzag();
/// "Following a hallway" (V.C), 7 tags (E4).
[[nodiscard]] PhaseExperiment hallway();
/// One tag at the origin, the robot anywhere in the square of half-width `reach_m` about it, facing anywhere.
[[nodiscard]] PhaseExperiment homing(double reach_m, std::uint64_t seed);

/// EPC of the n-th tag of an experiment.
[[nodiscard]] Epc experiment_epc(std::size_t n);

/// The paper's tracking error and its equation 4 (V): the signed perpendicular distance to the line of the
/// segment being followed, left of travel positive (A.0). Counted are the legs that begin at a tag, as in the
/// paper ("after that, the robot started to track its target trajectory; the tracking error of this phase is
/// what is shown"): all but leg 0.
class PathScore {
 public:
  explicit PathScore(const PhaseExperiment& experiment) : experiment_(experiment) {}

  /// \param leg  being driven, as the mission says it: index of the destination in `order`
  void sample(std::size_t leg, const Vec2& p_W_m);

  [[nodiscard]] double rmse_m() const;
  [[nodiscard]] double error_min_m() const { return min_m_; }
  [[nodiscard]] double error_max_m() const { return max_m_; }
  /// Root mean square of the distance to the nearest point of the whole path, for comparison.
  [[nodiscard]] double nearest_rms_m() const;
  [[nodiscard]] int samples() const { return samples_; }
  /// \pre 1 <= leg < order.size()
  [[nodiscard]] double error_m(std::size_t leg, const Vec2& p_W_m) const;

 private:
  PhaseExperiment experiment_;
  int samples_{0};
  double squares_m2_{0.0};
  double nearest_squares_m2_{0.0};
  double min_m_{0.0};
  double max_m_{0.0};
};

}  // namespace sensotwin::robot::testing
