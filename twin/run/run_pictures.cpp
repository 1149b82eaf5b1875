// SPDX-License-Identifier: MIT
#include "twin/run/run_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/mapping_pictures.hpp"
#include "render/png_writer.hpp"
#include "robot/output/output_error.hpp"
#include "twin/run/recovered_map.hpp"
#include "twin/run/scene_views.hpp"

namespace sensotwin::twin {
namespace {

/// Moments of the progress sheet and of snapshots/, as fractions of the tiles found (SensoBot, Figure 6 shows
/// six).
constexpr std::array<double, 6> kMoments{0.1, 0.25, 0.45, 0.65, 0.85, 1.0};

/// Snapshots are leafed through: smaller than the other pictures, and drawn in less than half the time.
constexpr render::PictureOptions kSnapshot{.width_px = 1000};

template <class T>
T drawn(render::Rendered<T> result, std::string_view name) {
  if (!result) {
    throw robot::OutputError(
        robot::ExitCode::kCannotCreate,
        fmt::format("{}: not drawn: {}; --no-pictures runs without pictures", name, result.error().message));
  }
  return std::move(*result);
}

/// One run's pictures: the scene with the robot's map laid over it.
class RunPainter {
 public:
  RunPainter(const Scene& scene, const MappingTwin& twin, const RunRecorder& recorder,
             const MapVerdict& verdict, const std::optional<MapPlacement>& placement, const Summary& summary,
             robot::RunFolder& folder, const std::function<bool()>& may_go_on)
      : scene_(scene),
        twin_(twin),
        recorder_(recorder),
        verdict_(verdict),
        placement_(placement),
        summary_(summary),
        folder_(folder),
        may_go_on_(may_go_on),
        context_(drawn(render::make_context(), "pictures")),
        base_(view_of(scene, twin.world().tags(), twin.world().X_WF())) {}

  /// \returns false when it was told to stop
  bool draw_all() {
    const render::SceneView end = final_view();
    save("floorplan.png", drawn(render::draw_top_view(*context_, end), "floorplan.png").image);
    if (!may_go_on_()) {
      return false;
    }
    save("oblique.png", drawn(render::draw_oblique_view(*context_, end), "oblique.png").image);
    if (!may_go_on_()) {
      return false;
    }
    save("recovered.png",
         drawn(render::draw_recovered_plan(*context_, recovered_view()), "recovered.png").image);
    if (!may_go_on_() || !draw_progress() || !may_go_on_()) {
      return false;
    }
    draw_chart();
    return true;
  }

 private:
  void save(const std::string& name, const render::Image& image) {
    render::PngText text;
    text.comment = render::provenance(scene_.name, scene_.seed, context_->renderer());
    const auto bytes = drawn(render::encode_png(image, text), name);
    folder_.write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

  [[nodiscard]] std::string figures() const {
    const MapResult& map = *summary_.map;
    return fmt::format("{}: {} of {} tiles in {:.1f} min, {:.0f} m, epsilon {:.1f} %", map.explorer,
                       map.tiles_mapped, promised(), map.minutes, map.metres, 100.0 * map.epsilon);
  }
  [[nodiscard]] int promised() const { return verdict_.mapped + verdict_.missed; }

  /// Colour of a tile of the truth at the end of the run.
  [[nodiscard]] render::TileState state_of(const JudgedTile& tile) const {
    const robot::TileMap& map = twin_.program().mission().map();
    if (tile.outcome == TileOutcome::kWrong) {
      return render::TileState::kWrong;
    }
    if (tile.outcome == TileOutcome::kMissed) {
      return render::TileState::kMissed;
    }
    if (!placement_) {
      return render::TileState::kUnvisited;
    }
    const robot::Tile own = tile_in_map(*placement_, tile.column, tile.row);
    if (tile.outcome == TileOutcome::kBeyond) {
      return map.unreachable(own) ? render::TileState::kUnreachable : render::TileState::kBlocked;
    }
    return map.color(own) == robot::TileColor::kBlack ? render::TileState::kBlack : render::TileState::kGrey;
  }

  [[nodiscard]] render::SceneView final_view() const {
    render::SceneView view = base_;
    view.subtitle = figures();
    view.trajectory = recorder_.trajectory();
    for (std::size_t i = 0; i < view.tiles.size() && i < verdict_.tiles.size(); ++i) {
      view.tiles[i].state = state_of(verdict_.tiles[i]);
    }
    view.robot =
        render::RobotView{twin_.world().X_WR(), scene_.robot.base.radius_m, scene_.robot.base.height_m};
    return view;
  }

  /// The plan at the moment `until_s`: tiles found by then, and the way driven by then.
  [[nodiscard]] render::SceneView view_at(double until_s) const {
    render::SceneView view = base_;
    view.time_end_s = summary_.sim_s;
    for (const render::TimedPoint& point : recorder_.trajectory()) {
      if (point.t_s <= until_s) {
        view.trajectory.push_back(point);
      }
    }
    if (!view.trajectory.empty()) {
      const auto& end = view.trajectory.back().p_m;
      const std::size_t back = std::min<std::size_t>(view.trajectory.size(), 4);
      const auto& before = view.trajectory[view.trajectory.size() - back].p_m;
      const double yaw = std::atan2(end.y() - before.y(), end.x() - before.x());
      const bool now = until_s >= summary_.sim_s;
      view.robot = render::RobotView{now ? twin_.world().X_WR() : robot::Pose2{end, yaw},
                                     scene_.robot.base.radius_m, scene_.robot.base.height_m};
    }
    if (!placement_) {
      return view;
    }
    std::set<robot::Tile> known;
    for (const FoundTile& found : recorder_.found()) {
      if (found.t_s <= until_s) {
        known.insert(found.tile);
      }
    }
    for (std::size_t i = 0; i < view.tiles.size() && i < verdict_.tiles.size(); ++i) {
      const robot::Tile own = tile_in_map(*placement_, verdict_.tiles[i].column, verdict_.tiles[i].row);
      if (known.contains(own)) {
        const bool closed =
            std::all_of(robot::kDirections.begin(), robot::kDirections.end(), [&](robot::Direction d) {
              const robot::Tile next = neighbour(own, d);
              return known.contains(next) || !twin_.program().mission().map().visited(next);
            });
        view.tiles[i].state = closed ? render::TileState::kBlack : render::TileState::kGrey;
      }
    }
    return view;
  }

  [[nodiscard]] render::SceneView recovered_view() const {
    render::SceneView view = base_;
    view.title = "Recovered plan over the true one, as the tags hold it";
    view.subtitle = figures();
    view.tiles.clear();
    view.tags.clear();
    view.start.reset();  // the tile (0, 0) says it
    for (render::LandmarkView& mark : view.landmarks) {
      mark.label.clear();
    }
    for (std::size_t i = 0; i < verdict_.tiles.size(); ++i) {
      const TileOutcome outcome = verdict_.tiles[i].outcome;
      if (outcome != TileOutcome::kBeyond) {
        view.tiles.push_back(base_.tiles[i]);
        render::TileView& tile = view.tiles.back();
        tile.state = state_of(verdict_.tiles[i]);
        if (outcome == TileOutcome::kMapped && placement_) {
          const robot::Tile own = tile_in_map(*placement_, verdict_.tiles[i].column, verdict_.tiles[i].row);
          tile.label = fmt::format("{},{}", own.column, own.row);
        }
      }
    }
    return view;
  }

  /// \returns false when it was told to stop
  bool draw_progress() {
    render::ProgressSheet sheet;
    sheet.title = scene_.title;
    sheet.subtitle = figures();
    sheet.scene = scene_.name;
    sheet.seed = scene_.seed;
    const std::size_t tiles = recorder_.found().size();
    for (std::size_t i = 0; i < kMoments.size() && tiles > 0; ++i) {
      const auto nth = static_cast<std::size_t>(std::ceil(kMoments[i] * static_cast<double>(tiles))) - 1;
      const bool last = i + 1 == kMoments.size();
      const double t_s = last ? summary_.sim_s : recorder_.found()[nth].t_s;
      render::SceneView plan = view_at(t_s);
      plan.subtitle = fmt::format("{} tiles after {:.1f} min", nth + 1, t_s / 60.0);
      const auto picture = drawn(render::draw_top_view(*context_, plan, kSnapshot), "snapshots");
      save(fmt::format("snapshots/{:03d}_tiles.png", nth + 1), picture.image);
      sheet.frames.push_back({t_s, std::move(plan)});
      if (!may_go_on_()) {
        return false;
      }
    }
    if (!sheet.frames.empty()) {
      save("progress.png", drawn(render::draw_progress_sheet(*context_, sheet), "progress.png").image);
    }
    return true;
  }

  void draw_chart() {
    render::TagsOverTime chart;
    chart.scene = scene_.name;
    chart.seed = scene_.seed;
    chart.tags_total = promised();
    render::ExplorerRun run{summary_.map->explorer, {{0.0, 0.0}}};
    for (const FoundTile& found : recorder_.found()) {
      run.found.push_back({found.t_s / 60.0, static_cast<double>(run.found.size())});
    }
    // To the end of the mission: the way back is part of its minutes.
    run.found.push_back({summary_.map->minutes, run.found.back().y});
    chart.runs.push_back(std::move(run));
    const auto image = drawn(render::draw(render::tags_over_time_chart(chart)), "tags_over_time.png").image;
    save("tags_over_time.png", image);
  }

  const Scene& scene_;
  const MappingTwin& twin_;
  const RunRecorder& recorder_;
  const MapVerdict& verdict_;
  const std::optional<MapPlacement>& placement_;
  const Summary& summary_;
  robot::RunFolder& folder_;
  const std::function<bool()>& may_go_on_;
  std::unique_ptr<render::OffscreenContext> context_;
  render::SceneView base_;
};

}  // namespace

bool draw_run(const Scene& scene, const MappingTwin& twin, const RunRecorder& recorder,
              const MapVerdict& verdict, const std::optional<MapPlacement>& placement, const Summary& summary,
              robot::RunFolder& folder, const std::function<bool()>& may_go_on) {
  return RunPainter(scene, twin, recorder, verdict, placement, summary, folder, may_go_on).draw_all();
}

}  // namespace sensotwin::twin
