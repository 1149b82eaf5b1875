// SPDX-License-Identifier: MIT
#pragma once

#include "robot/config/field_visitor.hpp"
#include "twin/scene/scene.hpp"

/// The part of the field list that speaks of ceiling tags, the radio between them and the robot, and missions
/// along them.
namespace sensotwin::twin {

/// In `world`: ceiling_tags, radio, floor_tag_radius_m.
void radio_world_fields(robot::FieldVisitor& v, world::WorldDescription& world);
/// In `robot`: uhf_reader.
void uhf_reader_fields(robot::FieldVisitor& v, world::WorldDescription& world);

/// What a scene leaves to the twin: codes of tags, antennas. Nothing when there is no radio.
void complete_radio(Scene& scene);

}  // namespace sensotwin::twin
