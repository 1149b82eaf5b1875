// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "render/phase_style.hpp"
#include "render/phase_views.hpp"

/// Charts about phases: their noise and what the fuzzy controller makes of them. By cairo alone.
namespace sensotwin::render {

/// A finished sheet of charts, and where in it the data are.
struct PanelPicture {
  Image image;
  std::vector<Panel> panels;
};

/// Gueaieb & Miah, figure 7: single reads with the law's 2-sigma envelope above (left out without reads),
/// standard deviations with the laws' curves below. Panels in that order; radians. \returns kBadView naming
/// the first number that cannot be drawn.
[[nodiscard]] Rendered<PanelPicture> draw_noise(const NoiseView& view, int width_px = 1600);

/// Gueaieb & Miah, figure 5, and the control curve: panels input sets, output sets, curve. Sets of one rule
/// share a colour. Errors as draw_noise().
[[nodiscard]] Rendered<PanelPicture> draw_controller(const FuzzyControllerView& view, int width_px = 1600);

}  // namespace sensotwin::render
