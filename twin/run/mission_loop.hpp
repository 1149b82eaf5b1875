// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <utility>

#include "robot/base/time.hpp"
#include "twin/output/summary.hpp"
#include "twin/run/run_options.hpp"
#include "twin/run/tick_loop.hpp"
#include "twin/run/twin_journal.hpp"
#include "twin/run/twin_tap.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// What TickLoop asks now and then. Holds references to all it is given.
/// \param done  how much of progress_total_of(scene) is done
template <class Twin, class Done>
[[nodiscard]] std::function<bool()> may_go_on(const Scene& scene, const SceneRunOptions& options,
                                              const Twin& twin, Done done) {
  return [&scene, &options, &twin, done = std::move(done)] {
    return !options.keep_going ||
           options.keep_going(
               {.sim_s = robot::to_s(twin.now()), .done = done(), .total = progress_total_of(scene)});
  };
}

struct MissionLoop {
  bool interrupted{false};
  Timing parts{};
  double ended_s{0.0};  ///< by main's clock
};

/// Runs a mission to its end or to the scene's limit; each tick goes into the journal, the record and onto
/// the monitor's page.
template <class Twin, class Recorder>
[[nodiscard]] MissionLoop run_to_its_end(const Scene& scene, const SceneRunOptions& options, Twin& twin,
                                         Recorder& recorder, TwinJournal& journal, TwinTap& tap,
                                         const std::function<bool()>& go_on) {
  JournallingRecorder journalling(recorder, journal);
  TappingRecorder tapping(journalling, tap);
  recorder.listen(tap.listener());
  TickLoop loop(options.wall_s, options.pace);
  const robot::Instant limit{robot::from_s(scene.limits.time_limit_s)};
  const bool interrupted = !loop.run(twin, tapping, limit, go_on);
  tap.ended(twin.now(), interrupted);
  recorder.finish();
  return {interrupted, loop.parts(), wall_s(options)};
}

}  // namespace sensotwin::twin
