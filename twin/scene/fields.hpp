// SPDX-License-Identifier: MIT
#pragma once

#include "robot/config/field_visitor.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// The fields of a scene file, in order. \param v what to do with each of them.
void visit_fields(robot::FieldVisitor& v, Scene& scene);

}  // namespace sensotwin::twin
