// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {

Command make_epsilon_command(Deed<EpsilonOptions> deed) {
  const auto options = std::make_shared<EpsilonOptions>();
  return {
      .name = "epsilon",
      .summary = "repeat SensoBot's study of superfluous visits over random rooms",
      .examples =
          "twin epsilon\n"
          "twin epsilon --explorer idfm --explorer sweep --maps 100 --jobs 4 --out epsilon.csv\n"
          "twin epsilon --chart epsilon.png",
      .set_up =
          [options](CLI::App& app) {
            app.add_option("--explorer", options->explorers, "Explorer to study; may be repeated")
                ->option_text("NAME")
                ->allow_extra_args(false);
            app.add_option("--maps", options->maps_per_cell, "Rooms for each of the 96 cells")
                ->check(CLI::Range(1, 1'000'000))
                ->option_text("N");
            add_seed_option(
                app, [options](std::uint64_t seed) { options->seed = seed; }, "Seed of the rooms");
            app.add_option("--jobs", options->jobs, "Threads; 0 takes all processors; changes no result")
                ->check(CLI::Range(0, 1024))
                ->option_text("N");
            app.add_option("--knowledge", options->knowledge,
                           "Blocked neighbours are known on arrival, or by bumping")
                ->check(CLI::IsMember({"adjacent", "bump"}))
                ->option_text("adjacent|bump");
            app.add_option("--chart", options->chart,
                           "Heat map of the first explorer's cells, as the paper counts")
                ->option_text("PATH");
            add_output_options(app, options->out, options->force, "CSV with every cell");
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
