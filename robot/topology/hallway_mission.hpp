// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robot/base/task.hpp"
#include "robot/topology/hallway_log.hpp"
#include "robot/topology/hallway_map.hpp"
#include "robot/topology/hallway_pilot.hpp"
#include "robot/topology/hallway_route.hpp"
#include "robot/topology/hallway_tracker.hpp"

namespace sensotwin::robot {

struct HallwayMissionConfig {
  HallwayConfig robot;
  HallwayMap map;
  /// Where it stands at the beginning; nothing: in some hallway, and the first tag will tell (Tsukiyama,
  /// section 3).
  std::optional<NodeIndex> start;
  NodeIndex goal{0};
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
/// planned. Each end that is not the goal is standing still with an entry in the log.
///
/// Neither copies nor moves: its behaviours hold references into it.
class HallwayMission {
 public:
  /// \pre the map is sound; start and goal are nodes of it
  explicit HallwayMission(HallwayMissionConfig config);
  HallwayMission(const HallwayMission&) = delete;
  HallwayMission& operator=(const HallwayMission&) = delete;

  /// One control step. \pre sensed.stamp is later than the last one
  /// \returns the command that holds until the next call
  HallwayCommand step(const HallwaySensed& sensed);

  [[nodiscard]] bool done() const { return status_.arrived || status_.stopped; }
  [[nodiscard]] const HallwayStatus& status() const { return status_; }
  [[nodiscard]] const HallwayTracker& tracker() const { return tracker_; }
  [[nodiscard]] const HallwayMap& map() const { return config_.map; }
  [[nodiscard]] HallwayLog& log() { return log_; }

 private:
  /// A hallway to be gone along.
  struct Leg {
    std::optional<NodeIndex> from;  ///< place behind
    CompassPoint heading;
    std::optional<NodeIndex> to;     ///< place ahead, where the map knows it
    std::optional<double> length_m;  ///< from here to there
  };
  enum class End : std::uint8_t { kArrived, kBlocked, kLost };
  struct Passage {
    End end{End::kLost};
    Arrival at;               ///< of kArrived
    double to_middle_m{0.0};  ///< of kArrived
  };

  Task<> run();
  /// From anywhere: along the hallway until a tag tells.
  Task<bool> find_place();
  Task<bool> go_on(RouteStep step);
  Task<Passage> go_along(Leg leg);
  /// What stands in the way: \returns whether it is gone or passed
  Task<bool> deal_with_obstacle();
  Task<> come_to(Passage passage, std::optional<NodeIndex> meant);

  /// What the last tag says of the leg; a leg that turns out to be another one is set right.
  [[nodiscard]] std::optional<Passage> by_tag(Leg& leg);
  /// Whether the sonars see the place ahead, though its tag has not been read.
  [[nodiscard]] std::optional<Passage> by_sonar(const Leg& leg) const;
  [[nodiscard]] bool place_is_due(const Leg& leg, double slack_m) const;
  [[nodiscard]] Leg leg_of(NodeIndex from, CompassPoint exit) const;
  void say(HallwayEventKind kind, std::optional<NodeIndex> place = {}, std::optional<CompassPoint> side = {},
           double value = 0.0);
  void stop(HallwayEventKind why);

  HallwayMissionConfig config_;
  HallwayTracker tracker_;
  HallwayStep step_;
  HallwayPilot pilot_;
  HallwayLog log_;
  HallwayStatus status_;
  BlockedHallways blocked_;
  std::optional<TagNumber> tag_;  ///< read, and not yet thought about
  bool started_{false};
  Task<> script_;
};

}  // namespace sensotwin::robot
