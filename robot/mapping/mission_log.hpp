// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "robot/base/time.hpp"
#include "robot/mapping/tile_map.hpp"

namespace sensotwin::robot {

enum class MissionEventKind : std::uint8_t {
  kTileFound,      ///< first visit: tile, tag
  kTileWritten,    ///< coordinates verified in the tag
  kWriteFailed,    ///< given up writing this tag
  kPassageSeen,    ///< blocked by what the light bumper saw, not tried
  kPassageBumped,  ///< blocked by touch
  kTagMissed,      ///< drove over the place of a tag without reading one
  kTagRecovered,   ///< found it by searching
  kTagGivenUp,     ///< searched and found none: no tag there
  kDetourBegun,
  kDetourDone,
  kUnreachable,  ///< no way left to this tile
  kDisplaced,    ///< read a known tag elsewhere than expected
  kLost,         ///< no known tag was found again: the mission ends here
  kDone,
};

struct MissionEvent {
  Instant stamp;
  MissionEventKind kind{MissionEventKind::kDone};
  Tile tile;
  TagUid tag{0};
};

/// What the mission counts as it goes.
struct MissionCounts {
  int visits{0};        ///< tags driven over, every time (physical S_T)
  int moves{0};         ///< tile moves begun
  int moves_missed{0};  ///< of them: the tag was not read in passing
  int misses_recovered{0};
  int bumps{0};
  int quarter_turns{0};
  int detours{0};
  int writes_verified{0};
  int writes_failed{0};
  int tiles_given_up{0};  ///< reported as not to be reached, or without a tag
};

/// Events since they were last taken, and the counts.
class MissionLog {
 public:
  void add(Instant stamp, MissionEventKind kind, Tile tile = {}, TagUid tag = 0) {
    events_.push_back({stamp, kind, tile, tag});
  }
  [[nodiscard]] std::vector<MissionEvent> take() { return std::exchange(events_, {}); }
  [[nodiscard]] bool empty() const { return events_.empty(); }
  MissionCounts counts;

 private:
  std::vector<MissionEvent> events_;
};

}  // namespace sensotwin::robot
