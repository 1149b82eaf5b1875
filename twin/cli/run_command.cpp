// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {

Command make_run_command(Deed<RunOptions> deed) {
  const auto options = std::make_shared<RunOptions>();
  return {
      .name = "run",
      .summary = "drive the robot's own code through a scene and leave a folder of results",
      .examples =
          "twin run scenes/house.yaml\n"
          "twin run scenes/house.yaml --seed 8 --set mission.map.explorer=dfm --out runs/dfm\n"
          "twin run scenes/hallway.yaml --tag-log hallway.csv\n"
          "twin run scenes/lesson_2x2.yaml --journal lesson.journal\n"
          "twin run scenes/house.yaml --monitor --rtf 30            # draws on a page while it runs\n"
          "twin run scenes/house.yaml --json | jq .verdict",
      .set_up =
          [options](CLI::App& app) {
            add_scene_options(app, options->choice);
            add_output_options(app, options->out, options->force,
                               "Folder of the run (default runs/<scene>-<seed>-<time>)");
            app.add_option("--trace-every", options->trace_every,
                           "Ticks of 15 ms from row to row of trace.csv")
                ->option_text("N")
                ->check(CLI::Range(1, 1'000'000));
            app.add_option_function<std::string>(
                   "--tag-log", [options](const std::string& file) { options->tag_log = file; },
                   "Write what the UHF reader reports, as sllurp does (CSV)")
                ->option_text("FILE");
            app.add_option_function<std::string>(
                   "--journal", [options](const std::string& file) { options->journal = file; },
                   "Write all bytes of all wires, for twin replay")
                ->option_text("FILE");
            add_monitor_option(app, options->monitor);
            app.add_option("--rtf", options->rtf,
                           "Simulated seconds for each real one, to be watched (as fast as it goes)")
                ->option_text("F")
                ->check(number_between(1e-2, 1e6));
            app.add_option_function<double>(
                   "--monitor-linger", [options](double seconds) { options->monitor_linger_s = seconds; },
                   "Seconds that the monitor stays after the run (until Ctrl-C)")
                ->option_text("S")
                ->check(number_between(0.0, 1e9));
            app.add_flag_callback(
                "--no-pictures", [options] { options->pictures = false; }, "Leave pictures and charts out");
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
