// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/base/random.hpp"
#include "world/radio/wave_field.hpp"
#include "world/radio_description.hpp"

namespace sensotwin::world {

/// Image sources are level with their tag, in any direction, evenly between these distances: walls 2 to 5 m
/// from the tag (algorithms study, A.3), the images twice as far.
inline constexpr double kNearestImage_m = 4.0;
inline constexpr double kFarthestImage_m = 10.0;

/// Stream of all that is drawn for one ceiling tag, below the radio's own. Named by the tag, not by its place
/// in the list nor by its EPC, so that neither a further tag nor swapped EPCs change what the others' air
/// does.
[[nodiscard]] robot::RandomStream stream_of(const CeilingTag& tag, const robot::RandomStream& radio);

/// What lies between antennas and ceiling tags, without the reader: path lengths, echoes, strength.
///
///   L    = d_tx + d_rx (bistatic), 2 d (monostatic)
///   RSSI = RSSI_1m + slope / 2 (lg d_1 + lg d_2) + (G - A_1 - G_ref) + (G - A_2 - G_ref) - 2 shadow
///          + 20 lg |g_1 g_2| + place fading + channel fading
///   A    = min(-10 n lg cos(theta), 20 dB), n such that A is 3 dB at half the beam's width
///   g    = 1 + a sum_j exp(-i k (d_j - d))
///
/// | symbol   | meaning                                                                      | unit |
/// |----------|------------------------------------------------------------------------------|------|
/// | d, d_j   | from the tag, from its j-th image source, to the antenna; 1, 2: way out, back | m    |
/// | theta    | between boresight and the tag                                                | rad  |
/// | G, A     | antenna's gain, and its pattern: cos^n, side lobes at -20 dB (chosen)        | dBi, dB |
/// | a, k     | relative amplitude of an image; 2 pi f / c                                   | 1, rad/m |
///
/// The bistatic transmitter stands in the middle of the robot, as high as the first antenna, and looks
/// straight up with the pattern of the receiving antenna. Left out: polarisation, near field, tags that
/// couple to each other, people.
class Air {
 public:
  /// \param radio_random the radio's stream
  Air(const RadioWorld& world, const robot::RandomStream& radio_random);

  /// Where the antennas are and look when the robot is at X_WR. Kept until the next call.
  void place(const robot::Pose2& X_WR);

  struct Heard {
    double distance_m{0.0};  ///< receiving antenna to tag
    double path_m{0.0};      ///< L
    double echo_rad{0.0};    ///< the images' part of the phase lag, and the smooth error of the place
    double rssi_dbm{0.0};
  };
  /// The tag by this antenna on this channel; nothing when it is not there, or so weak that no luck of a
  /// single read could lift it over the cut-off. \pre place() was called
  [[nodiscard]] std::optional<Heard> hear(std::uint32_t tag, std::uint16_t antenna,
                                          std::uint16_t channel) const;

 private:
  struct Aerial {
    Eigen::Vector3d p_W_m{0.0, 0.0, 0.0};
    Eigen::Vector3d boresight_W{0.0, 0.0, 1.0};
    double over_reference_db{0.0};
    double pattern_exponent{0.0};
    double least_cosine{0.0};  ///< where the pattern reaches its floor
  };
  struct Ceiling {
    Eigen::Vector3d p_W_m{0.0, 0.0, 0.0};
    double loss_db{0.0};
    bool present{true};
  };
  struct Fields {
    WaveField phase_rad;
    WaveField place_db;
    WaveField channel_db;
  };
  [[nodiscard]] std::complex<double> echo_gain(std::uint32_t tag, const Eigen::Vector3d& from_W_m, double d_m,
                                               double k_radpm) const;
  void add_fields(const robot::RandomStream& random);
  void add_images(const Ceiling& tag, robot::RandomStream random);

  RadioDescription radio_;
  std::vector<AntennaDescription> described_;
  double hopeless_dbm_;
  double band_middle_hz_{0.0};
  std::vector<Ceiling> tags_;
  std::vector<Eigen::Vector3d> images_W_m_;  ///< radio_.images of each tag
  std::vector<Fields> fields_;               ///< of each tag and antenna; empty when all are zero
  std::vector<Aerial> aerials_;
  Eigen::Vector3d transmitter_W_m_{0.0, 0.0, 0.0};
};

}  // namespace sensotwin::world
