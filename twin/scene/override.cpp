// SPDX-License-Identifier: MIT
#include "twin/scene/override.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <optional>
#include <utility>

namespace sensotwin::twin {
namespace {

/// One step of a path: a key, then perhaps places in lists.
struct Step {
  std::string key;
  std::vector<std::size_t> indices;
};

std::optional<Step> parse_step(const std::string& text) {
  Step step;
  std::size_t at = text.find('[');
  step.key = text.substr(0, at);
  while (at != std::string::npos && at < text.size()) {
    const std::size_t close = text.find(']', at);
    if (text[at] != '[' || close == std::string::npos) {
      return std::nullopt;
    }
    std::size_t index = 0;
    const char* last = text.data() + close;
    const auto [end, error] = std::from_chars(text.data() + at + 1, last, index);
    if (error != std::errc{} || end != last) {
      return std::nullopt;
    }
    step.indices.push_back(index);
    at = close + 1;
  }
  return step.key.empty() ? std::nullopt : std::optional<Step>{step};
}

std::vector<Step> parse_path(const std::string& path) {
  std::vector<Step> steps;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t dot = path.find('.', from);
    const std::optional<Step> step =
        parse_step(path.substr(from, dot == std::string::npos ? dot : dot - from));
    if (!step) {
      return {};
    }
    steps.push_back(*step);
    if (dot == std::string::npos) {
      break;
    }
    from = dot + 1;
  }
  return steps;
}

robot::YamlNode& child(robot::YamlNode& section, const std::string& key, const robot::Place& place) {
  for (robot::YamlEntry& entry : section.entries) {
    if (entry.key == key) {
      return entry.value;
    }
  }
  section.entries.push_back({key, place, {robot::YamlKind::kNothing, place, "", false, {}, {}}});
  return section.entries.back().value;
}

}  // namespace

bool assign(robot::YamlNode& root, const std::string& path, robot::YamlNode value, const robot::Place& place,
            std::vector<robot::Problem>& problems) {
  const std::vector<Step> steps = parse_path(path);
  if (steps.empty()) {
    return false;
  }
  robot::YamlNode* node = &root;
  std::string so_far;
  for (const Step& step : steps) {
    if (node->kind == robot::YamlKind::kNothing) {
      *node = {robot::YamlKind::kSection, place, "", false, {}, {}};
    }
    if (node->kind != robot::YamlKind::kSection) {
      problems.push_back({place, so_far, fmt::format("is {} in the file", node->describe()),
                          fmt::format("only a section has a key '{}'", step.key)});
      return true;
    }
    so_far += (so_far.empty() ? "" : ".") + step.key;
    node = &child(*node, step.key, place);
    for (const std::size_t index : step.indices) {
      if (node->kind != robot::YamlKind::kList || index >= node->items.size()) {
        problems.push_back({place, so_far, fmt::format("has no item {}", index),
                            node->kind == robot::YamlKind::kList
                                ? fmt::format("it has {}, counted from 0", node->items.size())
                                : "it is no list"});
        return true;
      }
      node = &node->items[index];
      so_far += fmt::format("[{}]", index);
    }
  }
  *node = std::move(value);
  return true;
}

bool apply_override(robot::YamlNode& root, const std::string& assignment,
                    std::vector<robot::Problem>& problems) {
  const robot::Place place{"--set " + assignment, 0, 0};
  const std::size_t equals = assignment.find('=');
  if (equals != std::string::npos) {
    robot::YamlNode value = robot::parse_yaml(assignment.substr(equals + 1), place.source, problems);
    robot::set_place(value, place);
    if (assign(root, assignment.substr(0, equals), std::move(value), place, problems)) {
      return true;
    }
  }
  problems.push_back(
      {place, "", "is no assignment", "expected key.path=value, such as mission.map.explorer=dfm"});
  return false;
}

}  // namespace sensotwin::twin
