// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "twin/serve/handle.hpp"

namespace sensotwin::twin {

/// The folder of a served scene. One server at a time has it; the next takes it over without being asked
/// twice, so that clients find their terminals under the same names day after day.
class ServeFolder {
 public:
  /// Makes it where missing, and removes an earlier server's devices.yaml.
  /// \throws OutputError kCannotCreate: no such place, or another server has it
  explicit ServeFolder(std::filesystem::path directory);
  /// Removes devices.yaml, whose wires are gone.
  ~ServeFolder();
  ServeFolder(const ServeFolder&) = delete;
  ServeFolder& operator=(const ServeFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return directory_; }

 private:
  std::filesystem::path directory_;
  Handle lock_;
};

/// Where a server puts its files when nobody said where: runs/serve-<scene>, below the working directory.
[[nodiscard]] std::filesystem::path default_serve_folder(const std::filesystem::path& scene_file);

}  // namespace sensotwin::twin
