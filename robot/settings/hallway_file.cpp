// SPDX-License-Identifier: MIT
#include "robot/settings/hallway_file.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/config/field_reader.hpp"
#include "robot/config/field_writer.hpp"
#include "robot/config/nearest_name.hpp"
#include "robot/config/text_file.hpp"
#include "robot/config/yaml_tree.hpp"

namespace sensotwin::robot {
namespace {

constexpr std::string_view kUnknown = "?";
constexpr std::size_t kUidDigits = 16;

/// One side as the file says it.
struct SideText {
  std::string to;
  std::optional<double> length_m;
  std::vector<std::string> tags;
  std::optional<double> bearing_rad;  ///< clockwise from the plan's north, as on a compass
  std::optional<double> tag_m;
};
struct PlaceText {
  std::string name;
  std::optional<Vec2> at_m;
  std::array<std::optional<SideText>, kCompassPoints.size()> sides;
};

std::string key_of(CompassPoint point) {
  return {letter_of(point)};
}

std::optional<TagNumber> tag_from(const std::string& text) {
  const int base = text.size() == kUidDigits ? 16 : 10;
  TagNumber tag = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, tag, base);
  return error == std::errc{} && stop == end ? std::optional{tag} : std::nullopt;
}

/// 16 hexadecimal digits for what cannot be told from them otherwise, decimal ones for the rest.
std::string tag_text(TagNumber tag) {
  constexpr TagNumber kLeastUid = 0xE000000000000000u;
  return tag >= kLeastUid ? fmt::format("{:016X}", tag) : fmt::format("{}", tag);
}

void side_fields(FieldVisitor& v, SideText& side) {
  v.text({"to", "the place at the other end, or ? when nobody knows", true}, side.to);
  v.maybe({"length_m", "from middle to middle, m"}, side.length_m, [&](double& length_m) {
    v.number({"length_m", "from middle to middle, m"}, length_m, {0.0, 10000.0, true});
  });
  v.texts({"tags", "met on coming to this place from this side"}, side.tags, {0, 100});
  const Field bearing{"bearing_deg", "in which it leaves, clockwise from the plan's north"};
  v.maybe(bearing, side.bearing_rad, [&](double& bearing_rad) {
    v.angle(bearing, bearing_rad, {-180.0, 360.0});
  });
  const Field tag{"tag_m", "from these tags to the middle of the place, m"};
  v.maybe(tag, side.tag_m, [&](double& tag_m) { v.number(tag, tag_m, {0.1, 10.0}); });
}

void place_fields(FieldVisitor& v, PlaceText& place) {
  v.maybe({"at_m", "on the plan, x east and y north, m"}, place.at_m, [&](Vec2& at_m) {
    v.point({"at_m", "on the plan, x east and y north, m"}, at_m, {-100000.0, 100000.0});
  });
  for (const CompassPoint point : kCompassPoints) {
    const std::string key = key_of(point);
    const Field field{key, "the hallway on this side; left out: none"};
    std::optional<SideText>& side = place.sides[static_cast<std::size_t>(point)];
    v.maybe(field, side, [&](SideText& text) { v.section(field, [&] { side_fields(v, text); }); });
  }
}

void visit_fields(FieldVisitor& v, HallwayFile& file, std::vector<PlaceText>& places) {
  v.whole({"version", "of this file format: 1", true}, file.version, 1, 1);
  v.angle({"north_deg", "the plan's north, counter-clockwise from magnetic north"}, file.north_rad,
          {-180.0, 180.0});
  v.number({"width_m", "of the hallways, m"}, file.width_m, {0.5, 10.0});
  v.number({"tag_to_middle_m", "from a tag to the middle of its place, m"}, file.tag_to_middle_m,
           {0.1, 10.0});
  v.number({"tag_reach_m", "a tag is read within this, m"}, file.tag_reach_m, {0.01, 2.0});
  v.named(
      {"places", "intersections, junctions, bends and ends, by name", true}, places.size(),
      [&](std::size_t i) { return places[i].name; },
      [&](const std::string& name) {
        places.push_back({name, std::nullopt, {}});
        return places.size() - 1;
      },
      [&](std::size_t i) { place_fields(v, places[i]); });
}

/// Names and numbers in the texts; what they do not name is a problem.
class MapMaker {
 public:
  MapMaker(const std::vector<PlaceText>& places, const FieldReader& reader, const std::string& section,
           std::vector<Problem>& problems)
      : places_(places), reader_(reader), section_(section), problems_(problems) {
    for (const PlaceText& place : places) {
      index_.emplace(place.name, names_.size());
      names_.push_back(place.name);
    }
  }

  HallwayMap map() {
    std::vector<HallwayNode> nodes;
    for (const PlaceText& place : places_) {
      HallwayNode node;
      node.name = place.name;
      node.at_m = place.at_m;
      for (const CompassPoint point : kCompassPoints) {
        if (const auto& text = place.sides[static_cast<std::size_t>(point)]) {
          node.side(point) = side(*text, section_ + "places." + place.name + "." + key_of(point));
        }
      }
      nodes.push_back(std::move(node));
    }
    return HallwayMap::from_nodes(std::move(nodes));
  }

 private:
  Side side(const SideText& text, const std::string& path) {
    Side side;
    side.hallway = Hallway::kUnknown;
    side.length_m = text.length_m;
    if (text.bearing_rad) {
      side.bearing_rad = wrap_angle(-*text.bearing_rad);
    }
    side.tag_m = text.tag_m;
    if (text.to != kUnknown) {
      const auto found = index_.find(text.to);
      if (found == index_.end()) {
        add(path + ".to", fmt::format("there is no place '{}'{}", text.to, did_you_mean(text.to, names_)),
            "expected a name under places, or \"?\"");
      } else {
        side.hallway = Hallway::kLeadsTo;
        side.to = found->second;
      }
    }
    for (const std::string& tag : text.tags) {
      if (const std::optional<TagNumber> number = tag_from(tag)) {
        side.tags.push_back(*number);
      } else {
        add(path + ".tags", fmt::format("'{}' is no tag", tag),
            "expected decimal digits, or 16 hexadecimal ones");
      }
    }
    return side;
  }
  void add(const std::string& path, std::string what, std::string hint) {
    problems_.push_back({reader_.place(path), path, std::move(what), std::move(hint)});
  }

  const std::vector<PlaceText>& places_;
  const FieldReader& reader_;
  const std::string& section_;
  std::vector<Problem>& problems_;
  std::vector<std::string> names_;
  std::map<std::string, std::size_t> index_;
};

PlaceText text_of(const HallwayNode& node, const HallwayMap& map) {
  PlaceText place{node.name, node.at_m, {}};
  for (const CompassPoint point : kCompassPoints) {
    const Side& side = node.side(point);
    if (side.hallway == Hallway::kNone) {
      continue;
    }
    SideText text{side.hallway == Hallway::kUnknown ? std::string{kUnknown} : map.node(side.to).name,
                  side.length_m,
                  {},
                  {},
                  side.tag_m};
    if (side.bearing_rad) {
      // As compasses say it, from 0 to 360.
      const double clockwise_rad = wrap_angle(-*side.bearing_rad);
      text.bearing_rad = clockwise_rad < 0.0 ? clockwise_rad + 2.0 * kPi : clockwise_rad;
    }
    for (const TagNumber tag : side.tags) {
      text.tags.push_back(tag_text(tag));
    }
    place.sides[static_cast<std::size_t>(point)] = std::move(text);
  }
  return place;
}

}  // namespace

struct HallwayFields::Texts {
  HallwayFile head;  ///< all but the map
  std::vector<PlaceText> places;
};

HallwayFields::HallwayFields() : texts_(std::make_unique<Texts>()) {}

HallwayFields::HallwayFields(const HallwayFile& hallways) : HallwayFields() {
  texts_->head = {hallways.version,         hallways.north_rad,   hallways.width_m,
                  hallways.tag_to_middle_m, hallways.tag_reach_m, {}};
  for (const HallwayNode& node : hallways.map.nodes()) {
    texts_->places.push_back(text_of(node, hallways.map));
  }
}

HallwayFields::~HallwayFields() = default;

void HallwayFields::visit(FieldVisitor& v) {
  visit_fields(v, texts_->head, texts_->places);
}

HallwayFile HallwayFields::read(const FieldReader& reader, const std::string& section,
                                std::vector<Problem>& problems) const {
  HallwayFile hallways = texts_->head;
  hallways.map = MapMaker(texts_->places, reader, section, problems).map();
  if (problems.empty()) {
    for (const HallwayMapProblem& problem : hallways.map.check()) {
      const std::string path =
          section + "places." + problem.node + (problem.side ? "." + key_of(*problem.side) : "");
      problems.push_back({reader.place(path), path, problem.what, ""});
    }
  }
  return hallways;
}

HallwayFile read_hallway_file(const std::filesystem::path& file) {
  return read_hallway_text(read_text_file(file, "hallway map"), file);
}

HallwayFile read_hallway_text(const std::string& text, const std::filesystem::path& file) {
  std::vector<Problem> problems;
  const YamlNode root = parse_yaml(text, file.string(), problems);
  if (problems.empty() && root.kind != YamlKind::kSection) {
    problems.push_back(
        {{file.string(), 1, 1}, "", "is " + root.describe(), "expected keys: version, places"});
  }
  if (!problems.empty()) {
    throw LoadError(std::move(problems), kExitInvalid);
  }
  HallwayFields fields;
  FieldReader reader(root, problems);
  fields.visit(reader);
  reader.finish();
  HallwayFile hallways = fields.read(reader, "", problems);
  if (!problems.empty()) {
    throw LoadError(std::move(problems), kExitInvalid);
  }
  return hallways;
}

std::string hallway_yaml(const HallwayFile& hallways) {
  HallwayFields fields(hallways);
  FieldWriter writer;
  fields.visit(writer);
  return writer.text();
}

}  // namespace sensotwin::robot
