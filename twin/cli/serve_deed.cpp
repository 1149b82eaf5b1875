// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <ostream>

#include "robot/output/signals.hpp"
#include "twin/cli/deed_support.hpp"
#include "twin/cli/deeds.hpp"
#include "twin/output/progress.hpp"
#include "twin/serve/serve_error.hpp"
#include "twin/serve/serve_folder.hpp"
#include "twin/serve/server.hpp"
#include "twin/serve/status_line.hpp"

namespace sensotwin::twin {
namespace {

/// One line at the bottom of the terminal; nothing where there is none, for a line a second would fill a log.
class StatusLine {
 public:
  explicit StatusLine(Context& context)
      : context_(context), live_(context.progress.live && context.verbosity != Verbosity::kQuiet) {}
  void draw(const ServeStatus& status) {
    if (live_) {
      // One column stays free: a character in the last one makes some terminals wrap.
      context_.talk << '\r' << status_line(status, context_.progress.width_columns - 1) << "\x1b[K"
                    << std::flush;
    }
  }
  void clear() {
    if (live_) {
      context_.talk << "\r\x1b[K" << std::flush;
    }
  }

 private:
  Context& context_;
  bool live_;
};

Endpoint endpoint_of(const char* option, const std::string& text) {
  const auto endpoint = endpoint_from(text);
  if (!endpoint) {
    throw CommandError(robot::ExitCode::kWrongCommandLine,
                       fmt::format("{}: '{}' is not of the form host:port", option, text));
  }
  return *endpoint;
}

ServerSettings settings_of(const ServeOptions& asked, Context& context, StatusLine& line) {
  ServerSettings settings;
  settings.scene_as_given = asked.choice.scene.string();
  settings.folder = asked.out.value_or(default_serve_folder(asked.choice.scene));
  settings.factor = asked.factor;
  settings.wait_for_cards = asked.wait_for_cards;
  settings.truth = asked.truth;
  settings.wires.strict_baud = asked.strict_baud;
  if (asked.llrp) {
    settings.wires.llrp = endpoint_of("--llrp", *asked.llrp);
  }
  settings.wires.vpcd.reset();
  if (asked.cards) {
    settings.wires.vpcd = endpoint_of("--vpcd", asked.vpcd);
  }
  settings.end_after_sim_s = asked.end_after_sim_s;
  settings.wall_s = context.wall_s;
  settings.keep_going = [] { return !robot::pending_interruption(); };
  settings.say = [&context, &line](std::string_view text) {
    line.clear();
    context.say(text);
  };
  settings.warn = [&context, &line](std::string_view text) {
    line.clear();
    context.warn(text);
  };
  return settings;
}

}  // namespace

robot::ExitCode serve_deed(const ServeOptions& asked, Context& context) {
  const Scene scene = scene_of(asked.choice);
  StatusLine line(context);
  const auto monitor = monitor_for(asked.monitor, context);
  ServerSettings settings = settings_of(asked, context, line);
  settings.telemetry = monitor ? &monitor->hub() : nullptr;
  try {
    Server server(scene, settings);
    const ServeStatus last = server.run([&line](const ServeStatus& status) { line.draw(status); });
    line.clear();
    context.out << (context.json ? to_json(last, scene, settings) : table_of(last));
  } catch (const ServeError& error) {
    throw CommandError(robot::ExitCode::kUnavailable, error.what());
  }
  return robot::pending_interruption().value_or(robot::ExitCode::kDone);
}

}  // namespace sensotwin::twin
