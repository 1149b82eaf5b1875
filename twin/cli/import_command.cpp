// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {

Command make_import_command(Deed<ImportOptions> deed) {
  const auto options = std::make_shared<ImportOptions>();
  return {
      .name = "import",
      .summary = "make a scene of a ROS map_server map, carpeted wherever there is floor",
      .examples =
          "twin import maps/flat.yaml\n"
          "twin import maps/flat.yaml --tile-m 0.5 --out scenes/flat.yaml",
      .set_up =
          [options](CLI::App& app) {
            app.add_option("MAP", options->map, "YAML of the map, beside its PGM or PNG")
                ->required()
                ->option_text(" ");
            add_output_options(app, options->out, options->force,
                               "Scene to write (default <map>.scene.yaml)");
            // A tile smaller than the robot's wheel base or larger than a room is a slip of the pen.
            app.add_option("--tile-m", options->tile_m, "Side of a carpet tile in metres")
                ->check(number_between(0.1, 5.0))
                ->option_text("M");
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
