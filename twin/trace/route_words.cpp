// SPDX-License-Identifier: MIT
#include "twin/trace/route_words.hpp"

#include <fmt/format.h>

#include <charconv>

namespace sensotwin::twin {
namespace {

/// As the hallway file spells it (robot/settings/hallway_file.hpp).
std::string tag_words(const std::vector<robot::TagNumber>& tags) {
  std::string words;
  for (const robot::TagNumber tag : tags) {
    const bool uid = tag >= 0xE000000000000000u;
    words += (words.empty() ? "" : ", ") + (uid ? fmt::format("{:016X}", tag) : fmt::format("{}", tag));
  }
  return words;
}

std::optional<robot::TagNumber> tag_from(const std::string& text) {
  robot::TagNumber tag = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, tag, text.size() == 16 ? 16 : 10);
  return error == std::errc{} && stop == end ? std::optional{tag} : std::nullopt;
}

const char* turn_words(int quarter_turns_right) {
  switch (quarter_turns_right) {
    case 1:
      return "Turn right and go";
    case -1:
      return "Turn left and go";
    case 2:
      return "Turn round and go";
    default:
      return "Go straight on";
  }
}

}  // namespace

std::optional<RouteStart> route_start(const robot::HallwayMap& map, const std::string& text) {
  if (const auto node = map.find(text)) {
    return RouteStart{*node, std::nullopt, fmt::format("Start at {}.", text)};
  }
  const auto tag = tag_from(text);
  const auto arrival = tag ? map.place_of(*tag) : std::nullopt;
  if (!arrival) {
    return std::nullopt;
  }
  return RouteStart{arrival->node, arrival->from,
                    fmt::format("Tag {}: at {}, having come in from the {}.", text,
                                map.node(arrival->node).name, robot::name_of(arrival->from))};
}

std::vector<std::string> route_words(const robot::HallwayMap& map, const RouteStart& start,
                                     const robot::HallwayRoute& route) {
  std::vector<std::string> words;
  std::optional<robot::CompassPoint> came_from = start.came_from;
  for (const robot::RouteStep& step : route.steps) {
    std::string line = came_from ? turn_words(robot::turn_at(*came_from, step.exit)) : "Go";
    line += fmt::format(" {}", robot::name_of(step.exit));
    const robot::Side& out = map.node(step.from).side(step.exit);
    if (out.length_m) {
      line += fmt::format(" {:.1f} m", *out.length_m);
    }
    line += fmt::format(" to {}", map.node(step.to).name);
    came_from = robot::opposite(step.exit);
    const auto& tags = map.node(step.to).side(*came_from).tags;
    line += tags.empty() ? " (no tag: look for the junction)" : fmt::format(" (tag {})", tag_words(tags));
    words.push_back(std::move(line));
  }
  return words;
}

}  // namespace sensotwin::twin
