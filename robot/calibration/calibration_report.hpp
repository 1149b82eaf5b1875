// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "robot/calibration/calibration_program.hpp"
#include "robot/settings/robot_settings.hpp"

namespace sensotwin::robot {

/// What was measured as sections of a robot file, which `sensobot run --calibration` lays over that file.
/// Empty when nothing was. \param told  the settings that the calibration began with
/// \param about  a line that says when and of what
[[nodiscard]] std::string calibration_yaml(const CalibrationResult& result, const RobotSettings& told,
                                           std::string_view about);

/// Lines for people: how good it is, and what would make it better.
[[nodiscard]] std::string calibration_text(const CalibrationResult& result, const RobotSettings& told);

/// The same as a JSON object.
[[nodiscard]] std::string calibration_json(const CalibrationResult& result, const RobotSettings& told);

}  // namespace sensotwin::robot
