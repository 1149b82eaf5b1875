// SPDX-License-Identifier: MIT
#include "render/label_placer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sensotwin::render {
namespace {

// Costs, chosen by looking: any free place is better than one on another name, a short step away is better
// than writing over a line, and right above is better than left below when both are free.
constexpr double kOnName = 1000.0;
constexpr double kOutside = 3000.0;
constexpr double kOnLine = 2.0;
constexpr double kMostOnLines = 60.0;
constexpr double kStepAway = 14.0;
constexpr int kRings = 5;
/// A point of a line every so many pixels is enough to feel a box of letters.
constexpr double kCrumb_px = 6.0;

struct Direction {
  Vec2 way;  ///< from the mark, y down
  double cost;
};
const std::array kDirections{
    Direction{{1.0, 0.0}, 0.0},   Direction{{0.8, -0.8}, 0.5}, Direction{{0.8, 0.8}, 1.0},
    Direction{{-1.0, 0.0}, 1.5},  Direction{{0.0, -1.0}, 2.0}, Direction{{0.0, 1.0}, 2.5},
    Direction{{-0.8, -0.8}, 3.0}, Direction{{-0.8, 0.8}, 3.5},
};

/// The box whose nearest side is `gap` away from the point in that direction.
[[nodiscard]] RectPx box_at(const Vec2& at_px, const Vec2& way, double gap, const Vec2& size) {
  const auto side = [](double share) { return share > 0.1 ? 1.0 : share < -0.1 ? -1.0 : 0.0; };
  const Vec2 middle =
      at_px + gap * way + Vec2{side(way.x()) * size.x() / 2.0, side(way.y()) * size.y() / 2.0};
  return {middle.x() - size.x() / 2.0, middle.y() - size.y() / 2.0, size.x(), size.y()};
}

[[nodiscard]] bool holds(const RectPx& box, const Vec2& p) {
  return p.x() > box.x && p.x() < box.right() && p.y() > box.y && p.y() < box.bottom();
}

}  // namespace

void LabelPlacer::avoid(std::span<const Vec2> line) {
  const RectPx near{within_.x - 50.0, within_.y - 50.0, within_.width + 100.0, within_.height + 100.0};
  Vec2 last{-1e9, -1e9};
  const auto drop = [&](const Vec2& p) {
    if (holds(near, p) && (p - last).norm() >= kCrumb_px) {
      crumbs_.push_back(p);
      last = p;
    }
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    drop(line[i]);
    if (i + 1 == line.size() || !(holds(near, line[i]) || holds(near, line[i + 1]))) {
      continue;
    }
    const Vec2 along = line[i + 1] - line[i];
    const int steps = static_cast<int>(along.norm() / kCrumb_px);
    for (int k = 1; k < steps; ++k) {
      drop(line[i] + along * (static_cast<double>(k) / steps));
    }
  }
}

double LabelPlacer::cost(const RectPx& box, const Vec2& at_px, double reach_px) const {
  double total = 0.0;
  if (box.x < within_.x || box.y < within_.y || box.right() > within_.right() ||
      box.bottom() > within_.bottom()) {
    total += kOutside;
  }
  for (const RectPx& other : taken_) {
    total += other.overlaps(box) ? kOnName : 0.0;
  }
  // Letters need air between them and a line: a third of their height.
  const double air = box.height / 3.0;
  const RectPx airy{box.x - air, box.y - air, box.width + 2.0 * air, box.height + 2.0 * air};
  const auto on_lines =
      std::count_if(crumbs_.begin(), crumbs_.end(), [&](const Vec2& p) { return holds(airy, p); });
  total += std::min(kMostOnLines, kOnLine * static_cast<double>(on_lines));
  return total + reach_px * 1e-3 + (box.center() - at_px).norm() * 1e-4;
}

LabelPlacer::Place LabelPlacer::place(const Vec2& at_px, double mark_radius_px, const Vec2& size_px) {
  Place best{box_at(at_px, kDirections[0].way, mark_radius_px, size_px), false};
  double least = 1e300;
  for (int ring = 0; ring < kRings; ++ring) {
    const double gap = mark_radius_px + ring * 0.9 * size_px.y();
    for (const Direction& direction : kDirections) {
      const RectPx box = box_at(at_px, direction.way, gap, size_px);
      const double total = cost(box, at_px, gap) + direction.cost + ring * kStepAway;
      if (total < least) {
        least = total;
        best = {box, ring > 1};
      }
    }
  }
  taken_.push_back(best.box);
  return best;
}

Vec2 leader_end(const LabelPlacer::Place& place, const Vec2& at_px) {
  return {std::clamp(at_px.x(), place.box.x, place.box.right()),
          std::clamp(at_px.y(), place.box.y, place.box.bottom())};
}

}  // namespace sensotwin::render
