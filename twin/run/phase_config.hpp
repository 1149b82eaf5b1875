// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "robot/base/random.hpp"
#include "robot/program/phase_program.hpp"
#include "robot/settings/robot_settings.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// Indices into the ceiling tags, in the order in which the mission goes to them. \pre scene.mission.phase
[[nodiscard]] std::vector<std::size_t> destinations_of(const Scene& scene);

/// The radio with what the run's seed decides: a hop table of the reader's own, slots for its antennas.
/// \pre scene.world.radio
[[nodiscard]] world::RadioWorld radio_of(const Scene& scene, const robot::RandomStream& random);

/// What the robot knows of the scene, reader and tags included. What a calibration tells of the reader (sign,
/// delays, noise laws) the robot knows; what is a fault (noise_scale) or of the place (where tags are,
/// shadows) it does not.
/// \param radio  from radio_of()
[[nodiscard]] robot::RobotSettings robot_settings_of(const Scene& scene, const world::RadioWorld& radio);

/// What our own controller is told, whichever controller the mission has. \param radio  from radio_of()
[[nodiscard]] robot::CeilingMissionConfig ceiling_config_of(const Scene& scene,
                                                            const world::RadioWorld& radio);

/// The program's configuration as the scene's robot and mission sections say it.
/// \param radio  from radio_of()
[[nodiscard]] robot::PhaseProgramConfig phase_config_of(const Scene& scene, const world::RadioWorld& radio);

}  // namespace sensotwin::twin
