// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "robot/base/epc.hpp"
#include "robot/base/time.hpp"
#include "robot/phase/estimation/ceiling_mission_config.hpp"
#include "robot/phase/fuzzy_log.hpp"

namespace sensotwin::robot {

/// What a phase mission says, whichever controller it has.
struct PhaseEvent {
  Instant stamp;
  std::string_view name;   ///< for machines: snake case
  std::string_view words;  ///< for people
  std::optional<Epc> tag;
  double value{0.0};  ///< see CeilingEventKind; else 0
};

[[nodiscard]] PhaseEvent event_of(const FuzzyEvent& event);
[[nodiscard]] PhaseEvent event_of(const CeilingEvent& event);

}  // namespace sensotwin::robot
