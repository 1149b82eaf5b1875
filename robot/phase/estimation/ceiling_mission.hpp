// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "robot/phase/estimation/ceiling_mission_config.hpp"
#include "robot/phase/estimation/tag_search.hpp"
#include "robot/phase/phase_io.hpp"

namespace sensotwin::robot {

/// Drives along a path given by ceiling tags whose places nobody told: estimates where they and the robot are
/// (CeilingEstimator), follows the way between them (follow()), arrives by the estimate; notices what goes
/// wrong and does what it was told to do about it (FaultPolicy).
///
/// One object, stepped once per Open Interface frame; the same on the machine and in the twin. Never
/// allocates after construction.
class CeilingMission {
 public:
  /// \pre the route is not empty, every antenna count and height as the estimator wants it
  explicit CeilingMission(const CeilingMissionConfig& config);
  CeilingMission(const CeilingMission&) = delete;
  CeilingMission& operator=(const CeilingMission&) = delete;

  /// One control step. \pre sensed.stamp is later than the last one
  [[nodiscard]] PhaseCommand step(const PhaseSensed& sensed);

  [[nodiscard]] bool done() const { return mode_ == CeilingMode::kFinished; }
  /// The last tag was reached, all others before it or skipped with a word.
  [[nodiscard]] bool arrived() const { return done() && arrived_; }
  /// Index in the route of the present destination. A circle about a tag: 0 on the way to it, 1 on it.
  [[nodiscard]] std::size_t leg() const { return leg_; }
  [[nodiscard]] CeilingStatus status() const;
  [[nodiscard]] const CeilingEstimator& estimator() const { return estimator_; }
  /// The estimator's index of a tag of the route.
  [[nodiscard]] int tag_of(std::size_t route_index) const { return route_[route_index]; }
  [[nodiscard]] int skipped() const { return skipped_; }
  /// Events since they were last forgotten, at most kMostEvents.
  [[nodiscard]] std::span<const CeilingEvent> events() const { return events_; }
  void forget_events() { events_.clear(); }

  static constexpr std::size_t kMostEvents = 256;

 private:
  // What the path is (ceiling_mission_path.cpp).
  [[nodiscard]] std::optional<Vec2> place_of(int tag) const;
  /// A tag's place if at least its direction is known.
  [[nodiscard]] std::optional<Vec2> towards(int tag) const;
  [[nodiscard]] std::optional<Vec2> place(std::ptrdiff_t route_index) const;
  [[nodiscard]] std::optional<PathReference> reference(std::size_t leg) const;
  [[nodiscard]] std::optional<PathReference> smooth_reference(std::size_t leg) const;
  [[nodiscard]] std::optional<PathReference> circle_reference(std::size_t leg) const;
  [[nodiscard]] std::optional<Circle> fitted_circle() const;
  [[nodiscard]] Vec2 leg_origin(std::size_t leg) const;
  [[nodiscard]] double corner_rad() const;
  void attend();

  // What goes wrong (ceiling_mission_faults.cpp).
  void hear_estimator();
  void watch_reader(const PhaseSensed& sensed);
  void watch_destination();
  void watch_order();
  [[nodiscard]] double spread_m(int tag) const;  ///< one sigma of its place
  /// The list is doubted, and the tag after the next must be heard before it can be judged: worth one turn.
  [[nodiscard]] bool doubts_order() const;
  void watch_corridor();
  void lose_tag(OnTagFault action);
  void skip();
  [[nodiscard]] WheelSpeeds search();
  [[nodiscard]] bool in_hearing(const TagEstimate& tag) const;
  /// When the tag was heard, or the leg began.
  [[nodiscard]] Instant last_chance(const TagEstimate& sought) const;
  /// The tag's place is a guess that no reads confirm: not worth driving to.
  [[nodiscard]] bool guesses(const TagEstimate& sought) const;
  [[nodiscard]] WheelSpeeds look(const TagEstimate& sought);

  // What is done.
  [[nodiscard]] WheelSpeeds drive();
  [[nodiscard]] WheelSpeeds drive_to(const PathReference& path);
  [[nodiscard]] WheelSpeeds turn();
  [[nodiscard]] WheelSpeeds back_off(const PhaseSensed& sensed);
  [[nodiscard]] bool reached(const PathReference& path) const;
  void reach();
  void begin_leg(std::size_t leg);
  void finish(bool arrived);
  void note(CeilingEventKind kind, std::optional<int> tag = std::nullopt, double value = 0.0);
  [[nodiscard]] bool is_last() const;
  /// Route index of the tag that is made for, or circled.
  [[nodiscard]] std::size_t destination() const {
    return config_.path == TagPathKind::kCircleAbout ? 0 : leg_;
  }

  CeilingMissionConfig config_;
  std::vector<int> route_;  ///< the estimator's index of each tag
  CeilingEstimator estimator_;
  std::vector<CeilingEvent> events_;
  std::vector<int> attended_;
  Instant now_;
  Instant before_;  ///< of the last step
  CeilingMode mode_{CeilingMode::kLooking};
  std::size_t leg_{0};
  std::optional<std::size_t> from_;  ///< route index of the last tag reached; none: the start
  Vec2 origin_M_m_{0.0, 0.0};        ///< where the leg begins if it does not at a tag
  Instant leg_since_;
  bool started_{false};
  bool arrived_{false};
  int skipped_{0};
  bool silent_said_{false};
  bool reader_silent_{false};
  bool reader_was_up_{false};
  bool reader_silence_said_{false};
  bool reader_up_{true};
  Instant silent_since_;
  double blind_m_{0.0};
  int bumps_{0};
  double backed_m_{0.0};
  double step_m_{0.0};
  double step_rad_{0.0};
  double searched_rad_{0.0};
  TagSearch looking_;
  std::optional<double> loudest_dbm_;  ///< the destination's reads of this step
  bool order_judged_{false};
  double order_doubted_s_{0.0};
  int looks_{0};                  ///< on this leg
  double order_looked_rad_{0.0};  ///< turned on this leg, to hear the tag after the next
  double circled_rad_{0.0};       ///< kCircleAbout
  double last_bearing_rad_{0.0};
};

}  // namespace sensotwin::robot
