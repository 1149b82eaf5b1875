// SPDX-License-Identifier: MIT
#pragma once

#include "robot/config/yaml_tree.hpp"
#include "twin/scene/problem.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::is_json_number;
using robot::parse_yaml;
using robot::set_place;
using robot::YamlEntry;
using robot::YamlKind;
using robot::YamlNode;

}  // namespace sensotwin::twin
