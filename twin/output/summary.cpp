// SPDX-License-Identifier: MIT
#include "twin/output/summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <variant>

namespace sensotwin::twin {
namespace {

using Json = nlohmann::ordered_json;

/// A figure's name and place: the one list behind the JSON, the expectations and their check.
template <class Owner>
struct Figure {
  std::string_view name;
  std::variant<int Owner::*, std::int64_t Owner::*, double Owner::*> member;
};

constexpr std::array<Figure<MapResult>, 16> kMapFigures{{
    {"tiles_reachable", &MapResult::tiles_reachable},
    {"tiles_grid_reachable", &MapResult::tiles_grid_reachable},
    {"tiles_mapped", &MapResult::tiles_mapped},
    {"tiles_missed", &MapResult::tiles_missed},
    {"tiles_wrong", &MapResult::tiles_wrong},
    {"tiles_given_up", &MapResult::tiles_given_up},
    {"visits", &MapResult::visits},
    {"visits_paper", &MapResult::visits_paper},
    {"epsilon", &MapResult::epsilon},
    {"minutes", &MapResult::minutes},
    {"metres", &MapResult::metres},
    {"turns", &MapResult::turns},
    {"energy_wh", &MapResult::energy_wh},
    {"moves", &MapResult::moves},
    {"moves_missed", &MapResult::moves_missed},
    {"moves_recovered", &MapResult::moves_recovered},
}};

constexpr std::array<Figure<HallwayResult>, 16> kHallwayFigures{{
    {"arrived", &HallwayResult::arrived},
    {"length_m", &HallwayResult::length_m},
    {"shortest_m", &HallwayResult::shortest_m},
    {"detour", &HallwayResult::detour},
    {"wall_contacts", &HallwayResult::wall_contacts},
    {"end_error_m", &HallwayResult::end_error_m},
    {"minutes", &HallwayResult::minutes},
    {"tags_read", &HallwayResult::tags_read},
    {"tags_missed", &HallwayResult::tags_missed},
    {"turned_wrong", &HallwayResult::turned_wrong},
    {"blocked", &HallwayResult::blocked},
    {"went_round", &HallwayResult::went_round},
    {"shoved", &HallwayResult::shoved},
    {"explored", &HallwayResult::explored},
    {"places", &HallwayResult::places},
    {"map_differences", &HallwayResult::map_differences},
}};

constexpr std::array<Figure<PathResult>, 16> kPathFigures{{
    {"rmse_m", &PathResult::rmse_m},
    {"rmse_first_half_m", &PathResult::rmse_first_half_m},
    {"rmse_second_half_m", &PathResult::rmse_second_half_m},
    {"error_min_m", &PathResult::error_min_m},
    {"error_max_m", &PathResult::error_max_m},
    {"off_path_max_m", &PathResult::off_path_max_m},
    {"arrived", &PathResult::arrived},
    {"tags_reached", &PathResult::tags_reached},
    {"tags_skipped", &PathResult::tags_skipped},
    {"minutes", &PathResult::minutes},
    {"time_to_first_s", &PathResult::time_to_first_s},
    {"metres", &PathResult::metres},
    {"end_error_m", &PathResult::end_error_m},
    {"wall_contacts", &PathResult::wall_contacts},
    {"uhf_reads", &PathResult::uhf_reads},
    {"uhf_faults", &PathResult::uhf_faults},
}};

constexpr std::array<Figure<BoundResult>, 3> kBoundFigures{{
    {"bound_m", &BoundResult::bound_m},
    {"bound_first_half_m", &BoundResult::bound_first_half_m},
    {"bound_second_half_m", &BoundResult::bound_second_half_m},
}};

constexpr std::array<Figure<LinkHealth>, 9> kLinkFigures{{
    {"roomba_frames", &LinkHealth::roomba_frames},
    {"roomba_frames_corrupt", &LinkHealth::roomba_frames_corrupt},
    {"roomba_frames_missed", &LinkHealth::roomba_frames_missed},
    {"roomba_watchdog_stops", &LinkHealth::roomba_watchdog_stops},
    {"card_exchanges", &LinkHealth::card_exchanges},
    {"card_exchanges_failed", &LinkHealth::card_exchanges_failed},
    {"card_writes_repeated", &LinkHealth::card_writes_repeated},
    {"compass_sentences", &LinkHealth::compass_sentences},
    {"compass_sentences_corrupt", &LinkHealth::compass_sentences_corrupt},
}};

constexpr std::string_view kSimulatedTime = "sim_s";

Json number(double value) {
  if (!std::isfinite(value)) {
    return nullptr;
  }
  const double rounded = std::abs(value) < 1e9 ? std::nearbyint(value * 1e6) / 1e6 : value;
  return rounded == 0.0 ? 0.0 : rounded;  // never -0.0
}
Json number(std::int64_t value) {
  return value;
}
Json limit(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

template <class Owner, std::size_t N>
void put_figures(Json& into, const Owner& owner, const std::array<Figure<Owner>, N>& figures) {
  for (const auto& figure : figures) {
    into[std::string{figure.name}] = std::visit(
        [&](auto member) {
          if constexpr (std::is_same_v<decltype(member), double Owner::*>) {
            return number(owner.*member);
          } else {
            return number(std::int64_t{owner.*member});
          }
        },
        figure.member);
  }
}

template <class Owner, std::size_t N>
void put_figures(Figures& into, const Owner& owner, const std::array<Figure<Owner>, N>& figures) {
  for (const auto& figure : figures) {
    into[std::string{figure.name}] =
        std::visit([&](auto member) { return static_cast<double>(owner.*member); }, figure.member);
  }
}

std::string text_of(const Json& json) {
  // Broken UTF-8 in a scene's file name must not make the summary fail.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string_view verdict_of(const Summary& summary) {
  if (summary.interrupted) {
    return "interrupted";
  }
  const bool all_ok =
      std::all_of(summary.expect.begin(), summary.expect.end(), [](const auto& e) { return e.ok; });
  return all_ok ? "accepted" : "not_accepted";
}

Figures figures_of(const Summary& summary) {
  Figures figures;
  figures[std::string{kSimulatedTime}] = summary.sim_s;
  put_figures(figures, summary.links, kLinkFigures);
  if (summary.map) {
    put_figures(figures, *summary.map, kMapFigures);
  }
  if (summary.path) {
    put_figures(figures, *summary.path, kPathFigures);
    if (summary.path->bound) {
      put_figures(figures, *summary.path->bound, kBoundFigures);
    }
  }
  if (summary.hallway) {
    put_figures(figures, *summary.hallway, kHallwayFigures);
  }
  return figures;
}

std::vector<std::string> figure_names() {
  Summary every_section;
  every_section.map.emplace();
  every_section.path.emplace().bound.emplace();
  every_section.hallway.emplace();
  std::vector<std::string> names;
  for (const auto& [name, value] : figures_of(every_section)) {
    names.push_back(name);
  }
  return names;
}

std::optional<std::string> complain_about(const std::vector<FigureLimits>& expectations) {
  const std::vector<std::string> names = figure_names();
  for (const FigureLimits& expectation : expectations) {
    if (!std::binary_search(names.begin(), names.end(), expectation.name)) {
      std::string text = "expect: no figure is called '" + expectation.name + "'; there are ";
      for (const std::string& name : names) {
        text += name + (&name == &names.back() ? "" : ", ");
      }
      return text;
    }
  }
  return std::nullopt;
}

std::vector<JudgedFigure> judge(const std::vector<FigureLimits>& expectations, const Figures& figures) {
  std::vector<JudgedFigure> judged;
  for (const FigureLimits& asked : expectations) {
    const auto figure = figures.find(asked.name);
    const double value = figure == figures.end() ? std::numeric_limits<double>::quiet_NaN() : figure->second;
    const bool ok =
        std::isfinite(value) && (!asked.min || value >= *asked.min) && (!asked.max || value <= *asked.max);
    judged.push_back({asked, value, ok});
  }
  return judged;
}

std::string to_json(const Summary& summary) {
  Json json;
  json["scene"] = summary.scene;
  if (!summary.variant.empty()) {
    json["variant"] = summary.variant;
  }
  json["seed"] = summary.seed;
  json["verdict"] = verdict_of(summary);
  json["expect"] = Json::array();
  for (const JudgedFigure& e : summary.expect) {
    json["expect"].push_back(Json{{"name", e.asked.name},
                                  {"value", number(e.value)},
                                  {"min", limit(e.asked.min)},
                                  {"max", limit(e.asked.max)},
                                  {"ok", e.ok}});
  }
  json["state_hash"] = summary.state_hash;
  json["sim_s"] = number(summary.sim_s);
  if (summary.map) {
    json["map"]["explorer"] = summary.map->explorer;
    put_figures(json["map"], *summary.map, kMapFigures);
  }
  if (summary.path) {
    json["path"]["controller"] = summary.path->controller;
    put_figures(json["path"], *summary.path, kPathFigures);
    if (summary.path->bound) {
      put_figures(json["path"], *summary.path->bound, kBoundFigures);
    }
  }
  if (summary.hallway) {
    json["hallway"]["mission"] = summary.hallway->mission;
    put_figures(json["hallway"], *summary.hallway, kHallwayFigures);
  }
  put_figures(json["links"], summary.links, kLinkFigures);
  return text_of(json);
}

std::string to_json(const Timing& timing) {
  const Json json{
      {"sim_s", number(timing.sim_s)},
      {"wall_s", number(timing.wall_s)},
      {"rtf", number(timing.wall_s > 0.0 ? timing.sim_s / timing.wall_s : 0.0)},
      {"split",
       {{"physics_s", number(timing.physics_s)},
        {"devices_s", number(timing.devices_s)},
        {"controller_s", number(timing.controller_s)},
        {"log_s", number(timing.log_s)},
        {"render_s", number(timing.render_s)}}},
  };
  return text_of(json);
}

}  // namespace sensotwin::twin
