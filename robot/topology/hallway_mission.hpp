// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robot/base/task.hpp"
#include "robot/topology/hallway_map.hpp"
#include "robot/topology/hallway_route.hpp"
#include "robot/topology/hallway_walk.hpp"

namespace sensotwin::robot {

struct HallwayMissionConfig {
  HallwayConfig robot;
  HallwayMap map;
  /// Where it stands at the beginning; nothing: in some hallway, and the first tag will tell (Tsukiyama,
  /// section 3).
  std::optional<NodeIndex> start;
  NodeIndex goal{0};
  /// Whether it tries hallways whose ends nobody knows where no other way leads to the goal.
  bool explore{true};
};

/// For traces and pages.
struct HallwayStatus {
  std::optional<NodeIndex> place;        ///< last one it was at
  std::optional<CompassPoint> leaving;   ///< by which side it went on
  std::optional<NodeIndex> heading_for;  ///< next place
  bool arrived{false};
  bool stopped{false};  ///< ended before the goal; the log says why
};

/// The paper's navigation (section 3): find a way over the map, leave each place for the next sub-goal's
/// compass point, follow the hallway until a tag says which place it comes to and from which side; "this
/// process is repeated until the robot finds the goal".
///
/// What the paper leaves out: a tag that is not read is made up for by the junction that the sonars see where
/// the map has one; a tag of another place than was meant sets the place right and plans anew; what stands in
/// the way is waited for, gone round where there is room, and else the hallway is given up and another way
/// planned; where only hallways might lead to the goal whose ends the map does not know, they are tried,
/// nearest first, and the map is completed by what is found. A place that the sonars alone see is believed
/// where the map's length agrees with the wheels, and the compass, and where the map has none, nothing stood
/// in the way; else it goes back for the tag, so that it never says that it arrived where it did not. Only
/// where its way leads straight on there it may go on, and no place is believed by the sonars before the next
/// tag. Each end that is not the goal is standing still with an entry in the log.
///
/// Neither copies nor moves: its behaviours hold references into it.
class HallwayMission final : private PlaceWatcher {
 public:
  /// \pre the map is sound; start and goal are nodes of it
  explicit HallwayMission(HallwayMissionConfig config);

  /// One control step. \pre sensed.stamp is later than the last one
  /// \returns the command that holds until the next call
  HallwayCommand step(const HallwaySensed& sensed);

  [[nodiscard]] bool done() const { return status_.arrived || status_.stopped; }
  [[nodiscard]] const HallwayStatus& status() const { return status_; }
  [[nodiscard]] const HallwayTracker& tracker() const { return walk_.tracker(); }
  [[nodiscard]] const HallwayMap& map() const { return config_.map; }
  [[nodiscard]] HallwayLog& log() { return walk_.log(); }

 private:
  Task<> run();
  /// From anywhere: along the hallway until a tag tells.
  /// \param axis_rad  of the hallway it stands in
  Task<bool> find_place(double axis_rad);
  /// \param to  nothing: nobody knows where the exit leads
  Task<bool> go_on(NodeIndex from, CompassPoint exit, std::optional<NodeIndex> to);
  /// Whether the way leads straight on at a place that it is perhaps at, so that the next tag may tell.
  [[nodiscard]] bool leads_on(const HallwayPassage& passage) const;
  /// The next step to the goal, or to the nearest hallway that is worth trying; nothing: there is none, and
  /// it has said why.
  struct Step {
    NodeIndex from;
    CompassPoint exit;
    std::optional<NodeIndex> to;
  };
  [[nodiscard]] std::optional<Step> next_step();
  /// An unknown hallway was gone to its end: the map is told, and what leads elsewhere than straight on is
  /// not tried again.
  void learn(const HallwayLeg& leg, const HallwayPassage& passage);
  Task<> come_to(HallwayPassage passage, std::optional<NodeIndex> meant);
  /// Back along the hallway for the tag of a place that it is perhaps at, and on to the place behind if there
  /// is none.
  Task<HallwayPassage> look_again(HallwayPassage doubted);

  std::optional<HallwayPassage> by_tag(HallwayLeg& leg, TagNumber tag) override;
  std::optional<HallwayPassage> by_sonar(const HallwayLeg& leg) override;
  /// A tag says that it goes away from a place: whether it is there all the same, the place behind it.
  [[nodiscard]] bool run_past(const HallwayLeg& leg, const Arrival& met) const;
  /// As by_sonar(), of the sonars alone: how far it is to the middle of the place ahead.
  [[nodiscard]] std::optional<double> seen_ahead_m(const HallwayLeg& leg) const;
  [[nodiscard]] HallwayLeg leg_of(NodeIndex from, CompassPoint exit) const;
  /// From the tags on that side of a place to its middle.
  [[nodiscard]] double tag_to_middle_m(NodeIndex node, CompassPoint side) const;
  void say(HallwayEventKind kind, std::optional<NodeIndex> place = {}, std::optional<CompassPoint> side = {},
           double value = 0.0);
  void stop(HallwayEventKind why);

  HallwayMissionConfig config_;
  HallwayWalk walk_;
  HallwayStatus status_;
  BlockedHallways blocked_;
  CompassPoint heading_{CompassPoint::kNorth};  ///< at the last place
  std::optional<Arrival> doubted_;              ///< whose tag it goes back for
  int looks_{0};                                ///< times that it did
  bool unsure_{false};    ///< of status_.place: it went on there, and has read no tag since
  double beyond_m_{0.0};  ///< the middle of that is so far behind, as it sets out
  Task<> script_;
};

}  // namespace sensotwin::robot
