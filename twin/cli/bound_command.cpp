// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {

Command make_bound_command(Deed<BoundOptions> deed) {
  const auto options = std::make_shared<BoundOptions>();
  return {
      .name = "bound",
      .summary = "say how well a robot can know its way along ceiling tags at best",
      .examples =
          "twin bound scenes/hallway.yaml\n"
          "twin bound scenes/line_at_90.yaml --variant own_multipath --images --json\n"
          "twin bound scenes/hallway.yaml --set world.radio.rate_hz=50",
      .set_up =
          [options](CLI::App& app) {
            add_scene_and_changes(app, options->choice);
            app.add_flag("--images", options->images,
                         "also the error of the best linear estimator among the scene's image sources, which "
                         "are no Gauss-Markov process (takes seconds)");
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
