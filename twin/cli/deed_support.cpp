// SPDX-License-Identifier: MIT
#include "twin/cli/deed_support.hpp"

#include <fmt/format.h>

#include "render/png_writer.hpp"
#include "twin/output/output_file.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {

Scene scene_of(const SceneChoice& choice) {
  try {
    return read_scene(choice.scene, {.set = choice.set, .seed = choice.seed, .variant = choice.variant});
  } catch (const SceneError& error) {
    throw CommandError(static_cast<ExitCode>(error.exit_code()), error.what(), true);
  }
}

void write_file(const std::filesystem::path& path, std::string_view content, bool force) {
  if (!force && std::filesystem::exists(path)) {
    throw CommandError(ExitCode::kCannotCreate,
                       fmt::format("{}: exists; --force replaces it", path.string()));
  }
  OutputFile file(path);
  file.append(content);
  file.finish();
}

void write_picture(const std::filesystem::path& path, const render::Image& image, std::string_view comment,
                   bool force) {
  render::PngText text;
  text.comment = comment;
  const auto bytes = drawn_or_throw(render::encode_png(image, text));
  write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, force);
}

}  // namespace sensotwin::twin
