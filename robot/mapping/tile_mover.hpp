// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "robot/base/task.hpp"
#include "robot/mapping/mission_log.hpp"
#include "robot/mapping/navigator.hpp"
#include "robot/mapping/pilot.hpp"

namespace sensotwin::robot {

/// How a move ended. Except after kArrived and kDisplaced the robot is back on the tile it came from.
enum class MoveEnd : std::uint8_t {
  kArrived,    ///< the antenna is over the target's tag
  kBlocked,    ///< something solid is in the way
  kNoTag,      ///< the way was free, and no tag was found there by searching either
  kDisplaced,  ///< over a known tag that is not the target: at() says which
  kLost,       ///< no tag found anywhere near
};

/// Whether a detour leads through gaps that look too narrow: not; a little; or so much that only touch can
/// tell, what was touched near the target before being forgotten.
enum class Squeeze : std::uint8_t { kNo, kTight, kByTouch };

/// Carries the robot from tag to tag, by straight moves between neighbours or by a detour, and keeps the
/// map's tags and tiles true: a tag counts as visited when the antenna has read it where it should be.
class TileMover {
 public:
  TileMover(const MappingConfig& config, Navigator& navigator, TileMap& map, Pilot& pilot, StepIo& io,
            MissionLog& log)
      : config_(config), navigator_(navigator), map_(map), pilot_(pilot), io_(io), log_(log) {}

  /// Drives ahead, then in growing squares, until the first tag is read: the origin.
  Task<bool> find_origin();
  /// Drives to a neighbour of at(). Returns rolling when it arrives, so that a straight run needs no stop.
  Task<MoveEnd> go(Tile target);
  /// Goes to `target` by any way the floor may offer.
  Task<MoveEnd> detour(Tile target, Squeeze squeeze);
  /// Whether a detour to `target` has a plan to begin with.
  [[nodiscard]] bool way_seems_open(Tile target);
  /// Turns to both sides and back, so that the light bumper has seen everything round the robot.
  Task<> look_round();
  /// Lost: looks for any tag in growing rings, farther than a move does. \returns false when none was found
  Task<bool> recover();
  /// Brings the robot to rest over the tag of at().
  Task<> settle();

  /// Marks those passages of at() and of its visited neighbours blocked that the light bumper has seen
  /// something in.
  void see_passages();

  /// The tile whose tag was read last.
  [[nodiscard]] Tile at() const { return at_; }
  /// The way of the last move.
  [[nodiscard]] Direction heading() const { return heading_; }
  /// True while the tag of at() still has to be written.
  [[nodiscard]] bool write_pending() const { return write_pending_; }
  /// Tells the outcome of a write; called once per step before the behaviours run.
  void write_ended(const TileWriteEnded& ended);

 private:
  [[nodiscard]] Line line_of(Tile from, Direction d) const;
  [[nodiscard]] double clearest_aim(const Line& line, double length_m) const;
  void see_passages_of(Tile tile);
  /// Brings the robot to rest `stop_m` past the middle of at(), and its write to an end; below `slowest_mps`
  /// it brakes.
  Task<> rest_at(double stop_m, double slowest_mps);
  Task<> face(Direction d);
  Task<MoveEnd> roll(Tile from, Tile target, Direction d);
  /// Feels round the place of a tag that is nearly in reach. \returns nothing, and over `from` again, if in
  /// vain
  Task<std::optional<MoveEnd>> feel_for(Tile from, Tile target);
  Task<MoveEnd> give_way(Tile from, Line line);
  /// Looks for the tag of `target` round its place; that of `from` does not count. Any other tag ends the
  /// search too.
  enum class TrustFloor : std::uint8_t { kYes, kNo };
  Task<std::optional<MoveEnd>> search(std::optional<Tile> from, Tile target, int rings, TrustFloor trust);
  /// Which tags end a creep: known ones but that of `ignored`, and new ones where the pose is good enough for
  /// them.
  struct TagWanted {
    std::optional<Tile> ignored;
    bool new_ones{true};
  };
  [[nodiscard]] bool over_wanted(const TagWanted& wanted) const;
  /// Straight and slowly to a point; stops at a wanted tag. \returns false when something was in the way
  Task<bool> creep_to(Vec2 p_M_m, TagWanted wanted);
  /// Back over the tag of at(), or of any known one. \returns false when none was found
  Task<bool> relocalise();
  /// Sets how narrow ways may be. \returns how many plans such a detour is worth
  int dare(Squeeze squeeze);
  [[nodiscard]] std::vector<Vec2> way(const Vec2& start_M_m, Tile target) const;
  /// A visited tile from which a way to the target seems to lead.
  [[nodiscard]] std::optional<Tile> base_for(Tile target) const;
  /// By known passages, as far as they are open.
  Task<> travel(Tile to);
  /// Plans and walks until the target's tag is read, nothing is left to try, or `plans_max` plans were
  /// spoilt.
  Task<MoveEnd> approach(Tile target, int plans_max);
  /// Along the corners, slowly. \returns how it ended at a tag; nothing when the plan was spoilt or walked to
  /// its end
  Task<std::optional<MoveEnd>> walk(Tile target, std::vector<Vec2> corners);
  /// A tag met on the way of a detour: a new one is taken in, the target's ends the walk.
  std::optional<MoveEnd> pass_tag(TagUid tag, Tile target);
  /// Lost for good: anywhere, until a known tag is met. \returns false when none was
  Task<bool> wander();
  Task<> hold_for_write(Tile tile);
  /// The visited tiles, nearest first.
  [[nodiscard]] std::vector<Tile> visited_by_distance(const Vec2& from_M_m) const;
  /// Back over the tag of `tile`. \returns false when nothing is in the field
  Task<bool> regain(Tile tile);
  /// What the tag just read means for a move towards `target`; nothing while it is the one the robot came
  /// from.
  std::optional<MoveEnd> judge_tag(TagUid tag, std::optional<Tile> from, Tile target);
  /// Too far from the middle of this tile for a tag in the field to be its own.
  [[nodiscard]] bool misplaced(Tile tile) const;
  void arrive(Tile tile, TagUid tag, bool first);
  void begin_write(Tile tile, TagUid tag);

  const MappingConfig& config_;
  Navigator& navigator_;
  TileMap& map_;
  Pilot& pilot_;
  StepIo& io_;
  MissionLog& log_;
  Tile at_;
  Direction heading_{Direction::kEast};
  bool write_pending_{false};
  bool write_in_flight_{false};
  int write_attempts_{0};
  double clearance_m_{0.0};  ///< of the present detour
  double inside_m_{0.0};
  bool astray_{false};  ///< met a new tag where none can be, and has not found itself since
};

}  // namespace sensotwin::robot
