// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "render/offscreen_context.hpp"
#include "render/scene_picture.hpp"
#include "robot/output/run_folder.hpp"
#include "twin/output/summary.hpp"
#include "twin/run/map_verdict.hpp"
#include "twin/run/mapping_twin.hpp"
#include "twin/run/run_recorder.hpp"

namespace sensotwin::twin {

/// Draws what a run came to into its folder.
/// \param may_go_on  asked between pictures  \returns false when it said no: those drawn so far stay
/// \throws OutputError; a missing renderer is one, with its remedy
[[nodiscard]] bool draw_run(const Scene& scene, const MappingTwin& twin, const RunRecorder& recorder,
                            const MapVerdict& verdict, const std::optional<MapPlacement>& placement,
                            const Summary& summary, robot::RunFolder& folder,
                            const std::function<bool()>& may_go_on);

}  // namespace sensotwin::twin
