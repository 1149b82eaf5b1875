// SPDX-License-Identifier: MIT
#include "world/tag_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace sensotwin::world {
namespace {

/// SensoBot, Table 1: block 0, first and second byte, in the order of LandmarkKind. The outlet's second byte
/// is a dash there and 0 here.
constexpr std::array<std::array<std::uint8_t, 2>, 9> kLandmarkBytes = {{{0x01, 0x01},
                                                                        {0x01, 0x00},
                                                                        {0x81, 0x01},
                                                                        {0x81, 0x00},
                                                                        {0x02, 0x01},
                                                                        {0x02, 0x00},
                                                                        {0x03, 0x00},
                                                                        {0x04, 0x01},
                                                                        {0x04, 0x00}}};
constexpr std::uint8_t kDynamicLandmark = 0xFF;  ///< the same table, last row

/// How much farther than it reads the field is searched, so that the next search can wait. Chosen: the way of
/// half a second.
constexpr double kLookOut_m = 0.15;
/// Guards comparisons of distances that were rounded differently.
constexpr double kRounding_m = 1e-9;

// Without a call, where the processor that we compile for has no instruction for it.
int floor_of(double x) {
  const int whole = static_cast<int>(x);
  return whole - (x < whole ? 1 : 0);
}
int ceil_of(double x) {
  return -floor_of(-x);
}

/// Where a piece carries its tags, in its own frame: each leg, or the middle of each side; a circle has four.
std::vector<Vec2> tag_places(const Furniture& piece) {
  const Vec2 half_m = 0.5 * piece.size_m;
  const double r_m = piece.radius_m;
  switch (piece.shape) {
    case FurnitureShape::kLegs:
      return piece.points_m;
    case FurnitureShape::kCircle:
      return {{r_m, 0.0}, {0.0, r_m}, {-r_m, 0.0}, {0.0, -r_m}};
    case FurnitureShape::kBox:
      return {{half_m.x(), 0.0}, {0.0, half_m.y()}, {-half_m.x(), 0.0}, {0.0, -half_m.y()}};
    case FurnitureShape::kPolygon:
      break;
  }
  std::vector<Vec2> middles_m;
  for (std::size_t i = 0; i < piece.points_m.size(); ++i) {
    middles_m.emplace_back(0.5 * (piece.points_m[i] + piece.points_m[(i + 1) % piece.points_m.size()]));
  }
  return middles_m;
}

}  // namespace

TagField::TagField(const WorldDescription& world, const robot::RandomStream& random)
    : tile_m_(world.carpet.tile_m), origin_m_(world.carpet.origin_m) {
  add_carpet(world.carpet, random);
  add_landmarks(world.landmarks, random);
  add_furniture(world.furniture, random);
  loose_begin_ = tags_.size();
  if (world.radio) {
    add_floor_tags(world.radio->tags, random);
  }
  for (std::uint32_t i = 0; i < world.hallway_tags.size(); ++i) {
    Tag tag{.place = TagPlace::kHallway, .owner = i, .at_m = world.hallway_tags[i].at_m};
    tag.memory.uid = world.hallway_tags[i].uid;
    tags_.push_back(std::move(tag));
  }
}

void TagField::add(Tag tag, robot::RandomStream& random) {
  tag.memory.uid = icode_sli_uid(random.next_u64());
  tags_.push_back(std::move(tag));
}

void TagField::add_carpet(const Carpet& carpet, const robot::RandomStream& random) {
  carpet_count_ = carpet.tiles.size();
  if (carpet.tiles.empty()) {
    return;
  }
  int column1 = column0_ = carpet.tiles.front().first;
  int row1 = row0_ = carpet.tiles.front().second;
  for (const auto& [column, row] : carpet.tiles) {
    column0_ = std::min(column0_, column);
    column1 = std::max(column1, column);
    row0_ = std::min(row0_, row);
    row1 = std::max(row1, row);
  }
  columns_ = column1 - column0_ + 1;
  rows_ = row1 - row0_ + 1;
  grid_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
  const robot::RandomStream tiles = random.fork("carpet");
  for (const auto& [column, row] : carpet.tiles) {
    robot::RandomStream own = tiles.fork(std::to_string(column) + ',' + std::to_string(row));
    const Vec2 stray_m{own.normal(0.0, carpet.tag_offset_sigma_m),
                       own.normal(0.0, carpet.tag_offset_sigma_m)};
    stray_m_ = std::max(stray_m_, stray_m.norm());
    grid_[static_cast<std::size_t>(row - row0_) * static_cast<std::size_t>(columns_) +
          static_cast<std::size_t>(column - column0_)] = static_cast<std::int32_t>(tags_.size());
    add({.place = TagPlace::kCarpet,
         .column = column,
         .row = row,
         .at_m = carpet.origin_m + tile_m_ * Vec2{column + 0.5, row + 0.5} + stray_m},
        own);
  }
  for (const auto& [column, row] : carpet.unreadable) {
    if (const auto tag = of_tile(column, row)) {
      tags_[*tag].readable = false;
    }
  }
}

void TagField::add_landmarks(const std::vector<Landmark>& landmarks, const robot::RandomStream& random) {
  for (std::uint32_t i = 0; i < landmarks.size(); ++i) {
    robot::RandomStream own = random.fork("landmark").fork(std::to_string(i));
    Tag tag{.place = TagPlace::kLandmark, .owner = i, .at_m = landmarks[i].at_m};
    const auto& bytes = kLandmarkBytes[static_cast<std::size_t>(landmarks[i].kind)];
    tag.memory.blocks[0] = {bytes[0], bytes[1], 0, 0};
    add(std::move(tag), own);
  }
}

void TagField::add_furniture(const std::vector<Furniture>& furniture, const robot::RandomStream& random) {
  for (std::uint32_t i = 0; i < furniture.size(); ++i) {
    const Furniture& piece = furniture[i];
    if (!piece.tag) {
      continue;
    }
    robot::RandomStream own = random.fork("furniture").fork(piece.name).fork(std::to_string(i));
    for (const Vec2& p_OT_m : tag_places(piece)) {
      Tag tag{.place = TagPlace::kFurniture, .owner = i, .p_OT_m = p_OT_m, .at_m = piece.X_WF * p_OT_m};
      tag.memory.blocks[0] = {kDynamicLandmark, 0, 0, 0};
      tag.memory.blocks[1] = {piece.tag->category, piece.tag->length, piece.tag->width, piece.tag->color};
      add(std::move(tag), own);
    }
  }
}

void TagField::add_floor_tags(const std::vector<CeilingTag>& ceiling, const robot::RandomStream& random) {
  for (std::uint32_t i = 0; i < ceiling.size(); ++i) {
    if (!ceiling[i].floor_tag) {
      continue;
    }
    const std::string name = ceiling[i].name.empty() ? std::to_string(i) : ceiling[i].name;
    robot::RandomStream own = random.fork("floor tag").fork(name);
    Tag tag{.place = TagPlace::kFloor, .owner = i, .at_m = ceiling[i].at_m};
    const auto& epc = ceiling[i].epc.bytes;
    for (std::size_t b = 0; b < epc.size(); ++b) {
      tag.memory.blocks[b / tag.memory.blocks[0].size()][b % tag.memory.blocks[0].size()] = epc[b];
    }
    add(std::move(tag), own);
  }
}

std::optional<TagIndex> TagField::of_tile(int column, int row) const {
  const int c = column - column0_;
  const int r = row - row0_;
  if (c < 0 || r < 0 || c >= columns_ || r >= rows_) {
    return std::nullopt;
  }
  const std::int32_t tag =
      grid_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c)];
  return tag < 0 ? std::nullopt : std::optional<TagIndex>{static_cast<TagIndex>(tag)};
}

std::optional<TagIndex> TagField::carpet_tag(const Vec2& antenna_m, double read_radius_m) const {
  if (carpet_quiet_.holds(antenna_m, read_radius_m)) {
    return std::nullopt;
  }
  // A tag answers from outside its own tile when the radius is large: look at every tile whose middle is
  // near.
  const Vec2 in_tiles = (antenna_m - origin_m_) / tile_m_;
  const double reach = (read_radius_m + stray_m_ + kLookOut_m) / tile_m_;
  const int row1 = floor_of(in_tiles.y() + reach - 0.5);
  const int column0 = ceil_of(in_tiles.x() - reach - 0.5);
  const int column1 = floor_of(in_tiles.x() + reach - 0.5);
  std::optional<TagIndex> answer;
  double nearest_m2 = (read_radius_m + kLookOut_m) * (read_radius_m + kLookOut_m);
  for (int row = ceil_of(in_tiles.y() - reach - 0.5); row <= row1; ++row) {
    for (int column = column0; column <= column1; ++column) {
      const auto tag = of_tile(column, row);
      if (!tag || !tags_[*tag].readable) {
        continue;
      }
      const double d_m2 = (tags_[*tag].at_m - antenna_m).squaredNorm();
      if (d_m2 <= nearest_m2) {
        nearest_m2 = d_m2;
        answer = tag;
      }
    }
  }
  carpet_quiet_ = {antenna_m, std::sqrt(nearest_m2) - kRounding_m};
  return nearest_m2 <= read_radius_m * read_radius_m ? answer : std::nullopt;
}

std::optional<TagIndex> TagField::standing_tag(const Vec2& antenna_m, double read_radius_m) const {
  return nearest_of(carpet_count_, loose_begin_, antenna_m, read_radius_m, standing_quiet_);
}

std::optional<TagIndex> TagField::loose_tag(const Vec2& antenna_m, double read_radius_m) const {
  return nearest_of(loose_begin_, tags_.size(), antenna_m, read_radius_m, loose_quiet_);
}

std::optional<TagIndex> TagField::nearest_of(std::size_t begin, std::size_t end, const Vec2& antenna_m,
                                             double read_radius_m, Quiet& quiet) const {
  if (quiet.holds(antenna_m, read_radius_m)) {
    return std::nullopt;
  }
  double nearest_m2 = std::numeric_limits<double>::infinity();
  std::size_t nearest = end;
  for (std::size_t i = begin; i < end; ++i) {
    const double d_m2 = (tags_[i].at_m - antenna_m).squaredNorm();
    if (d_m2 <= nearest_m2) {
      nearest_m2 = d_m2;
      nearest = i;
    }
  }
  quiet = {antenna_m, std::sqrt(nearest_m2) - kRounding_m};
  return nearest_m2 <= read_radius_m * read_radius_m ? std::optional{static_cast<TagIndex>(nearest)}
                                                     : std::nullopt;
}

void TagField::move_furniture(std::uint32_t owner, const Pose2& X_WF) {
  standing_quiet_ = {};
  for (std::size_t i = carpet_count_; i < tags_.size(); ++i) {
    if (tags_[i].place == TagPlace::kFurniture && tags_[i].owner == owner) {
      tags_[i].at_m = X_WF * tags_[i].p_OT_m;
    }
  }
}

}  // namespace sensotwin::world
