// SPDX-License-Identifier: MIT
#include "twin/scene/variant.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "twin/scene/nearest_name.hpp"
#include "twin/scene/override.hpp"

namespace sensotwin::twin {
namespace {

constexpr const char* kExpected = "expected paths with values, such as mission.phase.controller: own";

void put(YamlNode& root, YamlEntry change, const std::string& path, std::vector<Problem>& problems) {
  if (!assign(root, change.key, std::move(change.value), change.key_place, problems)) {
    problems.push_back({change.key_place, path, fmt::format("'{}' is no path", change.key), kExpected});
  }
}

/// What each variant must be, whether it is chosen or not.
void check_shape(const YamlEntry& variant, const std::string& path, std::vector<Problem>& problems) {
  if (variant.value.kind != YamlKind::kSection) {
    problems.push_back({variant.value.place, path, "is " + variant.value.describe(), kExpected});
    return;
  }
  const std::vector<YamlEntry>& changes = variant.value.entries;
  for (auto change = changes.begin(); change != changes.end(); ++change) {
    const bool before = std::any_of(changes.begin(), change,
                                    [&](const YamlEntry& other) { return other.key == change->key; });
    if (before) {
      problems.push_back(
          {change->key_place, path, fmt::format("'{}' is there twice", change->key), kExpected});
    }
    if (change->key == "seed" || change->key == "version" || change->key == "variants") {
      problems.push_back({change->key_place, path, fmt::format("changes '{}'", change->key),
                          "a variant changes what the scene holds, not what it is"});
    }
  }
}

}  // namespace

std::vector<std::string> take_variant(YamlNode& root, const std::string& chosen,
                                      std::vector<Problem>& problems) {
  std::vector<std::string> names;
  const auto section = std::find_if(root.entries.begin(), root.entries.end(),
                                    [](const YamlEntry& entry) { return entry.key == "variants"; });
  std::vector<YamlEntry> variants;
  if (section != root.entries.end()) {
    if (section->value.kind != YamlKind::kSection) {
      problems.push_back({section->value.place, "variants", "is " + section->value.describe(),
                          "expected a section for each variant, by its name"});
    }
    variants = std::move(section->value.entries);
    root.entries.erase(section);
  }
  bool found = chosen.empty();
  for (YamlEntry& variant : variants) {
    const std::string path = "variants." + variant.key;
    if (std::find(names.begin(), names.end(), variant.key) != names.end()) {
      problems.push_back({variant.key_place, path, "is there twice", "expected a name of its own"});
      continue;
    }
    names.push_back(variant.key);
    check_shape(variant, path, problems);
    if (variant.key == chosen) {
      found = true;
      for (YamlEntry& change : variant.value.entries) {
        put(root, std::move(change), path, problems);
      }
    }
  }
  if (!found) {
    problems.push_back({{"--variant " + chosen, 0, 0},
                        "",
                        "the scene has no such variant" + did_you_mean(chosen, names),
                        names.empty() ? "it has none" : fmt::format("it has {}", fmt::join(names, ", "))});
  }
  return names;
}

}  // namespace sensotwin::twin
