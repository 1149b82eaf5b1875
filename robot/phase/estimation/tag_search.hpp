// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "robot/phase/estimation/dead_reckoning.hpp"

namespace sensotwin::robot {

/// How a tag is looked for whose place is not known.
struct TagSearchConfig {
  double turn_radps{0.6};   ///< chosen: 6 cm of an antenna 0.1 m off the middle, ten rounds of four ports
  double speed_mps{0.15};   ///< chosen: slower than driving, as nobody knows what stands there
  /// Driven between two turns; sides of the square grow by as much. Chosen: two wavelengths, so that a fade is
  /// left behind.
  double piece_m{0.6};
  int rounds{6};  ///< then it is given up. Chosen: the square is 1.8 m wide by then
};

/// Looks for a tag whose place is not known: once round on the spot; if the tag answered meanwhile, a piece
/// straight on towards where it did so loudest; if it did not, once more round, and then a piece along a square
/// that grows, as one searches at sea. Then round again. Antennas that look ahead and behind hear a tag from
/// far away in some headings only, and a way tells where it is.
///
/// Knows wheels and loudness only. Never allocates.
class TagSearch {
 public:
  explicit TagSearch(const TagSearchConfig& config = {}) : config_(config) {}

  void begin();
  void end() { phase_ = Phase::kIdle; }
  [[nodiscard]] bool running() const { return phase_ != Phase::kIdle; }

  struct Move {
    double speed_mps{0.0};
    double turn_radps{0.0};
  };
  /// One control step. \param loudest_dbm  of the tag's reads since the last step
  /// \returns nothing once it has been given up, or idles
  [[nodiscard]] std::optional<Move> step(const WheelStep& way, std::optional<double> loudest_dbm);
  /// Whole turns made in which the tag did not answer once.
  [[nodiscard]] int silent_turns() const { return silent_turns_; }

 private:
  enum class Phase : std::uint8_t { kIdle, kTurning, kFacing, kDriving };
  static constexpr std::size_t kSectors = 12;
  struct Sector {
    double sum_dbm{0.0};
    int count{0};
  };
  void begin_turn();
  void listen(double loudest_dbm);
  /// What to turn by before the next piece.
  [[nodiscard]] double bearing_rad() const;

  TagSearchConfig config_;
  Phase phase_{Phase::kIdle};
  std::array<Sector, kSectors> sectors_{};
  double turned_rad_{0.0};
  double to_turn_rad_{0.0};
  double to_drive_m_{0.0};
  int round_{0};
  int silent_turns_{0};
};

}  // namespace sensotwin::robot
