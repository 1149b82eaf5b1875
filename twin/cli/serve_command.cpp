// SPDX-License-Identifier: MIT
#include <memory>
#include <utility>

#include "twin/cli/options.hpp"

namespace sensotwin::twin {
namespace {

/// Chosen: a tenth of a thousandth of real time is a still picture; no machine does ten thousand times.
constexpr double kFactorMin = 1e-4;
constexpr double kFactorMax = 1e4;

void add_pace_options(CLI::App& app, ServeOptions& options) {
  app.add_option_function<std::string>(
         "--rtf",
         [&options](const std::string& text) {
           options.factor.reset();
           if (text != "max") {
             options.factor = std::stod(text);
           }
         },
         "Simulated seconds for each real one, or max: as fast as the client follows (1)")
      ->option_text("F|max")
      ->check([](const std::string& text) {
        return text == "max" ? std::string{} : number_between(kFactorMin, kFactorMax)(text);
      });
  app.add_option_function<double>(
         "--for", [&options](double seconds) { options.end_after_sim_s = seconds; },
         "End after so many simulated seconds, with 0 (until Ctrl-C)")
      ->option_text("S")
      ->check(number_between(0.015, 1e9));
}

void add_wire_options(CLI::App& app, ServeOptions& options) {
  app.add_option_function<std::string>(
         "--llrp", [&options](const std::string& at) { options.llrp = at; },
         "Where the UHF reader listens; port 0: any free one (127.0.0.1:5084, else any)")
      ->option_text("HOST:PORT");
  app.add_option("--vpcd", options.vpcd,
                 "Where the virtual card reader's first slot listens (127.0.0.1:35963)")
      ->option_text("HOST:PORT");
  app.add_flag_callback(
      "--no-cards", [&options] { options.cards = false; }, "Leave the card slots alone");
  app.add_flag("--wait-for-cards", options.wait_for_cards,
               "Let the world stand still until pcscd has noticed that a tag came or went (0.4 s)");
  app.add_flag("--truth", options.truth, "Leave truth.csv: where the robot was in truth, every 15 ms");
  app.add_flag("--strict-baud", options.strict_baud,
               "Lose what is said to the base at a wrong speed, as a cable does");
}

}  // namespace

Command make_serve_command(Deed<ServeOptions> deed) {
  const auto options = std::make_shared<ServeOptions>();
  return {
      .name = "serve",
      .summary = "let other programs drive the robot: open its wires and pace the world by a real clock",
      .examples =
          "twin serve scenes/house.yaml --out runs/served\n"
          "twin serve scenes/hallway.yaml --llrp 127.0.0.1:5084\n"
          "twin serve scenes/house.yaml --rtf 0.5 --set robot.base.kind=roomba400\n"
          "twin serve scenes/house.yaml --monitor 0.0.0.0:8420\n"
          "twin serve scenes/lesson_2x2.yaml --rtf max --for 600 --json",
      .set_up =
          [options](CLI::App& app) {
            add_scene_options(app, options->choice);
            app.add_option_function<std::string>(
                   "--out", [options](const std::string& path) { options->out = path; },
                   "Folder for devices.yaml and the terminals (default runs/serve-<scene>)")
                ->option_text("PATH");
            add_pace_options(app, *options);
            add_wire_options(app, *options);
            add_monitor_option(app, options->monitor);
          },
      .run = [options, deed = std::move(deed)](Context& context) { return deed(*options, context); },
  };
}

}  // namespace sensotwin::twin
