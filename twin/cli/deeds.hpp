// SPDX-License-Identifier: MIT
#pragma once

#include "twin/cli/commands.hpp"

/// What the commands do: each joins the command line to one library of the twin.
namespace sensotwin::twin {

robot::ExitCode replay_deed(const ReplayOptions& options, Context& context);
robot::ExitCode run_deed(const RunOptions& options, Context& context);
robot::ExitCode serve_deed(const ServeOptions& asked, Context& context);
robot::ExitCode trace_deed(const TraceOptions& asked, Context& context);
robot::ExitCode validate_deed(const ValidateOptions& options, Context& context);
robot::ExitCode bound_deed(const BoundOptions& options, Context& context);
robot::ExitCode show_deed(const ShowOptions& options, Context& context);
robot::ExitCode render_deed(const RenderOptions& options, Context& context);
robot::ExitCode import_deed(const ImportOptions& options, Context& context);
robot::ExitCode epsilon_deed(const EpsilonOptions& options, Context& context);
robot::ExitCode calibrate_deed(const CalibrateOptions& options, Context& context);
robot::ExitCode chart_deed(const ChartOptions& options, Context& context);

/// The renderers and their drivers, for `twin doctor`.
[[nodiscard]] std::vector<Probe> renderer_probes();
/// The explorers, for `twin list`.
[[nodiscard]] ListTopic explorers_topic();
/// Of scene_files(): "scenes/line.yaml --variant slow" and its title for each variant; what is wrong with a
/// scene that does not read.
[[nodiscard]] ListTopic variants_topic(std::vector<std::filesystem::path> folders);

}  // namespace sensotwin::twin
