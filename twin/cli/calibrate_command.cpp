// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {

Command make_calibrate_command(Deed<CalibrateOptions> deed) {
  const auto options = std::make_shared<CalibrateOptions>();
  return {
      .name = "calibrate",
      .summary = "fit noise, delays, hop table, flips and timing of a UHF reader to its logs",
      .examples =
          "twin calibrate spot1.csv spot2.csv spot3.csv --out reader.yaml --chart reader.png\n"
          "twin calibrate *.csv --distances distances.csv\n"
          "twin calibrate *.csv --hop-table capabilities.csv --json",
      .set_up =
          [options](CLI::App& app) {
            app.add_option("LOG", options->logs, "CSV logs of sllurp: one reader, tags at rest")
                ->required()
                ->expected(1, -1);
            app.add_option("--distances", options->distances,
                           "CSV log,distance_m: file names without folder, antenna to tag")
                ->option_text("PATH");
            app.add_option("--hop-table", options->hop_table,
                           "CSV channel_index,freq_mhz as the reader publishes it; else it is recovered")
                ->option_text("PATH");
            app.add_option("--band", options->band,
                           "Channels to recover a hop table from: FIRST:STEP:COUNT in MHz")
                ->option_text("MHZ:MHZ:N");
            app.add_option("--phase", options->phase,
                           "Which way phase goes with distance, without --hop-table")
                ->check(CLI::IsMember({"falls", "rises"}))
                ->option_text("falls|rises");
            app.add_option("--starts", options->starts, "Starts of the search for the hop table")
                ->check(CLI::Range(1, 1'000'000))
                ->option_text("N");
            app.add_option("--resamples", options->resamples, "Resamplings behind each interval")
                ->check(CLI::Range(10, 1'000'000))
                ->option_text("N");
            add_seed_option(
                app, [options](std::uint64_t seed) { options->seed = seed; },
                "Seed of starts and resamplings");
            app.add_option("--chart", options->chart, "Picture: noise against RSSI, phase against frequency")
                ->option_text("PATH");
            add_output_options(app, options->out, options->force, "The profile: a radio: section for scenes");
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
