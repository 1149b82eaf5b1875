// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robot/drivers/uhf_read.hpp"
#include "robot/phase/estimation/dead_reckoning.hpp"
#include "robot/phase/estimation/phase_model.hpp"

namespace sensotwin::robot {

/// What the robot believes of its compass: noise, and a bias by the iron nearby that changes with the way.
struct CompassTrust {
  double noise_sigma_rad{0.026};     ///< 1.5 degrees (robot/mapping, pose_track.hpp)
  double bias_walk_rad{0.12};        ///< per square root of a metre: 5 degrees over half a metre of way
  double turn_bias_walk_rad{0.017};  ///< per square root of a radian turned
};

/// A row with few entries that are not zero: one measurement's Jacobian.
struct SparseRow {
  static constexpr int kMost = 12;
  std::array<int, kMost> at{};
  std::array<double, kMost> by{};
  int size{0};
  void add(int column, double value) {
    at[static_cast<std::size_t>(size)] = column;
    by[static_cast<std::size_t>(size)] = value;
    ++size;
  }
};

/// A phase as the filter expects it.
struct PhasePrediction {
  double phase_rad{0.0};
  double slant_m{0.0};
  SparseRow H;
};

/// Robot and tags together: an extended Kalman filter over
///
///     [ x, y, yaw of R in M; scale, turn scale, curvature of the wheels; compass bias;
///       phase offset of ports 2.. against port 1; cable error of every port (metres);
///       per tag: u_x, u_y, z, phase offset; echo at the transmitter, at every port ]
///
/// M is where R stood at the start. A tag's place is told by its direction u from an anchor a on the floor,
/// the horizontal part of the unit vector from the antennas' height above a,
///
///     p_M = a + (z - h) u / sqrt(1 - u^2),
///
/// because phases are almost linear in u however far the tag, and far from linear in x and y when it is far.
/// The anchor is where the robot was when the tag was added, and moves on with it (reanchor). Phases of every
/// read, each port by itself (the common mode of the ports tells a change of range to a millimetre;
/// algorithms study, A.4):
///
///     phase = sign (k L + (k - k_0) (c T_port + cable error)) + offset_tag + offset_port + noise
///
/// plus the echoes, Gauss-Markov processes over the antennas' way and over frequency (PhaseNoise; left out if
/// its echo is zero),
/// with L the way over the tag and k_0 the wave number of the centre, so that what the tag's own phase keeps
/// through all channels is one number, and a hop tells L itself.
///
/// At most kMostTags tags at once, so that a read costs a bounded time (estimator_cost_test.cpp prints what a
/// step takes). Never allocates after construction.
class JointFilter {
 public:
  static constexpr int kMostTags = 12;

  JointFilter(const PhaseReaderModel& model, const WheelModel& wheels, const CompassTrust& compass);

  void drive(const WheelStep& step);
  /// The body touches something in this control step.
  void touch();
  /// \param reading_rad  counter-clockwise from north
  void correct_by_compass(double reading_rad);

  /// A tag's place relative to the robot now, independent of what is known of the robot.
  struct NewTag {
    int id{0};
    Vec2 p_R_m{0.0, 0.0};
    Eigen::Matrix2d covariance_R_m2;
    double height_m{3.0};
    double height_sigma_m{0.0};
  };
  /// \returns false when there is no room. \pre !knows(tag.id)
  bool add(const NewTag& tag);
  /// As before it was removed: place in M and its covariance, what tied it to the rest forgotten.
  bool restore(int id, const Eigen::Vector3d& p_M_m, const Eigen::Matrix3d& covariance_m2);
  void remove(int id);
  /// What the tag's own phase was is forgotten: the next read tells.
  void forget_phase(int id);
  [[nodiscard]] bool knows(int id) const { return slot(id) >= 0; }
  [[nodiscard]] int tags() const { return static_cast<int>(ids_.size()); }
  [[nodiscard]] int id_in_slot(int slot) const { return ids_[static_cast<std::size_t>(slot)]; }

  enum class Fate : std::uint8_t {
    kUsed,
    kRejected,   ///< beyond the gate
    kOffsetSet,  ///< the prediction said nothing of the phase; the read told the tag's or port's offset
  };
  struct Outcome {
    Fate fate{Fate::kUsed};
    double innovation_rad{0.0};
    double variance{0.0};  ///< of the innovation
    double noise{0.0};     ///< of which read noise
  };
  /// \pre knows(id)  \param noise_scale2  factor on the model's variance
  Outcome read(int id, const UhfRead& read, const Pose2& X_now_then, double noise_scale2, double gate_sigmas);
  /// Covariance of a read made now whose phase is as expected, without gate and without doubt which turn of
  /// the phase it is: what the read can say at most. \pre knows(id)
  void inform(int id, const UhfRead& read);
  /// The robot's middle is over the tag, somewhere within these. \pre knows(id)
  void fix_over(int id, const Vec2& offset_M_m, const Vec2& along_M, double along_sigma_m,
                double across_sigma_m);

  /// Expected phase and its Jacobian. \pre knows(id)
  [[nodiscard]] PhasePrediction predict(int id, const UhfRead& read, const Pose2& X_now_then) const;

  [[nodiscard]] Pose2 pose() const { return {{x_(0), x_(1)}, x_(2)}; }
  [[nodiscard]] Eigen::Matrix3d pose_covariance() const { return P_.topLeftCorner<3, 3>(); }
  [[nodiscard]] Eigen::Vector3d tag_M_m(int id) const;
  [[nodiscard]] Eigen::Matrix3d tag_covariance(int id) const;
  /// Wheels as learned: what the robot did when the encoders said `step`.
  [[nodiscard]] WheelStep corrected(const WheelStep& step) const;
  /// Offsets of ports 2.. against port 1, and their variances.
  [[nodiscard]] Eigen::Vector3d port_offsets_rad() const;
  [[nodiscard]] Eigen::Vector3d port_offset_variances() const;
  /// How something changes with the place of a tag.
  struct TagPull {
    int id{0};
    Vec2 by_tag{0.0, 0.0};
  };
  /// Standard deviation of by_robot . robot + sum of by_tag . tag. An unknown tag counts as exactly known.
  [[nodiscard]] double sigma_m(const Vec2& by_robot, std::span<const TagPull> pulls) const;
  /// Standard deviation of n . (robot - (1 - part) from - part to): of the error beside a line between two
  /// tags. An unknown tag counts as exactly known.
  [[nodiscard]] double across_sigma_m(const Vec2& n_M, int from, int to, double part) const;

  /// Mean distance of the antennas from the robot's middle.
  [[nodiscard]] double antenna_arm_m() const { return antenna_arm_m_; }
  /// For tests and bounds: the whole state and its covariance.
  [[nodiscard]] Eigen::Ref<const Eigen::VectorXd> state() const { return x_.head(n_); }
  [[nodiscard]] Eigen::Ref<const Eigen::MatrixXd> covariance() const { return P_.topLeftCorner(n_, n_); }
  void set_state(const Eigen::VectorXd& x) { x_.head(n_) = x; }

 private:
  [[nodiscard]] int slot(int id) const;
  [[nodiscard]] int state_of(int id) const { return base_ + per_tag_ * slot(id); }
  [[nodiscard]] double project(const SparseRow& H);  ///< gain_ = P H'; returns H P H'
  void correct(double innovation, double variance);
  /// d (x, y, z) / d (u_x, u_y, z) of the tag in a slot.
  [[nodiscard]] Eigen::Matrix3d by_direction(int slot) const;
  /// d (x, y, z in M, phase offset) / d (u_x, u_y, z, phase at the anchor).
  [[nodiscard]] Eigen::Matrix4d by_states(int slot) const;
  /// Way from the anchor's middle to the tag and back.
  [[nodiscard]] double anchor_way_m(int slot) const;
  /// The tag's states are x, y, z in M and its phase offset; from now on they are told from the robot's
  /// present place.
  void become_directions(int slot, const Eigen::Vector3d& p_M_m);
  /// The tag's direction is told from the robot's present place from now on.
  void reanchor(int slot);
  /// P <- T P T', T the identity but for J at the four states from j.
  void turn_states(int j, const Eigen::Matrix4d& J);
  void keep_in_disc(int j);
  void begin_echoes(int j);
  [[nodiscard]] double echo_variance(int echo) const;
  void age_echoes(double frequency_hz);
  void set_offset(int j, double innovation, double from_state, double noise);

  const PhaseReaderModel& model_;
  WheelModel wheels_;
  CompassTrust compass_;
  int ports_;    ///< states of offsets of ports 2..
  int base_;     ///< states before the tags
  int echoes_;   ///< states of echoes per tag: none, or the transmitter's and each port's
  int per_tag_;  ///< states per tag
  int n_;
  Eigen::VectorXd x_;
  Eigen::MatrixXd P_;
  Eigen::VectorXd gain_;
  std::vector<int> ids_;
  std::array<Vec2, kMostTags> anchors_M_m_{};  ///< by slot
  double antenna_height_m_;
  bool compass_known_{false};
  double way_since_read_m_{0.0};  ///< of an antenna, while echoes were not aged
  double echo_hz_{0.0};           ///< at which the echoes are; 0: at no read yet
  double antenna_arm_m_{0.0};     ///< mean distance of the antennas from the robot's middle
};

}  // namespace sensotwin::robot
