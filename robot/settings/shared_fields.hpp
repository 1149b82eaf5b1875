// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "robot/config/field_visitor.hpp"

/// Fields that scenes and robot files share.
namespace sensotwin::robot {

inline constexpr std::array<std::string_view, 2> kBaseKindWords{"create2", "roomba400"};
inline constexpr std::array<std::string_view, 4> kBaseFirmwareWords{"current", "before_3.4.1", "before_3.3.0",
                                                                    "wifi"};

/// In `robot.base`. Base: BaseSettings, or another struct with members
/// of the same names, its enumerations in the same order.
template <class Base>
void base_fields(FieldVisitor& v, Base& base) {
  v.choice({"kind", "model of the machine"}, base.kind, kBaseKindWords);
  v.choice({"firmware", "which errata of the mainboard answer"}, base.firmware, kBaseFirmwareWords);
  v.number({"radius_m", "of the body, m"}, base.radius_m, {0.05, 0.5});
  v.number({"wheel_base_m", "between the wheels, m"}, base.wheel_base_m, {0.02, 1.0});
  v.number({"wheel_diameter_m", "m"}, base.wheel_diameter_m, {0.01, 0.5});
  v.number({"counts_per_turn", "encoder counts in one turn of a wheel"}, base.counts_per_turn,
           {1.0, 100000.0});
  v.number({"speed_max_mps", "of a wheel, m/s"}, base.speed_max_mps, {0.01, 5.0});
}

/// Three numbers, each within `range`.
inline void xyz(FieldVisitor& v, const Field& field, Eigen::Vector3d& value, const Range& range) {
  std::vector<double> numbers{value.x(), value.y(), value.z()};
  v.numbers(field, numbers, range, {3, 3});
  if (numbers.size() == 3) {
    value = {numbers[0], numbers[1], numbers[2]};
  }
}

}  // namespace sensotwin::robot
