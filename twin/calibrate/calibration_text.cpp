// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "twin/calibrate/calibration.hpp"

namespace sensotwin::twin {
namespace {

using Line = std::back_insert_iterator<std::string>;

std::string with_interval(const Estimate& e, double scale, int digits) {
  return fmt::format("{:.{}f} [{:.{}f}, {:.{}f}]", scale * e.value, digits, scale * e.low, digits,
                     scale * e.high, digits);
}

void put_noise(Line out, const Calibration& c) {
  const NoiseFit& noise = c.noise;
  fmt::format_to(out, "Read noise, {} links with three reads in a row within a channel visit\n",
                 noise.points.size());
  const auto put = [&](const char* law, const std::optional<NoiseLawFit>& fit, std::string parameters) {
    if (fit) {
      fmt::format_to(out, "  {:<20} {:<64} x{:.2f}  R2 {:.2f}\n", law, parameters, fit->spread,
                     fit->r_squared);
    }
  };
  if (const auto& fit = noise.by_rssi) {
    put("by RSSI", fit,
        fmt::format("floor {} rad, at -50 dBm {} rad", with_interval(fit->parameters[0], 1.0, 4),
                    with_interval(fit->parameters[1], 1.0, 4)));
  }
  if (const auto& fit = noise.proportional) {
    put("proportional", fit, fmt::format("{} rad/m", with_interval(fit->parameters[0], 1.0, 4)));
  }
  if (const auto& fit = noise.offset) {
    put("offset, proportional", fit,
        fmt::format("floor {} rad, {} rad/m", with_interval(fit->parameters[0], 1.0, 4),
                    with_interval(fit->parameters[1], 1.0, 4)));
  }
  if (noise.by_rssi) {
    fmt::format_to(out, "  measured / predicted by RSSI from the other links: {:.0f} % within 0.8 to 1.25\n",
                   100.0 * noise.left_out_share);
  } else {
    fmt::format_to(out, "  too few for a law\n");
  }
  if (noise.by_rssi && !noise.proportional) {
    fmt::format_to(out, "  laws of distance want --distances\n");
  }
}

void put_flips(Line out, const FlipFit& flips) {
  fmt::format_to(out, "Flips by pi: {} of {} pairs", flips.flips, flips.pairs);
  if (flips.rssi_dbm) {
    fmt::format_to(out, "; 0.5 / (1 + exp((RSSI - p) / w)), p {} dBm, w {} dB\n",
                   with_interval(*flips.rssi_dbm, 1.0, 1), with_interval(*flips.width_db, 1.0, 2));
  } else {
    fmt::format_to(out, "; too few for a curve\n");
  }
}

void put_frequency(Line out, const Calibration& c) {
  if (c.channels_hz.empty()) {
    fmt::format_to(out, "Hop table: not given, and no two strong links to recover it from\n");
    return;
  }
  if (c.recovered) {
    const auto& stability = c.recovered->stability;
    const auto firm = std::count_if(stability.begin(), stability.end(), [](double s) { return s >= 0.95; });
    fmt::format_to(
        out,
        "Hop table recovered from {} strong links: coherence {:.4f}; found by {} of {} starts; {} of {} "
        "positions\n  the same in 95 % of resamplings. Phase taken to {} with distance: the other way, "
        "mirror the table\n",
        c.recovered->links, c.recovered->coherence, c.recovered->agreeing, c.recovered->starts, firm,
        stability.size(), c.phase_sign > 0.0 ? "grow" : "fall");
  } else if (c.rising_coherence) {
    fmt::format_to(out, "Hop table given: phase {} with distance (coherence {:.3f} rising, {:.3f} falling)\n",
                   c.phase_sign > 0.0 ? "grows" : "falls", *c.rising_coherence, *c.falling_coherence);
  }
  if (c.strong_coherence) {
    fmt::format_to(
        out, "Phase linear in frequency: coherence {} over links above {:.0f} dBm, {:.0f} % over 0.95\n",
        with_interval(*c.strong_coherence, 1.0, 3), kStrong_dbm, 100.0 * c.linear_share);
  }
  for (const auto& [port, delay] : c.delay_s) {
    fmt::format_to(out, "  port {}: delay {} ns", port, with_interval(delay, 1e9, 1));
    if (const auto cable = c.cable_delay_s.find(port); cable != c.cable_delay_s.end()) {
      fmt::format_to(out, ", of which reader and cable {} ns", with_interval(cable->second, 1e9, 1));
    }
    fmt::format_to(out, "\n");
  }
}

void put_timing(Line out, const ReaderTiming& t) {
  fmt::format_to(out, "Timing, {} logs with port", t.logs);
  for (const int port : t.ports) {
    fmt::format_to(out, " {}", port);
  }
  fmt::format_to(out, "\n ");
  if (t.reads_per_s) {
    fmt::format_to(out, " {} reads/s;", with_interval(*t.reads_per_s, 1.0, 1));
  }
  if (t.dwell_s) {
    fmt::format_to(out, " dwell {} ms;", with_interval(*t.dwell_s, 1e3, 1));
  }
  if (t.hop_dead_s) {
    fmt::format_to(out, " hop loses {} ms;", with_interval(*t.hop_dead_s, 1e3, 1));
  }
  if (t.per_tag_s) {
    fmt::format_to(out, " tag after tag {} ms;", with_interval(*t.per_tag_s, 1e3, 2));
  }
  fmt::format_to(out, " rows out of order {:.1f} %\n", 100.0 * t.out_of_order_share);
  for (const auto& [port, share] : t.port_share) {
    fmt::format_to(out, "  port {}: share {:.3f}", port, share);
    if (const auto slot = t.slot_s.find(port); slot != t.slot_s.end()) {
      fmt::format_to(out, ", slot {} ms", with_interval(slot->second, 1e3, 1));
    }
    fmt::format_to(out, "\n");
  }
}

void put_key(Line out, const char* key, const Estimate& e, double scale, int digits, const char* unit) {
  fmt::format_to(out, "  {}: {:.{}g}  # 95 %: {:.{}g} to {:.{}g} {}\n", key, scale * e.value, digits,
                 scale * e.low, digits, scale * e.high, digits, unit);
}

void put_timing_keys(Line out, const ReaderTiming& t) {
  fmt::format_to(out, "  simultaneous: false\n");
  if (t.slot_s.size() == t.ports.size()) {
    fmt::format_to(out, "  slots_s: [");
    for (std::size_t p = 0; p < t.ports.size(); ++p) {
      fmt::format_to(out, "{}{:.5f}", p > 0 ? ", " : "", t.slot_s.at(t.ports[p]).value);
    }
    fmt::format_to(out, "]\n");
  }
}

}  // namespace

std::string to_table(const Calibration& c) {
  std::string text;
  const Line out(text);
  fmt::format_to(out, "{} logs, {} links of tag and antenna, {} reads; seed {}\n", c.logs.size(),
                 c.links.size(), c.reads, c.settings.seed);
  if (c.stale_channels > 0) {
    fmt::format_to(out, "Accumulating reports: {} rows had the channel of the visit before\n",
                   c.stale_channels);
  }
  put_noise(out, c);
  put_flips(out, c.flips);
  put_frequency(out, c);
  fmt::format_to(out, "Phase in {} steps a turn; one read in a hundred below {:.0f} dBm\n", c.phase_steps,
                 c.weakest_dbm);
  if (c.rssi) {
    fmt::format_to(out, "RSSI: {} dBm at 1 m, {} dB a decade\n", with_interval(c.rssi->at_1m_dbm, 1.0, 1),
                   with_interval(c.rssi->slope_db, 1.0, 1));
  }
  if (c.doppler) {
    fmt::format_to(out, "Doppler at rest: bias {} Hz, scatter {} Hz and, at -50 dBm, {} Hz\n",
                   with_interval(c.doppler->bias_hz, 1.0, 1), with_interval(c.doppler->floor_hz, 1.0, 1),
                   with_interval(c.doppler->at_50dbm_hz, 1.0, 1));
  }
  for (const ReaderTiming& timing : c.timings) {
    put_timing(out, timing);
  }
  return text;
}

std::string to_profile(const Calibration& c) {
  std::string text;
  const Line out(text);
  fmt::format_to(out,
                 "# Fitted by twin calibrate to {} reads of {} logs, seed {}. Intervals: 95 %, bootstrap.\n",
                 c.reads, c.logs.size(), c.settings.seed);
  for (const auto& [port, cable] : c.cable_delay_s) {
    fmt::format_to(out, "# Antenna on port {}: cable_delay_s: {:.3e}  # 95 %: {:.3e} to {:.3e} s\n", port,
                   cable.value, cable.low, cable.high);
  }
  fmt::format_to(out, "radio:\n  profile: impinj_r420\n");
  if (!c.channels_hz.empty()) {
    fmt::format_to(out, "  channels_hz: [{:.10g}", c.channels_hz.front());
    for (std::size_t i = 1; i < c.channels_hz.size(); ++i) {
      fmt::format_to(out, "{}{:.10g}", i % 10 == 0 ? ",\n    " : ", ", c.channels_hz[i]);
    }
    fmt::format_to(out, "]\n  phase_sign: {:.0f}\n", c.phase_sign);
  }
  if (!c.timings.empty()) {
    put_timing_keys(out, c.timings.front());
  }
  // Each of these is told best by the reader's logs with the most reads, or the only ones that have it.
  const auto first = [&](const char* key, auto member, int digits) {
    const ReaderTiming* told = nullptr;
    for (const ReaderTiming& t : c.timings) {
      told = (t.*member) && (told == nullptr || t.reads > told->reads) ? &t : told;
    }
    if (told != nullptr) {
      put_key(out, key, *(told->*member), 1.0, digits, "s");
    }
  };
  first("dwell_s", &ReaderTiming::dwell_s, 5);
  first("hop_dead_s", &ReaderTiming::hop_dead_s, 3);
  first("per_tag_s", &ReaderTiming::per_tag_s, 3);
  if (const auto& fit = c.noise.by_rssi) {
    fmt::format_to(out, "  noise_law: rssi\n");
    put_key(out, "noise_floor_rad", fit->parameters[0], 1.0, 3, "rad");
    put_key(out, "noise_at_50dbm_rad", fit->parameters[1], 1.0, 3, "rad");
  }
  fmt::format_to(out, "  phase_steps: {}\n", c.phase_steps);
  fmt::format_to(out, "  pi_flips: {}\n", c.flips.rssi_dbm.has_value());
  if (c.flips.rssi_dbm) {
    put_key(out, "flip_rssi_dbm", *c.flips.rssi_dbm, 1.0, 4, "dBm");
    put_key(out, "flip_width_db", *c.flips.width_db, 1.0, 3, "dB");
  }
  if (c.rssi) {
    put_key(out, "rssi_at_1m_dbm", c.rssi->at_1m_dbm, 1.0, 4, "dBm");
    put_key(out, "rssi_slope_db", c.rssi->slope_db, 1.0, 4, "dB a decade");
  }
  if (c.doppler) {
    put_key(out, "doppler_bias_hz", c.doppler->bias_hz, 1.0, 3, "Hz");
    put_key(out, "doppler_floor_hz", c.doppler->floor_hz, 1.0, 3, "Hz");
    put_key(out, "doppler_at_50dbm_hz", c.doppler->at_50dbm_hz, 1.0, 3, "Hz");
  }
  return text;
}

}  // namespace sensotwin::twin
