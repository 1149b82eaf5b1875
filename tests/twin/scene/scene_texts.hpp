// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "robot/config/problem.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {

/// A scene without mistakes; the tests break it.
inline const std::string kSoundScene = R"(# A room with a table.
version: 1
seed: 7
world:
  room: { walls_m: [[0, 0], [4, 0], [4, 3], [0, 3]] }
  carpet: { tile_m: 0.5 }
  furniture:
    - { name: table, at_m: [2, 2], size_m: [1, 0.5] }
robot:
  start: { at_m: [1, 1], heading_deg: 0 }
mission:
  map: { explorer: idfm }
expect:
  tiles_mapped: { min: 1 }
)";

/// `text` with the first `find` replaced.
inline std::string edited(std::string text, const std::string& find, const std::string& replace) {
  const std::size_t at = text.find(find);
  if (at == std::string::npos) {
    throw std::logic_error("the scene to edit has no '" + find + "'");
  }
  return text.replace(at, find.size(), replace);
}

/// The messages that reading `text` as s.yaml ends in, one per line; "no error" when it reads.
inline std::string messages(const std::string& text, const SceneOverrides& overrides = {}) {
  try {
    (void)read_scene_text(text, "s.yaml", overrides);
    return "no error";
  } catch (const robot::LoadError& error) {
    return error.what();
  }
}

}  // namespace sensotwin::twin
