// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "render/phase_views.hpp"
#include "render/views.hpp"
#include "twin/scene/scene.hpp"
#include "world/tag_field.hpp"

namespace sensotwin::twin {

/// What of a scene never changes, as a picture wants it: walls, furniture where `X_WF` says (one pose a
/// piece; empty: where the scene puts it), tags, landmarks, home base, start, and every carpet tile as not
/// visited yet.
[[nodiscard]] render::SceneView view_of(const Scene& scene, std::span<const world::Tag> tags,
                                        std::span<const world::Pose2> X_WF);

/// What of a scene a run along tags is drawn on: walls, furniture where `X_WF` says, people, start.
[[nodiscard]] render::PhaseRunView plan_of(const Scene& scene, std::span<const world::Pose2> X_WF);

/// Middle of a carpet tile in W.
[[nodiscard]] world::Vec2 tile_centre_m(const world::Carpet& carpet, int column, int row);

}  // namespace sensotwin::twin
