// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "twin/calibrate/calibration.hpp"

namespace sensotwin::twin {

/// Logs of a real R420 (data study, 2: RFID-Locate). They state no licence, so they are not part of the
/// repository.
inline std::filesystem::path real_logs() {
  return std::filesystem::path{SENSOTWIN_SOURCE_DIR} / "../shared/data/rfid";
}

/// CSV logs of a folder, by name.
inline std::vector<TagLog> logs_of(const std::string& set) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(real_logs() / "rfid_locate" / set)) {
    if (entry.path().extension() == ".csv") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<TagLog> logs;
  for (const auto& file : files) {
    logs.push_back(read_sllurp_log(file));
  }
  return logs;
}

inline CalibrationInput input_of(const std::vector<std::string>& sets) {
  CalibrationInput input;
  for (const std::string& set : sets) {
    for (TagLog& log : logs_of(set)) {
      input.logs.push_back(std::move(log));
    }
  }
  input.distance_m.resize(input.logs.size());
  return input;
}

}  // namespace sensotwin::twin
