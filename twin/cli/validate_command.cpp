// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {
namespace {

void add_seeds_option(CLI::App& app, std::vector<std::uint64_t>& seeds) {
  app.add_option_function<std::string>(
         "--seeds",
         [&seeds](const std::string& text) {
           auto parsed = seeds_from(text);
           if (const auto* complaint = std::get_if<std::string>(&parsed)) {
             throw CLI::ValidationError("--seeds", *complaint);
           }
           seeds = std::get<std::vector<std::uint64_t>>(std::move(parsed));
         },
         "Seeds to run, instead of the scene's: 1..200, or 1..20,42")
      ->required()
      ->option_text("A..B");
}

void add_judgement_options(CLI::App& app, ValidateOptions& options) {
  app.add_option("--rate", options.rate,
                 "Share of the seeds that must keep a limit, with confidence; 1 (default) is every seed")
      ->check(number_between(1e-6, 1.0))
      ->option_text("R");
  app.add_option("--confidence", options.confidence, "Of every interval (default 0.95)")
      ->check(number_between(0.5, 0.999999))
      ->option_text("C");
  app.add_option("--intervals", options.intervals, "Of rates: never too narrow, or right on average")
      ->check(CLI::IsMember({"clopper-pearson", "wilson"}))
      ->option_text("clopper-pearson|wilson");
}

}  // namespace

Command make_validate_command(Deed<ValidateOptions> deed) {
  const auto options = std::make_shared<ValidateOptions>();
  return {
      .name = "validate",
      .summary = "run a scene from many seeds and judge what it expects with confidence intervals",
      .examples =
          "twin validate scenes/house.yaml --seeds 1..200\n"
          "twin validate scenes/house.yaml --seeds 1..200 --rate 0.95 --junit house.xml --json\n"
          "twin validate scenes/house.yaml --seeds 1..1000 --out house_validation --resume",
      .set_up =
          [options](CLI::App& app) {
            add_scene_and_changes(app, options->choice);
            add_seeds_option(app, options->seeds);
            app.add_option("--jobs", options->jobs, "Threads; 0 takes all processors; changes no result")
                ->check(CLI::Range(0, 1024))
                ->option_text("N");
            add_judgement_options(app, *options);
            add_output_options(app, options->out, options->force,
                               "Folder of the report (default runs/validate-<scene>-<time>)");
            app.add_flag("--resume", options->resume, "Keep the seeds that the folder holds and go on");
            app.add_option_function<std::string>(
                   "--junit", [options](const std::string& path) { options->junit = path; },
                   "JUnit XML with a case for each threshold")
                ->option_text("PATH");
            app.add_option("--worst", options->worst, "Seeds to run again with pictures (default 3)")
                ->check(CLI::Range(0, 1000))
                ->option_text("N");
            app.add_flag_callback(
                "--no-pictures", [options] { options->pictures = false; },
                "Leave charts and the worst seeds out");
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
