// SPDX-License-Identifier: MIT
#include "twin/cli/deed_support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>
#include <thread>

#include "render/png_writer.hpp"
#include "robot/output/output_file.hpp"
#include "robot/output/signals.hpp"
#include "robot/telemetry/web/web_error.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {
namespace {

/// Between two looks whether the user wants to stop. Chosen: a tenth of a second.
constexpr std::chrono::duration<double> kLook{0.1};

}  // namespace

Scene scene_of(const SceneChoice& choice) {
  try {
    return read_scene(choice.scene, {.set = choice.set, .seed = choice.seed, .variant = choice.variant});
  } catch (const robot::LoadError& error) {
    throw CommandError(static_cast<robot::ExitCode>(error.exit_code()), error.what(), true);
  }
}

void write_file(const std::filesystem::path& path, std::string_view content, bool force) {
  if (!force && std::filesystem::exists(path)) {
    throw CommandError(robot::ExitCode::kCannotCreate,
                       fmt::format("{}: exists; --force replaces it", path.string()));
  }
  robot::OutputFile file(path);
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

std::unique_ptr<robot::Monitor> monitor_for(const std::optional<std::string>& address, Context& context) {
  if (!address) {
    return nullptr;
  }
  try {
    auto monitor = robot::begin_monitor(*address);
    context.talk << "monitor at " << monitor->url() << '\n' << std::flush;
    return monitor;
  } catch (const robot::WebError& error) {
    throw CommandError(robot::ExitCode::kUnavailable, error.what());
  }
}

void linger(const robot::Monitor& monitor, const std::optional<double>& seconds, Context& context) {
  if (!seconds) {
    context.say(fmt::format("the monitor stays at {} until Ctrl-C", monitor.url()));
  }
  context.out.flush();
  const double until_s = context.wall_s() + seconds.value_or(INFINITY);
  while (!robot::pending_interruption() && context.wall_s() < until_s) {
    std::this_thread::sleep_for(kLook);
  }
}

void wait_until_due(double sim_s, double rtf, double begun_s, const Context& context) {
  const double due_s = begun_s + sim_s / rtf;
  while (!robot::pending_interruption()) {
    const double left_s = due_s - context.wall_s();
    if (left_s <= 0.0) {
      return;
    }
    std::this_thread::sleep_for(std::min(std::chrono::duration<double>(left_s), {kLook}));
  }
}

}  // namespace sensotwin::twin
