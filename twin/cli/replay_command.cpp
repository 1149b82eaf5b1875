// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {

Command make_replay_command(Deed<ReplayOptions> deed) {
  const auto options = std::make_shared<ReplayOptions>();
  return {
      .name = "replay",
      .summary = "run the program of a journal again and compare its commands byte for byte",
      .examples =
          "twin run scenes/lesson_2x2.yaml --journal lesson.journal && twin replay lesson.journal\n"
          "twin replay runs/kitchen/journal --json | jq .difference",
      .set_up =
          [options](CLI::App& app) {
            app.add_option("journal", options->journal, "What twin run --journal or sensobot run wrote")
                ->required()
                ->option_text("JOURNAL");
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
