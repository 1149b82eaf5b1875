// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/base/epc.hpp"
#include "robot/base/geometry.hpp"
#include "robot/base/time.hpp"
#include "robot/drivers/tag_reader.hpp"
#include "robot/mapping/mapping_config.hpp"
#include "robot/phase/estimation/phase_model.hpp"
#include "robot/settings/hallway_file.hpp"
#include "robot/settings/mission.hpp"
#include "robot/wire/storage_card.hpp"

namespace sensotwin::robot {

/// What speaks at the other end of the serial line.
enum class BaseKind : std::uint8_t {
  kCreate2,    ///< Open Interface, 115200 baud
  kRoomba400,  ///< SCI, 57600 baud
};
/// Which errata of the mainboard answer (protocols study, 1.7). The driver has to know of the last only.
enum class BaseFirmware : std::uint8_t { kCurrent, kBefore341, kBefore330, kWifi };

/// The machine as the robot knows it. Create 2 Open Interface 2016: wheel base, wheel, counts, speed.
struct BaseSettings {
  BaseKind kind{BaseKind::kCreate2};
  BaseFirmware firmware{BaseFirmware::kCurrent};
  double radius_m{0.17};
  double wheel_base_m{0.235};
  double wheel_diameter_m{0.072};  ///< mean of both
  double wheel_ratio{1.0};         ///< right wheel's over the left's
  double counts_per_turn{508.8};
  double speed_max_mps{0.5};
};

/// One short-range antenna and the PC/SC reader behind it.
struct CardReaderSettings {
  double read_radius_m{0.08};  ///< a tag answers within
  UidOrder uid_order{UidOrder::kMsbFirst};
  int blocks_per_command{4};
  /// A tag's coming and going is noticed this much late, with this scatter (1 sigma). Default: half a look of
  /// the twin's reader and half a control step. pcscd looks every 0.4 s at a reader whose driver does not
  /// wake it: 0.2 s and 0.115 s then.
  double notice_delay_s{MappingConfig{}.rim_delay_s};
  double notice_sigma_s{0.0};
  double exchange_limit_s{to_s(TagReaderConfig{}.exchange_limit)};  ///< without an answer it is given up
};

/// Reader and antennas for the tags under the ceiling, as calibrated. Defaults: the paper's reader.
struct UhfReaderSettings {
  std::vector<AntennaMount> antennas{{.at_R_m = {0.0, 0.08, 0.1}}, {.at_R_m = {0.0, -0.08, 0.1}}};
  bool monostatic{false};
  double phase_sign{1.0};    ///< +1: the reported phase grows with distance; -1: falls
  bool pi_ambiguous{false};  ///< all reads are known up to half a turn only
  double centre_hz{915e6};
  PhaseNoise noise;
  int report_every{1};
  double echo_caution{1.0};  ///< EstimatorConfig::echo_caution: how far its law of echoes is distrusted
};

/// A tag under the ceiling that a mission may name.
struct KnownTag {
  std::string name;
  Epc epc;
  double height_m{3.0};
};

/// All that a program is told: of its machine, of the place, of its task. Nothing of where anything is.
struct RobotSettings {
  BaseSettings base;
  CardReaderSettings floor_reader;
  CardReaderSettings forward_reader{.read_radius_m = 0.10};
  UhfReaderSettings uhf_reader;
  double tile_m{0.508};  ///< edge of a carpet tile, 20 inches (SensoBot, III.A)
  std::vector<KnownTag> ceiling_tags;
  double floor_tag_radius_m{0.08};  ///< of a floor tag below a ceiling tag
  HallwayFile hallways;             ///< of missions in hallways
  Mission mission;
  std::uint32_t map_id{1};  ///< written into tags, to tell this map from an older one
};

}  // namespace sensotwin::robot
