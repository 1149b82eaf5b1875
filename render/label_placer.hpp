// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "render/canvas.hpp"

namespace sensotwin::render {

/// Finds room for names beside their points. Of some forty places around a point, near ones first, it takes
/// the one that covers least of what was said to matter; places of other names are never taken while a free
/// one is left. The order of asking decides, nothing else: equal calls give equal places.
class LabelPlacer {
 public:
  /// Names stay inside `within`.
  explicit LabelPlacer(const RectPx& within) : within_(within) {}

  /// A mark that no name may cover.
  void keep_clear(const RectPx& box) { taken_.push_back(box); }
  /// A line that names should rather not cover. Only corners inside `within` or near it count.
  void avoid(std::span<const Vec2> line);

  struct Place {
    RectPx box;
    bool far{false};  ///< not beside its point: draw a leader from the point to the box
  };
  /// Takes the best place for a name of that size beside a mark of that radius, and keeps it.
  [[nodiscard]] Place place(const Vec2& at_px, double mark_radius_px, const Vec2& size_px);

 private:
  [[nodiscard]] double cost(const RectPx& box, const Vec2& at_px, double reach_px) const;
  RectPx within_;
  std::vector<RectPx> taken_;
  std::vector<Vec2> crumbs_;  ///< points along the lines to avoid
};

/// Where a leader from the point meets the box: the nearest point of the box.
[[nodiscard]] Vec2 leader_end(const LabelPlacer::Place& place, const Vec2& at_px);

}  // namespace sensotwin::render
