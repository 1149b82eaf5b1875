// SPDX-License-Identifier: MIT
#include "twin/trace/map_answers.hpp"

#include <fmt/format.h>

#include <utility>

#include "robot/topology/hallway_route.hpp"
#include "twin/scene/scene_reader.hpp"
#include "twin/trace/drawing_advice.hpp"
#include "twin/trace/route_words.hpp"
#include "twin/trace/trace_document.hpp"
#include "twin/trace/trace_error.hpp"

namespace sensotwin::twin {
namespace {

using robot::CompassPoint;

/// Chosen: a carpet of 100 m x 100 m in 0.5 m tiles; the page draws no more.
constexpr std::size_t kTilesShownMax = 40'000;

/// Place and side that a path such as "places.c.E.tags" is about; names may hold dots, so the longest fits.
std::pair<std::string, std::string> culprit(const std::string& path, const Json& document) {
  constexpr std::string_view kPlaces = "places.";
  if (!path.starts_with(kPlaces)) {
    return {};
  }
  const std::string rest = path.substr(kPlaces.size());
  std::string best;
  for (const Json& place : document.at("hallways").at("places")) {
    const std::string name = place.at("name");
    if (name.size() >= best.size() && rest.starts_with(name) &&
        (rest.size() == name.size() || rest[name.size()] == '.')) {
      best = name;
    }
  }
  const std::string side = rest.size() > best.size() + 1 ? rest.substr(best.size() + 1, 1) : "";
  return {best, robot::compass_point_from(side) ? side : ""};
}

Json advice_json(const std::vector<robot::HallwayMapProblem>& advice) {
  Json list = Json::array();
  for (const robot::HallwayMapProblem& one : advice) {
    list.push_back({{"level", "advice"},
                    {"place", one.node},
                    {"side", one.side ? std::string(1, robot::letter_of(*one.side)) : ""},
                    {"path", ""},
                    {"what", one.what},
                    {"hint", ""}});
  }
  return list;
}

robot::BlockedHallways blocked_in(const Json& request, const robot::HallwayMap& map) {
  robot::BlockedHallways blocked;
  const Json list = request.value("blocked", Json::array());
  for (const Json& one : list) {
    const bool pair = one.is_array() && one.size() == 2 && one[0].is_string() && one[1].is_string();
    const auto node = pair ? map.find(one[0].get<std::string>()) : std::nullopt;
    const auto side = pair ? robot::compass_point_from(one[1].get<std::string>()) : std::nullopt;
    if (!node || !side) {
      throw TraceError(TraceError::kBadRequest, "blocked: expected pairs of a place and N, E, S or W");
    }
    blocked.block(map, *node, *side);
  }
  return blocked;
}

std::string text_at(const Json& request, const char* key) {
  const auto found = request.find(key);
  if (found == request.end() || !found->is_string()) {
    throw TraceError(TraceError::kBadRequest, fmt::format("the request has no text '{}'", key));
  }
  return found->get<std::string>();
}

}  // namespace

JudgedMap judged_map(const Json& document) {
  const std::string text = hallway_text(document);
  try {
    return {robot::read_hallway_text(text, "hallway map"), {}};
  } catch (const robot::LoadError& error) {
    return {std::nullopt, error.problems()};
  }
}

Json problems_json(const std::vector<robot::Problem>& problems, const Json& document) {
  Json list = Json::array();
  for (const robot::Problem& problem : problems) {
    const auto [place, side] = culprit(problem.path, document);
    list.push_back({{"level", "error"},
                    {"place", place},
                    {"side", side},
                    {"path", problem.path},
                    {"what", problem.what},
                    {"hint", problem.hint}});
  }
  return list;
}

Json check_answer(const Json& document) {
  const JudgedMap judged = judged_map(document);
  if (!judged.file) {
    return {{"sound", false}, {"problems", problems_json(judged.problems, document)}, {"text", ""}};
  }
  return {{"sound", true},
          {"problems", advice_json(advice_on(*judged.file))},
          {"text", robot::hallway_yaml(*judged.file)}};
}

Json route_answer(const Json& request) {
  const JudgedMap judged = judged_map(request.value("document", Json::object()));
  if (!judged.file) {
    throw TraceError(TraceError::kUnusable,
                     "no route is planned over a map with mistakes: " + judged.problems.front().path + " " +
                         judged.problems.front().what);
  }
  const robot::HallwayMap& map = judged.file->map;
  const std::string from = text_at(request, "from");
  const std::string to = text_at(request, "to");
  const auto start = route_start(map, from);
  const auto goal = map.find(to);
  if (!start || !goal) {
    throw TraceError(TraceError::kUnusable, !start ? fmt::format("there is no place or tag '{}'", from)
                                                   : fmt::format("there is no place '{}'", to));
  }
  const auto route = robot::plan_route(map, start->node, *goal, blocked_in(request, map));
  if (!route) {
    const bool unknown = route.error() == robot::RouteError::kOnlyByUnknown;
    return {{"found", false},
            {"reason",
             unknown ? fmt::format("No known way leads from {} to {}; a hallway marked ? might.", from, to)
                     : fmt::format("No way leads from {} to {}.", from, to)}};
  }
  Json steps = Json::array();
  for (const robot::RouteStep& step : route->steps) {
    const auto& length_m = map.node(step.from).side(step.exit).length_m;
    steps.push_back({{"from", map.node(step.from).name},
                     {"exit", std::string(1, robot::letter_of(step.exit))},
                     {"to", map.node(step.to).name},
                     {"length_m", length_m ? Json(*length_m) : Json()}});
  }
  return {{"found", true},
          {"start", map.node(start->node).name},
          {"start_words", start->words},
          {"steps", steps},
          {"words", route_words(map, *start, *route)},
          {"cost", route->cost},
          {"by_length", route->by_length}};
}

Json scene_answer(const std::string& text, const std::filesystem::path& file, const Json& document) {
  try {
    const Scene scene = read_scene_text(text, file);
    const world::Carpet& carpet = scene.world.carpet;
    Json tiles = Json::array();
    for (std::size_t i = 0; i < carpet.tiles.size() && i < kTilesShownMax; ++i) {
      tiles.push_back({carpet.tiles[i].first, carpet.tiles[i].second});
    }
    const robot::Pose2& start = scene.robot.X_WR_start;
    return {{"sound", true},
            {"problems", Json::array()},
            {"text", text},
            {"tile_m", carpet.tile_m},
            {"tile_origin_m", {carpet.origin_m.x(), carpet.origin_m.y()}},
            {"tiles", std::move(tiles)},
            {"tile_count", carpet.tiles.size()},
            {"start", {start.p_m.x(), start.p_m.y(), robot::deg_from_rad(start.yaw_rad)}}};
  } catch (const robot::LoadError& error) {
    std::vector<robot::Problem> problems = error.problems();
    for (robot::Problem& problem : problems) {
      // The hallway map's own problems name a file of ours that the user does not know.
      problem.place = {};
    }
    return {{"sound", false}, {"problems", problems_json(problems, document)}, {"text", text}};
  }
}

}  // namespace sensotwin::twin
