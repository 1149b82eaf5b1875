// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

/// What a compass board says for a heading, and what a driver makes of it.
namespace sensotwin::testing {

struct CompassLine {
  double yaw_from_north_rad;  ///< counter-clockwise
  std::string_view sentence;
};
/// Checksums worked out by hand (a program of ten lines): exclusive or of the characters between $ and *.
inline constexpr std::array<CompassLine, 4> kCompassLines{{
    {0.0, "$HCHDM,0.0,M*29\r\n"},
    {-1.5707963267948966, "$HCHDM,90.0,M*10\r\n"},  // east
    {1.5707963267948966, "$HCHDM,270.0,M*2C\r\n"},  // west
    {2.1205750411731104, "$HCHDM,238.5,M*25\r\n"},  // 360 - 238.5 = 121.5 degrees to the left of north
}};

}  // namespace sensotwin::testing
