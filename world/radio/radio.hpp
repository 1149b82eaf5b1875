// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/base/random.hpp"
#include "world/radio/radio_read.hpp"
#include "world/radio_description.hpp"

namespace sensotwin::world {

/// The robot's way within one tick: straight in place and in yaw, at an even pace.
struct RobotMotion {
  double begin_s{0.0};
  double end_s{0.0};
  robot::Pose2 X_WR_begin{};
  robot::Pose2 X_WR_end{};
};

/// Standard deviation of one read's noise by the law of `radio`, its scale included.
[[nodiscard]] double read_noise_rad(const RadioDescription& radio, double distance_m, double rssi_dbm);

/// Ceiling tags as a reader on the robot reads them.
///
///   phi = s (2 pi f (L / c + T) + echo) + theta + drift + noise + pi (flip + coin)    modulo 2 pi, in steps
///
/// | symbol      | meaning                                                               | unit  |
/// |-------------|-----------------------------------------------------------------------|-------|
/// | s           | sign: does phase grow or fall with distance                           | 1     |
/// | f, c        | frequency of the channel, speed of light                              | Hz, m/s |
/// | L           | way of the wave, see PathKind                                         | m     |
/// | T           | delay of reader and cable, of each antenna                            | s     |
/// | echo        | image sources, and the smooth error of the place                      | rad   |
/// | theta       | what the tag adds: constant                                           | rad   |
/// | drift       | Ornstein-Uhlenbeck, of each tag and antenna                           | rad   |
/// | noise       | normal and white, sd by NoiseLaw                                      | rad   |
/// | flip        | chance by RSSI; coin: one half where phases are known up to pi only   |       |
///
/// A pair of reads differs by a flip with P = 1 / (2 (1 + exp((RSSI - flip_rssi) / width))) (data
/// study, 3.7), so that one read is turned with q = (1 - sqrt(1 - 2 P)) / 2. A tag is read in each round in
/// which its RSSI, with its scatter from read to read, reaches the cut-off: the study found misses to be
/// fades, not coin tosses (3.8). Each read happens at an instant of its own, for which the robot's pose is
/// interpolated.
///
/// Deterministic. Random streams are forked by name for each tag and antenna: a further tag changes no other
/// tag's reads with a simultaneous reader (with one antenna after another it takes time from them).
class Radio {
 public:
  /// \param random the run's stream; the radio forks from it by name and draws nothing from it
  /// \pre channels, and slots for each antenna unless simultaneous; the scene reader checks it
  Radio(const RadioWorld& world, const robot::RandomStream& random);
  ~Radio();
  Radio(Radio&&) noexcept;
  Radio& operator=(Radio&&) noexcept;

  /// Goes on to motion.end_s. \returns what reports brought until then, in their order; valid until the next
  /// step. Costs nothing when no read is due.
  [[nodiscard]] std::span<const RadioRead> step(const RobotMotion& motion);

  /// Reads through these antennas (indices from 0) from `now_s` on, in this order: what a reader is told in
  /// its ROSpec. None: silent. At the beginning all are used from time 0 on.
  void use_antennas(std::span<const std::uint16_t> antennas, double now_s);

  /// Truth, for verdicts and bounds: the phase that a tag adds.
  [[nodiscard]] double tag_phase_rad(std::uint32_t tag) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sensotwin::world
