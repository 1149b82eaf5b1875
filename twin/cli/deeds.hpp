// SPDX-License-Identifier: MIT
#pragma once

#include "twin/cli/commands.hpp"

/// What the commands do: each joins the command line to one library of the twin.
namespace sensotwin::twin {

ExitCode replay_deed(const ReplayOptions& options, Context& context);
ExitCode run_deed(const RunOptions& options, Context& context);
ExitCode serve_deed(const ServeOptions& asked, Context& context);
ExitCode trace_deed(const TraceOptions& asked, Context& context);
ExitCode validate_deed(const ValidateOptions& options, Context& context);
ExitCode bound_deed(const BoundOptions& options, Context& context);
ExitCode show_deed(const ShowOptions& options, Context& context);
ExitCode render_deed(const RenderOptions& options, Context& context);
ExitCode import_deed(const ImportOptions& options, Context& context);
ExitCode epsilon_deed(const EpsilonOptions& options, Context& context);
ExitCode calibrate_deed(const CalibrateOptions& options, Context& context);
ExitCode chart_deed(const ChartOptions& options, Context& context);

/// The renderers and their drivers, for `twin doctor`.
[[nodiscard]] std::vector<Probe> renderer_probes();
/// The explorers, for `twin list`.
[[nodiscard]] ListTopic explorers_topic();
/// Of scene_files(): "scenes/line.yaml --variant slow" and its title for each variant; what is wrong with a
/// scene that does not read.
[[nodiscard]] ListTopic variants_topic(std::vector<std::filesystem::path> folders);

}  // namespace sensotwin::twin
