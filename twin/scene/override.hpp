// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "robot/config/problem.hpp"
#include "robot/config/yaml_tree.hpp"

namespace sensotwin::twin {

/// Puts `value` where "key.path[index].key" says; sections on the way that are not there are made. \returns
/// false when `path` is not of that form; other mistakes are appended to `problems` with the place
[[nodiscard]] bool assign(robot::YamlNode& root, const std::string& path, robot::YamlNode value,
                          const robot::Place& place, std::vector<robot::Problem>& problems);

/// Puts the value of "key.path[index]=value" into the tree, so that it is read and checked like the file
/// itself. \returns false when the text is not of that form; other mistakes are appended to `problems` with
/// the place
///          "--set key.path=value"
[[nodiscard]] bool apply_override(robot::YamlNode& root, const std::string& assignment,
                                  std::vector<robot::Problem>& problems);

}  // namespace sensotwin::twin
