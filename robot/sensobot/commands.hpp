// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "robot/calibration/calibration_program.hpp"
#include "robot/output/exit_codes.hpp"
#include "robot/ports/card_session.hpp"

/// What can be asked of `sensobot`. Each deed throws LoadError and OutputError.
namespace sensotwin::robot {

/// What main knows of the process and hands down.
struct SensobotEnvironment {
  std::ostream& out;                 ///< stdout: results
  std::ostream& err;                 ///< stderr: what is said on the way
  std::function<std::string()> utc;  ///< now, as "20260131T235959Z"
  CardService card_service{begin_pcsc_session};
};

struct RunCommandOptions {
  std::filesystem::path robot;
  std::optional<std::filesystem::path> devices{};      ///< instead of the file's own section
  std::optional<std::filesystem::path> calibration{};  ///< laid over the file
  std::optional<std::filesystem::path> out{};
  bool force{false};
  std::optional<std::filesystem::path> journal{};  ///< none: in the run's folder
  bool no_journal{false};
  std::optional<std::string> monitor{};  ///< host:port of a page, empty: where there is room
  double rate{1.0};
  double wait_s{10.0};
  double patience_s{60.0};
  bool json{false};
  bool quiet{false};
};
[[nodiscard]] ExitCode run_command(const RunCommandOptions& options, const SensobotEnvironment& environment);

struct CheckCommandOptions {
  std::filesystem::path robot;
  std::optional<std::filesystem::path> devices{};
  std::optional<std::filesystem::path> calibration{};
  double seconds{2.0};  ///< of listening to each device
  bool json{false};
};
[[nodiscard]] ExitCode check_command(const CheckCommandOptions& options,
                                     const SensobotEnvironment& environment);

struct CalibrateCommandOptions {
  std::filesystem::path robot;
  std::optional<std::filesystem::path> devices{};
  std::optional<std::filesystem::path> calibration{};
  CalibrationPlan plan{};
  std::optional<std::filesystem::path> out{};  ///< none: the lines go to stdout
  double rate{1.0};
  bool json{false};
};
[[nodiscard]] ExitCode calibrate_command(const CalibrateCommandOptions& options,
                                         const SensobotEnvironment& environment);

struct MonitorCommandOptions {
  std::vector<std::string> urls{};  ///< as the other programs printed them
  std::string at{};                 ///< host:port of the page; empty: where there is room
};
[[nodiscard]] ExitCode monitor_command(const MonitorCommandOptions& options,
                                       const SensobotEnvironment& environment);

struct ReplayCommandOptions {
  std::filesystem::path journal;
  bool json{false};
};
[[nodiscard]] ExitCode replay_command(const ReplayCommandOptions& options,
                                      const SensobotEnvironment& environment);

struct ShowCommandOptions {
  std::filesystem::path robot;
  std::optional<std::filesystem::path> devices{};
  std::optional<std::filesystem::path> calibration{};
};
[[nodiscard]] ExitCode show_command(const ShowCommandOptions& options,
                                    const SensobotEnvironment& environment);

}  // namespace sensotwin::robot
