// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "robot/telemetry/telemetry_hub.hpp"
#include "robot/telemetry/web/web_address.hpp"
#include "robot/telemetry/web/web_server.hpp"

namespace sensotwin::robot {

/// A page that draws while a robot works: http://host:port/, and its telemetry as server-sent events at
/// /events. It is read only: it has nothing that a browser could change.
class Monitor {
 public:
  /// Begins to serve. \throws WebError
  explicit Monitor(const WebAddress& address);

  [[nodiscard]] TelemetryHub& hub() { return hub_; }
  [[nodiscard]] std::string url() const { return server_.url(); }

 private:
  TelemetryHub hub_;
  WebServer server_;  ///< ends before what it reads
};

/// \param address  as web_address() reads it; empty: 127.0.0.1:8420, or any free port when that is taken
/// \throws WebError
[[nodiscard]] std::unique_ptr<Monitor> begin_monitor(const std::string& address);

}  // namespace sensotwin::robot
