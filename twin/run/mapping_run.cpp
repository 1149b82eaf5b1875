// SPDX-License-Identifier: MIT
#include "twin/run/mapping_run.hpp"

#include <algorithm>

#include "robot/mapping/explorer_kind.hpp"
#include "twin/run/map_verdict.hpp"
#include "twin/run/mapping_twin.hpp"
#include "twin/run/mission_loop.hpp"
#include "twin/run/recovered_map.hpp"
#include "twin/run/run_parts.hpp"
#include "twin/run/run_pictures.hpp"
#include "twin/run/run_recorder.hpp"
#include "twin/run/twin_journal.hpp"
#include "twin/run/twin_tap.hpp"
#include "world/free_space.hpp"

namespace sensotwin::twin {
namespace {

/// The tiles that this explorer is there to map.
const std::set<std::pair<int, int>>& promised_by(const Scene& scene, const world::ReachableTiles& truth) {
  return scene.mission.map->explorer == robot::ExplorerKind::kSweep ? truth.reachable : truth.grid_reachable;
}

/// Tiles of the scene by how they can be reached.
world::ReachableTiles reachable_in(const Scene& scene, const MappingTwin& twin) {
  std::vector<world::Vec2> carpet_tags;
  for (const world::Tag& tag : twin.world().tags()) {
    if (tag.place == world::TagPlace::kCarpet) {
      carpet_tags.push_back(tag.at_m);
    }
  }
  return world::reachable_tiles(scene.world, scene.robot, {}, carpet_tags);
}

MapResult map_result(const Scene& scene, const MappingTwin& twin, const MapVerdict& verdict,
                     const world::ReachableTiles& truth, double energy_wh) {
  const robot::MappingMission& mission = twin.program().mission();
  const robot::MissionCounts& counts = mission.counts();
  MapResult result;
  result.explorer = robot::name_of(scene.mission.map->explorer);
  result.tiles_reachable = static_cast<int>(truth.reachable.size());
  result.tiles_grid_reachable = static_cast<int>(truth.grid_reachable.size());
  result.tiles_mapped = verdict.mapped;
  result.tiles_missed = verdict.missed;
  result.tiles_wrong = verdict.wrong;
  result.tiles_given_up = counts.tiles_given_up;
  result.visits = counts.visits;
  result.visits_paper = mission.explorer().paper_visits();
  const auto visited = static_cast<double>(mission.map().visited_count());
  result.epsilon = visited > 0 ? counts.visits / visited - 1.0 : 0.0;
  result.minutes = robot::to_s(twin.now()) / 60.0;
  result.metres = mission.navigator().filter().path_length_m();
  result.turns = mission.navigator().filter().turned_rad() / (robot::kPi / 2.0);
  result.energy_wh = energy_wh;
  result.moves = counts.moves;
  result.moves_missed = counts.moves_missed;
  result.moves_recovered = counts.misses_recovered;
  return result;
}

}  // namespace

Summary run_mapping(const Scene& scene, robot::RunFolder& folder, const SceneRunOptions& options) {
  const double begun_s = wall_s(options);
  TwinJournal journal(options.journal, scene);
  MappingTwin twin(scene, journal.on_mapping_wires());
  RunRecorder recorder(folder, options.trace_every);
  TwinTap tap(options.telemetry, scene, robot_settings_of(scene));
  if (options.telemetry != nullptr) {
    tap.show_total(promised_by(scene, reachable_in(scene, twin)).size());
  }
  const auto go_on =
      may_go_on(scene, options, twin, [&] { return static_cast<int>(recorder.found().size()); });
  const MissionLoop loop = run_to_its_end(scene, options, twin, recorder, journal, tap, go_on);

  Summary summary;
  summary.interrupted = loop.interrupted;
  const world::ReachableTiles truth = reachable_in(scene, twin);
  const auto placement = placement_of(scene, twin);
  const MapVerdict verdict =
      judge_map(twin.world().tags(), twin.map_id(), placement, promised_by(scene, truth));
  open_summary(summary, scene, twin, options);
  summary.map = map_result(scene, twin, verdict, truth, recorder.energy_wh());
  summary.links =
      links_of(twin.program(), {&twin.program().floor_reader(), &twin.program().forward_reader()});
  summary.expect = judge(limits_of(scene), figures_of(summary));

  robot::write_recovered_map(folder, twin.program().mission(), scene.world.carpet.tile_m);
  if (options.pictures && !summary.interrupted) {
    // Whoever interrupts is answered within a second; a house takes three to draw.
    summary.interrupted = !draw_run(scene, twin, recorder, verdict, placement, summary, folder, go_on);
  }
  folder.write("summary.json", to_json(summary));
  write_timing(folder, loop.parts, summary.sim_s, begun_s, loop.ended_s, options);
  return summary;
}

}  // namespace sensotwin::twin
