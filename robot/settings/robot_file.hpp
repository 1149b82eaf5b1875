// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robot/config/problem.hpp"
#include "robot/settings/robot_settings.hpp"

namespace sensotwin::robot {

/// Where the devices are plugged in, as `twin serve` writes it too (devices.yaml). What is absent is not
/// there; check_robot() says what a mission cannot do without.
struct DeviceAddresses {
  std::optional<std::string> base;        ///< serial device of the Roomba
  std::optional<std::string> sensors;     ///< serial device of the sensor board
  std::optional<std::string> llrp;        ///< host:port of the UHF reader
  std::vector<std::string> card_readers;  ///< PC/SC names: under the robot, then ahead of it
  int sensors_baud{4800};                 ///< NMEA 0183
};

/// A robot file: one machine, its place and its task. Field order here is the order in the YAML.
struct RobotFile {
  int version{1};    ///< of the file format; the reader refuses others
  std::string file;  ///< as the user spelt it
  DeviceAddresses devices;
  RobotSettings settings;
  bool hallways_given{false};  ///< settings.hallways was, here or in the file named here
  bool map_id_given{false};
  double time_limit_s{20700.0};  ///< the run ends undone after this. As of scenes
};

/// What a file is read for.
enum class RobotFileUse : std::uint8_t {
  kRun,    ///< all that its mission needs must be there
  kCheck,  ///< what is there is tested, whatever the mission
};

/// \param devices  a file to take the section `devices:` from, instead of what stands there
/// \param calibration  a file of the same form that holds some sections only: what stands in it takes the
/// place of what stands here, key by key, lists as a whole
/// \throws LoadError
[[nodiscard]] RobotFile read_robot_file(const std::filesystem::path& file,
                                        const std::optional<std::filesystem::path>& devices = {},
                                        RobotFileUse use = RobotFileUse::kRun,
                                        const std::optional<std::filesystem::path>& calibration = {});
/// \param file  for messages, and where relative paths begin
[[nodiscard]] RobotFile read_robot_text(const std::string& text, const std::filesystem::path& file,
                                        const std::optional<std::filesystem::path>& devices = {},
                                        RobotFileUse use = RobotFileUse::kRun,
                                        const std::optional<std::filesystem::path>& calibration = {});

/// The file with all defaults; reads back to the same.
[[nodiscard]] std::string robot_yaml(const RobotFile& robot);

}  // namespace sensotwin::robot
