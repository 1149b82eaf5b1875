// SPDX-License-Identifier: MIT
#include "twin/scene/scene_writer.hpp"

#include "robot/config/field_writer.hpp"
#include "twin/scene/fields.hpp"

namespace sensotwin::twin {

std::string scene_yaml(const Scene& scene, const std::filesystem::path& folder) {
  Scene shown = scene;
  const auto spell = [&](std::string& file) {
    if (!folder.empty() && !file.empty()) {
      const std::filesystem::path there = std::filesystem::path(scene.file).parent_path() / file;
      file = std::filesystem::proximate(there, folder).string();
    }
  };
  if (shown.layout.map) {
    spell(shown.layout.map->file);
    spell(shown.layout.map->hallways);
  }
  if (shown.layout.hallways) {
    spell(shown.layout.hallways->file);
  }
  spell(shown.known_file);
  robot::FieldWriter writer;
  visit_fields(writer, shown);
  return writer.text();
}

}  // namespace sensotwin::twin
