// SPDX-License-Identifier: MIT
#include "robot/settings/robot_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "robot/config/field_reader.hpp"
#include "robot/config/field_writer.hpp"
#include "robot/config/text_file.hpp"
#include "robot/config/yaml_tree.hpp"
#include "robot/settings/mission_checks.hpp"
#include "robot/settings/mission_fields.hpp"
#include "robot/settings/shared_fields.hpp"

namespace sensotwin::robot {
namespace {

constexpr std::array<std::string_view, 2> kUidOrderWords{"msb_first", "lsb_first"};
constexpr std::array<std::string_view, 2> kPathKindWords{"bistatic", "monostatic"};

/// Keys of a scene that say what is true, which no machine asks for: they may stand here, for the sections
/// are the same, and are passed over.
void of_the_twin_alone(FieldVisitor& v, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) {
    v.maybe(
        {key, "of the twin alone"}, false, [] {}, [] {});
  }
}

void address(FieldVisitor& v, const Field& field, std::optional<std::string>& where) {
  v.maybe(field, where, [&](std::string& text) { v.text(field, text); });
}

void device_fields(FieldVisitor& v, DeviceAddresses& devices) {
  address(v, {"base", "serial device of the Roomba"}, devices.base);
  address(v, {"sensors", "serial device of the sensor board"}, devices.sensors);
  address(v, {"llrp", "UHF reader, host:port"}, devices.llrp);
  v.texts({"card_readers", "PC/SC names: under the robot, then ahead of it"}, devices.card_readers, {0, 2});
  v.whole({"sensors_baud", "bits a second of the sensor board"}, devices.sensors_baud, 300, 230400);
}

void card_reader_fields(FieldVisitor& v, CardReaderSettings& reader) {
  v.number({"read_radius_m", "a tag answers within this radius, m"}, reader.read_radius_m, {0.005, 1.0});
  v.choice({"uid_order", "which byte of a UID the reader gives first"}, reader.uid_order, kUidOrderWords);
  v.whole({"blocks_per_command", "blocks of 4 bytes in one command"}, reader.blocks_per_command, 1, 63);
  v.number({"notice_delay_s", "a tag's coming and going is noticed this much late, s"}, reader.notice_delay_s,
           {0.0, 5.0});
  v.number({"exchange_limit_s", "an exchange without an answer is given up after this, s"},
           reader.exchange_limit_s, {0.02, 60.0});
  v.number({"notice_sigma_s", "scatter of that, 1 sigma, s"}, reader.notice_sigma_s, {0.0, 5.0});
  of_the_twin_alone(v, {"at_m", "exchange_s", "latency_s", "missed_share", "torn_write_probability"});
}

void uhf_reader_fields(FieldVisitor& v, UhfReaderSettings& reader) {
  v.list(
      {"antennas", "port 1 first; else two, 0.08 m to the left and to the right"}, reader.antennas,
      [&](AntennaMount& antenna) {
        xyz(v, {"at_m", "forward, left, up from the floor below the middle, m", true}, antenna.at_R_m,
            {-1.0, 1.0});
        v.number({"cable_delay_s", "reader and cable, counted once, s"}, antenna.cable_delay_s, {0.0, 1e-6});
        v.number({"phase_offset_rad", "of this port against port 1, rad"}, antenna.phase_offset_rad,
                 {-10.0, 10.0});
        v.number({"phase_offset_sigma_rad", "how well that is known; above 1: learned on the way, rad"},
                 antenna.phase_offset_sigma_rad, {0.0, 10.0});
        of_the_twin_alone(v, {"boresight", "gain_dbi", "beam_width_deg"});
      });
  std::size_t path = reader.monostatic ? 1 : 0;
  v.choice({"path", "sent from the middle of the robot, or by the antenna that receives"}, path,
           kPathKindWords);
  reader.monostatic = path == 1;
  v.number({"phase_sign", "+1: phase grows with distance; -1: falls"}, reader.phase_sign, {-1.0, 1.0});
  v.flag({"pi_ambiguous", "each read's phase is known up to pi only"}, reader.pi_ambiguous);
  v.number({"centre_hz", "middle of the band, Hz"}, reader.centre_hz, {1e8, 1e10});
  v.number({"echo_caution", "how many times as large as noise.echo_rad says echoes are taken to be"},
           reader.echo_caution, {1.0, 10.0});
  v.whole({"report_every", "reads in one report"}, reader.report_every, 1, 1000);
  v.section({"noise", "of a read's phase, 1 sigma"}, [&] {
    v.number({"floor_rad", "rad"}, reader.noise.floor_rad, {0.0, 10.0});
    v.number({"per_m_rad", "rad/m"}, reader.noise.per_m_rad, {0.0, 10.0});
    v.number({"at_50dbm_rad", "at -50 dBm, rad"}, reader.noise.at_50dbm_rad, {0.0, 10.0});
    v.number({"echo_rad", "of echoes, rad"}, reader.noise.echo_rad, {0.0, 10.0});
    v.number({"echo_length_m", "over which they become others, m"}, reader.noise.echo_length_m,
             {0.001, 1000.0});
    v.number({"echo_delay_s", "spread of their delays: how another channel hears others, s"},
             reader.noise.echo_delay_s, {0.0, 1e-3});
  });
}

void robot_fields(FieldVisitor& v, RobotSettings& settings) {
  v.section({"base", "the Roomba"}, [&] {
    base_fields(v, settings.base);
    v.number({"wheel_ratio", "right wheel's diameter over the left's"}, settings.base.wheel_ratio,
             {0.8, 1.25});
    of_the_twin_alone(v, {"height_m", "mass_kg", "wheel_acceleration_mps2", "wheel_diameter_sigma",
                          "wheel_base_sigma", "battery_capacity_mah", "battery_charge_mah"});
  });
  v.section({"floor_reader", "reads the tags under the robot"},
            [&] { card_reader_fields(v, settings.floor_reader); });
  v.section({"forward_reader", "reads the tags ahead"},
            [&] { card_reader_fields(v, settings.forward_reader); });
  v.section({"uhf_reader", "reads the tags under the ceiling"},
            [&] { uhf_reader_fields(v, settings.uhf_reader); });
  of_the_twin_alone(v, {"start", "compass"});
}

void place_fields(FieldVisitor& v, RobotFile& robot, HallwayFields& hallways) {
  RobotSettings& settings = robot.settings;
  v.number({"tile_m", "side of a carpet tile, m"}, settings.tile_m, {0.1, 5.0});
  v.list({"ceiling_tags", "UHF tags under the ceiling"}, settings.ceiling_tags, [&](KnownTag& tag) {
    v.text({"name", "for missions and events", true}, tag.name);
    v.hex({"epc", "its code, 24 hexadecimal digits", true}, tag.epc.bytes);
    v.number({"height_m", "above the floor, m"}, tag.height_m, {0.2, 100.0});
  });
  const Field field{"hallways", "hallway map, or the name of the file beside this one that holds it"};
  v.maybe(
      field, robot.hallways_given, [&] { robot.hallways_given = true; },
      [&] { v.section(field, [&] { hallways.visit(v); }); });
  v.number({"floor_tag_radius_m", "a floor tag below a ceiling tag is read within this, m"},
           settings.floor_tag_radius_m, {0.001, 1.0});
}

void visit_fields(FieldVisitor& v, RobotFile& robot, HallwayFields& hallways) {
  v.whole({"version", "of this file format: 1", true}, robot.version, 1, 1);
  v.section({"devices", "where the devices are plugged in", true}, [&] { device_fields(v, robot.devices); });
  v.section({"robot", "the machine"}, [&] { robot_fields(v, robot.settings); });
  v.section({"place", "what is known of the place"}, [&] { place_fields(v, robot, hallways); });
  v.section({"mission", "what the robot is to do; by default, map the carpet"},
            [&] { mission_fields(v, robot.settings.mission); });
  const Field map_id{"map_id", "written into tags, to tell this map from an older one; else a new one"};
  v.maybe(
      map_id, robot.map_id_given, [&] { robot.map_id_given = true; },
      [&] { v.whole(map_id, robot.settings.map_id, 1, 4294967295); });
  v.number({"time_limit_s", "the run ends undone after this time, s"}, robot.time_limit_s,
           {0.0, 1.0e7, true});
}

/// The tree of a file, which must be a section.
YamlNode section_of(const std::string& text, const std::string& source, std::vector<Problem>& problems) {
  YamlNode root = parse_yaml(text, source, problems);
  if (problems.empty() && root.kind != YamlKind::kSection) {
    problems.push_back({{source, 1, 1}, "", "is " + root.describe(), "expected keys: value"});
  }
  if (!problems.empty()) {
    throw LoadError(problems, kExitInvalid);
  }
  return root;
}

/// `devices: FILE`, and what the caller has in place of it, become the section that stands in that file.
void take_devices(YamlNode& root, const std::filesystem::path& folder,
                  const std::optional<std::filesystem::path>& given, std::vector<Problem>& problems) {
  auto entry = std::find_if(root.entries.begin(), root.entries.end(),
                            [](const YamlEntry& candidate) { return candidate.key == "devices"; });
  if (given) {
    if (entry == root.entries.end()) {
      root.entries.push_back({"devices", root.place, {}});
      entry = root.entries.end() - 1;
    }
    entry->value = section_of(read_text_file(*given, "devices"), given->string(), problems);
  } else if (entry != root.entries.end() && entry->value.kind == YamlKind::kText) {
    const std::filesystem::path file = folder / entry->value.text;
    entry->value = section_of(read_text_file(file, "devices"), file.string(), problems);
  }
}

/// `place.hallways: FILE` becomes the section that stands in that file.
void take_hallways(YamlNode& root, const std::filesystem::path& folder, std::vector<Problem>& problems) {
  for (YamlEntry& section : root.entries) {
    for (YamlEntry& entry : section.value.entries) {
      if (section.key == "place" && entry.key == "hallways" && entry.value.kind == YamlKind::kText) {
        const std::filesystem::path file = folder / entry.value.text;
        entry.value = section_of(read_text_file(file, "hallway map"), file.string(), problems);
      }
    }
  }
}

/// Sections key by key; everything else, lists too, as a whole.
void lay_over(YamlNode& below, const YamlNode& above) {
  if (below.kind != YamlKind::kSection || above.kind != YamlKind::kSection) {
    below = above;
    return;
  }
  for (const YamlEntry& entry : above.entries) {
    const auto found = std::find_if(below.entries.begin(), below.entries.end(),
                                    [&](const YamlEntry& candidate) { return candidate.key == entry.key; });
    if (found == below.entries.end()) {
      below.entries.push_back(entry);
    } else {
      lay_over(found->value, entry.value);
    }
  }
}

void check_machine(const RobotSettings& settings, const FieldReader& reader, std::vector<Problem>& problems) {
  const double sign = settings.uhf_reader.phase_sign;
  if (sign != 1.0 && sign != -1.0) {
    const std::string path = "robot.uhf_reader.phase_sign";
    problems.push_back({reader.place(path), path, fmt::format("is {}", sign), "expected 1 or -1"});
  }
  if (settings.uhf_reader.antennas.empty()) {
    const std::string path = "robot.uhf_reader.antennas";
    problems.push_back({reader.place(path), path, "is empty", "expected one antenna or more"});
  }
}

void check_mission(const RobotFile& robot, const FieldReader& reader, std::vector<Problem>& problems) {
  const RobotSettings& settings = robot.settings;
  const auto add = [&](const std::string& path, const std::string& what, const std::string& hint) {
    problems.push_back({reader.place(path), path, what, hint});
  };
  if (settings.base.kind == BaseKind::kRoomba400) {
    add("robot.base.kind", "a Roomba 400 has no encoders, and every mission counts them",
        "expected create2; `sensobot check` tests a Roomba 400 all the same");
  }
  const auto need = [&](bool there, const std::string& key, const std::string& what) {
    if (!there) {
      add("devices", fmt::format("'{}' is missing", key), "expected " + what);
    }
  };
  need(robot.devices.base.has_value(), "base", "the serial device of the Roomba, such as /dev/ttyUSB0");
  if (settings.mission.hallway) {
    need(robot.devices.sensors.has_value(), "sensors", "the serial device of compass and rangefinders");
    for (const MissionProblem& problem : problems_of(*settings.mission.hallway, settings.hallways.map)) {
      add(problem.path, problem.what, problem.hint);
    }
  }
  if (!settings.mission.phase) {
    need(!robot.devices.card_readers.empty(), "card_readers",
         "the PC/SC name of the reader under the robot (pcsc_scan -n lists them)");
    return;
  }
  need(robot.devices.llrp.has_value(), "llrp", "the UHF reader's address, such as 192.168.1.20:5084");
  if (settings.ceiling_tags.empty()) {
    add("mission.phase", "needs ceiling tags", "expected place.ceiling_tags");
    return;
  }
  std::vector<std::string> names;
  for (const KnownTag& tag : settings.ceiling_tags) {
    names.push_back(tag.name);
  }
  for (const MissionProblem& problem : problems_of(
           *settings.mission.phase, names, settings.uhf_reader.antennas.size(), "place.ceiling_tags")) {
    add(problem.path, problem.what, problem.hint);
  }
}

}  // namespace

RobotFile read_robot_file(const std::filesystem::path& file,
                          const std::optional<std::filesystem::path>& devices, RobotFileUse use,
                          const std::optional<std::filesystem::path>& calibration) {
  return read_robot_text(read_text_file(file, "robot file"), file, devices, use, calibration);
}

RobotFile read_robot_text(const std::string& text, const std::filesystem::path& file,
                          const std::optional<std::filesystem::path>& devices, RobotFileUse use,
                          const std::optional<std::filesystem::path>& calibration) {
  std::vector<Problem> problems;
  YamlNode root = section_of(text, file.string(), problems);
  take_devices(root, file.parent_path(), devices, problems);
  if (calibration) {
    lay_over(root, section_of(read_text_file(*calibration, "calibration"), calibration->string(), problems));
  }
  take_hallways(root, file.parent_path(), problems);
  RobotFile robot;
  robot.file = file.string();
  HallwayFields hallways;
  FieldReader reader(root, problems);
  visit_fields(reader, robot, hallways);
  reader.finish();
  if (robot.hallways_given) {
    robot.settings.hallways = hallways.read(reader, "place.hallways.", problems);
  }
  if (!reader.has("mission")) {
    robot.settings.mission.map.emplace();
  }
  if (problems.empty()) {
    check_machine(robot.settings, reader, problems);
    if (use == RobotFileUse::kRun) {
      check_mission(robot, reader, problems);
    }
  }
  if (!problems.empty()) {
    throw LoadError(std::move(problems), kExitInvalid);
  }
  return robot;
}

std::string robot_yaml(const RobotFile& robot) {
  RobotFile shown = robot;
  HallwayFields hallways(robot.settings.hallways);
  FieldWriter writer;
  visit_fields(writer, shown, hallways);
  return writer.text();
}

}  // namespace sensotwin::robot
