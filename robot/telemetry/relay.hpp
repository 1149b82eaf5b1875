// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "robot/telemetry/telemetry_hub.hpp"
#include "robot/telemetry/web/event_source.hpp"

namespace sensotwin::robot {

/// Shows the robot of another program's monitor on this one's page, so that one page shows several. The
/// browser talks to this program alone; tokens of the others stay here.
class Relay {
 public:
  /// \param id  that the robot has on this page  \throws WebError when `url` is no monitor's address
  Relay(TelemetryHub& hub, int id, const std::string& url);

 private:
  void pass_on(std::string_view data);
  void publish(std::string_view key, std::string_view body);
  /// Whether its monitor answers, and where that is: never its token.
  void tell(bool up);

  TelemetryHub& hub_;
  std::string id_;
  std::string origin_;
  EventSource source_;  ///< last: its thread uses the others
};

}  // namespace sensotwin::robot
