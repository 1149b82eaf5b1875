// SPDX-License-Identifier: MIT
#include "twin/validate/run_once.hpp"

#include "robot/output/run_folder.hpp"
#include "twin/run/scene_run.hpp"

namespace sensotwin::twin {
namespace {

/// Rows of trace.csv nobody reads, unless someone will look at the pictures beside it.
constexpr int kNoTrace = 1'000'000;

Summary run_mission(const Scene& scene, robot::RunFolder& folder, const RunRequest& request) {
  SceneRunOptions options;
  options.scene_as_given = request.scene_as_given;
  options.pictures = request.pictures;
  options.bound = request.bound;
  if (!request.pictures) {
    options.trace_every = kNoTrace;
  }
  options.keep_going = [&](const RunProgress&) { return !request.keep_going || request.keep_going(); };
  return run_scene(scene, folder, options);
}

}  // namespace

std::optional<RunOutcome> run_once(const Scene& scene, std::uint64_t seed, const RunRequest& request) {
  Scene seeded = scene;
  seeded.seed = seed;
  robot::RunFolder folder(request.folder, robot::Existing::kReplace);
  const Summary summary = run_mission(seeded, folder, request);
  if (summary.interrupted) {
    return std::nullopt;
  }
  return RunOutcome{seed, figures_of(summary), summary.state_hash};
}

}  // namespace sensotwin::twin
