// SPDX-License-Identifier: MIT
#include "twin/scene/scene_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "robot/config/field_reader.hpp"
#include "robot/config/text_file.hpp"
#include "robot/config/yaml_tree.hpp"
#include "robot/settings/mission_checks.hpp"
#include "twin/scene/fields.hpp"
#include "twin/scene/floor_plan.hpp"
#include "twin/scene/hallway_building.hpp"
#include "twin/scene/map_import.hpp"
#include "twin/scene/override.hpp"
#include "twin/scene/phase_fields.hpp"
#include "twin/scene/radio_profile.hpp"
#include "twin/scene/scene_checks.hpp"
#include "twin/scene/variant.hpp"

namespace sensotwin::twin {
namespace {

/// The first comment line that says something, for scenes without `title:`. Lines for tools are passed over.
std::string first_comment(const std::string& text) {
  std::size_t from = 0;
  while (from < text.size() && text[from] == '#') {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    std::string line = text.substr(from, end - from);
    line.erase(0, line.find_first_not_of("# \t"));
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())) != 0) {
      line.pop_back();
    }
    const bool for_tools = line.starts_with("SPDX-") || line.starts_with("yaml-language-server:");
    if (!line.empty() && !for_tools) {
      return line;
    }
    from = end + 1;
  }
  return "";
}

/// The hallway map that the scene names, its tags in the world, and what hallways want by default: no carpet,
/// rangefinders, a start at the place where the mission begins.
void take_hallways(Scene& scene, const std::filesystem::path& folder, const robot::FieldReader& reader,
                   std::vector<robot::Problem>& problems, int& exit_code) {
  const bool drawn = scene.layout.hallways.has_value();
  const std::string name = drawn              ? scene.layout.hallways->file
                           : scene.layout.map ? scene.layout.map->hallways
                                              : "";
  const std::string path = drawn ? "world.hallways.file" : "world.map.hallways";
  const auto add = [&](std::string what, std::string hint) {
    problems.push_back({reader.place(path), path, std::move(what), std::move(hint)});
  };
  if (name.empty()) {
    if (scene.mission.hallway) {
      problems.push_back({reader.place("mission.hallway"), "mission.hallway", "needs hallways",
                          "expected world.hallways.file, or world.map.hallways"});
    }
    return;
  }
  try {
    scene.hallways = robot::read_hallway_file(folder / name);
    if (!scene.known_file.empty()) {
      scene.known = robot::read_hallway_file(folder / scene.known_file);
    }
  } catch (const robot::LoadError& error) {
    exit_code = error.exit_code() == robot::kExitMissing ? robot::kExitMissing : exit_code;
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    return;
  }
  for (const robot::HallwayNode& node : scene.hallways.map.nodes()) {
    if (!node.at_m) {
      add("place '" + node.name + "' has no position", "expected at_m: [x, y] for each place of a scene");
      scene.hallways.map = {};
      return;
    }
  }
  scene.world.hallway_tags = tags_of(scene.hallways);
  scene.world.hallway_tag_reach_m = scene.hallways.tag_reach_m;
  for (const robot::HallwayNode& node : scene.hallways.map.nodes()) {
    scene.world.shoves.places_m.push_back(*node.at_m);
  }
  if (!scene.mission.hallway) {
    return;
  }
  if (!scene.robot.sonar) {
    scene.robot.sonar.emplace();
  }
  for (const robot::MissionProblem& problem :
       robot::problems_of(*scene.mission.hallway, (scene.known ? *scene.known : scene.hallways).map)) {
    problems.push_back({reader.place(problem.path), problem.path, problem.what, problem.hint});
  }
  const auto from = scene.hallways.map.find(scene.mission.hallway->from);
  if (from && !reader.has("robot.start.at_m")) {
    scene.robot.X_WR_start = {*scene.hallways.map.node(*from).at_m, 0.5 * robot::kPi};
  }
}

/// The floor of the scene's room or map; its walls are put into the world.
std::optional<FloorPlan> build_walls(Scene& scene, const std::filesystem::path& folder, SceneChecks& checks,
                                     const robot::FieldReader& reader, std::vector<robot::Problem>& problems,
                                     int& exit_code) {
  if (scene.layout.room) {
    if (!checks.room()) {
      return std::nullopt;
    }
    scene.world.walls.push_back({scene.layout.room->walls_m, true});
    for (const Partition& partition : scene.layout.room->partitions) {
      // Two points close no loop.
      scene.world.walls.push_back({partition.points_m, partition.closed && partition.points_m.size() > 2});
    }
    return FloorPlan(scene.layout.room->walls_m);
  }
  if (scene.layout.hallways && !scene.hallways.map.nodes().empty()) {
    OccupancyMap building = floor_of(scene.hallways, scene.layout.hallways->rooms);
    scene.world.walls = outline(building);
    return FloorPlan(std::move(building));
  }
  if (!scene.layout.map || scene.layout.map->file.empty()) {
    return std::nullopt;
  }
  try {
    OccupancyMap map = read_map(folder / scene.layout.map->file);
    scene.world.walls = outline(map);
    if (map.count(Cell::kFree) == 0) {
      problems.push_back({reader.place("world.map.file"), "world.map.file", "the map has no free cell",
                          "expected floor: are negate and free_thresh right?"});
      return std::nullopt;
    }
    return FloorPlan(std::move(map));
  } catch (const robot::LoadError& error) {
    if (error.exit_code() == robot::kExitMissing) {
      exit_code = robot::kExitMissing;
    }
    for (robot::Problem problem : error.problems()) {
      if (problem.place.line == 0) {  // of the file as a whole: the mistake is here, where it is named
        problem = {reader.place("world.map.file"), "world.map.file",
                   problem.place.source + ": " + problem.what, problem.hint};
      }
      problems.push_back(std::move(problem));
    }
    return std::nullopt;
  }
}

void furnish(Scene& scene, const FloorPlan& floor, SceneChecks& checks, const robot::FieldReader& reader,
             std::vector<robot::Problem>& problems) {
  if (checks.carpet_size(floor)) {
    scene.world.carpet = lay_carpet(scene.layout.carpet, floor);
    scene.layout.carpet.origin_m = scene.world.carpet.origin_m;
  }
  checks.on_floor(floor);
  if (reader.has("robot.start.at_m") || !problems.empty() ||
      (scene.mission.hallway && !scene.mission.hallway->from.empty())) {
    return;
  }
  if (const std::optional<robot::Pose2> start = find_start(scene)) {
    scene.robot.X_WR_start = *start;
  } else {
    problems.push_back({reader.place("robot.start"), "robot.start", "no tile has room for the robot",
                        "expected a start: { at_m: [x, y], heading_deg: 0 }"});
  }
}

robot::YamlNode parse_with_overrides(const std::string& text, const std::string& source,
                                     const SceneOverrides& overrides, std::vector<std::string>& variants,
                                     std::vector<robot::Problem>& problems) {
  robot::YamlNode root = robot::parse_yaml(text, source, problems);
  if (problems.empty() && root.kind == robot::YamlKind::kNothing) {
    problems.push_back({{source, 1, 1}, "", "the file holds no scene", "expected version, seed, world ..."});
  } else if (problems.empty() && root.kind != robot::YamlKind::kSection) {
    problems.push_back({root.place, "", "is " + root.describe(), "expected keys: version, seed, world ..."});
  }
  if (!problems.empty()) {
    throw robot::LoadError(problems, robot::kExitInvalid);
  }
  variants = take_variant(root, overrides.variant, problems);
  if (!overrides.variant.empty() &&
      std::find(variants.begin(), variants.end(), overrides.variant) == variants.end()) {
    throw robot::LoadError(problems, robot::kExitUsage);
  }
  for (const std::string& assignment : overrides.set) {
    if (!apply_override(root, assignment, problems)) {
      throw robot::LoadError(problems, robot::kExitUsage);
    }
  }
  if (overrides.seed && !apply_override(root, fmt::format("seed={}", *overrides.seed), problems)) {
    throw robot::LoadError(problems, robot::kExitUsage);
  }
  return root;
}

}  // namespace

Scene read_scene(const std::filesystem::path& file, const SceneOverrides& overrides) {
  return read_scene_text(robot::read_text_file(file, "scene"), file, overrides);
}

Scene read_scene_text(const std::string& text, const std::filesystem::path& file,
                      const SceneOverrides& overrides) {
  std::vector<robot::Problem> problems;
  Scene scene;
  robot::YamlNode root = parse_with_overrides(text, file.string(), overrides, scene.variants, problems);
  int exit_code = robot::kExitInvalid;
  take_radio_profile(root, file.parent_path(), problems, exit_code);

  scene.file = file.string();
  scene.variant = overrides.variant;
  scene.name = file.stem().string() + (overrides.variant.empty() ? "" : "-" + overrides.variant);
  robot::FieldReader reader(root, problems);
  visit_fields(reader, scene);
  reader.finish();
  if (scene.title.empty()) {
    scene.title = first_comment(text);
  }
  if (!reader.has("mission")) {
    scene.mission.map.emplace();
  }

  complete_radio(scene);
  take_hallways(scene, file.parent_path(), reader, problems, exit_code);
  SceneChecks checks(scene, reader, problems);
  checks.by_itself();
  if (const auto floor = build_walls(scene, file.parent_path(), checks, reader, problems, exit_code)) {
    furnish(scene, *floor, checks, reader, problems);
  }
  if (!problems.empty()) {
    throw robot::LoadError(std::move(problems), exit_code);
  }
  return scene;
}

}  // namespace sensotwin::twin
