// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {

Command make_chart_command(Deed<ChartOptions> deed) {
  const auto options = std::make_shared<ChartOptions>();
  return {
      .name = "chart",
      .summary = "draw the tags found over time, of several runs on one chart",
      .examples =
          "twin chart runs/bfm runs/dfm runs/idfm --out explorers.png\n"
          "twin chart runs/bfm runs/dfm runs/idfm --paper",
      .set_up =
          [options](CLI::App& app) {
            app.add_option("RUN", options->runs, "Folders of runs of one scene")->required()->expected(1, -1);
            add_output_options(app, options->out, options->force, "The picture (default tags_over_time.png)");
            app.add_flag("--paper", options->paper_marks, "Mark the paper's 69, 42 and 26 minutes");
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
