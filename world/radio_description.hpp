// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/base/epc.hpp"
#include "robot/base/geometry.hpp"

/// Ceiling tags, antennas and the reader between them: plain values, filled by twin/scene, obeyed by
/// world/radio. Numbers of the `impinj_r420` profile are measurements of the data study (its section is named
/// beside each).
namespace sensotwin::world {

/// A UHF tag under the ceiling, and the short-range floor tag below it, if one is laid.
struct CeilingTag {
  std::string name{};
  robot::Epc epc{};
  robot::Vec2 at_m{0.0, 0.0};  ///< in W
  double height_m{3.0};        ///< above the floor (Gueaieb & Miah, section IV)
  /// Phase that the tag itself adds, a constant of the chip and its antenna. None: drawn once per run,
  /// uniform.
  std::optional<double> phase_offset_rad{};
  std::vector<std::uint16_t> user_memory{};  ///< 16-bit words of the user bank
  bool present{true};                        ///< false: listed by the mission, fallen off the ceiling
  double shadow_db{0.0};                     ///< loss of everything heard from it, one way
  bool floor_tag{true};                      ///< an ISO 15693 tag on the floor below carries this EPC
};

/// One antenna on the robot.
struct AntennaDescription {
  Eigen::Vector3d at_m{0.0, 0.0, 0.1};  ///< in R: x forward, y left, z above the floor
  Eigen::Vector3d boresight{0.0, 0.0, 1.0};
  double gain_dbi{5.5};          ///< data study, 3.6: one of the antennas measured
  double beam_width_rad{1.222};  ///< half power, full angle: 70 degrees, a patch of that gain. Chosen
  double cable_delay_s{0.0};     ///< reader and cable, counted once (data study, 3.4: 35 to 75 ns)
};

/// The antenna whose RSSI at 1 m RadioDescription states (data study, 3.6: S9028PCLJ, 9 dBic). A weaker
/// antenna loses the difference twice, on the way out and back.
inline constexpr double kReferenceGain_dbi = 9.0;

enum class NoiseLaw : std::uint8_t {
  kProportional,  ///< sigma = per_m * distance (Gueaieb & Miah, section IV)
  kOffset,        ///< sigma = floor + per_m * distance
  kRssi,          ///< sigma = sqrt(floor^2 + (at_50dbm * 10^(-(RSSI + 50) / 20))^2) (data study, 3.5)
};

enum class PathKind : std::uint8_t {
  kBistatic,  ///< transmitted from the middle of the robot, received by each antenna: d_tx + d_i (the paper)
  kMonostatic,  ///< sent and received by the same antenna: 2 d (commercial readers)
};

/// A reader and the air about it. Everything off by default except what the paper names; see paper_radio()
/// and impinj_r420_radio().
struct RadioDescription {
  std::string profile{"paper"};
  PathKind path{PathKind::kBistatic};
  std::vector<double> channels_hz{915e6};  ///< published hop table, in the order of hopping. The paper: one
  double dwell_s{0.203};                   ///< on one channel (data study, 3.8)
  double hop_dead_s{0.006};                ///< lost at a hop (3.8)
  /// All antennas at the same instant, `rate_hz` times a second (the paper's two receivers); else one after
  /// another by `slots_s`.
  bool simultaneous{true};
  double rate_hz{20.0};  ///< algorithms study, A.0
  std::vector<double> slots_s{};
  /// Slot of an antenna that hears no tag; 0: the same as with one.
  double silent_slot_s{0.0};
  double per_tag_s{0.0007};  ///< further tags in one round (3.8)
  NoiseLaw noise_law{NoiseLaw::kProportional};
  double noise_floor_rad{0.0};
  double noise_per_m_rad{0.024};  ///< least squares through 0 of the paper's measurements (algorithms, A.0)
  double noise_at_50dbm_rad{0.0};
  double noise_scale{1.0};  ///< multiplies all of the above: "three times the calibrated noise"
  double phase_sign{1.0};   ///< +1: grows with distance; -1: falls (3.2, R420)
  int phase_steps{0};       ///< per turn, 0: not quantised. R420: 1024 (3.3)
  double drift_sigma_rad{0.0};
  double drift_time_s{2.0};
  double place_sigma_rad{0.0};  ///< smooth error of each place, from echoes (3.11)
  double place_length_m{0.0};   ///< over which it changes; 0: one value for the whole room
  /// Spread (1 sigma) of the echoes' delays behind the direct wave: how the error of a place changes from
  /// channel to channel.
  double place_delay_s{0.0};
  /// Echoes: each tag gets this many image sources of this relative amplitude (algorithms, A.3).
  int images{0};
  double image_amplitude{0.0};
  bool pi_flips{false};
  double flip_rssi_dbm{-72.2};  ///< logistic of 3.7
  double flip_width_db{2.52};
  bool pi_ambiguous{false};      ///< each read's phase is known up to pi only, by a coin
  double rssi_at_1m_dbm{-35.0};  ///< on the axis of an antenna of kReferenceGain_dbi (data study, 3.6)
  double rssi_slope_db{-40.0};   ///< per decade of distance, before antenna pattern and fading
  double place_sigma_db{0.0};    ///< fading of the place
  double channel_sigma_db{0.0};  ///< fading of the channel, which changes with the place too
  double channel_delay_s{0.0};   ///< spread of the delays behind it: narrow fades come from late echoes
  double rssi_sigma_db{0.0};     ///< from read to read (data study, 3.3)
  double rssi_step_db{0.0};      ///< of the report; 0: not rounded
  double cutoff_dbm{-1000.0};    ///< weaker tags are not read
  double doppler_bias_hz{0.0};   ///< of a tag at rest (data study, 3.10)
  /// Its scatter: sqrt(floor^2 + (at_50dbm * 10^(-(RSSI + 50) / 20))^2), the form of the phase noise.
  double doppler_floor_hz{0.0};
  double doppler_at_50dbm_hz{0.0};
  int report_every{1};  ///< reads in one report (3.9)
  /// A tag that an antenna reads again before the report goes out updates its row (time, phase, RSSI) and
  /// leaves the channel as it was first seen: wrong after a hop (3.9). Else each read is a row.
  bool accumulate_reads{false};
  double report_latency_s{0.0};
};

/// How antennas are mounted when nobody lists them.
enum class AntennaMounting : std::uint8_t {
  kPair,  ///< two patches on the robot's back that look up: pair_of_antennas()
  kRoof,  ///< two patches that look ahead and two that look behind: roof_of_antennas()
};

/// What goes wrong between reader and program. Nobody is told.
struct ReaderFaults {
  std::vector<robot::Vec2> silent_s{};  ///< from x to y the reader hears nothing, its connection standing
  double lost_share{0.0};               ///< of reads, each by its own luck
  bool cables_swapped{false};           ///< of ports 1 and 2
};

/// Everything of radio in one world. No antennas: no UHF reader.
struct RadioWorld {
  RadioDescription radio{};
  std::vector<CeilingTag> tags{};
  AntennaMounting mounting{AntennaMounting::kPair};
  std::vector<AntennaDescription> antennas{};  ///< port 1 first
  ReaderFaults faults{};
  double floor_tag_radius_m{0.05};  ///< read zone of the floor antenna over a floor tag (algorithms, A.0: r)
};

}  // namespace sensotwin::world
