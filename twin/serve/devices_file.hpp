// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sensotwin::twin {

/// Where a client finds the four wires: the content of devices.yaml, which `sensobot` takes as it is.
struct Devices {
  std::filesystem::path base;               ///< terminal of the Open Interface
  std::filesystem::path sensors;            ///< terminal of the sensor board
  std::optional<std::string> llrp{};        ///< host:port; none: no UHF reader in this scene
  std::vector<std::string> card_readers{};  ///< PC/SC names: floor, forward; none: no virtual reader here

  bool operator==(const Devices&) const = default;
};

/// \param scene  as the first line names it
[[nodiscard]] std::string to_yaml(const Devices& devices, const std::string& scene);

}  // namespace sensotwin::twin
