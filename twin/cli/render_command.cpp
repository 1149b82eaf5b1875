// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {

Command make_render_command(Deed<RenderOptions> deed) {
  const auto options = std::make_shared<RenderOptions>();
  return {
      .name = "render",
      .summary = "draw a scene as it stands before a run",
      .examples =
          "twin render scenes/house.yaml\n"
          "twin render scenes/house.yaml --view oblique --width-px 2400 --out house.png",
      .set_up =
          [options](CLI::App& app) {
            add_scene_options(app, options->choice);
            add_output_options(app, options->out, options->force, "Picture to write (default <scene>.png)");
            app.add_option("--view", options->view, "From where")
                ->check(CLI::IsMember({"top", "oblique"}))
                ->option_text("top|oblique");
            // Above, a picture of RGBA needs more than a gigabyte.
            app.add_option("--width-px", options->width_px, "Width of the picture")
                ->check(CLI::Range(64, 16384))
                ->option_text("N");
            app.add_option("--renderer", options->renderer, "What draws it")
                ->check(CLI::IsMember({"auto", "osmesa", "egl"}))
                ->option_text("auto|osmesa|egl");
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
