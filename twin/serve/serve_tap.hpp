// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "robot/base/time.hpp"
#include "robot/telemetry/program_tap.hpp"
#include "robot/telemetry/telemetry_hub.hpp"
#include "twin/serve/served_twin.hpp"
#include "twin/serve/server.hpp"

namespace sensotwin::twin {

/// What a served scene shows on a monitor: the room and the robot as they truly are, for no program is here
/// that believes anything, the battery, and who is on which wire.
class ServeTap {
 public:
  /// \param hub  none: nothing is shown
  ServeTap(robot::TelemetryHub* hub, const Scene& scene);

  void after_tick(const ServedTwin& twin);
  void show(robot::Instant now, const ServeStatus& status);

 private:
  void tell_of_clients(robot::Instant now, const ServeStatus& status);

  std::optional<robot::ProgramTap> tap_;
  std::map<std::string, bool> clients_;
};

}  // namespace sensotwin::twin
