// SPDX-License-Identifier: MIT
#pragma once

#include "render/error.hpp"
#include "render/image.hpp"
#include "twin/calibrate/calibration.hpp"

namespace sensotwin::twin {

/// The report as a picture: above, read noise against RSSI with the fitted laws; below, phase against
/// frequency of some strong links with their straight lines, where a hop table is known.
[[nodiscard]] render::Rendered<render::Image> draw_calibration(const Calibration& calibration);

}  // namespace sensotwin::twin
