// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/robot/output/temporary_folder.hpp"
#include "twin/scene/map_import.hpp"

namespace sensotwin::twin {

inline void save(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// A PGM drawn in letters, top row first: '#' wall, '.' free, '?' unknown.
inline std::string drawn(const std::vector<std::string>& rows) {
  std::string pgm = "P5\n# drawn by a test\n" + std::to_string(rows.front().size()) + " " +
                    std::to_string(rows.size()) + "\n255\n";
  for (const std::string& row : rows) {
    for (const char c : row) {
      pgm += static_cast<char>(c == '#' ? 0 : c == '.' ? 254 : 205);
    }
  }
  return pgm;
}

inline const std::string kMapYaml =
    "image: map.pgm\nresolution: 0.5\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: "
    "0.65\nfree_thresh: 0.196\n";

/// The map of a drawing, with `map_yaml` beside it.
inline OccupancyMap drawn_map(const std::vector<std::string>& rows, const std::string& map_yaml = kMapYaml) {
  const TemporaryFolder folder;
  save(folder / "map.pgm", drawn(rows));
  save(folder / "map.yaml", map_yaml);
  return read_map(folder / "map.yaml");
}

}  // namespace sensotwin::twin
