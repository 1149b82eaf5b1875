// SPDX-License-Identifier: MIT
#pragma once

#include "robot/config/field_visitor.hpp"

/// The machine's, under the twin's name.
namespace sensotwin::twin {

using robot::Cells;
using robot::Count;
using robot::Field;
using robot::FieldVisitor;
using robot::kFarthestTile;
using robot::kNamePattern;
using robot::Range;

}  // namespace sensotwin::twin
