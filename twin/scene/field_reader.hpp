// SPDX-License-Identifier: MIT
#pragma once

#include "robot/config/field_reader.hpp"
#include "twin/scene/field_visitor.hpp"
#include "twin/scene/problem.hpp"
#include "twin/scene/yaml_tree.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::FieldReader;

}  // namespace sensotwin::twin
