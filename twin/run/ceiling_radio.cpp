// SPDX-License-Identifier: MIT
#include "twin/run/ceiling_radio.hpp"

#include <algorithm>

#include "twin/run/phase_config.hpp"

namespace sensotwin::twin {
namespace {

/// Reports are the emulated reader's affair: the radio hands it each read at once.
world::RadioWorld at_once(world::RadioWorld radio) {
  radio.radio.report_every = 1;
  radio.radio.accumulate_reads = false;
  radio.radio.report_latency_s = 0.0;
  return radio;
}

UhfReaderSettings settings_of(const world::RadioWorld& radio) {
  UhfReaderSettings settings;
  settings.channels_hz = radio.radio.channels_hz;
  settings.antennas =
      static_cast<std::uint16_t>(std::max<std::size_t>(settings.antennas, radio.antennas.size()));
  settings.report_latency = robot::from_s(radio.radio.report_latency_s);
  if (radio.radio.rssi_step_db > 0.0) {
    settings.rssi_step_db = radio.radio.rssi_step_db;
  }
  return settings;
}

std::vector<std::vector<std::uint16_t>> user_memory_of(const world::RadioWorld& radio) {
  std::vector<std::vector<std::uint16_t>> memory;
  for (const world::CeilingTag& tag : radio.tags) {
    memory.push_back(tag.user_memory);
  }
  return memory;
}

}  // namespace

CeilingRadio::CeilingRadio(const Scene& scene, const robot::RandomStream& random)
    : fault_random_(random.fork("reader faults")),
      radio_world_(radio_of(scene, random)),
      user_memory_(user_memory_of(radio_world_)),
      radio_(at_once(radio_world_), random.fork("radio")),
      reader_(settings_of(radio_world_), [this](const robot::Epc& epc) -> std::span<std::uint16_t> {
        for (std::size_t i = 0; i < radio_world_.tags.size(); ++i) {
          if (radio_world_.tags[i].epc == epc) {
            return user_memory_[i];
          }
        }
        return {};
      }) {
  radio_.use_antennas({}, 0.0);
}

void CeilingRadio::tick_world(const world::RobotMotion& motion) {
  heard_ = radio_.step(motion);
}

void CeilingRadio::tick_devices(robot::Instant now) {
  readings_.clear();
  for (const world::RadioRead& read : heard_) {
    RadioReading reading{.at = robot::Instant{robot::from_s(read.time_s)},
                         .epc = radio_world_.tags[read.tag].epc,
                         .antenna = static_cast<std::uint16_t>(read.antenna + 1),
                         .channel = static_cast<std::uint16_t>(read.channel + 1),
                         .phase_rad = read.phase_rad,
                         .rssi_dbm = read.rssi_dbm,
                         .doppler_hz = read.doppler_hz};
    if (comes_through(reading) && reader_.report(reading)) {
      readings_.push_back(reading);
    }
  }
  reader_.step(now);
  follow_ro_spec(now);
}

bool CeilingRadio::comes_through(RadioReading& reading) {
  const world::ReaderFaults& faults = radio_world_.faults;
  const double at_s = robot::to_s(reading.at);
  const bool silent =
      std::any_of(faults.silent_s.begin(), faults.silent_s.end(),
                  [at_s](const robot::Vec2& from_to) { return at_s >= from_to.x() && at_s < from_to.y(); });
  if (silent || (faults.lost_share > 0.0 && fault_random_.chance(faults.lost_share))) {
    return false;
  }
  if (faults.cables_swapped && reading.antenna <= 2) {
    reading.antenna = static_cast<std::uint16_t>(3 - reading.antenna);
  }
  return true;
}

void CeilingRadio::follow_ro_spec(robot::Instant now) {
  const std::span<const std::uint16_t> wanted = reader_.antennas();
  if (std::equal(wanted.begin(), wanted.end(), ports_.begin(), ports_.end())) {
    return;
  }
  ports_.assign(wanted.begin(), wanted.end());
  std::vector<std::uint16_t> antennas;
  for (const std::uint16_t port : ports_) {
    if (port >= 1 && port <= radio_world_.antennas.size()) {
      antennas.push_back(static_cast<std::uint16_t>(port - 1));
    }
  }
  radio_.use_antennas(antennas, robot::to_s(now));
}

}  // namespace sensotwin::twin
