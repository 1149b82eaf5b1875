// SPDX-License-Identifier: MIT
#include "robot/sensobot/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace sensotwin::robot {

std::string findings_text(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += fmt::format("{} {} ({})\n", finding.ok ? "ok    " : "FAILED", finding.device, finding.address);
    for (const auto& [name, value] : finding.facts) {
      text += fmt::format("         {:<24} {}\n", name, value);
    }
    if (!finding.ok) {
      text += fmt::format("         {}\n         {}\n", finding.trouble, finding.remedy);
    }
  }
  return text;
}

std::string findings_json(const std::vector<Finding>& findings) {
  nlohmann::ordered_json devices = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    nlohmann::ordered_json device{
        {"device", finding.device}, {"address", finding.address}, {"ok", finding.ok}};
    if (!finding.ok) {
      device["trouble"] = finding.trouble;
      device["remedy"] = finding.remedy;
    }
    for (const auto& [name, value] : finding.facts) {
      device["found"][name] = value;
    }
    devices.push_back(std::move(device));
  }
  const bool ok = std::all_of(findings.begin(), findings.end(), [](const Finding& f) { return f.ok; });
  return nlohmann::ordered_json{{"ok", ok}, {"devices", std::move(devices)}}.dump(2) + "\n";
}

}  // namespace sensotwin::robot
