// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {

Command make_show_command(Deed<ShowOptions> deed) {
  const auto options = std::make_shared<ShowOptions>();
  return {
      .name = "show",
      .summary = "check a scene and print it with all its defaults",
      .examples =
          "twin show scenes/house.yaml\n"
          "twin show scenes/lesson_2x2.yaml --robot > robot.yaml\n"
          "twin show scenes/house.yaml --set mission.map.explorer=bfm --json",
      .set_up =
          [options](CLI::App& app) {
            add_scene_options(app, options->choice);
            app.add_flag("--robot", options->robot,
                         "Print what the robot is told instead, as a robot file for sensobot");
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
