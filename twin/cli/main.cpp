// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <iostream>

#include "robot/output/signals.hpp"
#include "twin/cli/application.hpp"
#include "twin/cli/commands.hpp"
#include "twin/cli/deeds.hpp"

namespace {

using namespace sensotwin::twin;  // NOLINT(google-build-using-namespace): main is the namespace's guest

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::string text(sizeof "20260131T235959Z", '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y%m%dT%H%M%SZ", &utc));
  return text;
}

/// Scenes lie in the working directory, or in the source tree that this program was built in.
std::vector<std::filesystem::path> scene_folders() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  return {"scenes", program.parent_path() / "../../../scenes"};
}

std::vector<Command> commands() {
  std::vector<Probe> probes = machine_probes();
  const std::vector<Probe> renderers = renderer_probes();
  probes.insert(probes.end(), renderers.begin(), renderers.end());
  return {
      make_run_command(run_deed),
      make_serve_command(serve_deed),
      make_trace_command(trace_deed),
      make_replay_command(replay_deed),
      make_validate_command(validate_deed),
      make_bound_command(bound_deed),
      make_chart_command(chart_deed),
      make_render_command(render_deed),
      make_show_command(show_deed),
      make_import_command(import_deed),
      make_epsilon_command(epsilon_deed),
      make_calibrate_command(calibrate_deed),
      make_list_command({scenes_topic(scene_folders()), variants_topic(scene_folders()), explorers_topic(),
                         figures_topic(), exit_codes_topic()}),
      make_doctor_command(probes),
  };
}

}  // namespace

int main(int argc, char** argv) {
  sensotwin::robot::install_signal_handlers();
  // llvmpipe's threads cost more than they save at the size of our pictures (render/README.md).
  ::setenv("LP_NUM_THREADS", "1", 0);  // NOLINT(concurrency-mt-unsafe): no thread runs yet
  const auto begin = std::chrono::steady_clock::now();
  const char* no_color = std::getenv("NO_COLOR");  // NOLINT(concurrency-mt-unsafe): no thread runs yet
  const Environment environment{
      .out = std::cout,
      .err = std::cerr,
      .err_is_terminal = ::isatty(STDERR_FILENO) == 1,
      .no_color = no_color != nullptr && *no_color != '\0',
      .progress = progress_style_for(STDERR_FILENO),
      .wall_s =
          [begin] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); },
      .utc = utc_now,
  };
  return sensotwin::robot::as_int(run_application({argv + 1, argv + argc}, commands(), environment));
}
