// SPDX-License-Identifier: MIT
#pragma once

#include "render/phase_views.hpp"

namespace sensotwin::render::testing {

/// The paper's paths and two of ours, driven by a point that turns toward the next tag as fast as it may: not
/// a controller of anybody's, but curves of the same kind.
[[nodiscard]] PhaseRunView made_up_line();
/// Pentagram of 3 m radius from (0, 3), heading 270 degrees.
[[nodiscard]] PhaseRunView made_up_star();
[[nodiscard]] PhaseRunView made_up_hallway();
/// Circle of 2 m radius by 8 tags, two laps.
[[nodiscard]] PhaseRunView made_up_circle();
/// 40 tags in a hall of 40 by 24 m.
[[nodiscard]] PhaseRunView made_up_hall();

[[nodiscard]] NoiseView made_up_noise();
/// Three triangles and ramps as in the algorithms study, A.0, with their control curve.
[[nodiscard]] FuzzyControllerView made_up_controller();
/// The run up to a time in space: tags under the ceiling, antennas on the robot that hear tag `target`.
[[nodiscard]] SceneView made_up_ceiling(const PhaseRunView& run, double until_s, std::size_t target);
/// The hallway at 96 s.
[[nodiscard]] SceneView made_up_ceiling();

}  // namespace sensotwin::render::testing
