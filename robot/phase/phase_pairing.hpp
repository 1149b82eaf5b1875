// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "robot/base/epc.hpp"
#include "robot/base/time.hpp"
#include "robot/drivers/uhf_read.hpp"

namespace sensotwin::robot {

/// How the readings of two antennas become one phase difference.
enum class Pairing : std::uint8_t {
  /// Both antennas at one instant, as the paper supposes.
  kSameInstant,
  /// The newest of each, once both are new: what one does who overlooks that a commercial reader listens with
  /// one antenna after the other. The robot has driven on in between, which looks like a tag to the side:
  /// 2 k v tau (rho / d) cos(beta), and the robot ends up circling the tag (algorithms study, A.3).
  kLatest,
  /// Read 1-2-1: the phase of antenna 1 straight between its two readings, at the instant of antenna 2's; and
  /// the same with the antennas exchanged. Late by one slot.
  kInterpolated,
};

struct PairingConfig {
  Pairing pairing{Pairing::kSameInstant};
  std::uint16_t left_port{1};  ///< antenna 1 of the paper (phase_angle.hpp)
  std::uint16_t right_port{2};
  double phase_sign{1.0};  ///< +1: the reader's phase grows with distance; -1: falls (data study, 3.2: R420)
  bool pi_ambiguous{false};  ///< the reader tells phases up to pi only
  /// Delays of reader and cable per port, both ways together, as a calibration finds them (data study, 3.4:
  /// 35 to 75 ns): what their difference adds to the phase difference looks like a tag to the side.
  double left_delay_s{0.0};
  double right_delay_s{0.0};
  /// Readings count as one instant within this. Chosen: 0.2 mm of way, a thousandth of a wavelength's turn.
  Duration same_instant{std::chrono::milliseconds{1}};
  /// Readings further apart are not combined. Chosen: twice the 100 ms slot with which 1-2-1 was found to
  /// work (algorithms study, A.3) and some; at 0.2 m/s the phase moves by 2.0 rad meanwhile, less than half a
  /// turn.
  Duration longest_gap{std::chrono::milliseconds{260}};
};

/// Equation 2's phase difference, and when it held.
struct PhasePair {
  Instant at;
  double difference_rad{0.0};  ///< negative: the tag is on the left
};

/// Makes phase differences of one tag out of a reader's reports. Only readings of that tag count, and only
/// readings of one channel are combined: on another frequency, cable and tag add another phase.
class PhasePairing {
 public:
  PhasePairing(const PairingConfig& config, const Epc& tag) : config_(config), tag_(tag) {}

  /// Another tag; forgets what was read.
  void follow(const Epc& tag);
  /// \param read  in order of time
  /// \returns the phase difference that this reading completes, if it does
  [[nodiscard]] std::optional<PhasePair> add(const UhfRead& read);
  /// When the tag was last read by either antenna.
  [[nodiscard]] std::optional<Instant> last_read() const { return last_read_; }

 private:
  struct Reading {
    Instant at;
    std::uint16_t channel;
    double phase_rad;
  };
  /// One antenna: its newest reading, whether that was used up, and the one it had when the other antenna was
  /// last read.
  struct Side {
    std::optional<Reading> newest;
    bool fresh{false};
    std::optional<Reading> before_other;
  };
  /// The reading's phase at the antenna, growing with distance.
  [[nodiscard]] double at_antenna_rad(const UhfRead& read) const;
  [[nodiscard]] bool together(const Reading& a, const Reading& b, Duration within) const;
  [[nodiscard]] double difference(double left_rad, double right_rad) const;
  [[nodiscard]] std::optional<PhasePair> of_newest(Duration within);
  [[nodiscard]] std::optional<PhasePair> interpolated(std::size_t side);

  PairingConfig config_;
  Epc tag_;
  std::array<Side, 2> sides_;  ///< left, right
  std::optional<Instant> last_read_;
};

}  // namespace sensotwin::robot
