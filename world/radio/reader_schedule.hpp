// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "world/radio_description.hpp"

namespace sensotwin::world {

/// When the reader asks which antenna on which channel (data study, 3.8).
///
/// Simultaneous: all antennas, `rate_hz` times a second from the start, without drift. Else one antenna after
/// another, each for its slot, to which each further tag adds `per_tag_s`. A hop is due every `dwell_s`; the
/// round is finished first, and `hop_dead_s` is lost. An antenna that hears nothing holds the reader up for
/// `silent_slot_s`.
class ReaderSchedule {
 public:
  ReaderSchedule(const RadioDescription& radio, std::size_t antennas);

  /// One inventory.
  struct Round {
    double begin_s{0.0};       ///< the first tag answers; infinite when no antenna is on
    std::uint16_t channel{0};  ///< position in the hop table, from 0
    /// Who listens: one antenna, or all of the simultaneous reader's. Valid until the next call of a member.
    std::span<const std::uint16_t> antennas;
  };
  [[nodiscard]] Round round() const;
  /// The present round is over; `answers` reads were made in it.
  void finish(std::size_t answers);
  /// From `now_s` on reads through these antennas (indices from 0), in this order; none: silent.
  void use_antennas(std::span<const std::uint16_t> antennas, double now_s);

 private:
  void hop_if_due();

  bool simultaneous_;
  double period_s_;
  double dwell_s_;
  double dead_s_;
  double per_tag_s_;
  double silent_slot_s_;
  std::vector<double> slots_s_;
  std::vector<std::uint16_t> antennas_;
  std::uint16_t channels_;
  std::uint16_t channel_{0};
  std::size_t turn_{0};     ///< in antennas_
  double start_s_{0.0};     ///< of the simultaneous reader's even beat
  std::uint64_t beats_{0};  ///< since then
  double begin_s_{0.0};
  double hop_due_s_;
};

}  // namespace sensotwin::world
