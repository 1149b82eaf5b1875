// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "twin/calibrate/calibration.hpp"

namespace sensotwin::twin {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Estimate& e) {
  return {{"value", e.value}, {"low", e.low}, {"high", e.high}};
}
Json json_of(const std::optional<Estimate>& e) {
  return e ? json_of(*e) : Json();
}

Json json_of(const std::optional<NoiseLawFit>& fit, std::initializer_list<const char*> names) {
  if (!fit) {
    return {};
  }
  Json json;
  std::size_t next = 0;
  for (const char* name : names) {
    json[name] = json_of(fit->parameters[next++]);
  }
  json["spread_factor"] = fit->spread;
  json["r_squared"] = fit->r_squared;
  return json;
}

Json noise_of(const Calibration& c) {
  Json json;
  json["by_rssi"] = json_of(c.noise.by_rssi, {"noise_floor_rad", "noise_at_50dbm_rad"});
  json["proportional"] = json_of(c.noise.proportional, {"noise_per_m_rad"});
  json["offset"] = json_of(c.noise.offset, {"noise_floor_rad", "noise_per_m_rad"});
  json["left_out_share_within_0.8_to_1.25"] = c.noise.left_out_share;
  json["links"] = Json::array();
  for (std::size_t i = 0; i < c.noise.points.size(); ++i) {
    const NoisePoint& point = c.noise.points[i];
    const TagLink& link = c.links[point.link];
    Json entry = {{"log", c.logs[link.log]},
                  {"antenna", link.antenna},
                  {"triples", link.bends_rad.size()},
                  {"rssi_dbm", point.rssi_dbm},
                  {"noise_rad", point.sigma_rad}};
    if (i < c.noise.left_out_ratio.size()) {
      entry["measured_over_predicted"] = c.noise.left_out_ratio[i];
    }
    json["links"].push_back(entry);
  }
  return json;
}

Json timing_of(const ReaderTiming& t) {
  Json json = {{"ports", t.ports},
               {"logs", t.logs},
               {"reads", t.reads},
               {"reads_per_s", json_of(t.reads_per_s)},
               {"dwell_s", json_of(t.dwell_s)},
               {"hop_dead_s", json_of(t.hop_dead_s)},
               {"per_tag_s", json_of(t.per_tag_s)},
               {"revisit_s_5_25_50_75_95", t.revisit_quantiles_s},
               {"out_of_order_share", t.out_of_order_share}};
  for (const auto& [port, share] : t.port_share) {
    Json entry = {{"port", port}, {"share", share}};
    if (const auto slot = t.slot_s.find(port); slot != t.slot_s.end()) {
      entry["slot_s"] = json_of(slot->second);
    }
    json["of_ports"].push_back(entry);
  }
  return json;
}

Json frequency_of(const Calibration& c) {
  Json json;
  json["phase_sign"] = c.phase_sign;
  json["channels_hz"] = c.channels_hz;
  if (c.recovered) {
    json["recovered"] = {{"coherence", c.recovered->coherence},
                         {"links", c.recovered->links},
                         {"starts", c.recovered->starts},
                         {"agreeing_starts", c.recovered->agreeing},
                         {"stability", c.recovered->stability}};
  }
  if (c.rising_coherence) {
    json["coherence_rising"] = *c.rising_coherence;
    json["coherence_falling"] = *c.falling_coherence;
  }
  json["strong_coherence"] = json_of(c.strong_coherence);
  json["strong_share_over_0.95"] = c.linear_share;
  for (const auto& [port, delay] : c.delay_s) {
    Json entry = {{"port", port}, {"delay_s", json_of(delay)}};
    if (const auto cable = c.cable_delay_s.find(port); cable != c.cable_delay_s.end()) {
      entry["cable_delay_s"] = json_of(cable->second);
    }
    json["of_ports"].push_back(entry);
  }
  for (const LinkLine& line : c.lines) {
    const TagLink& link = c.links[line.link];
    json["links"].push_back({{"log", c.logs[link.log]},
                             {"antenna", link.antenna},
                             {"rssi_dbm", link.rssi_dbm},
                             {"channels", line.channels},
                             {"delay_s", line.line.delay_s},
                             {"coherence", line.line.coherence}});
  }
  return json;
}

}  // namespace

std::string to_json(const Calibration& c) {
  Json json = {{"logs", c.logs},
               {"links", c.links.size()},
               {"reads", c.reads},
               {"stale_channels", c.stale_channels},
               {"seed", c.settings.seed}};
  json["noise"] = noise_of(c);
  json["flips"] = {{"pairs", c.flips.pairs},
                   {"flips", c.flips.flips},
                   {"flip_rssi_dbm", json_of(c.flips.rssi_dbm)},
                   {"flip_width_db", json_of(c.flips.width_db)}};
  json["frequency"] = frequency_of(c);
  json["phase_steps"] = c.phase_steps;
  json["weakest_dbm"] = c.weakest_dbm;
  json["rssi"] = c.rssi ? Json{{"rssi_at_1m_dbm", json_of(c.rssi->at_1m_dbm)},
                               {"rssi_slope_db", json_of(c.rssi->slope_db)}}
                        : Json();
  json["doppler"] = c.doppler ? Json{{"doppler_bias_hz", json_of(c.doppler->bias_hz)},
                                     {"doppler_floor_hz", json_of(c.doppler->floor_hz)},
                                     {"doppler_at_50dbm_hz", json_of(c.doppler->at_50dbm_hz)}}
                              : Json();
  json["timing"] = Json::array();
  for (const ReaderTiming& timing : c.timings) {
    json["timing"].push_back(timing_of(timing));
  }
  return json.dump(2) + "\n";
}

}  // namespace sensotwin::twin
