// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/base/geometry.hpp"
#include "robot/mapping/floor_grid.hpp"
#include "robot/mapping/mapping_config.hpp"
#include "robot/mapping/mission_io.hpp"
#include "robot/mapping/pose_filter.hpp"
#include "robot/mapping/tile_map.hpp"

namespace sensotwin::robot {

/// Turns what the devices say into where the robot is and what stands around it. Moves nothing.
class Navigator {
 public:
  /// \param map  which tag lies on which tile, as far as known; outlives the navigator
  Navigator(const MappingConfig& config, const TileMap& map);

  /// Takes in one control step.
  void sense(const Sensed& sensed);

  /// Middle of a tile, where its tag is, in M.
  [[nodiscard]] Vec2 centre_m(Tile tile) const {
    return {tile.column * config_.tile_m, tile.row * config_.tile_m};
  }
  [[nodiscard]] Tile nearest_tile(const Vec2& p_M_m) const;
  [[nodiscard]] const Pose2& pose() const { return filter_.pose(); }
  [[nodiscard]] PoseFilter& filter() { return filter_; }
  [[nodiscard]] const PoseFilter& filter() const { return filter_; }
  [[nodiscard]] FloorGrid& floor() { return floor_; }
  [[nodiscard]] const FloorGrid& floor() const { return floor_; }
  [[nodiscard]] double speed_mps() const { return speed_mps_; }

  /// The pose is known too badly to tell which tile a new tag lies on.
  [[nodiscard]] bool uncertain() { return filter_.position_sigma_m() > kTellTiles * config_.tile_m; }

  /// The tag that was identified in this very step.
  [[nodiscard]] std::optional<TagUid> identified() const { return identified_; }
  /// The tag in the antenna's field now, once identified.
  [[nodiscard]] std::optional<TagUid> tag_in_field() const { return in_field_ ? uid_ : std::nullopt; }
  /// The tag identified in this very step is known, and was not expected here: the pose was set right.
  [[nodiscard]] bool relocated() const { return relocated_; }
  [[nodiscard]] bool anything_in_field() const { return in_field_; }
  /// The tag in the field has just been given its tile: its coming into the field now corrects the pose.
  void use_tag_in_field();
  /// The robot is on `tile` for certain, though the filter thought otherwise.
  void relocate(Tile tile);
  /// The robot drove past the place of this tile's tag, along this yaw, and read none.
  void miss(Tile tile, double yaw_M_rad);
  /// The bumper was pressed: remembers where. \param side  +1 left only, -1 right only, 0 both
  void remember_bump(int side, const Sensed& sensed);

 private:
  /// Half a tile is 2.3 standard deviations then.
  static constexpr double kTellTiles = 0.22;
  [[nodiscard]] ReadZone zone_of(Tile tile) const;
  /// The robot believes itself on this tile: what its tag's rim says of the pose can be taken at its word. A
  /// tag read farther off says that the robot is elsewhere: relocate().
  [[nodiscard]] bool near(Tile tile) const;
  /// Where on the shell it touches, in R: the switches tell the side only, the brightest beam on that side
  /// roughly where. \param side  +1 left only, -1 right only, 0 both
  [[nodiscard]] double contact_yaw_R_rad(int side, const Sensed& sensed) const;
  void sense_motion(const Sensed& sensed);
  void sense_obstacles(const Sensed& sensed);
  void sense_tag(const Sensed& sensed);

  MappingConfig config_;
  const TileMap& map_;
  PoseFilter filter_;
  FloorGrid floor_;
  double speed_mps_{0.0};
  Vec2 swept_at_m_{1e9, 1e9};
  Vec2 looked_at_m_{1e9, 1e9};
  double looked_yaw_rad_{1e9};
  int steps_since_look_{0};
  bool in_field_{false};
  std::optional<TagUid> uid_;
  std::optional<TagUid> identified_;
  bool relocated_{false};
  bool entered_{false};       ///< rolling, so that the place of entry is known
  bool entry_usable_{false};  ///< and not yet used
};

}  // namespace sensotwin::robot
