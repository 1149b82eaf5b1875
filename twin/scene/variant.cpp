// SPDX-License-Identifier: MIT
#include "twin/scene/variant.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "robot/config/nearest_name.hpp"
#include "twin/scene/override.hpp"

namespace sensotwin::twin {
namespace {

/// The key of a variant that names another one.
constexpr const char* kFrom = "from";
constexpr const char* kExpected = "expected paths with values, such as mission.phase.controller: own";

void put(robot::YamlNode& root, robot::YamlEntry change, const std::string& path,
         std::vector<robot::Problem>& problems) {
  if (!assign(root, change.key, std::move(change.value), change.key_place, problems)) {
    problems.push_back({change.key_place, path, fmt::format("'{}' is no path", change.key), kExpected});
  }
}

/// What each variant must be, whether it is chosen or not.
void check_shape(const robot::YamlEntry& variant, const std::string& path,
                 std::vector<robot::Problem>& problems) {
  if (variant.value.kind != robot::YamlKind::kSection) {
    problems.push_back({variant.value.place, path, "is " + variant.value.describe(), kExpected});
    return;
  }
  const std::vector<robot::YamlEntry>& changes = variant.value.entries;
  for (auto change = changes.begin(); change != changes.end(); ++change) {
    const bool before = std::any_of(changes.begin(), change,
                                    [&](const robot::YamlEntry& other) { return other.key == change->key; });
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

/// Does what the variant at `index` says, after what the one says that it goes on from.
void apply(robot::YamlNode& root, const std::vector<robot::YamlEntry>& variants, std::size_t index,
           std::vector<robot::Problem>& problems) {
  const std::string path = "variants." + variants[index].key;
  for (const robot::YamlEntry& change : variants[index].value.entries) {
    if (change.key != kFrom) {
      continue;
    }
    // Only one above, so that none goes on from itself.
    const auto end = variants.begin() + static_cast<std::ptrdiff_t>(index);
    const auto base = std::find_if(variants.begin(), end, [&](const robot::YamlEntry& other) {
      return change.value.kind == robot::YamlKind::kText && other.key == change.value.text;
    });
    if (base == end) {
      problems.push_back({change.value.place, path + ".from", "is " + change.value.describe(),
                          "expected the name of a variant above this one"});
      continue;
    }
    apply(root, variants, static_cast<std::size_t>(base - variants.begin()), problems);
  }
  for (const robot::YamlEntry& change : variants[index].value.entries) {
    if (change.key != kFrom) {
      put(root, change, path, problems);
    }
  }
}

}  // namespace

std::vector<std::string> take_variant(robot::YamlNode& root, const std::string& chosen,
                                      std::vector<robot::Problem>& problems) {
  std::vector<std::string> names;
  const auto section = std::find_if(root.entries.begin(), root.entries.end(),
                                    [](const robot::YamlEntry& entry) { return entry.key == "variants"; });
  std::vector<robot::YamlEntry> variants;
  if (section != root.entries.end()) {
    if (section->value.kind != robot::YamlKind::kSection) {
      problems.push_back({section->value.place, "variants", "is " + section->value.describe(),
                          "expected a section for each variant, by its name"});
    }
    variants = std::move(section->value.entries);
    root.entries.erase(section);
  }
  bool found = chosen.empty();
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const robot::YamlEntry& variant = variants[i];
    const std::string path = "variants." + variant.key;
    if (std::find(names.begin(), names.end(), variant.key) != names.end()) {
      problems.push_back({variant.key_place, path, "is there twice", "expected a name of its own"});
      continue;
    }
    names.push_back(variant.key);
    check_shape(variant, path, problems);
    if (variant.key == chosen) {
      found = true;
      apply(root, variants, i, problems);
    }
  }
  if (!found) {
    problems.push_back({{"--variant " + chosen, 0, 0},
                        "",
                        "the scene has no such variant" + robot::did_you_mean(chosen, names),
                        names.empty() ? "it has none" : fmt::format("it has {}", fmt::join(names, ", "))});
  }
  return names;
}

}  // namespace sensotwin::twin
