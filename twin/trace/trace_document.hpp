// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "twin/trace/json_yaml.hpp"
#include "twin/trace/plan_picture.hpp"

/// The page's document, and the files that it stands for.
///
///     { "tracing": 1,
///       "plan": { "id", "name", "width_px", "height_px", "resolution_m", "scaled", "origin": [x, y, yaw],
///                 "negate", "occupied_thresh", "free_thresh" } or null,
///       "hallways": { "version": 1, "north_deg", ..., "places": [ { "name", "at_m", "N": {...} ... } ] },
///       "scene": { "kind": "hallway" | "carpet" | "ceiling", ... } }
///
/// `hallways` is a hallway map (robot/settings/hallway_file.hpp) key for key, except that places are a list:
/// a list keeps its order and may hold a name twice while somebody is typing.
namespace sensotwin::twin {

/// Chosen: a hundred floors of an office; more is a mistake, and checks compare every two hallways.
inline constexpr std::size_t kPlacesMax = 2000;

/// \throws TraceError kBadRequest: no JSON, nested too deep, or not such a document; kTooLarge
[[nodiscard]] Json document_from(const std::string& body);

/// The hallway map of a document as YAML that read_hallway_text() judges. \throws TraceError kBadRequest
[[nodiscard]] std::string hallway_text(const Json& document);

/// A hallway map's YAML as the document's `hallways`, keys that we do not know included. \pre text is YAML
[[nodiscard]] Json hallways_from(const std::string& text);

/// What a scene refers to, by the names that its files have beside it.
struct SceneNames {
  std::string hallways;  ///< of the hallway map; empty: it has no places
  std::string map;       ///< of the plan as a map_server map; empty: there is no plan
};

/// The scene of a document as YAML that read_scene_text() judges. \throws TraceError kBadRequest
[[nodiscard]] std::string scene_text(const Json& document, const SceneNames& names);

/// As the page spells a plan. \param id  by which it asks for the picture
[[nodiscard]] Json plan_json(const PlanPicture& plan, const std::string& id);
/// What the page says of the scale and place of a picture that we hold. \throws TraceError kBadRequest
void take_placement(PlanPicture& plan, const Json& placement);

}  // namespace sensotwin::twin
