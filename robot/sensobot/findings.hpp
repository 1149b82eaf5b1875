// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sensotwin::robot {

/// What a device was found to be.
struct Finding {
  std::string device;   ///< "the Roomba"
  std::string address;  ///< as the file has it
  bool ok{false};
  std::string trouble{};  ///< why it is not ok, for people
  std::string remedy{};   ///< what to try then
  /// Name and value, in the order in which they are shown; names end in their unit.
  std::vector<std::pair<std::string, std::string>> facts{};
};

/// Lines for people: each device, then what was found of it.
[[nodiscard]] std::string findings_text(const std::vector<Finding>& findings);
/// {"ok": ..., "devices": [...]}
[[nodiscard]] std::string findings_json(const std::vector<Finding>& findings);

}  // namespace sensotwin::robot
