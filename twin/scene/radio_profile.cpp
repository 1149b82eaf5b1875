// SPDX-License-Identifier: MIT
#include "twin/scene/radio_profile.hpp"

#include <algorithm>

#include "twin/scene/text_file.hpp"

namespace sensotwin::twin {
namespace {

YamlNode* find(YamlNode* node, const std::string& key) {
  if (node == nullptr) {
    return nullptr;
  }
  const auto found = std::find_if(node->entries.begin(), node->entries.end(),
                                  [&](const YamlEntry& entry) { return entry.key == key; });
  return found == node->entries.end() ? nullptr : &found->value;
}

}  // namespace

void take_radio_profile(YamlNode& scene, const std::filesystem::path& folder, std::vector<Problem>& problems,
                        int& exit_code) {
  YamlNode* const radio = find(find(&scene, "world"), "radio");
  const YamlNode* const named = find(radio, "file");
  if (named == nullptr || named->kind != YamlKind::kText) {
    return;  // a wrong type is told by the field itself
  }
  const Place place = named->place;
  const std::filesystem::path file = folder / named->text;
  try {
    YamlNode profile = parse_yaml(read_text_file(file, "radio profile"), file.string(), problems);
    YamlNode* const section = find(&profile, "radio");
    if (section == nullptr || section->kind != YamlKind::kSection) {
      problems.push_back({place, "world.radio.file", file.string() + " has no section radio",
                          "expected what twin calibrate --out writes"});
      return;
    }
    for (YamlEntry& entry : section->entries) {
      if (entry.key != "file" && radio->find(entry.key) == nullptr) {
        radio->entries.push_back(std::move(entry));
      }
    }
  } catch (const SceneError& error) {
    exit_code = error.exit_code();
    for (const Problem& problem : error.problems()) {
      problems.push_back(
          {place, "world.radio.file", problem.place.source + ": " + problem.what, problem.hint});
    }
  }
}

}  // namespace sensotwin::twin
