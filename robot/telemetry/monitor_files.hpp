// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "robot/telemetry/web/http.hpp"

namespace sensotwin::robot {

/// The monitor's page, made from pages/bundle.
[[nodiscard]] std::span<const EmbeddedFile> monitor_files();

}  // namespace sensotwin::robot
