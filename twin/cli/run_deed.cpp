// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <ostream>

#include "robot/output/signals.hpp"
#include "twin/cli/deed_support.hpp"
#include "twin/cli/deeds.hpp"
#include "twin/output/summary.hpp"
#include "twin/run/scene_run.hpp"

namespace sensotwin::twin {
namespace {

/// Names that `expect:` may not use are found before the run, not after it.
void check_expectations(const Scene& scene) {
  if (const auto complaint = complain_about(limits_of(scene))) {
    throw CommandError(robot::ExitCode::kInvalidData, fmt::format("{}: {}", scene.file, *complaint));
  }
}

std::string table_of(const Summary& summary) {
  std::string table;
  for (const auto& [name, value] : figures_of(summary)) {
    table += fmt::format("{:<28} {:>14.6g}\n", name, value);
  }
  for (const JudgedFigure& figure : summary.expect) {
    if (!figure.asked.min && !figure.asked.max) {
      continue;  // asked of many seeds only
    }
    std::string bounds;
    if (figure.asked.min) {
      bounds += fmt::format(" at least {:g}", *figure.asked.min);
    }
    if (figure.asked.max) {
      bounds += fmt::format(" at most {:g}", *figure.asked.max);
    }
    table += fmt::format("{} {} {:g}, asked{}\n", figure.ok ? "ok    " : "FAILED", figure.asked.name,
                         figure.value, bounds);
  }
  return table + fmt::format("verdict {}\n", verdict_of(summary));
}

robot::ExitCode exit_code_of(const Summary& summary) {
  if (summary.interrupted) {
    return robot::pending_interruption().value_or(robot::ExitCode::kInterrupted);
  }
  return verdict_of(summary) == "accepted" ? robot::ExitCode::kDone : robot::ExitCode::kNotAccepted;
}

}  // namespace

robot::ExitCode run_deed(const RunOptions& options, Context& context) {
  const Scene scene = scene_of(options.choice);
  check_expectations(scene);
  if (options.tag_log && !scene.mission.phase) {
    throw CommandError(robot::ExitCode::kWrongCommandLine,
                       "--tag-log needs a scene with mission.phase: no UHF reader runs here");
  }
  const auto path = options.out.value_or(robot::default_run_folder(scene.name, scene.seed, context.utc()));
  robot::RunFolder folder(path, options.force ? robot::Existing::kReplace : robot::Existing::kRefuse);
  const auto monitor = monitor_for(options.monitor, context);
  const double total = progress_total_of(scene);
  Progress progress(context.talk, context.progress, scene.name, progress_unit_of(scene));
  const double begun = context.wall_s();
  ProgressState state{.done = 0.0, .total = total, .wall_s = 0.0, .note = {}};
  std::string note;
  SceneRunOptions run{
      .scene_as_given = options.choice.scene.string(),
      .trace_every = options.trace_every,
      .pictures = options.pictures,
      .tag_log = options.tag_log,
      .journal = options.journal,
      .keep_going =
          [&](const RunProgress& now) {
            state.done = now.done;
            state.wall_s = context.wall_s() - begun;
            note = fmt::format("{:.0f} min, {:.0f} x real time", now.sim_s / 60.0,
                               now.sim_s / std::max(state.wall_s, 1e-3));
            state.note = note;
            if (context.verbosity != Verbosity::kQuiet) {
              progress.update(state);
            }
            return !robot::pending_interruption();
          },
      .wall_s = context.wall_s,
  };
  run.telemetry = monitor ? &monitor->hub() : nullptr;
  if (options.rtf > 0.0) {
    run.pace = [&](double sim_s) { wait_until_due(sim_s, options.rtf, begun, context); };
  }
  const Summary summary = run_scene(scene, folder, run);
  if (context.verbosity != Verbosity::kQuiet) {
    progress.finish(state);
  }
  context.out << (context.json ? to_json(summary) : table_of(summary));
  context.say(fmt::format("results in {}", path.string()));
  if (monitor && !summary.interrupted) {
    linger(*monitor, options.monitor_linger_s, context);
  }
  return exit_code_of(summary);
}

}  // namespace sensotwin::twin
