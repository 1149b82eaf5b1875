// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>

#include "robot/base/geometry.hpp"

namespace sensotwin::robot {

/// What the robot has felt of the floor, finer than tiles: squares of 2.5 cm in M, each with the evidence
/// that something stands there. The body's own sweep is the strongest evidence that nothing does.
///
/// Chosen 2.5 cm: a table leg covers two cells, and the pose is known to one or two centimetres.
class FloorGrid {
 public:
  static constexpr double kCell_m = 0.025;
  struct Cell {
    int x{0};
    int y{0};
    auto operator<=>(const Cell&) const = default;
  };

  [[nodiscard]] static Cell cell_at(const Vec2& p_M_m) {
    return {static_cast<int>(std::floor(p_M_m.x() / kCell_m)),
            static_cast<int>(std::floor(p_M_m.y() / kCell_m))};
  }
  [[nodiscard]] static Vec2 centre_m(Cell c) { return {(c.x + 0.5) * kCell_m, (c.y + 0.5) * kCell_m}; }

  /// A beam met something here. What was seen from a place known badly is forgotten as soon as a few beams go
  /// through it; what was seen from a place known well is not.
  enum class Seen : std::uint8_t { kFromKnownPlace, kFromDoubtfulPlace };
  void add_hit(const Vec2& p_M_m, Seen seen = Seen::kFromKnownPlace);
  /// A beam went from one point to the other and met nothing.
  void see_through(const Vec2& from_M_m, const Vec2& to_M_m);
  /// The bumper was pressed with the robot here: the robot's centre cannot be at `p_M_m`.
  void forbid_centre(const Vec2& p_M_m);
  /// Forgets every touch within `radius_m`, and what was only seen from places known badly.
  void forget_doubtful(const Vec2& round_M_m, double radius_m);
  /// The body stood at `centre`: whatever was believed within `radius_m` of it is not there.
  void clear_disc(const Vec2& centre_M_m, double radius_m);

  /// The robot's centre was here, and its place was known well: it can be here again, whatever was seen
  /// since.
  void tread(const Vec2& centre_M_m);

  [[nodiscard]] bool occupied(Cell c) const;
  [[nodiscard]] bool centre_forbidden(Cell c) const;
  [[nodiscard]] bool trodden(Cell c) const;
  /// The body has covered this cell.
  [[nodiscard]] bool swept(Cell c) const;
  /// True when something stands closer than `clearance_m` to the straight way from `from` to `to`.
  [[nodiscard]] bool blocks(const Vec2& from_M_m, const Vec2& to_M_m, double clearance_m) const;
  /// Grows with every change of an obstacle, so that planners know when their plan is old.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  static constexpr int kChunkBits = 6;
  static constexpr int kChunkSide = 1 << kChunkBits;
  struct Chunk {
    std::array<std::uint8_t, kChunkSide * kChunkSide> cells{};
  };
  [[nodiscard]] const std::uint8_t* find(Cell c) const;
  [[nodiscard]] std::uint8_t& at(Cell c);

  std::map<std::pair<int, int>, std::unique_ptr<Chunk>> chunks_;
  mutable std::pair<int, int> last_key_{0, 0};
  mutable Chunk* last_chunk_{nullptr};
  std::uint64_t revision_{0};
};

}  // namespace sensotwin::robot
