// SPDX-License-Identifier: MIT
#include "twin/scene/scene_writer.hpp"

#include "robot/config/field_writer.hpp"
#include "twin/scene/fields.hpp"

namespace sensotwin::twin {

std::string scene_yaml(const Scene& scene, const std::filesystem::path& folder) {
  Scene shown = scene;
  if (shown.layout.map && !folder.empty()) {
    const std::filesystem::path map =
        std::filesystem::path(scene.file).parent_path() / scene.layout.map->file;
    shown.layout.map->file = std::filesystem::proximate(map, folder).string();
  }
  robot::FieldWriter writer;
  visit_fields(writer, shown);
  return writer.text();
}

}  // namespace sensotwin::twin
