// SPDX-License-Identifier: MIT
#include "twin/scene/phase_fields.hpp"

#include <algorithm>
#include <array>

#include "robot/settings/shared_fields.hpp"
#include "world/radio/profiles.hpp"

namespace sensotwin::twin {
namespace {

constexpr robot::Range kWhere{-1000.0, 1000.0};
constexpr robot::Range kPhase{0.0, 10.0};
constexpr robot::Range kTime{0.0, 60.0};
constexpr robot::Range kDecibel{-200.0, 200.0};

constexpr std::array<std::string_view, 2> kProfileWords{"paper", "impinj_r420"};
constexpr std::array<std::string_view, 2> kPathKindWords{"bistatic", "monostatic"};
constexpr std::array<std::string_view, 3> kNoiseLawWords{"proportional", "offset", "rssi"};
constexpr std::array<std::string_view, 2> kMountWords{"pair", "roof"};
constexpr std::array<std::string_view, 2> kCableWords{"as_given", "swapped"};

/// A profile as scenes have it: its hop table and its slots are made when the run begins, from its seed and
/// its antennas, unless the scene gives them.
world::RadioDescription profile(std::size_t index) {
  if (index == 0) {
    return world::paper_radio();
  }
  world::RadioDescription radio = world::impinj_r420_radio(robot::RandomStream(0), 2);
  radio.channels_hz.clear();
  radio.slots_s.clear();
  return radio;
}

void tag_fields(robot::FieldVisitor& v, world::CeilingTag& tag) {
  v.text({"name", "for missions, pictures and events", true}, tag.name);
  v.maybe(
      {"epc", "its code, 24 hexadecimal digits; else made from its place in the list"},
      tag.epc != robot::Epc{}, [] {},
      [&] {
        v.hex({"epc", "its code"}, tag.epc.bytes);
      });
  v.point({"at_m", "x and y in the world, m", true}, tag.at_m, kWhere);
  v.number({"height_m", "above the floor, m"}, tag.height_m, {0.2, 100.0});
  v.maybe({"phase_offset_rad", "phase that the tag adds; else drawn from the seed"}, tag.phase_offset_rad,
          [&](double& offset) {
            v.number({"phase_offset_rad", "phase that the tag adds, rad"}, offset, {-10.0, 10.0});
          });
  v.flag({"present", "false: listed by missions, fallen off the ceiling"}, tag.present);
  v.number({"shadow_db", "loss of all that is heard from it, one way, dB"}, tag.shadow_db, {0.0, 100.0});
  v.flag({"floor_tag", "a floor tag below carries its code"}, tag.floor_tag);
}

void reader_fields(robot::FieldVisitor& v, world::RadioDescription& radio) {
  v.choice({"path", "sent from the middle of the robot, or by the antenna that receives"}, radio.path,
           kPathKindWords);
  v.numbers({"channels_hz", "hop table in the order of hopping; empty: the profile's own"}, radio.channels_hz,
            {1e8, 1e10}, {});
  v.number({"dwell_s", "on one channel, s"}, radio.dwell_s, {0.001, 60.0});
  v.number({"hop_dead_s", "lost at a hop, s"}, radio.hop_dead_s, kTime);
  v.flag({"simultaneous", "all antennas at one instant; else one after another"}, radio.simultaneous);
  v.number({"rate_hz", "simultaneous: reads a second"}, radio.rate_hz, {0.1, 1000.0});
  v.numbers({"slots_s", "not simultaneous: each antenna's time, s; empty: as measured"}, radio.slots_s,
            {0.001, 60.0}, {});
  v.number({"silent_slot_s", "of several antennas one that hears no tag, s; 0: as with one"},
           radio.silent_slot_s, kTime);
  v.number({"per_tag_s", "each further tag in one round, s"}, radio.per_tag_s, kTime);
  v.number({"phase_sign", "+1: phase grows with distance; -1: falls"}, radio.phase_sign, {-1.0, 1.0});
  v.whole({"phase_steps", "of a turn; 0: not quantised"}, radio.phase_steps, 0, 65536);
  v.flag({"pi_flips", "reads half a turn off, by RSSI"}, radio.pi_flips);
  v.number({"flip_rssi_dbm", "where pairs of reads differ by a flip in one of four"}, radio.flip_rssi_dbm,
           kDecibel);
  v.number({"flip_width_db", "of the logistic about it, dB"}, radio.flip_width_db, {0.0, 100.0, true});
  v.flag({"pi_ambiguous", "each read's phase is known up to pi only"}, radio.pi_ambiguous);
  v.whole({"report_every", "reads in one report"}, radio.report_every, 1, 1000);
  v.flag({"accumulate_reads", "reads of a tag by an antenna merge in a report"}, radio.accumulate_reads);
  v.number({"report_latency_s", "from the last read of a report to its first byte, s"},
           radio.report_latency_s, kTime);
}

void noise_fields(robot::FieldVisitor& v, world::RadioDescription& radio) {
  v.choice({"noise_law", "what the phase noise grows with"}, radio.noise_law, kNoiseLawWords);
  v.number({"noise_floor_rad", "1 sigma, rad"}, radio.noise_floor_rad, kPhase);
  v.number({"noise_per_m_rad", "1 sigma, rad/m"}, radio.noise_per_m_rad, kPhase);
  v.number({"noise_at_50dbm_rad", "1 sigma at -50 dBm, rad"}, radio.noise_at_50dbm_rad, kPhase);
  v.number({"noise_scale", "multiplies all of these"}, radio.noise_scale, {0.0, 1000.0});
  v.number({"drift_sigma_rad", "slow drift, 1 sigma, rad"}, radio.drift_sigma_rad, kPhase);
  v.number({"drift_time_s", "over which it changes, s"}, radio.drift_time_s, {0.001, 1e6});
}

void air_fields(robot::FieldVisitor& v, world::RadioDescription& radio) {
  v.number({"place_sigma_rad", "smooth error of each place, 1 sigma, rad"}, radio.place_sigma_rad, kPhase);
  v.number({"place_length_m", "over which it changes, m; 0: one for the room"}, radio.place_length_m,
           {0.0, 1000.0});
  v.number({"place_delay_s", "spread of the echoes' delays, s"}, radio.place_delay_s, {0.0, 1e-3});
  v.whole({"images", "echoes of each tag"}, radio.images, 0, 100);
  v.number({"image_amplitude", "of an echo, against the direct wave"}, radio.image_amplitude, {0.0, 1.0});
  v.number({"rssi_at_1m_dbm", "on the axis of a 9 dBi antenna, dBm"}, radio.rssi_at_1m_dbm, kDecibel);
  v.number({"rssi_slope_db", "per decade of distance, dB"}, radio.rssi_slope_db, kDecibel);
  v.number({"place_sigma_db", "fading of the place, 1 sigma, dB"}, radio.place_sigma_db, {0.0, 100.0});
  v.number({"channel_sigma_db", "fading of the channel, 1 sigma, dB"}, radio.channel_sigma_db, {0.0, 100.0});
  v.number({"channel_delay_s", "spread of the delays behind it, s"}, radio.channel_delay_s, {0.0, 1e-3});
  v.number({"rssi_sigma_db", "from read to read, 1 sigma, dB"}, radio.rssi_sigma_db, {0.0, 100.0});
  v.number({"rssi_step_db", "of the report, dB; 0: the wire's own 0.5"}, radio.rssi_step_db, {0.0, 100.0});
  v.number({"cutoff_dbm", "weaker tags are not read, dBm"}, radio.cutoff_dbm, {-1000.0, 100.0});
  v.number({"doppler_bias_hz", "of a tag at rest, Hz"}, radio.doppler_bias_hz, {-1000.0, 1000.0});
  v.number({"doppler_floor_hz", "its scatter, 1 sigma, Hz"}, radio.doppler_floor_hz, {0.0, 1000.0});
  v.number({"doppler_at_50dbm_hz", "its scatter that follows RSSI, Hz"}, radio.doppler_at_50dbm_hz,
           {0.0, 1000.0});
}

void radio_fields(robot::FieldVisitor& v, world::RadioDescription& radio) {
  auto index = static_cast<std::size_t>(radio.profile == kProfileWords[1]);
  v.choice({"profile", "where the numbers below come from unless given: docs/phase.md"}, index,
           kProfileWords);
  if (kProfileWords[index] != radio.profile) {
    radio = profile(index);
  }
  std::optional<std::string> file;  // put in its place by the reader before any field is read
  v.maybe({"file", "a profile that twin calibrate wrote, relative to the scene; keys here go before it"},
          file, [&](std::string& name) {
            v.text({"file", "a profile that twin calibrate wrote"}, name);
          });
  reader_fields(v, radio);
  noise_fields(v, radio);
  air_fields(v, radio);
}

void reader_fault_fields(robot::FieldVisitor& v, world::ReaderFaults& faults) {
  v.points({"silent_s", "[from, to]: hears nothing meanwhile, s of the run"}, faults.silent_s, {0.0, 1e6},
           {0, 1000});
  v.number({"lost_share", "of reads that never arrive"}, faults.lost_share, {0.0, 1.0});
  std::size_t cables = faults.cables_swapped ? 1 : 0;
  v.choice({"cables", "of ports 1 and 2"}, cables, kCableWords);
  faults.cables_swapped = cables == 1;
}

/// Makes the optional radio of a world there.
auto there(world::WorldDescription& world) {
  return [&world] {
    if (!world.radio) {
      world.radio.emplace();
    }
  };
}

}  // namespace

void radio_world_fields(robot::FieldVisitor& v, world::WorldDescription& world) {
  const robot::Field tags{"ceiling_tags", "UHF tags under the ceiling"};
  v.maybe(tags, world.radio.has_value(), there(world),
          [&] { v.list(tags, world.radio->tags, [&](world::CeilingTag& tag) { tag_fields(v, tag); }); });
  const robot::Field radio{"radio", "UHF reader and air: a profile, and what differs from it"};
  v.maybe(radio, world.radio.has_value(), there(world),
          [&] { v.section(radio, [&] { radio_fields(v, world.radio->radio); }); });
  const robot::Field radius{"floor_tag_radius_m", "a floor tag below a ceiling tag is read within this, m"};
  v.maybe(radius, world.radio.has_value(), there(world), [&] {
    v.number(radius, world.radio->floor_tag_radius_m, {0.001, 1.0});
  });
}

void uhf_reader_fields(robot::FieldVisitor& v, world::WorldDescription& world) {
  const robot::Field reader{"uhf_reader", "reads the tags under the ceiling"};
  v.maybe(reader, world.radio.has_value(), there(world), [&] {
    v.section(reader, [&] {
      v.choice({"mount", "of antennas that are not listed: two look up, or two ahead and two behind"},
               world.radio->mounting, kMountWords);
      v.list(
          {"antennas", "port 1 first; else as mounted"}, world.radio->antennas,
          [&](world::AntennaDescription& antenna) {
            robot::xyz(v, {"at_m", "forward, left, up from the floor below the middle, m"}, antenna.at_m,
                       {-1.0, 1.0});
            robot::xyz(v, {"boresight", "direction in which it hears best"}, antenna.boresight, {-1.0, 1.0});
            v.number({"gain_dbi", "dBi"}, antenna.gain_dbi, {-20.0, 30.0});
            v.angle({"beam_width_deg", "between the directions of half power, degrees"},
                    antenna.beam_width_rad, {1.0, 179.0});
            v.number({"cable_delay_s", "reader and cable, counted once, s"}, antenna.cable_delay_s,
                     {0.0, 1e-6});
          });
      v.section({"faults", "of reader and cables; the robot is not told"},
                [&] { reader_fault_fields(v, world.radio->faults); });
    });
  });
}

void complete_radio(Scene& scene) {
  if (!scene.world.radio) {
    return;
  }
  world::RadioWorld& radio = *scene.world.radio;
  for (std::size_t i = 0; i < radio.tags.size(); ++i) {
    if (radio.tags[i].epc == robot::Epc{}) {
      // Header of an SGTIN-96 (EPC Tag Data Standard), then the tag's number: as a shop would print them.
      radio.tags[i].epc.bytes[0] = 0x30;
      radio.tags[i].epc.bytes[10] = static_cast<std::uint8_t>((i + 1) >> 8);
      radio.tags[i].epc.bytes[11] = static_cast<std::uint8_t>((i + 1) & 0xFFu);
    }
  }
  if (radio.antennas.empty()) {
    radio.antennas = radio.mounting == world::AntennaMounting::kRoof ? world::roof_of_antennas()
                                                                     : world::pair_of_antennas();
  }
}

}  // namespace sensotwin::twin
