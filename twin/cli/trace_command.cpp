// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {

Command make_trace_command(Deed<TraceOptions> deed) {
  const auto options = std::make_shared<TraceOptions>();
  return {
      .name = "trace",
      .summary = "draw hallways, carpets and ceiling tags on a floor plan, on a page in the browser",
      .examples =
          "twin trace floor.png --out maps\n"
          "twin trace building.yaml --listen 127.0.0.1:8080\n"
          "twin trace scenes/hallways/office.yaml --out my_office.yaml\n"
          "twin trace --open",
      .set_up =
          [options](CLI::App& app) {
            app.add_option_function<std::string>(
                   "PLAN", [options](const std::string& path) { options->plan = path; },
                   "Picture (PNG, PGM), map_server map, hallway map or tracing; without it, an empty sheet")
                ->option_text(" ");
            app.add_option_function<std::string>(
                   "--out", [options](const std::string& path) { options->out = path; },
                   "Folder that is read and written, or a hallway map (.yaml) in it (default: the plan's "
                   "folder)")
                ->option_text("PATH");
            app.add_option(
                   "--listen", options->listen,
                   "Where the page is served; beyond this machine it asks for a token (127.0.0.1, any port)")
                ->option_text("HOST:PORT");
            app.add_flag("--open", options->open, "Open the page in the desktop's browser");
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
