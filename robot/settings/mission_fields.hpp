// SPDX-License-Identifier: MIT
#pragma once

#include "robot/config/field_visitor.hpp"
#include "robot/settings/mission.hpp"

namespace sensotwin::robot {

/// What stands in the section `mission:`.
void mission_fields(FieldVisitor& v, Mission& mission);

}  // namespace sensotwin::robot
