// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <ostream>

#include "render/png_writer.hpp"
#include "render/scene_picture.hpp"
#include "robot/config/problem.hpp"
#include "robot/mapping/explorer_kind.hpp"
#include "twin/cli/deed_support.hpp"
#include "twin/cli/deeds.hpp"
#include "twin/run/scene_views.hpp"
#include "twin/run/twin_journal.hpp"
#include "twin/scene/map_import.hpp"
#include "twin/scene/scene_reader.hpp"
#include "twin/scene/scene_writer.hpp"
#include "world/world.hpp"

namespace sensotwin::twin {
namespace {

render::Backend backend_of(const std::string& name) {
  return name == "osmesa" ? render::Backend::kOsMesa
         : name == "egl"  ? render::Backend::kEgl
                          : render::Backend::kAuto;
}

std::string_view summary_of(robot::ExplorerKind kind) {
  switch (kind) {
    case robot::ExplorerKind::kBfm:
      return "breadth first (SensoBot, IV.1), next open neighbour directly";
    case robot::ExplorerKind::kBfmOutAndBack:
      return "breadth first, back to the tag after each open neighbour";
    case robot::ExplorerKind::kBfmAllNeighbours:
      return "breadth first, back after each of all four neighbours";
    case robot::ExplorerKind::kDfm:
      return "depth first (SensoBot, IV.2), retracing every tag";
    case robot::ExplorerKind::kIdfm:
      return "depth first, improved (SensoBot, Algorithm 1)";
    case robot::ExplorerKind::kSpiral:
      return "right-hand spiral, then the nearest open tag";
    case robot::ExplorerKind::kSweep:
      break;
  }
  return "ours, the default: plans the rest ahead, detours round what blocks straight moves";
}

/// Maps are often called map.yaml: then the folder tells more.
std::string map_name(const std::filesystem::path& map) {
  const auto folder = std::filesystem::absolute(map).lexically_normal().parent_path().filename();
  return (map.stem() == "map" && !folder.empty() ? folder : map.stem()).string();
}

Probe renderer_probe(render::Backend backend, bool required) {
  return {
      .name = fmt::format("renderer {}", render::name_of(backend)), .required = required, .look = [backend] {
        const auto context = render::make_context(backend);
        return context ? ProbeResult{true, (*context)->renderer()}
                       : ProbeResult{false, context.error().message};
      }};
}

}  // namespace

robot::ExitCode show_deed(const ShowOptions& options, Context& context) {
  const Scene scene = scene_of(options.choice);
  context.out << (options.robot ? robot_file_of(scene) : scene_yaml(scene));
  return robot::ExitCode::kDone;
}

robot::ExitCode render_deed(const RenderOptions& options, Context& context) {
  const Scene scene = scene_of(options.choice);
  const world::World world(scene.world, scene.robot, scene.physics,
                           robot::RandomStream(scene.seed).fork("world"));
  render::SceneView view = view_of(scene, world.tags(), world.X_WF());
  view.robot =
      render::RobotView{scene.robot.X_WR_start, scene.robot.base.radius_m, scene.robot.base.height_m};
  const auto gl = drawn_or_throw(render::make_context(backend_of(options.renderer)));
  render::PictureOptions picture;
  picture.width_px = options.width_px;
  const auto drawn = drawn_or_throw(options.view == "oblique" ? render::draw_oblique_view(*gl, view, picture)
                                                              : render::draw_top_view(*gl, view, picture));
  const auto path = options.out.value_or(scene.name + ".png");
  write_picture(path, drawn.image, render::provenance(scene.name, scene.seed, gl->renderer()), options.force);
  context.say_more(gl->renderer());
  context.out << path.string() << '\n';
  return robot::ExitCode::kDone;
}

robot::ExitCode import_deed(const ImportOptions& options, Context& context) {
  try {
    const OccupancyMap map = read_map(options.map);
    const MapCounts figures = counts(map, outline(map));
    std::filesystem::path fallback = options.map;
    const auto path = options.out.value_or(fallback.replace_extension(".scene.yaml").filename());
    const auto folder = std::filesystem::absolute(path).parent_path();
    const auto from_scene = std::filesystem::absolute(options.map).lexically_relative(folder);
    const std::string name = map_name(options.map);
    const std::string text = fmt::format(
        "# {} as a carpeted floor: every tile that its free space can hold.\nversion: 1\nseed: 1\n"
        "title: \"{}, carpeted\"\nworld:\n"
        "  map: {{ file: {} }}\n  carpet: {{ tile_m: {:g} }}\nmission: {{ map: {{}} }}\n"
        "expect:\n  tiles_missed: {{ max: 0 }}\n  tiles_wrong: {{ max: 0 }}\n",
        name, name, from_scene.string(), options.tile_m);
    const Scene scene = read_scene_text(text, path);
    write_file(path, text, options.force);
    context.say(fmt::format("{:.0f} m2 of floor, {} walls of {} segments, {} tiles", figures.free_m2,
                            figures.outlines, figures.segments, scene.world.carpet.tiles.size()));
    context.out << path.string() << '\n';
  } catch (const robot::LoadError& error) {
    throw CommandError(static_cast<robot::ExitCode>(error.exit_code()), error.what(), true);
  }
  return robot::ExitCode::kDone;
}

std::vector<Probe> renderer_probes() {
  return {renderer_probe(render::Backend::kOsMesa, true), renderer_probe(render::Backend::kEgl, false)};
}

ListTopic variants_topic(std::vector<std::filesystem::path> folders) {
  return {"variants", "scenes with each of their variants", [folders = std::move(folders)] {
            std::vector<ListEntry> entries;
            for (const std::filesystem::path& file : scene_files(folders)) {
              try {
                for (const std::string& variant : read_scene(file).variants) {
                  entries.push_back({file.string() + " --variant " + variant,
                                     read_scene(file, {.variant = variant}).title});
                }
              } catch (const robot::LoadError& error) {
                entries.push_back({file.string(), error.problems().front().text()});
              }
            }
            return entries;
          }};
}

ListTopic explorers_topic() {
  return {.name = "explorers", .summary = "orders in which the carpet's tiles are visited", .entries = [] {
            std::vector<ListEntry> entries;
            entries.reserve(robot::kExplorerKinds.size());
            for (const robot::ExplorerKind kind : robot::kExplorerKinds) {
              entries.push_back({std::string(robot::name_of(kind)), std::string(summary_of(kind))});
            }
            return entries;
          }};
}

}  // namespace sensotwin::twin
