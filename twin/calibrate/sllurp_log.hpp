// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sensotwin::twin {

/// One row of a reader's log.
struct LogRow {
  double time_s{0.0};  ///< from any fixed instant: only differences are used
  int antenna{1};      ///< port, from 1
  int channel{1};      ///< ChannelIndex: position in the reader's hop table, from 1 (data study, 3.1)
  int epc{0};          ///< in TagLog::epcs
  double phase_rad{0.0};
  double rssi_dbm{0.0};
  double doppler_hz{0.0};
};

/// A log of the LLRP client sllurp, in the order of the file.
struct TagLog {
  std::string name;  ///< file name without folder
  std::vector<std::string> epcs;
  std::vector<LogRow> rows;
};

/// Reads CSV with the columns timestamp, antenna, rssi, epc, phase_angle, channel_index, doppler_frequency,
/// and perhaps reader, in any order (twin/output/tag_log.hpp has their units). Time is a number of seconds,
/// or ISO 8601 without zone, as sllurp's older logs have it; an EPC is hexadecimal, bare or as Python bytes.
/// \throws SceneError  kExitMissing; kExitInvalid with file, line and column of each mistake
[[nodiscard]] TagLog read_sllurp_log(const std::filesystem::path& file);
/// The same of text already in hand. \param file for messages and the log's name
[[nodiscard]] TagLog parse_sllurp_log(std::string_view text, const std::filesystem::path& file);

/// Number of each line's `value` by its `key`, from a CSV with exactly these two columns.
/// \throws SceneError as above; also for keys that come twice
struct KeyedNumber {
  std::string key;
  double value{0.0};
};
[[nodiscard]] std::vector<KeyedNumber> read_keyed_numbers(const std::filesystem::path& file,
                                                          std::string_view key, std::string_view value);

}  // namespace sensotwin::twin
