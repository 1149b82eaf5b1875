// SPDX-License-Identifier: MIT
#include <chrono>
#include <memory>
#include <ostream>
#include <vector>

#include "robot/output/signals.hpp"
#include "robot/ports/monotonic_clock.hpp"
#include "robot/sensobot/commands.hpp"
#include "robot/telemetry/monitor.hpp"
#include "robot/telemetry/relay.hpp"

namespace sensotwin::robot {
namespace {

/// Between two looks whether to stop. Chosen: a tenth of a second.
constexpr Duration kLook = std::chrono::milliseconds{100};

}  // namespace

ExitCode monitor_command(const MonitorCommandOptions& options, const SensobotEnvironment& environment) {
  const auto monitor = begin_monitor(options.at);
  std::vector<std::unique_ptr<Relay>> relays;
  for (const std::string& url : options.urls) {
    relays.push_back(std::make_unique<Relay>(monitor->hub(), static_cast<int>(relays.size()), url));
  }
  environment.err << "monitor at " << monitor->url() << '\n' << std::flush;
  MonotonicClock clock(1.0);
  while (!pending_interruption()) {
    clock.wait_until(clock.now() + kLook);
  }
  return ExitCode::kDone;
}

}  // namespace sensotwin::robot
