// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

#include "render/image.hpp"
#include "render/offscreen_context.hpp"
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

/// The value, or its error as a CommandError.
template <class T>
T drawn_or_throw(render::Rendered<T> result) {
  if (!result) {
    throw CommandError(ExitCode::kUnavailable, result.error().message);
  }
  return std::move(*result);
}

}  // namespace sensotwin::twin
