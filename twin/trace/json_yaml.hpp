// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "robot/config/yaml_tree.hpp"

/// Between what the page says (JSON) and what our readers read (YAML).
namespace sensotwin::twin {

/// Keys keep the order in which they were written.
using Json = nlohmann::ordered_json;

/// Chosen: a place's tag lies five deep in a tracing.
inline constexpr int kJsonDepthMax = 16;

/// The value as YAML that parse_yaml() reads back to the same: sections as blocks, lists of numbers and small
/// sections in one line, lines of about 100 columns. \pre nested no deeper than kJsonDepthMax
[[nodiscard]] std::string yaml_of(const Json& section);

/// Numbers become numbers, quoted text stays text, an empty value becomes null; of a key that is there twice,
/// the last.
[[nodiscard]] Json json_of(const robot::YamlNode& node);

}  // namespace sensotwin::twin
