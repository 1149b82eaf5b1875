// SPDX-License-Identifier: MIT
#include "twin/run/hallway_run.hpp"

#include <fmt/format.h>

#include "render/phase_pictures.hpp"
#include "render/png_writer.hpp"
#include "robot/output/output_error.hpp"
#include "twin/run/hallway_recorder.hpp"
#include "twin/run/hallway_twin.hpp"
#include "twin/run/mission_loop.hpp"
#include "twin/run/run_parts.hpp"
#include "twin/run/scene_views.hpp"
#include "twin/run/twin_journal.hpp"
#include "twin/run/twin_tap.hpp"

namespace sensotwin::twin {
namespace {

std::string figures_in_words(const HallwayResult& result) {
  if (result.mission == "survey") {
    return fmt::format("{} places found in {:.1f} min and {:.0f} m", result.places, result.minutes,
                       result.length_m);
  }
  return fmt::format("{:.1f} m driven, {:.1f} m the shortest way, {} tags read, {} places known without",
                     result.length_m, result.shortest_m, result.tags_read, result.tags_missed);
}

/// The way driven through the building, places and hallways of the map beneath it.
render::PhaseRunView view_of(const Scene& scene, const HallwayTwin& twin, const HallwayRecorder& recorder,
                             const HallwayResult& result) {
  render::PhaseRunView view = plan_of(scene, twin.world().X_WF());
  view.subtitle = figures_in_words(result);
  for (const robot::HallwayNode& node : scene.hallways.map.nodes()) {
    view.tags.push_back({node.name, *node.at_m, false});
  }
  view.tags_are = "place";
  view.driven = recorder.driven();
  view.end = twin.world().X_WR();
  return view;
}

void draw(const render::PhaseRunView& view, robot::RunFolder& folder) {
  const auto picture = render::draw_phase_plan(view);
  if (!picture) {
    throw robot::OutputError(robot::ExitCode::kUnavailable, "plan.png: " + picture.error().message);
  }
  render::PngText text;
  text.comment = render::provenance(view.scene, view.seed, "cairo");
  const auto bytes = render::encode_png(picture->image, text);
  if (!bytes) {
    throw robot::OutputError(robot::ExitCode::kUnavailable, "plan.png: " + bytes.error().message);
  }
  folder.write("plan.png", {reinterpret_cast<const char*>(bytes->data()), bytes->size()});
}

}  // namespace

Summary run_hallway(const Scene& scene, robot::RunFolder& folder, const SceneRunOptions& options) {
  const double begun_s = wall_s(options);
  TwinJournal journal(options.journal, scene);
  HallwayTwin twin(scene, journal.on_hallway_wires());
  HallwayRecorder recorder(scene, folder, options.trace_every, options.pictures);
  TwinTap tap(options.telemetry, scene, hallway_settings_of(scene));
  const auto go_on =
      may_go_on(scene, options, twin, [&] { return twin.program().done() ? progress_total_of(scene) : 0; });
  const MissionLoop loop = run_to_its_end(scene, options, twin, recorder, journal, tap, go_on);

  Summary summary;
  summary.interrupted = loop.interrupted;
  open_summary(summary, scene, twin, options);
  summary.hallway = recorder.result(twin);
  summary.links = links_of(twin.program(), {&twin.program().floor_reader()});
  summary.expect = judge(limits_of(scene), figures_of(summary));
  if (scene.mission.hallway->survey) {
    robot::HallwayFile drawn = scene.hallways;
    drawn.map = twin.program().map();
    folder.write("hallways.yaml", robot::hallway_yaml(drawn));
  }
  if (options.pictures && !summary.interrupted) {
    draw(view_of(scene, twin, recorder, *summary.hallway), folder);
  }
  folder.write("summary.json", to_json(summary));
  write_timing(folder, loop.parts, summary.sim_s, begun_s, loop.ended_s, options);
  return summary;
}

}  // namespace sensotwin::twin
