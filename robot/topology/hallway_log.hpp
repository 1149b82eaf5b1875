// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/base/time.hpp"
#include "robot/topology/hallway_map.hpp"

namespace sensotwin::robot {

enum class HallwayEventKind : std::uint8_t {
  kPlaced,         ///< knows where it is, after it did not
  kRoute,          ///< a way was planned; value: its cost
  kLeft,           ///< left a place by this side
  kTag,            ///< a tag of the map; place: which it belongs to
  kStrangeTag,     ///< a tag that no place has
  kArrived,        ///< at this place, by its tag
  kTagMissed,      ///< at this place, by what the sonars see; its tag was not read
  kTurnedWrong,    ///< went by another side than was meant; it knows now which way it faces
  kElsewhere,      ///< came to this place, which it did not head for
  kWaiting,        ///< something stands in the way
  kWentRound,      ///< it was passed
  kBlocked,        ///< the hallway on this side is given up
  kBumped,         ///< touched something
  kExplored,       ///< an unknown hallway leads here: the map has it now
  kMapWhole,       ///< of a survey: no hallway is left whose end is unknown
  kGoal,           ///< at the goal
  kNoWay,          ///< no free hallway leads to the goal: the mission ends here
  kOnlyByUnknown,  ///< as kNoWay, but a hallway whose end is unknown might, if it may be tried: the end
  kLost,           ///< no place where there has to be one, and none found again: the mission ends here
  kTurnedByHand,  ///< the compass says that somebody turned it where it stood; value: by how much to the left
  kLooksAgain,    ///< perhaps at this place; it goes back for the tag to make sure
  kGoesOn,        ///< perhaps at this place; its way leads straight on there, so the next tag will tell
};

/// The event as a person reads it, in lower case, without a full stop.
[[nodiscard]] constexpr std::string_view words(HallwayEventKind kind) {
  switch (kind) {
    case HallwayEventKind::kPlaced:
      return "found out where it is";
    case HallwayEventKind::kRoute:
      return "way planned";
    case HallwayEventKind::kLeft:
      return "left";
    case HallwayEventKind::kTag:
      return "read a tag";
    case HallwayEventKind::kStrangeTag:
      return "read a tag that the map does not know";
    case HallwayEventKind::kArrived:
      return "arrived, tag read";
    case HallwayEventKind::kTagMissed:
      return "arrived by the sonars, its tag was not read";
    case HallwayEventKind::kTurnedWrong:
      return "faced another way than it thought";
    case HallwayEventKind::kElsewhere:
      return "came to another place than meant";
    case HallwayEventKind::kWaiting:
      return "something stands in the way, waiting";
    case HallwayEventKind::kWentRound:
      return "went round it";
    case HallwayEventKind::kBlocked:
      return "hallway blocked";
    case HallwayEventKind::kBumped:
      return "touched something";
    case HallwayEventKind::kExplored:
      return "found where an unknown hallway leads";
    case HallwayEventKind::kMapWhole:
      return "map whole";
    case HallwayEventKind::kGoal:
      return "at the goal";
    case HallwayEventKind::kNoWay:
      return "no free hallway leads to the goal, stopped";
    case HallwayEventKind::kOnlyByUnknown:
      return "only an unknown hallway might lead to the goal, stopped";
    case HallwayEventKind::kLost:
      return "lost, stopped";
    case HallwayEventKind::kTurnedByHand:
      return "somebody turned it, the compass says";
    case HallwayEventKind::kLooksAgain:
      return "not sure of the place, goes back for its tag";
    case HallwayEventKind::kGoesOn:
      return "not sure of the place, its way leads straight on there";
  }
  return "";
}

/// For machines: snake case.
[[nodiscard]] constexpr std::string_view name_of(HallwayEventKind kind) {
  constexpr std::array<std::string_view, 22> kNames{
      "placed",     "route",          "left",        "tag",     "strange_tag", "arrived",
      "tag_missed", "turned_wrong",   "elsewhere",   "waiting", "went_round",  "blocked",
      "bumped",     "explored",       "map_whole",   "goal",    "no_way",      "only_by_unknown",
      "lost",       "turned_by_hand", "looks_again", "goes_on"};
  return kNames[static_cast<std::size_t>(kind)];
}

struct HallwayEvent {
  Instant stamp;
  HallwayEventKind kind{HallwayEventKind::kRoute};
  std::string place;  ///< name; empty where none is known
  std::optional<CompassPoint> side{};
  double value{0.0};
};

/// Events since they were last taken: a few for each hallway.
class HallwayLog {
 public:
  void add(HallwayEvent event) { events_.push_back(std::move(event)); }
  [[nodiscard]] std::vector<HallwayEvent> take() { return std::exchange(events_, {}); }

 private:
  std::vector<HallwayEvent> events_;
};

}  // namespace sensotwin::robot
