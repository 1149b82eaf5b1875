// SPDX-License-Identifier: MIT
#include "twin/run/phase_run.hpp"

#include "twin/run/phase_config.hpp"
#include "twin/run/phase_pictures.hpp"
#include "twin/run/phase_recorder.hpp"
#include "twin/run/phase_twin.hpp"
#include "twin/run/run_parts.hpp"
#include "twin/run/scene_bound.hpp"
#include "twin/run/tick_loop.hpp"
#include "twin/run/twin_journal.hpp"
#include "twin/run/twin_tap.hpp"

namespace sensotwin::twin {
Summary run_phase(const Scene& scene, RunFolder& folder, const SceneRunOptions& options) {
  const double begun_s = wall_s(options);
  TwinJournal journal(options.journal, scene);
  PhaseTwin twin(scene, journal.on_phase_wires());
  PhaseRecorder recorder(scene, folder, options.trace_every, options.pictures, options.tag_log);
  JournallingRecorder journalling(recorder, journal);
  TwinTap tap(options.telemetry, scene, robot_settings_of(scene, twin.radio()));
  TappingRecorder tapping(journalling, tap);
  recorder.listen(tap.listener());
  TickLoop loop(options.wall_s, options.pace);
  const auto may_go_on = [&] {
    return !options.keep_going || options.keep_going({.sim_s = robot::to_s(twin.now()),
                                                      .done = static_cast<int>(twin.program().leg()),
                                                      .total = progress_total_of(scene)});
  };
  Summary summary;
  const robot::Instant limit{robot::from_s(scene.limits.time_limit_s)};
  summary.interrupted = !loop.run(twin, tapping, limit, may_go_on);
  tap.ended(twin.now(), summary.interrupted);
  recorder.finish();
  const double looped_s = wall_s(options);

  open_summary(summary, scene, twin, options);
  summary.path = recorder.result(twin);
  if (scene.mission.phase->controller == PhaseController::kOwn) {
    summary.path->bound = options.bound;
    // An interrupted run ends within a second: among forty tags the bound alone may take half of one.
    const bool wanted = !options.bound && !summary.interrupted;
    if (const auto bound = wanted ? bound_of(scene) : std::nullopt) {
      summary.path->bound = figures_of(*bound);
    }
  }
  summary.links = links_of(twin.program(), {&twin.program().floor_reader()});
  summary.expect = judge(limits_of(scene), figures_of(summary));
  if (options.pictures && !summary.interrupted) {
    summary.interrupted = !draw_phase_run(scene, twin, recorder, *summary.path, folder, may_go_on);
  }
  folder.write("summary.json", to_json(summary));
  write_timing(folder, loop.parts(), summary.sim_s, begun_s, looped_s, options);
  return summary;
}

}  // namespace sensotwin::twin
