// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/base/random.hpp"
#include "robot/phase/phase_io.hpp"

namespace sensotwin::robot::testing {

/// A tag under the ceiling and, if laid, the floor tag below it. Frame: W.
struct KinematicTag {
  Epc epc;
  Vec2 at_m{0.0, 0.0};
  double height_m{3.0};
  bool present{true};    ///< false: listed, fallen off the ceiling (its floor tag stays)
  bool floor_tag{true};  ///< one with the same EPC lies below it
};

/// What the wheels do not do as counted (algorithms study, A.0). One sigma; the first three are drawn once
/// per run.
struct KinematicErrors {
  double scale{0.01};  ///< travelled / counted - 1
  double turn_scale{0.01};
  double curvature_rad_per_m{0.004};
  double along_m{0.005};                  ///< per square root of a metre
  double heading_rad{rad_from_deg(0.5)};  ///< per square root of a metre
  std::optional<double> compass_rad;      ///< noise of a compass; none: no compass
};

/// Antennas, reader and air (algorithms study, A.0 and A.3).
struct KinematicRadio {
  double wavelength_m{0.328};
  double spacing_m{0.16};  ///< port 1 left, port 2 right of the robot's middle
  double antenna_height_m{0.10};
  bool cables_swapped{false};
  bool monostatic{false};  ///< 2 k d_i + o; else k (d_tx + d_i) + o, transmitted in the robot's middle
  double phase_sign{1.0};  ///< +1: grows with distance
  double noise_rad_per_m{0.024};
  bool pi_ambiguous{false};  ///< each phase known up to pi only, by a coin
  /// Image sources of each tag: mirrored in walls 2 to 5 m from it, of this amplitude relative to the direct
  /// way.
  int images{0};
  double image_amplitude{0.0};
  /// All ports at one instant, `rate_hz` times a second; else one port after another by `port_order`,
  /// `slot_s` each. {1, 2} is plain multiplexing, {1, 2, 1} the bracket that interpolation wants.
  bool simultaneous{true};
  double rate_hz{20.0};
  std::vector<std::uint16_t> port_order{1, 2};
  double slot_s{0.05};
  double loss{0.0};               ///< share of the reads that get lost, each by itself
  std::optional<double> range_m;  ///< slant range beyond which tags are not read; none: no limit
  double floor_radius_m{0.05};    ///< of a floor tag's zone (A.0: r)
};

/// A unicycle under ceiling tags: enough to try phase missions where Box2D is not installed, and fast enough
/// for hundreds of seeds. The body has no inertia and the floor no walls; each wheel does what it is told, up
/// to 0.5 m/s, within the errors of A.0.
class KinematicRobot {
 public:
  static constexpr double kWheelBase_m = 0.235;  ///< Create 2 Open Interface 2016, packet 20
  static constexpr double kMetresPerCount = kPi * 0.0720 / 508.8;  ///< same, packet 43
  static constexpr double kTopSpeed_mps = 0.5;                     ///< same, opcode 145

  KinematicRobot(std::vector<KinematicTag> tags, const Pose2& X_WR, const KinematicErrors& errors,
                 const KinematicRadio& radio, std::uint64_t seed);

  /// Drives for one tick under `command`. \returns what the drivers say at its end; its reads are valid until
  /// the next call
  [[nodiscard]] const PhaseSensed& step(const PhaseCommand& command);

  /// The reader hears nothing in [from, to), and says that it is down if `noticed`.
  void silence(Instant from, Instant to, bool noticed);
  /// For faults in mid-run: take a tag off, move it, give it another's EPC. Its offset and images stay.
  [[nodiscard]] std::vector<KinematicTag>& tags() { return tags_; }

  [[nodiscard]] const Pose2& X_WR() const { return X_WR_; }
  [[nodiscard]] Instant now() const { return now_; }
  [[nodiscard]] double driven_m() const { return driven_m_; }
  [[nodiscard]] std::uint64_t reads_made() const { return reads_made_; }

 private:
  struct TagSecrets {
    double offset_rad;
    std::vector<Vec2> images_m;
  };
  /// Motion of one tick: constant speeds, so that the pose at any instant within is exact.
  struct Stride {
    double forward_m;
    double turn_rad;
  };
  [[nodiscard]] Stride stride(const WheelSpeeds& wheels);
  void count(const WheelSpeeds& wheels);
  [[nodiscard]] static Pose2 along(const Pose2& X_WR, const Stride& stride, double part);
  void read_tags(const Pose2& X_WR_before, const Stride& stride);
  void read_port(const Pose2& X_WR, Instant at, std::uint16_t port);
  [[nodiscard]] double slant_m(const KinematicTag& tag, const Vec2& p_W_m, const Vec2& source_m) const;
  [[nodiscard]] std::complex<double> path(std::size_t tag, const Vec2& p_W_m) const;
  void sense_floor(const Vec2& before_W_m);

  std::vector<KinematicTag> tags_;
  std::vector<TagSecrets> secrets_;
  KinematicErrors errors_;
  KinematicRadio radio_;
  Pose2 X_WR_;
  double scale_;
  double turn_scale_;
  double curvature_rad_per_m_;
  RandomStream motion_noise_;
  RandomStream phase_noise_;
  RandomStream coin_;
  RandomStream loss_;
  RandomStream compass_noise_;
  Instant now_;
  std::int64_t ticks_{0};
  std::int64_t rounds_{0};
  double driven_m_{0.0};
  double left_counts_{0.0};
  double right_counts_{0.0};
  std::int64_t counted_left_{0};
  std::int64_t counted_right_{0};
  std::optional<std::size_t> over_floor_tag_;
  Instant silent_from_;
  Instant silent_to_;
  bool silence_noticed_{false};
  std::uint64_t reads_made_{0};
  std::vector<UhfRead> reads_;
  PhaseSensed sensed_;
};

}  // namespace sensotwin::robot::testing
