// SPDX-License-Identifier: MIT
#include "robot/config/number_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "robot/base/geometry.hpp"

namespace sensotwin::robot {

std::string number_text(double value) {
  return fmt::format("{}", value);
}

double degrees_for(double rad) {
  const double deg = robot::deg_from_rad(rad);
  for (int digits = 1; digits <= 17; ++digits) {
    const double rounded = std::strtod(fmt::format("{:.{}g}", deg, digits).c_str(), nullptr);
    if (robot::rad_from_deg(rounded) == rad) {
      return rounded;
    }
  }
  // Both conversions round: the degrees wanted may be the next number up or down.
  for (const double beyond : {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()}) {
    const double next = std::nextafter(deg, beyond);
    if (robot::rad_from_deg(next) == rad) {
      return next;
    }
  }
  return deg;
}

}  // namespace sensotwin::robot
