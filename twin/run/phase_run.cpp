// SPDX-License-Identifier: MIT
#include "twin/run/phase_run.hpp"

#include "twin/run/mission_loop.hpp"
#include "twin/run/phase_config.hpp"
#include "twin/run/phase_pictures.hpp"
#include "twin/run/phase_recorder.hpp"
#include "twin/run/phase_twin.hpp"
#include "twin/run/run_parts.hpp"
#include "twin/run/scene_bound.hpp"
#include "twin/run/twin_journal.hpp"
#include "twin/run/twin_tap.hpp"

namespace sensotwin::twin {
Summary run_phase(const Scene& scene, robot::RunFolder& folder, const SceneRunOptions& options) {
  const double begun_s = wall_s(options);
  TwinJournal journal(options.journal, scene);
  PhaseTwin twin(scene, journal.on_phase_wires());
  PhaseRecorder recorder(scene, folder, options.trace_every, options.pictures, options.tag_log);
  TwinTap tap(options.telemetry, scene, robot_settings_of(scene, twin.radio()));
  const auto go_on = may_go_on(scene, options, twin, [&] { return static_cast<int>(twin.program().leg()); });
  const MissionLoop loop = run_to_its_end(scene, options, twin, recorder, journal, tap, go_on);

  Summary summary;
  summary.interrupted = loop.interrupted;
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
    summary.interrupted = !draw_phase_run(scene, twin, recorder, *summary.path, folder, go_on);
  }
  folder.write("summary.json", to_json(summary));
  write_timing(folder, loop.parts, summary.sim_s, begun_s, loop.ended_s, options);
  return summary;
}

}  // namespace sensotwin::twin
