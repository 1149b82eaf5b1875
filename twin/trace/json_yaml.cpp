// SPDX-License-Identifier: MIT
#include "twin/trace/json_yaml.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace sensotwin::twin {
namespace {

// Chosen: below the 120 columns of the project's own YAML, with room for the key.
constexpr std::size_t kLineWidth = 100;

std::string key_text(const std::string& key) {
  const bool plain =
      !key.empty() && std::isalpha(static_cast<unsigned char>(key.front())) != 0 &&
      std::all_of(key.begin(), key.end(),
                  [](unsigned char c) { return (c < 0x80 && std::isalnum(c) != 0) || c == '_'; }) &&
      key != "true" && key != "false" && key != "null";
  return plain ? key : Json(key).dump();
}

/// Whether a value can stand in a line: scalars, lists of them, sections of both.
bool flat(const Json& value, int depth) {
  if (!value.is_structured()) {
    return true;
  }
  return depth > 0 &&
         std::all_of(value.begin(), value.end(), [&](const Json& item) { return flat(item, depth - 1); });
}

std::string flow(const Json& value, std::size_t indent) {
  if (!value.is_structured()) {
    return value.dump();
  }
  const bool section = value.is_object();
  std::string text(1, section ? '{' : '[');
  std::size_t line_from = 0;
  bool first = true;
  for (const auto& [key, item] : value.items()) {
    std::string part = (section ? key_text(key) + ": " : "") + flow(item, indent);
    text += first ? (section ? " " : "") : ",";
    if (!first && text.size() - line_from + part.size() > kLineWidth - std::min(indent, kLineWidth / 2)) {
      text += "\n" + std::string(indent + 2, ' ');
      line_from = text.size();
    } else if (!first) {
      text += " ";
    }
    text += part;
    first = false;
  }
  return text + (section ? (first ? "}" : " }") : "]");
}

void block(const Json& section, std::size_t indent, std::string& text);

void entry(const Json& value, std::size_t indent, std::string& text) {
  // A section of the second level and deeper may stand in a line; a list of sections gets a line for each.
  const bool short_section = value.is_object() && indent > 0 && flat(value, 3);
  if (value.is_object() && !value.empty() && !short_section) {
    text += "\n";
    block(value, indent + 2, text);
  } else if (value.is_array() &&
             std::any_of(value.begin(), value.end(), [](const Json& item) { return item.is_object(); })) {
    text += "\n";
    for (const Json& item : value) {
      text += std::string(indent + 2, ' ') + "- " + flow(item, indent + 4) + "\n";
    }
  } else {
    text += " " + flow(value, indent + 2) + "\n";
  }
}

void block(const Json& section, std::size_t indent, std::string& text) {
  for (const auto& [key, value] : section.items()) {
    text += std::string(indent, ' ') + key_text(key) + ":";
    entry(value, indent, text);
  }
}

}  // namespace

std::string yaml_of(const Json& section) {
  std::string text;
  block(section, 0, text);
  return text;
}

Json json_of(const robot::YamlNode& node) {
  switch (node.kind) {
    case robot::YamlKind::kNothing:
      break;
    case robot::YamlKind::kFlag:
      return node.text == "true";
    case robot::YamlKind::kNumber:
      return Json::parse(node.text, nullptr, false);
    case robot::YamlKind::kText:
      return node.text;
    case robot::YamlKind::kList: {
      Json list = Json::array();
      for (const robot::YamlNode& item : node.items) {
        list.push_back(json_of(item));
      }
      return list;
    }
    case robot::YamlKind::kSection: {
      Json section = Json::object();
      for (const robot::YamlEntry& each : node.entries) {
        section[each.key] = json_of(each.value);
      }
      return section;
    }
  }
  return nullptr;
}

}  // namespace sensotwin::twin
