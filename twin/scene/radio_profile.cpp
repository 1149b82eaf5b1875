// SPDX-License-Identifier: MIT
#include "twin/scene/radio_profile.hpp"

#include <algorithm>

#include "robot/config/text_file.hpp"

namespace sensotwin::twin {
namespace {

robot::YamlNode* find(robot::YamlNode* node, const std::string& key) {
  if (node == nullptr) {
    return nullptr;
  }
  const auto found = std::find_if(node->entries.begin(), node->entries.end(),
                                  [&](const robot::YamlEntry& entry) { return entry.key == key; });
  return found == node->entries.end() ? nullptr : &found->value;
}

}  // namespace

void take_radio_profile(robot::YamlNode& scene, const std::filesystem::path& folder,
                        std::vector<robot::Problem>& problems, int& exit_code) {
  robot::YamlNode* const radio = find(find(&scene, "world"), "radio");
  const robot::YamlNode* const named = find(radio, "file");
  if (named == nullptr || named->kind != robot::YamlKind::kText) {
    return;  // a wrong type is told by the field itself
  }
  const robot::Place place = named->place;
  const std::filesystem::path file = folder / named->text;
  try {
    robot::YamlNode profile =
        robot::parse_yaml(robot::read_text_file(file, "radio profile"), file.string(), problems);
    robot::YamlNode* const section = find(&profile, "radio");
    if (section == nullptr || section->kind != robot::YamlKind::kSection) {
      problems.push_back({place, "world.radio.file", file.string() + " has no section radio",
                          "expected what twin calibrate --out writes"});
      return;
    }
    for (robot::YamlEntry& entry : section->entries) {
      if (entry.key != "file" && radio->find(entry.key) == nullptr) {
        radio->entries.push_back(std::move(entry));
      }
    }
  } catch (const robot::LoadError& error) {
    exit_code = error.exit_code();
    for (const robot::Problem& problem : error.problems()) {
      problems.push_back(
          {place, "world.radio.file", problem.place.source + ": " + problem.what, problem.hint});
    }
  }
}

}  // namespace sensotwin::twin
