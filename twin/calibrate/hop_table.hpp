// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "robot/base/random.hpp"

namespace sensotwin::twin {

/// Frequencies that a reader of one region hops over, without their order.
struct Band {
  double first_hz{902.75e6};  ///< FCC: 47 CFR 15.247, as an R420's capabilities list it
  double step_hz{0.5e6};
  int channels{50};
  [[nodiscard]] double at_hz(int slot) const { return first_hz + step_hz * slot; }
};

/// Mean phase of one link by position in the hop table, as a unit vector; 0 where it was not heard.
using PhaseByChannel = std::vector<std::complex<double>>;

/// The straight line phase = sign * 2 pi f delay + constant nearest to one link's phases.
struct FrequencyLine {
  double delay_s{0.0};    ///< way out and back, cable and reader (data study, 3.4)
  double coherence{0.0};  ///< |mean of exp(i (phase - line))|: 1 on the line, 1 / sqrt(channels) by chance
};

/// Delays searched. Chosen: 75 ns of reader and cable, and 12 m of way.
inline constexpr double kDelayMax_s = 160e-9;

/// \param channels_hz  the hop table: as long as the phases
[[nodiscard]] FrequencyLine fit_line(const PhaseByChannel& phases, std::span<const double> channels_hz,
                                     double phase_sign);

struct HopTable {
  std::vector<double> channels_hz;  ///< by position
  double coherence{0.0};            ///< mean over the links used
  std::size_t links{0};
  int starts{0};
  int agreeing{0};                ///< starts that ended in this very table
  std::vector<double> stability;  ///< by position: share of resampled sets of links that keep its frequency
};

/// Finds the order of the band's frequencies that makes all links' phases linear in frequency (data
/// study, 3.1).
///
/// Each start sorts the channels by the phase difference of two random links, which grows evenly with
/// frequency for tags at different distances; then the links' lines and the table are fitted in turn, the
/// table by exchanging pairs of channels while that gains anything (2-opt). Phases alone cannot tell a table
/// from its mirror image read with the other sign, so that the sign must be known.
///
/// \param phase_sign  +1: phase grows with distance; -1: falls
/// \param go_on  asked before each start; false ends the search. \returns nothing then, and for less than two
///   links
[[nodiscard]] std::optional<HopTable> recover_hop_table(std::span<const PhaseByChannel> links,
                                                        const Band& band, double phase_sign, int starts,
                                                        int resamples, robot::RandomStream random,
                                                        const std::function<bool()>& go_on);

}  // namespace sensotwin::twin
