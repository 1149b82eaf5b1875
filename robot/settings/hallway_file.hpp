// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robot/config/field_reader.hpp"
#include "robot/config/field_visitor.hpp"
#include "robot/config/problem.hpp"
#include "robot/topology/hallway_config.hpp"
#include "robot/topology/hallway_map.hpp"

namespace sensotwin::robot {

/// A hallway map as it is kept: the "database of map information" of Tsukiyama, section 3.
///
///     version: 1
///     north_deg: 0            # the plan's north, counter-clockwise from magnetic north
///     width_m: 2              # of the hallways
///     tag_to_middle_m: 1      # from a tag to the middle of its place
///     tag_reach_m: 0.3        # a tag is read within this
///     places:
///       c:
///         at_m: [7, -6]       # x east, y north on the plan; may be left out
///         N: { to: d, length_m: 6, tags: ["6"] }      # met on coming to c from the north
///         W: { to: b, bearing_deg: 283, tag_m: 1.5 }  # leaves 13 degrees north of west; its tag's distance
///         E: { to: "?", tags: ["E004015012345678"] }  # nobody knows where it leads
///                             # no S: no hallway, the paper's "-"
///
/// A tag is its number on the plan, in decimal digits, or its unique number, 16 hexadecimal ones.
struct HallwayFile {
  int version{1};
  double north_rad{0.0};
  double width_m{HallwayConfig{}.hallway_width_m};
  double tag_to_middle_m{HallwayConfig{}.tag_to_middle_m};
  double tag_reach_m{HallwayConfig{}.tag_reach_m};
  HallwayMap map;
};

/// The fields of a hallway map: of a file of its own, or of a section in another one.
class HallwayFields {
 public:
  /// To be read into.
  HallwayFields();
  /// To be written.
  explicit HallwayFields(const HallwayFile& hallways);
  ~HallwayFields();
  HallwayFields(const HallwayFields&) = delete;
  HallwayFields& operator=(const HallwayFields&) = delete;

  void visit(FieldVisitor& v);
  /// After the reader's visit. What the texts name is looked up, and the map checked when nothing else is
  /// wrong. \param section  where the fields stand: "place.hallways.", or "" for a whole file
  [[nodiscard]] HallwayFile read(const FieldReader& reader, const std::string& section,
                                 std::vector<Problem>& problems) const;

 private:
  struct Texts;
  std::unique_ptr<Texts> texts_;
};

/// Reads strictly, and checks the map: every mistake in one pass, each with its place.
/// \throws LoadError
[[nodiscard]] HallwayFile read_hallway_file(const std::filesystem::path& file);
[[nodiscard]] HallwayFile read_hallway_text(const std::string& text, const std::filesystem::path& file);

/// Reads back to the same.
[[nodiscard]] std::string hallway_yaml(const HallwayFile& hallways);

}  // namespace sensotwin::robot
