// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <ostream>

#include "robot/config/problem.hpp"
#include "robot/output/signals.hpp"
#include "twin/calibrate/calibration.hpp"
#include "twin/calibrate/calibration_chart.hpp"
#include "twin/cli/deed_support.hpp"
#include "twin/cli/deeds.hpp"

namespace sensotwin::twin {
namespace {

/// "902.75:0.5:50" in MHz. \throws CommandError
Band band_from(const std::string& text) {
  Band band;
  double first_mhz = 0.0;
  double step_mhz = 0.0;
  const char* const end = text.data() + text.size();
  auto at = std::from_chars(text.data(), end, first_mhz);
  bool ok = at.ec == std::errc{} && at.ptr != end && *at.ptr == ':';
  if (ok) {
    at = std::from_chars(at.ptr + 1, end, step_mhz);
    ok = at.ec == std::errc{} && at.ptr != end && *at.ptr == ':';
  }
  if (ok) {
    at = std::from_chars(at.ptr + 1, end, band.channels);
    ok = at.ec == std::errc{} && at.ptr == end;
  }
  if (!ok || !(first_mhz > 0.0 && first_mhz < 1e5 && step_mhz > 0.0 && step_mhz < 1e3) || band.channels < 2 ||
      band.channels > 1000) {
    throw CommandError(
        robot::ExitCode::kWrongCommandLine,
        fmt::format("--band {}: FIRST:STEP:COUNT in MHz was expected, as 902.75:0.5:50", text));
  }
  band.first_hz = 1e6 * first_mhz;
  band.step_hz = 1e6 * step_mhz;
  return band;
}

/// Frequencies by position. \throws SceneError unless each of 1 .. n stands there once
std::vector<double> hop_table_from(const std::filesystem::path& file) {
  const auto numbers = read_keyed_numbers(file, "channel_index", "freq_mhz");
  std::vector<double> channels_hz(numbers.size(), 0.0);
  for (const KeyedNumber& number : numbers) {
    std::size_t index = 0;
    const char* const end = number.key.data() + number.key.size();
    if (std::from_chars(number.key.data(), end, index).ptr != end || index < 1 ||
        index > channels_hz.size()) {
      throw robot::LoadError({{{file.string(), 0, 0},
                               "channel_index",
                               fmt::format("'{}'", number.key),
                               fmt::format("each of 1 to {} was expected once", channels_hz.size())}},
                             robot::kExitInvalid);
    }
    channels_hz[index - 1] = 1e6 * number.value;
  }
  return channels_hz;
}

std::vector<std::optional<double>> distances_of(const std::vector<TagLog>& logs,
                                                const std::filesystem::path& file) {
  const auto numbers = read_keyed_numbers(file, "log", "distance_m");
  std::vector<std::optional<double>> distance_m;
  for (const TagLog& log : logs) {
    const auto known = std::find_if(numbers.begin(), numbers.end(),
                                    [&](const KeyedNumber& number) { return number.key == log.name; });
    distance_m.push_back(known != numbers.end() && known->value > 0.0 ? std::optional{known->value}
                                                                      : std::nullopt);
  }
  return distance_m;
}

CalibrationInput input_of(const CalibrateOptions& options) {
  try {
    CalibrationInput input;
    for (const std::filesystem::path& path : options.logs) {
      input.logs.push_back(read_sllurp_log(path));
    }
    input.distance_m.resize(input.logs.size());
    if (options.distances) {
      input.distance_m = distances_of(input.logs, *options.distances);
    }
    if (options.hop_table) {
      input.channels_hz = hop_table_from(*options.hop_table);
    }
    return input;
  } catch (const robot::LoadError& error) {
    throw CommandError(static_cast<robot::ExitCode>(error.exit_code()), error.what(), true);
  }
}

}  // namespace

robot::ExitCode calibrate_deed(const CalibrateOptions& options, Context& context) {
  CalibrationSettings settings;
  settings.band = band_from(options.band);
  settings.phase_sign = options.phase == "rises" ? 1.0 : -1.0;
  settings.starts = options.starts;
  settings.resamples = options.resamples;
  settings.seed = options.seed;
  const CalibrationInput input = input_of(options);
  std::optional<Calibration> result;
  try {
    result = calibrate(input, settings, [] { return !robot::pending_interruption(); });
  } catch (const robot::LoadError& error) {
    throw CommandError(static_cast<robot::ExitCode>(error.exit_code()), error.what(), true);
  }
  if (!result) {
    return robot::pending_interruption().value_or(robot::ExitCode::kInterrupted);
  }
  if (options.out) {
    write_file(*options.out, to_profile(*result), options.force);
  }
  if (options.chart) {
    write_picture(*options.chart, drawn_or_throw(draw_calibration(*result)),
                  fmt::format("seed {}", settings.seed), options.force);
  }
  context.out << (context.json ? to_json(*result) : to_table(*result));
  return robot::ExitCode::kDone;
}

}  // namespace sensotwin::twin
