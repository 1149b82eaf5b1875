// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "robot/base/task.hpp"
#include "robot/topology/hallway_map.hpp"
#include "robot/topology/hallway_route.hpp"
#include "robot/topology/hallway_walk.hpp"

namespace sensotwin::robot {

struct HallwaySurveyConfig {
  HallwayConfig robot;
  /// A place that lies so near to a known one is that one. Chosen: junctions are farther apart than a hallway
  /// is wide, and the way is known to some percent.
  double same_place_m{1.5};
  /// So long it stands in a junction and listens to its sonars. Chosen: ten rounds.
  Duration look{std::chrono::seconds{1}};
  /// From the middle of a junction, a side is open where nothing is seen so far beyond where the wall would
  /// be. Chosen.
  double open_m{0.7};
};

/// Builds the hallway map that HallwayMission needs, from one tag and the compass: goes along the hallway to
/// the first place, looks which of its sides are open, notes them as '?', and goes to the nearest '?' until
/// none is left.
///
/// Places are told apart by their tags, and where a side's tag is new, by the ways driven since. Beyond the
/// paper, whose maps are drawn by hand. Neither copies nor moves: its behaviours hold references into it.
class HallwaySurvey final : private PlaceWatcher {
 public:
  explicit HallwaySurvey(const HallwaySurveyConfig& config);

  /// One control step. \pre sensed.stamp is later than the last one
  HallwayCommand step(const HallwaySensed& sensed);

  /// The map so far; sound at any time.
  [[nodiscard]] const HallwayMap& map() const { return map_; }
  /// The last place it was at.
  [[nodiscard]] std::optional<NodeIndex> place() const { return here_; }
  [[nodiscard]] bool done() const { return whole_ || lost_; }
  /// No '?' is left that could be reached.
  [[nodiscard]] bool whole() const { return whole_; }
  [[nodiscard]] const HallwayTracker& tracker() const { return walk_.tracker(); }
  [[nodiscard]] HallwayLog& log() { return walk_.log(); }

 private:
  Task<> run();
  /// From anywhere to the first place.
  Task<bool> begin();
  /// Over hallways that are known, or out by one that is not.
  Task<bool> go(HallwayLeg leg);
  Task<> come_to(HallwayLeg leg, HallwayPassage passage);
  /// The first place: its tag may be met on leaving it as well as on coming to it.
  Task<> come_to_first(HallwayPassage passage);
  /// Left, ahead, right: whether a hallway leaves there, by standing in the middle.
  using OpenSides = std::array<bool, 3>;
  Task<OpenSides> look();
  void note(const OpenSides& open);

  std::optional<HallwayPassage> by_tag(HallwayLeg& leg, TagNumber tag) override;
  std::optional<HallwayPassage> by_sonar(const HallwayLeg& leg) override;
  /// The place at this point of the plan whose side may be the end of the hallway just driven.
  [[nodiscard]] std::optional<NodeIndex> place_at(const Vec2& at_m, CompassPoint side) const;
  void say(HallwayEventKind kind, std::optional<CompassPoint> side = {}, double value = 0.0);

  HallwaySurveyConfig config_;
  HallwayWalk walk_;
  HallwayMap map_;
  BlockedHallways blocked_;
  std::optional<NodeIndex> here_;
  CompassPoint heading_{CompassPoint::kNorth};
  std::optional<TagNumber> new_tag_;  ///< of the place ahead, not in the map yet
  bool whole_{false};
  bool lost_{false};
  Task<> script_;
};

}  // namespace sensotwin::robot
