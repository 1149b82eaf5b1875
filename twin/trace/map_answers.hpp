// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "robot/config/problem.hpp"
#include "robot/settings/hallway_file.hpp"
#include "twin/trace/json_yaml.hpp"

/// What the page is told about a hallway map: by the reader and the planner that the robot uses.
namespace sensotwin::twin {

struct JudgedMap {
  std::optional<robot::HallwayFile> file;  ///< none: it has problems
  std::vector<robot::Problem> problems;
};
/// \throws TraceError
[[nodiscard]] JudgedMap judged_map(const Json& document);

/// { sound, problems: [{ level, place, side, path, what, hint }], text }. \throws TraceError
[[nodiscard]] Json check_answer(const Json& document);

/// As check_answer() lists them. \param document  whose places the paths are looked up in
[[nodiscard]] Json problems_json(const std::vector<robot::Problem>& problems, const Json& document);

/// { found, steps: [{ from, exit, to, length_m }], words, cost, by_length } or { found: false, reason }.
/// \throws TraceError kUnusable: the map has problems, or there is no such place or tag
[[nodiscard]] Json route_answer(const Json& request);

/// { sound, problems, start, tiles ... } of a scene file and what lies beside it.
[[nodiscard]] Json scene_answer(const std::string& text, const std::filesystem::path& file,
                                const Json& document);

}  // namespace sensotwin::twin
