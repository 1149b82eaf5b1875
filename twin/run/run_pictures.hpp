// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "render/offscreen_context.hpp"
#include "render/scene_picture.hpp"
#include "twin/output/run_folder.hpp"
#include "twin/output/summary.hpp"
#include "twin/run/map_verdict.hpp"
#include "twin/run/mapping_twin.hpp"
#include "twin/run/run_recorder.hpp"

namespace sensotwin::twin {

/// Draws what a run came to into its folder. \throws OutputError; a missing renderer is one, with its remedy
void draw_run(const Scene& scene, const MappingTwin& twin, const RunRecorder& recorder, const MapVerdict& verdict,
              const std::optional<MapPlacement>& placement, const Summary& summary, RunFolder& folder);

}  // namespace sensotwin::twin
