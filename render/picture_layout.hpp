// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/canvas.hpp"
#include "render/scene_layers.hpp"

namespace sensotwin::render {

/// The sheet around a scene: title above, legend at the right, scale bar and north arrow below. Lengths are
/// in units of `unit_px`, which is 1 in a picture 1600 pixels wide: every picture looks the same at the size
/// a README shows.
struct Sheet {
  int width_px{0};
  int height_px{0};
  double unit_px{1.0};
  RectPx plot;    ///< where the scene goes
  RectPx legend;  ///< the column at the right
};

/// \param width_px   of the picture
/// \param height_px  0: as high as the scene's aspect asks for, within 9:16 and 5:4 of the width
/// \param aspect     width over height of the scene
[[nodiscard]] Sheet sheet_for(int width_px, int height_px, double aspect);

/// One line of a legend.
struct LegendItem {
  enum class Swatch : std::uint8_t {
    kTile,
    kSolid,
    kRaised,
    kLegs,
    kWall,
    kRobot,
    kStart,
    kHomeBase,
    kLandmark,
    kTag,
    kDeadTag,
    kCliff,
    kVirtualWall,
    kCeilingTag,
    kIdealPath,
    kEstimate,
    kAntenna,
    kRay,
  };
  Swatch swatch{Swatch::kTile};
  TileState tile{TileState::kUnvisited};
  std::string text;
};
/// Only what the view shows, in a fixed order, tiles with their counts.
[[nodiscard]] std::vector<LegendItem> legend_of(const SceneView& view, TileStyle style);

/// Title, then scene, seed and subtitle.
void draw_heading(Canvas& canvas, const Sheet& sheet, const SceneView& view);
/// Legend and, when there is a path, the colour scale of time below it.
void draw_legend(Canvas& canvas, const Sheet& sheet, const SceneView& view,
                 const std::vector<LegendItem>& items, TileStyle style);

/// A length and the bar that stands for it.
struct ScaleBar {
  double length_m{0.0};
  Vec2 from_px{0.0, 0.0};
  Vec2 to_px{0.0, 0.0};
};
/// The largest round length whose bar is at most a quarter of the plot.
[[nodiscard]] ScaleBar scale_bar_for(const Sheet& sheet, double px_per_m);
void draw_scale_bar(Canvas& canvas, const Sheet& sheet, const ScaleBar& bar);
/// \param toward_px  direction of north on the picture, any length
void draw_north(Canvas& canvas, const Sheet& sheet, const Vec2& toward_px);

/// "8 s", "3.4 min", "2.1 h".
[[nodiscard]] std::string time_text(double t_s);

}  // namespace sensotwin::render
