// SPDX-License-Identifier: MIT
#include "robot/telemetry/monitor.hpp"

#include "robot/telemetry/monitor_files.hpp"
#include "robot/telemetry/web/access_token.hpp"
#include "robot/telemetry/web/web_error.hpp"

namespace sensotwin::robot {
namespace {

Site monitor_site(TelemetryHub& hub) {
  Site site(monitor_files());
  site.on_events("/events",
                 [&hub](const HttpRequest& request) { return hub.stream(request.header("Last-Event-ID")); });
  return site;
}

}  // namespace

/// A run's log is told from any other's by a number that nobody else draws.
Monitor::Monitor(const WebAddress& address)
    : hub_(new_access_token().substr(0, 8)), server_(monitor_site(hub_), {.address = address}) {}

std::unique_ptr<Monitor> begin_monitor(const std::string& address) {
  if (!address.empty()) {
    return std::make_unique<Monitor>(web_address(address).value());
  }
  constexpr std::uint16_t kPort = 8420;  // chosen: free at IANA, easily remembered
  try {
    return std::make_unique<Monitor>(WebAddress{.port = kPort});
  } catch (const WebError&) {
    return std::make_unique<Monitor>(WebAddress{});
  }
}

}  // namespace sensotwin::robot
