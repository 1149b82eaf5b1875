// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "robot/base/time.hpp"
#include "twin/output/summary.hpp"

namespace sensotwin::twin {

/// Runs a twin tick by tick beside its recorder, whatever its mission.
///
/// Twin: tick(), tick_world(), tick_devices(), tick_program(), now(), done(). Recorder: record(Twin&).
class TickLoop {
 public:
  /// \param wall_s  main's clock; none: nothing is timed
  /// \param pace  see SceneRunOptions; none: as fast as it goes
  explicit TickLoop(const std::function<double()>& wall_s, const std::function<void(double)>& pace = {})
      : wall_s_(wall_s), pace_(pace) {}

  /// \param may_go_on  asked now and then
  /// \returns true when the mission ended by itself or at `limit`, false when it was told to stop
  template <class Twin, class Recorder>
  bool run(Twin& twin, Recorder& recorder, robot::Instant limit, const std::function<bool()>& may_go_on) {
    for (int tick = 0; !twin.done() && twin.now() < limit; ++tick) {
      one_tick(twin, recorder);
      if (pace_) {
        pace_(robot::to_s(twin.now()));
      }
      if (tick % (pace_ ? kAskEveryPaced : kAskEvery) == 0 && !may_go_on()) {
        return false;
      }
    }
    return true;
  }
  /// The parts of a few ticks, scaled to the whole.
  [[nodiscard]] Timing parts() const { return parts_; }

 private:
  /// Ticks between two looks at the outside. Chosen: 15 s of the twin, some ten milliseconds of ours.
  static constexpr int kAskEvery = 1000;
  /// Of a run that is slowed down to be watched. Chosen: a tenth of a second at real time.
  static constexpr int kAskEveryPaced = 7;
  /// One tick in so many is timed part by part; a clock costs as much as a light tick does.
  static constexpr int kTimeEvery = 64;

  template <class Twin, class Recorder>
  void one_tick(Twin& twin, Recorder& recorder) {
    if (!wall_s_ || count_++ % kTimeEvery != 0) {
      twin.tick();
      recorder.record(twin);
      return;
    }
    const double begun = wall_s_();
    twin.tick_world();
    const double world_done = wall_s_();
    twin.tick_devices();
    const double devices_done = wall_s_();
    twin.tick_program();
    const double program_done = wall_s_();
    recorder.record(twin);
    const double recorded = wall_s_();
    parts_.physics_s += kTimeEvery * (world_done - begun);
    parts_.devices_s += kTimeEvery * (devices_done - world_done);
    parts_.controller_s += kTimeEvery * (program_done - devices_done);
    parts_.log_s += kTimeEvery * (recorded - program_done);
  }

  const std::function<double()>& wall_s_;
  const std::function<void(double)> pace_;
  long count_{0};
  Timing parts_;
};

}  // namespace sensotwin::twin
