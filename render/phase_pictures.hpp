// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "render/phase_style.hpp"
#include "render/phase_views.hpp"
#include "render/picture_layout.hpp"
#include "render/projection.hpp"

/// Pictures of navigation by ceiling tags, as in Gueaieb & Miah. By cairo alone: no OpenGL, and the same view
/// gives the same bytes wherever cairo and the font are the same.
namespace sensotwin::render {

/// A finished picture, and where in it things are.
struct PhasePicture {
  Image image;
  Projection pixel_from_W;     ///< of the plan; all zero when there is none
  RectPx plan;                 ///< the part that shows it
  ScaleBar scale_bar;          ///< of the plan
  std::optional<Panel> error;  ///< the error chart: x in s, y in cm
};

/// The trajectory over the ideal path, with the projections of the tags, the estimates of where they are and
/// the walls: figures 9(a), 9(c), 11(a), 13(a). The height follows the scene's aspect. \returns kBadView
/// naming the first number that cannot be drawn. A view with nothing in it gives an empty plan.
[[nodiscard]] Rendered<PhasePicture> draw_phase_plan(const PhaseRunView& view, int width_px = 1600);
/// The signed error over time, changes of segment marked, with the root mean square: figures 9(b), 9(d),
/// 11(b), 13(b). Errors as draw_phase_plan().
[[nodiscard]] Rendered<PhasePicture> draw_tracking_error(const PhaseRunView& view, int width_px = 1600);
/// Both on one sheet: side by side, or above each other when the scene is much wider than high. Errors as
/// draw_phase_plan().
[[nodiscard]] Rendered<PhasePicture> draw_phase_sheet(const PhaseRunView& view, int width_px = 1600);

/// One small panel for each tag that was estimated, about where it truly is, all at one scale: the 95 %
/// ellipses shrink with time. Tags without an estimate are left out. \returns kBadView also for no estimate
/// or more than 60 tags.
[[nodiscard]] Rendered<PhasePicture> draw_estimates_sheet(const PhaseRunView& view, int width_px = 1600);

/// Parts of the sheets, for canvases of others.
namespace phase {
/// Paints the plan into `plot` and its axes around it. \returns where W is
Projection paint_plan(Canvas& canvas, const PhaseRunView& view, const RectPx& plot, double unit_px);
/// What the plan's signs mean; only those it shows.
[[nodiscard]] std::vector<FlowItem> plan_legend(const PhaseRunView& view);
/// Paints the error chart into `plot` and its axes around it.
Panel paint_error(Canvas& canvas, const PhaseRunView& view, const RectPx& plot, double unit_px);
}  // namespace phase

}  // namespace sensotwin::render
