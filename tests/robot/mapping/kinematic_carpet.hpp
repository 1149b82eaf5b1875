// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/base/random.hpp"
#include "robot/mapping/mission_io.hpp"

namespace sensotwin::robot::testing {

/// A carpeted room drawn as text, and a robot that rolls on it by kinematics alone: enough to try the mission
/// where Box2D is not installed. The first line is the far (north) row, every character a tile:
///
///     #  solid                      .  carpet with a tag         S  the same, and the start, facing east
///     g  glass: solid, and unseen by the light bumper            x  carpet whose tag is dead
///     o  a hole                     v  carpet in the fan of a virtual wall
///
/// Posts may be put between the middles of tiles. Frame: W, the origin at the plan's south-west corner.
class KinematicCarpet {
 public:
  /// What the wheels do not do as counted, and how tags are laid. One sigma where it is noise.
  struct Errors {
    double scale{0.0};       ///< travelled / counted - 1
    double turn_scale{0.0};  ///< turned / counted - 1
    double curvature_rad_per_m{0.0};
    double heading_noise_rad{0.0};  ///< per square root of a metre
    double turn_noise_rad{0.0};     ///< per square root of a radian turned
    double tag_offset_m{0.0};
    double compass_noise_rad{0.02};  ///< chosen: a degree
  };

  static constexpr double kTile_m = 0.508;  ///< SensoBot, III.A: 20 inches
  static constexpr double kRadius_m = 0.17;

  KinematicCarpet(std::vector<std::string> plan, const Errors& errors, std::uint64_t seed);

  /// A round post. \param at_tiles  in tiles from the plan's south-west corner
  /// \param seen  by the light bumper; touch feels it in any case
  void put_post(const Vec2& at_tiles, double radius_m, bool seen);
  /// Moves a tag from where it was laid. \param off_m  from the middle of its tile; it stays on the tile
  void lay_tag(Tile tile, const Vec2& off_m) { laid_at_m_.at(tile) = centre_m(tile) + off_m; }
  /// The next `n` writes end without being verified.
  void tear_writes(int n) { writes_to_tear_ = n; }
  /// Lifts the robot and puts it over the middle of another tile, facing the same way.
  void carry_to(Tile tile) { X_WR_.p_m = centre_m(tile); }
  /// Turns the robot where it stands, its wheels lifted.
  void twist(double rad) { X_WR_.yaw_rad = wrap_angle(X_WR_.yaw_rad + rad); }
  void silence_compass() { compass_silent_ = true; }

  /// Everything the mission may know, after one control step under `command`.
  Sensed step(const Command& command);

  /// '#' outside the plan.
  [[nodiscard]] char at(Tile tile) const;
  [[nodiscard]] const Pose2& X_WR() const { return X_WR_; }
  [[nodiscard]] Tile start() const { return start_; }
  [[nodiscard]] Instant now() const { return now_; }
  /// Tiles of the plan that hold a tag that answers.
  [[nodiscard]] const std::set<Tile>& tags() const { return tags_; }
  [[nodiscard]] static TagUid uid(Tile tile);
  /// The tag over whose zone the antenna is, whether or not it has said its name yet.
  [[nodiscard]] std::optional<TagUid> tag_in_field() const {
    return in_field_ ? std::optional{uid(*in_field_)} : std::nullopt;
  }
  /// The coordinates that each tag was given last.
  [[nodiscard]] const std::map<TagUid, Tile>& written() const { return written_; }
  /// Furthest that the robot's middle has been over a hole or into a virtual wall's fan.
  [[nodiscard]] double deepest_in_hazard_m() const { return deepest_in_hazard_m_; }
  [[nodiscard]] static Vec2 centre_m(Tile tile) {
    return {(tile.column + 0.5) * kTile_m, (tile.row + 0.5) * kTile_m};
  }
  [[nodiscard]] static Tile tile_at(const Vec2& p_W_m);

 private:
  struct Post {
    Vec2 at_m;
    double radius_m;
    bool seen;
  };
  [[nodiscard]] bool solid(Tile tile) const { return at(tile) == '#' || at(tile) == 'g'; }
  [[nodiscard]] Vec2 away_from_solid(const Vec2& p_W_m) const;
  [[nodiscard]] bool seen_at(const Vec2& p_W_m) const;
  void roll(const WheelSpeeds& wheels, Sensed& sensed);
  void count(const WheelSpeeds& wheels, Sensed& sensed);
  void touch(Sensed& sensed);
  void sense_light(Sensed& sensed) const;
  void sense_hazards(Sensed& sensed);
  void sense_tag(Sensed& sensed);
  void write(const Command& command, Sensed& sensed);

  std::vector<std::string> plan_;
  Errors errors_;
  RandomStream random_;
  Pose2 X_WR_;
  Tile start_;
  std::set<Tile> tags_;
  std::map<Tile, Vec2> laid_at_m_;
  std::vector<Post> posts_;
  Instant now_;
  int ticks_{0};
  double left_{0.0};
  double right_{0.0};
  int counted_left_{0};
  int counted_right_{0};
  std::optional<Tile> in_field_;
  Instant entered_;
  bool identified_{false};
  std::optional<TileWrite> writing_;
  Instant write_done_;
  int writes_to_tear_{0};
  std::map<TagUid, Tile> written_;
  bool compass_silent_{false};
  double deepest_in_hazard_m_{0.0};
};

}  // namespace sensotwin::robot::testing
