// SPDX-License-Identifier: MIT
#include "world/radio/radio.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>

#include "world/radio/air.hpp"
#include "world/radio/reader_schedule.hpp"
#include "world/radio/report_queue.hpp"

namespace sensotwin::world {
namespace {

constexpr double kLight_mps = 299'792'458.0;
constexpr double kTurn_rad = 2.0 * robot::kPi;

/// In [0, 2 pi).
double in_one_turn(double rad) {
  const double wrapped = rad - kTurn_rad * std::floor(rad / kTurn_rad);
  return wrapped < kTurn_rad ? wrapped : 0.0;
}

/// floor^2 + (at_50dbm * 10^(-(RSSI + 50) / 20))^2, its root: noise under a signal that grows weaker.
double by_rssi(double floor, double at_50dbm, double rssi_dbm) {
  return std::hypot(floor, at_50dbm * std::pow(10.0, -(rssi_dbm + 50.0) / 20.0));
}

/// A tag as one antenna of the reader hears it.
struct Link {
  robot::RandomStream random;
  double drift_rad{0.0};
  double drift_at_s{0.0};
  bool drifting{false};
};

}  // namespace

struct Radio::State {
  State(const RadioWorld& world, const robot::RandomStream& random);

  void read_at(double time_s, std::uint32_t tag, std::span<const std::uint16_t> antennas,
               std::uint16_t channel);
  [[nodiscard]] std::optional<RadioRead> read(double time_s, std::uint32_t tag, std::uint16_t antenna,
                                              std::uint16_t channel);
  [[nodiscard]] double drifted_rad(Link& link, double time_s) const;
  void move_to(double time_s, const RobotMotion& motion);

  RadioDescription radio;
  std::vector<double> cable_delay_s;
  Air air;
  ReaderSchedule schedule;
  ReportQueue reports;
  std::vector<double> theta_rad;  ///< of each tag
  std::vector<Link> links;        ///< of each tag and antenna
  std::uint32_t next_tag{0};      ///< to be asked in the present round
  std::size_t answers{0};         ///< of the present round
  std::vector<RadioRead> arrived;
};

Radio::State::State(const RadioWorld& world, const robot::RandomStream& random)
    : radio(world.radio),
      air(world, random.fork("radio")),
      schedule(world.radio, world.antennas.size()),
      reports(world.radio) {
  for (const AntennaDescription& antenna : world.antennas) {
    cable_delay_s.push_back(antenna.cable_delay_s);
  }
  for (const CeilingTag& tag : world.tags) {
    const robot::RandomStream own = stream_of(tag, random.fork("radio"));
    robot::RandomStream phase = own.fork("phase of the tag");
    theta_rad.push_back(tag.phase_offset_rad.value_or(phase.uniform(0.0, kTurn_rad)));
    for (std::size_t a = 0; a < world.antennas.size(); ++a) {
      links.push_back({.random = own.fork("antenna " + std::to_string(a)).fork("reads")});
    }
  }
}

double read_noise_rad(const RadioDescription& radio, double distance_m, double rssi_dbm) {
  switch (radio.noise_law) {
    case NoiseLaw::kProportional:
      return radio.noise_scale * radio.noise_per_m_rad * distance_m;
    case NoiseLaw::kOffset:
      return radio.noise_scale * (radio.noise_floor_rad + radio.noise_per_m_rad * distance_m);
    case NoiseLaw::kRssi:
      break;
  }
  return radio.noise_scale * by_rssi(radio.noise_floor_rad, radio.noise_at_50dbm_rad, rssi_dbm);
}

double Radio::State::drifted_rad(Link& link, double time_s) const {
  if (radio.drift_sigma_rad == 0.0) {
    return 0.0;
  }
  // Exact discretisation of dx = -x dt / T + sigma sqrt(2 / T) dW (Uhlenbeck & Ornstein, Phys. Rev. 36,
  // 1930).
  const double kept = link.drifting ? std::exp(-(time_s - link.drift_at_s) / radio.drift_time_s) : 0.0;
  link.drift_rad =
      kept * link.drift_rad + radio.drift_sigma_rad * std::sqrt(1.0 - kept * kept) * link.random.normal();
  link.drift_at_s = time_s;
  link.drifting = true;
  return link.drift_rad;
}

std::optional<RadioRead> Radio::State::read(double time_s, std::uint32_t tag, std::uint16_t antenna,
                                            std::uint16_t channel) {
  const auto heard = air.hear(tag, antenna, channel);
  if (!heard) {
    return std::nullopt;
  }
  Link& link = links[tag * cable_delay_s.size() + antenna];
  double rssi_dbm = heard->rssi_dbm;
  if (radio.rssi_sigma_db > 0.0) {
    rssi_dbm += link.random.normal(0.0, radio.rssi_sigma_db);
  }
  if (rssi_dbm < radio.cutoff_dbm) {
    return std::nullopt;
  }
  const double delay_s = heard->path_m / kLight_mps + cable_delay_s[antenna];
  const double cycles = radio.channels_hz[channel] * delay_s;
  double error_rad = radio.phase_sign * heard->echo_rad + drifted_rad(link, time_s) +
                     link.random.normal(0.0, read_noise_rad(radio, heard->distance_m, heard->rssi_dbm));
  if (radio.pi_flips) {
    const double pair = 0.5 / (1.0 + std::exp((heard->rssi_dbm - radio.flip_rssi_dbm) / radio.flip_width_db));
    error_rad += link.random.chance(0.5 * (1.0 - std::sqrt(1.0 - 2.0 * pair))) ? robot::kPi : 0.0;
  }
  if (radio.pi_ambiguous) {
    error_rad += link.random.chance(0.5) ? robot::kPi : 0.0;
  }
  double phase_rad =
      in_one_turn(radio.phase_sign * kTurn_rad * (cycles - std::floor(cycles)) + theta_rad[tag] + error_rad);
  if (radio.phase_steps > 0) {
    const double step_rad = kTurn_rad / radio.phase_steps;
    phase_rad = in_one_turn(step_rad * std::round(phase_rad / step_rad));
  }
  RadioRead read{
      .time_s = time_s, .tag = tag, .antenna = antenna, .channel = channel, .phase_rad = phase_rad};
  read.distance_m = heard->distance_m;
  read.error_rad = robot::wrap_angle(error_rad);
  read.rssi_dbm =
      radio.rssi_step_db > 0.0 ? radio.rssi_step_db * std::round(rssi_dbm / radio.rssi_step_db) : rssi_dbm;
  read.doppler_hz = radio.doppler_bias_hz;
  if (radio.doppler_floor_hz > 0.0 || radio.doppler_at_50dbm_hz > 0.0) {
    read.doppler_hz +=
        link.random.normal(0.0, by_rssi(radio.doppler_floor_hz, radio.doppler_at_50dbm_hz, rssi_dbm));
  }
  return read;
}

void Radio::State::read_at(double time_s, std::uint32_t tag, std::span<const std::uint16_t> antennas,
                           std::uint16_t channel) {
  for (const std::uint16_t antenna : antennas) {
    if (const auto made = read(time_s, tag, antenna, channel)) {
      reports.push(*made);
      ++answers;
    }
  }
}

void Radio::State::move_to(double time_s, const RobotMotion& motion) {
  const double whole_s = motion.end_s - motion.begin_s;
  const double part = whole_s > 0.0 ? std::clamp((time_s - motion.begin_s) / whole_s, 0.0, 1.0) : 1.0;
  const robot::Pose2& begin = motion.X_WR_begin;
  const robot::Pose2& end = motion.X_WR_end;
  air.place({begin.p_m + part * (end.p_m - begin.p_m),
             begin.yaw_rad + part * robot::wrap_angle(end.yaw_rad - begin.yaw_rad)});
}

Radio::Radio(const RadioWorld& world, const robot::RandomStream& random)
    : state_(std::make_unique<State>(world, random)) {}
Radio::~Radio() = default;
Radio::Radio(Radio&&) noexcept = default;
Radio& Radio::operator=(Radio&&) noexcept = default;

std::span<const RadioRead> Radio::step(const RobotMotion& motion) {
  State& s = *state_;
  s.arrived.clear();
  const auto tags = static_cast<std::uint32_t>(s.theta_rad.size());
  for (auto round = s.schedule.round(); round.begin_s <= motion.end_s; round = s.schedule.round()) {
    double placed_s = -1.0;
    while (s.next_tag < tags) {
      // One antenna's answers follow each other; all antennas of a simultaneous reader share the instant.
      const double time_s =
          round.begin_s + (s.radio.simultaneous ? 0.0 : s.radio.per_tag_s * static_cast<double>(s.answers));
      if (time_s > motion.end_s) {
        s.reports.take_arrived(motion.end_s, s.arrived);
        return s.arrived;
      }
      if (time_s != placed_s) {
        s.move_to(time_s, motion);
        placed_s = time_s;
      }
      s.read_at(time_s, s.next_tag++, round.antennas, round.channel);
    }
    s.schedule.finish(s.answers);
    s.next_tag = 0;
    s.answers = 0;
  }
  s.reports.take_arrived(motion.end_s, s.arrived);
  return s.arrived;
}

void Radio::use_antennas(std::span<const std::uint16_t> antennas, double now_s) {
  state_->schedule.use_antennas(antennas, now_s);
  state_->next_tag = 0;
  state_->answers = 0;
}

double Radio::tag_phase_rad(std::uint32_t tag) const {
  assert(tag < state_->theta_rad.size());
  return state_->theta_rad[tag];
}

}  // namespace sensotwin::world
