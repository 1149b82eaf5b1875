// SPDX-License-Identifier: MIT
#include "twin/calibrate/hop_table.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "robot/base/geometry.hpp"

namespace sensotwin::twin {
namespace {

using Permutation = std::vector<int>;  ///< slot of the band by position

/// Coarse grid of delays: a tenth of the band's resolution, 1 / 24.5 MHz. Chosen.
constexpr double kDelayStep_s = 4e-9;
constexpr int kRoundsMax = 40;  ///< chosen: all starts seen ended within 15

/// exp(-i s 2 pi f tau) by delay and slot; f from the middle of the band, which only turns the constant.
class Wheel {
 public:
  Wheel(const Band& band, double sign) : band_(band), sign_(sign) {
    const auto delays = static_cast<std::size_t>(kDelayMax_s / kDelayStep_s) + 1;
    for (std::size_t d = 0; d < delays; ++d) {
      for (int slot = 0; slot < band.channels; ++slot) {
        turns_.push_back(at(slot, kDelayStep_s * static_cast<double>(d)));
      }
    }
  }
  [[nodiscard]] std::complex<double> at(int slot, double delay_s) const {
    const double from_middle_hz = band_.step_hz * (slot - 0.5 * (band_.channels - 1));
    return std::polar(1.0, -sign_ * 2.0 * robot::kPi * from_middle_hz * delay_s);
  }
  [[nodiscard]] std::size_t delays() const {
    return turns_.size() / static_cast<std::size_t>(band_.channels);
  }
  [[nodiscard]] const std::complex<double>* row(std::size_t delay) const {
    return turns_.data() + delay * static_cast<std::size_t>(band_.channels);
  }
  [[nodiscard]] int channels() const { return band_.channels; }

 private:
  Band band_;
  double sign_;
  std::vector<std::complex<double>> turns_;
};

double heard_in(const PhaseByChannel& link) {
  return static_cast<double>(
      std::count_if(link.begin(), link.end(), [](const std::complex<double>& p) { return p != 0.0; }));
}

/// A link's best delay of the grid, and the sum of its phases turned back by it.
struct Line {
  std::size_t delay{0};
  std::complex<double> sum;
};
Line line_of(const PhaseByChannel& link, const Permutation& table, const Wheel& wheel) {
  Line best;
  for (std::size_t d = 0; d < wheel.delays(); ++d) {
    const std::complex<double>* const row = wheel.row(d);
    std::complex<double> sum;
    for (std::size_t c = 0; c < link.size(); ++c) {
      sum += link[c] * row[table[c]];
    }
    if (std::norm(sum) > std::norm(best.sum)) {
      best = {d, sum};
    }
  }
  return best;
}

/// Exchanges pairs of channels while that makes sum_c gain(c, table[c]) larger.
void exchange_pairs(const std::vector<double>& gain, Permutation& table) {
  const std::size_t n = table.size();
  const auto at = [&](std::size_t channel, int slot) {
    return gain[channel * n + static_cast<std::size_t>(slot)];
  };
  for (bool better = true; better;) {
    better = false;
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = a + 1; b < n; ++b) {
        if (at(a, table[b]) + at(b, table[a]) > at(a, table[a]) + at(b, table[b]) + 1e-9) {
          std::swap(table[a], table[b]);
          better = true;
        }
      }
    }
  }
}

/// Lines and table in turn, until the table stays. \returns the mean coherence
double settle(std::span<const PhaseByChannel* const> links, const Wheel& wheel, Permutation& table) {
  const std::size_t n = table.size();
  double coherence = 0.0;
  for (int round = 0; round < kRoundsMax; ++round) {
    std::vector<double> gain(n * n, 0.0);
    coherence = 0.0;
    for (const PhaseByChannel* link : links) {
      const Line line = line_of(*link, table, wheel);
      coherence += std::abs(line.sum) / heard_in(*link) / static_cast<double>(links.size());
      const std::complex<double> back = std::conj(line.sum) / std::max(1e-12, std::abs(line.sum));
      const std::complex<double>* const row = wheel.row(line.delay);
      for (std::size_t c = 0; c < n; ++c) {
        const std::complex<double> turned = (*link)[c] * back;
        for (std::size_t slot = 0; slot < n; ++slot) {
          gain[c * n + slot] += turned.real() * row[slot].real() - turned.imag() * row[slot].imag();
        }
      }
    }
    const Permutation before = table;
    exchange_pairs(gain, table);
    if (table == before) {
      break;
    }
  }
  return coherence;
}

/// Channels by the phase difference of two links, cut open at its widest gap; unheard ones last.
Permutation sorted_by_difference(const PhaseByChannel& one, const PhaseByChannel& other) {
  std::vector<std::pair<double, std::size_t>> by_angle;
  std::vector<std::size_t> unheard;
  for (std::size_t c = 0; c < one.size(); ++c) {
    const std::complex<double> difference = one[c] * std::conj(other[c]);
    if (difference == 0.0) {
      unheard.push_back(c);
    } else {
      by_angle.emplace_back(std::arg(difference), c);
    }
  }
  std::sort(by_angle.begin(), by_angle.end());
  std::size_t cut = 0;
  double widest_rad = -1.0;
  for (std::size_t i = 0; i < by_angle.size(); ++i) {
    const double from = i > 0 ? by_angle[i - 1].first : by_angle.back().first - 2.0 * robot::kPi;
    if (by_angle[i].first - from > widest_rad) {
      widest_rad = by_angle[i].first - from;
      cut = i;
    }
  }
  std::rotate(by_angle.begin(), by_angle.begin() + static_cast<std::ptrdiff_t>(cut), by_angle.end());
  Permutation table(one.size());
  int slot = 0;
  for (const auto& [angle, channel] : by_angle) {
    table[channel] = slot++;
  }
  for (const std::size_t channel : unheard) {
    table[channel] = slot++;
  }
  return table;
}

Permutation mirrored(Permutation table) {
  for (int& slot : table) {
    slot = static_cast<int>(table.size()) - 1 - slot;
  }
  return table;
}

/// Positions that keep their slot when the links are drawn anew.
std::vector<double> stability_of(std::span<const PhaseByChannel* const> links, const Wheel& wheel,
                                 const Permutation& best, int resamples, robot::RandomStream random) {
  std::vector<double> kept(best.size(), 0.0);
  for (int r = 0; r < resamples; ++r) {
    std::vector<const PhaseByChannel*> drawn;
    for (std::size_t i = 0; i < links.size(); ++i) {
      drawn.push_back(links[random.below(static_cast<std::uint32_t>(links.size()))]);
    }
    Permutation table = best;
    settle(drawn, wheel, table);
    for (std::size_t c = 0; c < best.size(); ++c) {
      kept[c] += table[c] == best[c] ? 1.0 / resamples : 0.0;
    }
  }
  return kept;
}

}  // namespace

FrequencyLine fit_line(const PhaseByChannel& phases, std::span<const double> channels_hz, double phase_sign) {
  const double heard = heard_in(phases);
  const double middle_hz =
      std::accumulate(channels_hz.begin(), channels_hz.end(), 0.0) / static_cast<double>(channels_hz.size());
  FrequencyLine best;
  const auto look = [&](double delay_s) {
    std::complex<double> sum;
    for (std::size_t c = 0; c < phases.size(); ++c) {
      sum += phases[c] *
             std::polar(1.0, -phase_sign * 2.0 * robot::kPi * (channels_hz[c] - middle_hz) * delay_s);
    }
    if (std::abs(sum) / heard > best.coherence) {
      best = {delay_s, std::abs(sum) / heard};
    }
  };
  for (double delay_s = 0.0; delay_s <= kDelayMax_s; delay_s += kDelayStep_s) {
    look(delay_s);
  }
  // A hundredth of a nanosecond is 3 mm of way: finer than any echo leaves it.
  for (double step_s = 0.5 * kDelayStep_s; step_s > 1e-11; step_s *= 0.5) {
    const double from_s = best.delay_s;
    look(std::max(0.0, from_s - step_s));
    look(from_s + step_s);
  }
  return best;
}

std::optional<HopTable> recover_hop_table(std::span<const PhaseByChannel> links, const Band& band,
                                          double phase_sign, int starts, int resamples,
                                          robot::RandomStream random, const std::function<bool()>& go_on) {
  if (links.size() < 2) {
    return std::nullopt;
  }
  const Wheel wheel(band, phase_sign);
  std::vector<const PhaseByChannel*> all;
  for (const PhaseByChannel& link : links) {
    all.push_back(&link);
  }
  const auto count = static_cast<std::uint32_t>(links.size());
  Permutation best;
  HopTable found{.channels_hz = {}, .links = links.size(), .starts = starts, .stability = {}};
  for (int start = 0; start < starts; ++start) {
    if (!go_on()) {
      return std::nullopt;
    }
    const std::uint32_t one = random.below(count);
    const std::uint32_t other = (one + 1 + random.below(count - 1)) % count;
    const Permutation rising = sorted_by_difference(links[one], links[other]);
    for (Permutation table : {rising, mirrored(rising)}) {
      const double coherence = settle(all, wheel, table);
      if (table == best) {
        ++found.agreeing;
      } else if (coherence > found.coherence) {
        best = table;
        found.coherence = coherence;
        found.agreeing = 1;
      }
    }
  }
  for (const int slot : best) {
    found.channels_hz.push_back(band.at_hz(slot));
  }
  found.stability = stability_of(all, wheel, best, resamples, random.fork("stability"));
  return found;
}

}  // namespace sensotwin::twin
