// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/config/problem.hpp"

/// YAML as written: every key and value with its place, duplicate keys kept, nothing converted. Stands
/// between us and yaml-cpp's nodes, which lose duplicates, read 010 as 8 and .nan as a number, and have no
/// place for keys.
namespace sensotwin::robot {

enum class YamlKind { kNothing, kFlag, kNumber, kText, kList, kSection };

struct YamlEntry;

struct YamlNode {
  YamlKind kind{YamlKind::kNothing};
  Place place;
  std::string text;                ///< of a scalar, unquoted
  bool quoted{false};              ///< scalar in quotes: always text
  std::vector<YamlNode> items;     ///< of a list
  std::vector<YamlEntry> entries;  ///< of a section, in the order of the file, duplicates included

  /// First entry of that name, or null. Valid until `entries` changes.
  [[nodiscard]] const YamlEntry* find(const std::string& key) const;
  /// "a number", "the text 'abc'" ...: for messages.
  [[nodiscard]] std::string describe() const;
};

struct YamlEntry {
  std::string key;
  Place key_place;
  YamlNode value;
};

/// Parses one document. Kinds: true and false are flags; what the JSON grammar calls a number is a number; an
/// empty value, ~ and null are nothing; everything else, 010, .nan, on and 0x1F included, is text. Anchors,
/// aliases, merge keys, tags and a second document are problems. \param source   name for the places \param
/// problems what is wrong is appended here \returns the root; kNothing when the text is empty or cannot be
/// parsed
[[nodiscard]] YamlNode parse_yaml(const std::string& text, const std::string& source,
                                  std::vector<Problem>& problems);

/// Gives every node below the same place: for text that came by an option.
void set_place(YamlNode& node, const Place& place);

/// What JSON calls a number: -0.5, 12, 1e-3; not .5, 1., +1, 010.
[[nodiscard]] bool is_json_number(const std::string& text);

}  // namespace sensotwin::robot
