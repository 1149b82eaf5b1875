// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robot/base/random.hpp"
#include "world/description.hpp"
#include "world/tag_memory.hpp"

namespace sensotwin::world {

enum class TagPlace : std::uint8_t { kCarpet, kLandmark, kFurniture, kFloor, kHallway };

/// Position of a tag in TagField::tags(): carpet tiles in the order of the scene, then landmarks, then
/// furniture, then floor tags below ceiling tags, then those of hallways. Never changes during a run.
using TagIndex = std::uint32_t;

struct Tag {
  TagPlace place{TagPlace::kCarpet};
  int column{0};  ///< carpet: its tile
  int row{0};
  std::uint32_t owner{0};  ///< landmark, furniture, ceiling tag above: index in the WorldDescription
  Vec2 p_OT_m{0.0, 0.0};   ///< furniture: in the piece's own frame
  Vec2 at_m{0.0, 0.0};     ///< in W, now
  bool readable{true};     ///< a dead tag never answers
  TagMemory memory{};
};

/// All tags of the world: where they are and what is in them.
///
/// A tag answers while the antenna's middle is within the read radius of it; of several, the nearest (the
/// field is strongest there). Left out: orientation, metal, collisions of several tags in one field.
///
/// Serial numbers and offsets come from streams forked by the tag's own name (tile, landmark, piece), so that
/// adding one tag changes no other. Landmarks hold SensoBot's Table 1 in block 0, furniture FF there and
/// Table 2 in block 1; carpet tags are blank. A floor tag below a ceiling tag holds that one's EPC in blocks
/// 0 to 2: the arrival test of Gueaieb & Miah, section III.
class TagField {
 public:
  TagField(const WorldDescription& world, const robot::RandomStream& random);

  [[nodiscard]] std::span<const Tag> tags() const { return tags_; }
  [[nodiscard]] TagMemory& memory(TagIndex tag) { return tags_[tag].memory; }
  /// Tag of a carpet tile, read or dead; nothing where there is no tile.
  [[nodiscard]] std::optional<TagIndex> of_tile(int column, int row) const;
  /// Carpet tag that answers an antenna at `antenna_m` (in W).
  [[nodiscard]] std::optional<TagIndex> carpet_tag(const Vec2& antenna_m, double read_radius_m) const;
  /// Landmark or furniture tag that answers an antenna at `antenna_m` (in W).
  [[nodiscard]] std::optional<TagIndex> standing_tag(const Vec2& antenna_m, double read_radius_m) const;
  /// Floor tag below a ceiling tag that answers an antenna at `antenna_m` (in W).
  [[nodiscard]] std::optional<TagIndex> loose_tag(const Vec2& antenna_m, double read_radius_m) const;
  /// Carries a piece's tags along.
  void move_furniture(std::uint32_t owner, const Pose2& X_WF);

 private:
  void add_carpet(const Carpet& carpet, const robot::RandomStream& random);
  void add_landmarks(const std::vector<Landmark>& landmarks, const robot::RandomStream& random);
  void add_furniture(const std::vector<Furniture>& furniture, const robot::RandomStream& random);
  void add_floor_tags(const std::vector<CeilingTag>& ceiling, const robot::RandomStream& random);
  void add(Tag tag, robot::RandomStream& random);

  std::vector<Tag> tags_;
  std::size_t carpet_count_{0};
  std::size_t loose_begin_{0};
  double tile_m_;
  Vec2 origin_m_;
  double stray_m_{0.0};  ///< farthest any carpet tag sits from the middle of its tile
  int column0_{0};
  int row0_{0};
  int columns_{0};
  int rows_{0};
  /// Nothing is nearer to `at_m` than `nearest_m`: until the antenna has gone that far less its radius, no
  /// tag answers.
  struct Quiet {
    Vec2 at_m{0.0, 0.0};
    double nearest_m{0.0};
    [[nodiscard]] bool holds(const Vec2& antenna_m, double read_radius_m) const {
      const double way_m = nearest_m - read_radius_m;
      return way_m > 0.0 && (antenna_m - at_m).squaredNorm() < way_m * way_m;
    }
  };
  mutable Quiet carpet_quiet_;
  mutable Quiet standing_quiet_;
  mutable Quiet loose_quiet_;
  /// Of the tags from `begin` to `end` the one that answers, and how long none will.
  [[nodiscard]] std::optional<TagIndex> nearest_of(std::size_t begin, std::size_t end, const Vec2& antenna_m,
                                                   double read_radius_m, Quiet& quiet) const;
  std::vector<std::int32_t> grid_;  ///< TagIndex of each cell of the tiles' bounding box, -1 where no tile is
};

}  // namespace sensotwin::world
