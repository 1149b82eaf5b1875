// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot/drivers/uhf_read.hpp"
#include "robot/phase/estimation/dead_reckoning.hpp"
#include "robot/phase/estimation/phase_model.hpp"

namespace sensotwin::robot {

/// Where a tag just heard may be: a Gaussian sum about the robot, in the frame O of dead reckoning.
///
/// Phases tell the direction u of a tag (the horizontal part of the unit vector towards it) almost linearly:
/// two antennas its part across the robot, motion its part along, and what either leaves open (in front or
/// behind, which turn of the phase) is told by the other. So the disc |u| < 1 is strewn with components,
/// evenly, each a small extended Kalman filter over
///
///     [ u_x, u_y from where the bank began; phase expected there; offsets of ports 2.. against port 1 ]
///
/// at the ceiling's height (why these: JointFilter). Every read weighs them; the light are dropped, those
/// grown together are joined, until one is left that is narrow enough to be treated as linear. Errors of dead
/// reckoning over that way enter as noise of the tag's place.
///
/// While nobody knows whether the cables of ports 1 and 2 are exchanged, each component has a twin that
/// believes so: on a straight way it sees a mirrored world that fits as well, in the first turn it does not.
///
/// Never allocates after construction.
class TagBank {
 public:
  TagBank(const PhaseReaderModel& model, const WheelModel& wheels);

  /// Begins anew about the robot. \param offsets_rad  of ports 2.. against port 1 as far as learned, with
  /// their variances
  void begin(const Pose2& X_OR, double height_m, const Eigen::Vector3d& offsets_rad,
             const Eigen::Vector3d& offset_variances, bool both_wirings);
  void clear() { count_ = 0; }
  [[nodiscard]] bool empty() const { return count_ == 0; }

  /// The robot moved, and is now at X_OR.
  void drive(const WheelStep& step, const Pose2& X_OR);
  /// \param X_OR  at the time of the read  \param noise_scale2  factor on the model's variance
  void read(const UhfRead& read, const Pose2& X_OR, double noise_scale2);

  struct Candidate {
    Vec2 p_O_m{0.0, 0.0};
    Eigen::Matrix2d covariance_m2{Eigen::Matrix2d::Zero()};
    Vec2 direction{0.0, 0.0};  ///< u, in O, from where the bank began
    Eigen::Matrix2d direction_covariance{Eigen::Matrix2d::Zero()};
  };
  /// Mean and covariance of all with the wiring as given. \pre !empty()
  [[nodiscard]] Candidate place() const;
  /// They are so near each other, and each so narrow, against their distance, that the place is as good as
  /// linear.
  [[nodiscard]] bool settled(const Pose2& X_OR) const;
  /// None explains the reads: mean of squared innovations over their variance, of the best, over the last
  /// reads.
  [[nodiscard]] double misfit() const { return misfit_; }
  /// Log of how much better the reads fit exchanged cables.
  [[nodiscard]] double exchange_evidence() const;
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] double driven_m() const { return driven_m_; }

  static constexpr std::size_t kMostComponents = 1024;

 private:
  static constexpr int kMostStates = 2 + static_cast<int>(PhaseReaderModel::kMostAntennas);
  using State = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostStates, 1>;
  using Covariance = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostStates, kMostStates>;
  struct Component {
    State x;
    Covariance P;
    double log_weight;
    double last_fit;  ///< squared innovation over its variance, of the last read
    bool exchanged;
  };
  struct Tally {
    double best{-1e300};
    double sum{0.0};  ///< of weights against the best
    std::size_t index{0};
  };
  void strew(const Pose2& X_OR, bool exchanged, const Eigen::Vector3d& offsets_rad,
             const Eigen::Vector3d& offset_variances);
  [[nodiscard]] Vec2 place_O_m(const Vec2& u) const;
  [[nodiscard]] Eigen::Matrix2d by_direction(const Vec2& u) const;  ///< d place / d u
  void spread();
  void weigh(Component& component, const UhfRead& read, const Pose2& X_OR, double noise_scale2,
             double echo) const;
  [[nodiscard]] Tally tally(bool exchanged) const;
  void prune();
  void join();

  const PhaseReaderModel& model_;
  WheelModel wheels_;
  int states_;
  std::vector<Component> components_;
  std::size_t count_{0};
  double spacing_{0.2};   ///< of components, in u
  double narrow_u_{0.2};  ///< one sigma of u with which no phase is taken for another
  double height_m_{3.0};
  double above_m_{2.9};  ///< the antennas
  Vec2 anchor_O_m_{0.0, 0.0};
  Vec2 robot_O_m_{0.0, 0.0};
  double pending_m_{0.0};
  double pending_rad_{0.0};
  std::array<double, PhaseReaderModel::kMostAntennas> way_since_read_m_{};
  std::array<double, PhaseReaderModel::kMostAntennas> last_hz_{};  ///< 0: not read yet
  double driven_m_{0.0};
  double misfit_{1.0};
  int reads_{0};
  bool both_wirings_{false};
};

}  // namespace sensotwin::robot
