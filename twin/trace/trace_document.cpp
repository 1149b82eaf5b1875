// SPDX-License-Identifier: MIT
#include "twin/trace/trace_document.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "twin/trace/trace_error.hpp"

namespace sensotwin::twin {
namespace {

[[noreturn]] void refuse(std::string what) {
  throw TraceError(TraceError::kBadRequest, "the page's document " + std::move(what));
}

const Json& section(const Json& document, const char* key) {
  const auto found = document.find(key);
  if (found == document.end() || !found->is_object()) {
    refuse(fmt::format("has no section '{}'", key));
  }
  return *found;
}

std::string text_in(const Json& values, const char* key) {
  const auto found = values.find(key);
  return found != values.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

/// Copies keys that are there; readers judge their values.
void copy(const Json& from, std::initializer_list<const char*> keys, Json& into) {
  for (const char* key : keys) {
    if (const auto found = from.find(key); found != from.end() && !found->is_null()) {
      into[key] = *found;
    }
  }
}

/// Hard floor without a pile that drags sideways, as the published scenes of hallways and ceiling tags have.
Json hard_floor() {
  return {{"nap_drift", 0}, {"roughness", 0.003}, {"rolling_resistance", 0.01}};
}

Json walls_of(const Json& scene, const SceneNames& names) {
  const std::string walls = text_in(scene, "walls");
  if (walls == "room") {
    return {{"room", {{"walls_m", scene.value("room_m", Json::array())}}}};
  }
  if (walls == "hallways") {
    return {{"hallways", {{"file", names.hallways}}}};
  }
  Json map{{"map", {{"file", names.map}}}};
  if (!names.hallways.empty() && text_in(scene, "kind") == "hallway") {
    map["map"]["hallways"] = names.hallways;
  }
  return map;
}

void hallway_scene(const Json& scene, const Json& hallways, Json& text) {
  text["world"]["carpet"] = "none";
  text["world"]["floor"] = hard_floor();
  Json mission = Json::object();
  if (scene.value("survey", Json(false)) == true) {
    mission["survey"] = true;
  } else {
    copy(scene, {"from", "to"}, mission);
  }
  text["mission"]["hallway"] = std::move(mission);
  text["expect"] = {{"arrived", {{"min", 1}}}, {"wall_contacts", {{"max", 0}}}};
  const auto north = hallways.find("north_deg");
  if (north != hallways.end() && north->is_number() && *north != 0) {
    // The plan's north is +y; magnetic north lies clockwise of it by as much.
    text["world"]["north_deg"] = 90.0 - north->get<double>();
  }
}

void carpet_scene(const Json& scene, Json& text) {
  Json carpet = Json::object();
  const auto laid = scene.find("carpet");
  if (laid != scene.end() && laid->is_object()) {
    copy(*laid, {"tile_m", "origin_m", "region_m", "without", "unreadable"}, carpet);
  }
  text["world"]["carpet"] = std::move(carpet);
  Json map = Json::object();
  copy(scene, {"explorer"}, map);
  text["mission"]["map"] = std::move(map);
  text["expect"] = {{"tiles_wrong", {{"max", 0}}}};
}

void ceiling_scene(const Json& scene, Json& text) {
  text["world"]["carpet"] = "none";
  text["world"]["floor"] = hard_floor();
  Json tags = Json::array();
  const auto given = scene.find("ceiling_tags");
  if (given != scene.end() && given->is_array()) {
    for (const Json& tag : *given) {
      Json one = Json::object();
      if (tag.is_object()) {
        copy(tag, {"name", "at_m", "height_m"}, one);
      }
      tags.push_back(std::move(one));
    }
  }
  text["world"]["ceiling_tags"] = std::move(tags);
  text["world"]["radio"] = {{"profile", scene.value("radio", Json("paper"))}};
  Json phase = Json::object();
  copy(scene, {"controller"}, phase);
  text["mission"]["phase"] = std::move(phase);
  text["expect"] = {{"arrived", {{"min", 1}}}};
}

Json named_places(const Json& hallways) {
  const auto places = hallways.find("places");
  if (places == hallways.end() || !places->is_array()) {
    refuse("has no list of places");
  }
  if (places->size() > kPlacesMax) {
    throw TraceError(TraceError::kTooLarge, fmt::format("more than {} places", kPlacesMax));
  }
  for (const Json& place : *places) {
    if (!place.is_object() || !place.contains("name") || !place["name"].is_string()) {
      refuse("has a place without a name");
    }
  }
  return *places;
}

/// Checks the depth before a recursion meets it.
Json parsed(const std::string& body) {
  const auto shallow = [](int depth, nlohmann::detail::parse_event_t, const Json&) {
    if (depth > kJsonDepthMax) {
      refuse("is nested too deep");
    }
    return true;
  };
  Json document = Json::parse(body, shallow, false);
  if (document.is_discarded() || !document.is_object()) {
    refuse("is no JSON object");
  }
  return document;
}

}  // namespace

Json document_from(const std::string& body) {
  return parsed(body);
}

std::string hallway_text(const Json& document) {
  const Json& hallways = section(document, "hallways");
  const Json places = named_places(hallways);
  std::string text;
  Json head = Json::object();
  for (const auto& [key, value] : hallways.items()) {
    if (key != "places") {
      head[key] = value;
    }
  }
  text = yaml_of(head) + "places:" + (places.empty() ? " {}\n" : "\n");
  // One by one: a name that is there twice is the reader's to refuse, and a JSON object would lose it.
  for (Json place : places) {
    const std::string name = place["name"];
    place.erase("name");
    std::string lines = yaml_of({{"places", {{name, place}}}});
    text += lines.substr(lines.find('\n') + 1);
  }
  return text;
}

Json hallways_from(const std::string& text) {
  std::vector<robot::Problem> problems;
  Json hallways = json_of(robot::parse_yaml(text, "", problems));
  Json places = Json::array();
  if (const auto found = hallways.find("places"); found != hallways.end() && found->is_object()) {
    for (const auto& [name, place] : found->items()) {
      Json one{{"name", name}};
      if (place.is_object()) {
        one.update(place);
      }
      places.push_back(std::move(one));
    }
  }
  hallways["places"] = std::move(places);
  return hallways;
}

std::string scene_text(const Json& document, const SceneNames& names) {
  const Json& scene = section(document, "scene");
  const std::string kind = text_in(scene, "kind");
  Json text{{"version", 1}, {"seed", scene.value("seed", Json(1))}};
  text["title"] = scene.value("title", Json("Traced"));
  text["world"] = walls_of(scene, names);
  if (const auto start = scene.find("start"); start != scene.end() && start->is_object()) {
    Json pose = Json::object();
    copy(*start, {"at_m", "heading_deg"}, pose);
    text["robot"]["start"] = std::move(pose);
  }
  if (kind == "hallway") {
    hallway_scene(scene, section(document, "hallways"), text);
  } else if (kind == "carpet") {
    carpet_scene(scene, text);
  } else if (kind == "ceiling") {
    ceiling_scene(scene, text);
  } else {
    refuse(fmt::format("knows no scenes of the kind '{}'", kind));
  }
  copy(scene, {"time_limit_s"}, text);
  return "# Drawn with twin trace.\n" + yaml_of(text);
}

Json plan_json(const PlanPicture& plan, const std::string& id) {
  return {{"id", id},
          {"name", plan.name},
          {"width_px", plan.columns},
          {"height_px", plan.rows},
          {"resolution_m", plan.resolution_m},
          {"scaled", plan.scaled},
          {"origin", {plan.X_WO.p_m.x(), plan.X_WO.p_m.y(), plan.X_WO.yaw_rad}},
          {"negate", plan.negate},
          {"occupied_thresh", plan.occupied_thresh},
          {"free_thresh", plan.free_thresh}};
}

void take_placement(PlanPicture& plan, const Json& placement) {
  const auto number = [&](const Json& value, double min, double max, const char* what) {
    const double found = value.is_number() ? value.get<double>() : std::nan("");
    if (!(found >= min && found <= max)) {
      refuse(fmt::format("has a plan whose {} is not from {} to {}", what, min, max));
    }
    return found;
  };
  const auto key = [&](const char* name) { return placement.value(name, Json()); };
  // Chosen: from a scan of a model railway to a satellite's picture.
  plan.resolution_m = number(key("resolution_m"), 1e-4, 10.0, "resolution_m");
  const Json origin = key("origin");
  if (!origin.is_array() || origin.size() != 3) {
    refuse("has a plan without origin: [x, y, yaw]");
  }
  plan.X_WO = {{number(origin[0], -1e5, 1e5, "origin"), number(origin[1], -1e5, 1e5, "origin")},
               robot::wrap_angle(number(origin[2], -100.0, 100.0, "origin's yaw"))};
  plan.scaled = key("scaled") == true;
  plan.negate = key("negate") == true;
  plan.free_thresh = number(key("free_thresh"), 0.0, 1.0, "free_thresh");
  plan.occupied_thresh = number(key("occupied_thresh"), plan.free_thresh, 1.0, "occupied_thresh");
}

}  // namespace sensotwin::twin
