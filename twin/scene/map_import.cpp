// SPDX-License-Identifier: MIT
#include "twin/scene/map_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "robot/config/text_file.hpp"
#include "robot/config/yaml_tree.hpp"
#include "twin/scene/picture_file.hpp"

namespace sensotwin::twin {
namespace {

/// The YAML half of a map. A foreign file: keys we do not know are passed over, as map_server does, and
/// numbers may be written in any way that strtod reads.
class MapYaml {
 public:
  MapYaml(const robot::YamlNode& root, std::vector<robot::Problem>& problems)
      : root_(root), problems_(problems) {}

  struct Bounds {
    double min;
    double max;
    const char* expected;
  };

  [[nodiscard]] const robot::YamlNode* find(const std::string& key, const std::string& expected) {
    const robot::YamlEntry* entry = root_.find(key);
    if (entry == nullptr) {
      problems_.push_back({{root_.place.source, 1, 1}, key, "is missing", "expected " + expected});
    }
    return entry == nullptr ? nullptr : &entry->value;
  }
  double number(const std::string& key, const Bounds& bounds) {
    const robot::YamlNode* node = find(key, bounds.expected);
    return node == nullptr ? bounds.max : number_in(*node, key, bounds);
  }
  double number_in(const robot::YamlNode& node, const std::string& path, const Bounds& bounds) {
    const std::string& text =
        node.text.starts_with(".n") || node.text.starts_with(".N") ? node.text.substr(1) : node.text;
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool scalar =
        node.kind == robot::YamlKind::kNumber || (node.kind == robot::YamlKind::kText && !node.quoted);
    const bool number = scalar && !text.empty() && *end == '\0';
    if (!number || !std::isfinite(value) || value < bounds.min || value > bounds.max) {
      problems_.push_back(
          {node.place, path, "is " + node.describe(), std::string("expected ") + bounds.expected});
      return bounds.max;
    }
    return value;
  }
  robot::Pose2 origin() {
    const robot::YamlNode* node = find("origin", "[x, y, yaw] of the picture's lower left corner, m and rad");
    if (node == nullptr) {
      return {};
    }
    if (node->kind != robot::YamlKind::kList || node->items.size() != 3) {
      problems_.push_back({node->place, "origin", "is " + node->describe(),
                           "expected [x, y, yaw] of the picture's lower left corner, m and rad"});
      return {};
    }
    // Chosen: the reader of scenes takes 1 km each way; maps in UTM coordinates do not fit the physics'
    // floats.
    const Bounds place{-1000.0, 1000.0, "a finite number from -1000 to 1000 (m)"};
    const Bounds yaw{-1000.0, 1000.0, "a finite number (rad)"};
    return {{number_in(node->items[0], "origin[0]", place), number_in(node->items[1], "origin[1]", place)},
            robot::wrap_angle(number_in(node->items[2], "origin[2]", yaw))};
  }
  bool negate() {
    const robot::YamlEntry* entry = root_.find("negate");
    const std::string text = entry == nullptr ? "0" : entry->value.text;
    if (text != "0" && text != "1" && text != "true" && text != "false") {
      problems_.push_back({entry->value.place, "negate", "is " + entry->value.describe(), "expected 0 or 1"});
    }
    return text == "1" || text == "true";
  }
  void mode() {
    const robot::YamlEntry* entry = root_.find("mode");
    if (entry == nullptr || entry->value.text == "trinary" || entry->value.text == "scale") {
      return;
    }
    problems_.push_back({entry->value.place, "mode", "is " + entry->value.describe(),
                         "expected trinary or scale (raw holds no walls that we could tell)"});
  }

 private:
  const robot::YamlNode& root_;
  std::vector<robot::Problem>& problems_;
};

struct Thresholds {
  double occupied;
  double free;
  bool negate;
};

Cell classify(std::uint16_t grey, const Thresholds& thresholds) {
  if (grey == GreyPicture::kClear) {
    return Cell::kUnknown;
  }
  const double light = static_cast<double>(grey) / GreyPicture::kWhite;
  const double p = thresholds.negate ? light : 1.0 - light;
  return p > thresholds.occupied ? Cell::kOccupied : p < thresholds.free ? Cell::kFree : Cell::kUnknown;
}

std::vector<Cell> cells_from_bottom(const GreyPicture& picture, const Thresholds& thresholds) {
  std::vector<Cell> cells;
  cells.reserve(picture.pixels.size());
  const auto columns = static_cast<std::size_t>(picture.columns);
  for (std::size_t row = static_cast<std::size_t>(picture.rows); row-- > 0;) {
    for (std::size_t column = 0; column < columns; ++column) {
      cells.push_back(classify(picture.pixels[row * columns + column], thresholds));
    }
  }
  return cells;
}

GreyPicture read_picture(const std::filesystem::path& map_yaml, const robot::YamlNode& image) {
  const std::filesystem::path file = map_yaml.parent_path() / image.text;
  try {
    auto picture = decode_picture(robot::read_text_file(file, "picture"));
    if (!picture) {
      throw robot::LoadError({{image.place, "image", fmt::format("{} {}", file.string(), picture.error()),
                               "expected a whole PGM or PNG"}},
                             robot::kExitInvalid);
    }
    return std::move(*picture);
  } catch (const robot::LoadError& error) {
    const robot::Problem& first = error.problems().front();
    if (first.path == "image") {
      throw;
    }
    throw robot::LoadError(
        {{image.place, "image", fmt::format("{}: {}", file.string(), first.what), first.hint}},
        error.exit_code());
  }
}

}  // namespace

Cell OccupancyMap::at(int column, int row) const {
  if (column < 0 || row < 0 || column >= columns || row >= rows) {
    return Cell::kUnknown;
  }
  return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column)];
}

Cell OccupancyMap::at(const robot::Vec2& p_W) const {
  const robot::Vec2 p_O = X_WO.inverse() * p_W / resolution_m;
  // Far outside, a cell number would not fit an int.
  if (!(p_O.cwiseAbs().maxCoeff() < 1.0e9)) {
    return Cell::kUnknown;
  }
  return at(static_cast<int>(std::floor(p_O.x())), static_cast<int>(std::floor(p_O.y())));
}

std::size_t OccupancyMap::count(Cell kind) const {
  return static_cast<std::size_t>(std::count(cells.begin(), cells.end(), kind));
}

OccupancyMap read_map(const std::filesystem::path& map_yaml) {
  const std::string source = map_yaml.string();
  std::vector<robot::Problem> problems;
  const robot::YamlNode root = robot::parse_yaml(robot::read_text_file(map_yaml, "map"), source, problems);
  if (problems.empty() && root.kind != robot::YamlKind::kSection) {
    problems.push_back(
        {{source, 1, 1}, "", "is " + root.describe(), "expected the keys of a map_server map"});
  }
  if (!problems.empty()) {
    throw robot::LoadError(std::move(problems), robot::kExitInvalid);
  }
  MapYaml yaml(root, problems);
  OccupancyMap map;
  const robot::YamlNode* image = yaml.find("image", "the picture's file, relative to this one");
  // Chosen: from a centimetre, since the physics merges corners 5 mm apart, to cells larger than the robot.
  map.resolution_m = yaml.number("resolution", {0.01, 1.0, "metres a cell, from 0.01 to 1"});
  map.X_WO = yaml.origin();
  const Thresholds thresholds{yaml.number("occupied_thresh", {0.0, 1.0, "a number from 0 to 1"}),
                              yaml.number("free_thresh", {0.0, 1.0, "a number from 0 to 1"}), yaml.negate()};
  yaml.mode();
  if (image != nullptr && image->kind != robot::YamlKind::kText) {
    problems.push_back({image->place, "image", "is " + image->describe(), "expected the picture's file"});
  }
  if (problems.empty() && thresholds.free > thresholds.occupied) {
    problems.push_back({root.find("free_thresh")->value.place, "free_thresh", "is above occupied_thresh",
                        "a cell would be free and occupied"});
  }
  if (!problems.empty()) {
    throw robot::LoadError(std::move(problems), robot::kExitInvalid);
  }
  const GreyPicture picture = read_picture(map_yaml, *image);
  map.columns = picture.columns;
  map.rows = picture.rows;
  map.cells = cells_from_bottom(picture, thresholds);
  return map;
}

MapCounts counts(const OccupancyMap& map, const std::vector<world::Wall>& walls) {
  MapCounts result;
  result.free_m2 = static_cast<double>(map.count(Cell::kFree)) * map.resolution_m * map.resolution_m;
  result.occupied_cells = map.count(Cell::kOccupied);
  result.unknown_cells = map.count(Cell::kUnknown);
  result.outlines = walls.size();
  for (const world::Wall& wall : walls) {
    result.segments += wall.points_m.size();
  }
  return result;
}

}  // namespace sensotwin::twin
