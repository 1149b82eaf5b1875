// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "render/image.hpp"
#include "render/offscreen_context.hpp"
#include "robot/telemetry/monitor.hpp"
#include "twin/cli/commands.hpp"
#include "twin/scene/scene.hpp"

/// What several deeds share.
namespace sensotwin::twin {

/// The scene with the command line's changes. \throws CommandError with every mistake, one a line
[[nodiscard]] Scene scene_of(const SceneChoice& choice);

/// Writes a whole file by way of a temporary name. \throws CommandError 73 when it exists and not `force`
void write_file(const std::filesystem::path& path, std::string_view content, bool force);

/// The image as a PNG that says where it comes from. \throws CommandError, OutputError
void write_picture(const std::filesystem::path& path, const render::Image& image, std::string_view comment,
                   bool force);

/// A page for this run, its address said even when the user wants quiet: without it nobody finds the page.
/// Nothing when none is asked for. \throws CommandError when the address cannot be had
[[nodiscard]] std::unique_ptr<robot::Monitor> monitor_for(const std::optional<std::string>& address,
                                                          Context& context);
/// Keeps the page there after a run: for `seconds`, or until somebody interrupts.
void linger(const robot::Monitor& monitor, const std::optional<double>& seconds, Context& context);
/// Waits until `sim_s` is due in a run that is to take `rtf` simulated seconds for each real one.
void wait_until_due(double sim_s, double rtf, double begun_s, const Context& context);

/// The value, or its error as a CommandError.
template <class T>
T drawn_or_throw(render::Rendered<T> result) {
  if (!result) {
    throw CommandError(robot::ExitCode::kUnavailable, result.error().message);
  }
  return std::move(*result);
}

}  // namespace sensotwin::twin
