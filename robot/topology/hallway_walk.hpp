// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "robot/base/task.hpp"
#include "robot/topology/hallway_log.hpp"
#include "robot/topology/hallway_pilot.hpp"
#include "robot/topology/hallway_tracker.hpp"

namespace sensotwin::robot {

/// A hallway to be gone along.
struct HallwayLeg {
  std::optional<NodeIndex> from{};  ///< place behind
  CompassPoint heading{CompassPoint::kNorth};
  double axis_rad{yaw_rad_of(CompassPoint::kNorth)};  ///< its direction, from the plan's north
  std::optional<NodeIndex> to{};                      ///< place ahead, where the map knows it
  std::optional<double> length_m{};                   ///< from middle to middle
  /// Before that the place ahead begins, and so far reaches the one behind: their walls are no hallway's, and
  /// it goes straight on there.
  double ahead_m{0.0};
  double behind_m{0.0};
};

enum class PassageEnd : std::uint8_t { kArrived, kBlocked, kLost };

/// What came of going along a hallway.
struct HallwayPassage {
  PassageEnd end{PassageEnd::kLost};
  Arrival at{};             ///< of kArrived
  double to_middle_m{0.0};  ///< of kArrived: from where the robot is; below 0: behind it
  double way_m{0.0};        ///< along the hallway since the leg began
  bool doubtful{false};     ///< of kArrived: no tag says so, and map, wheels or compass say another thing
};

/// Says, while a robot goes along a hallway, whether it has come to a place. Nothing: not yet.
class PlaceWatcher {
 public:
  PlaceWatcher() = default;
  PlaceWatcher(const PlaceWatcher&) = delete;
  PlaceWatcher& operator=(const PlaceWatcher&) = delete;
  virtual ~PlaceWatcher() = default;

  /// By a tag that was just read. A leg that turns out to be another one is set right.
  virtual std::optional<HallwayPassage> by_tag(HallwayLeg& leg, TagNumber tag) = 0;
  /// By what the sonars see, though no tag was read.
  virtual std::optional<HallwayPassage> by_sonar(const HallwayLeg& leg) = 0;
};

/// A robot on its way through hallways, whatever for: the step's input and output, heading and walls, and the
/// walk from one place to the next past whatever stands in the way. Neither copies nor moves: its behaviours
/// hold references.
class HallwayWalk {
 public:
  explicit HallwayWalk(const HallwayConfig& config)
      : config_(config), tracker_(config_), pilot_(config_, tracker_, step_) {}
  HallwayWalk(const HallwayWalk&) = delete;
  HallwayWalk& operator=(const HallwayWalk&) = delete;

  /// One control step of a behaviour that walks here: takes what the devices said, lets the behaviour go on,
  /// and gives its command; standing still once it is done. It begins when the compass has said which way the
  /// robot faces.
  template <class Done>
  HallwayCommand step(const HallwaySensed& sensed, Task<>& script, const Done& done) {
    take(sensed);
    if (!done() && tracker_.heading_rad()) {
      if (started_) {
        step_.next.resume();
      } else {
        started_ = true;
        script.start();
      }
    }
    if (done()) {
      step_.command = {};
    }
    return step_.command;
  }
  /// To the end of the leg, watching for places. Each obstacle is waited for, then passed where there is
  /// room.
  Task<HallwayPassage> along(HallwayLeg leg, PlaceWatcher& watcher);

  [[nodiscard]] const HallwayConfig& config() const { return config_; }
  [[nodiscard]] HallwayTracker& tracker() { return tracker_; }
  [[nodiscard]] const HallwayTracker& tracker() const { return tracker_; }
  [[nodiscard]] HallwayPilot& pilot() { return pilot_; }
  [[nodiscard]] const HallwayPilot& pilot() const { return pilot_; }
  [[nodiscard]] HallwayStep& step() { return step_; }
  [[nodiscard]] HallwayLog& log() { return log_; }
  /// From where a tag is read on coming to a place to the middle of that.
  [[nodiscard]] double tag_to_middle_m() const { return config_.tag_to_middle_m + config_.tag_reach_m; }
  /// How far it is to the middle of a hallway that crosses or joins on one of these sides, once enough of it
  /// is seen to be no doorway. \param edge_to_middle_m  half the width of that hallway
  [[nodiscard]] std::optional<double> opening_ahead_m(bool left, bool right, double edge_to_middle_m) const;
  /// The same of a hallway that ends at the wall ahead.
  [[nodiscard]] std::optional<double> end_ahead_m() const;
  /// Whether it touched or went round anything in this leg: the way is less well known then.
  [[nodiscard]] bool hindered() const { return hindered_; }
  /// Adds an event of this step. \param place  name; empty where none is known
  void say(HallwayEventKind kind, std::string place = {}, std::optional<CompassPoint> side = {},
           double value = 0.0);

 private:
  void take(const HallwaySensed& sensed);
  Task<bool> past_obstacle();

  HallwayConfig config_;
  HallwayTracker tracker_;
  HallwayStep step_;
  HallwayPilot pilot_;
  HallwayLog log_;
  bool started_{false};
  bool hindered_{false};
  double waited_m_{0.0};          ///< way at which it last waited for something to go away
  std::optional<TagNumber> tag_;  ///< read, and not yet thought about
};

}  // namespace sensotwin::robot
