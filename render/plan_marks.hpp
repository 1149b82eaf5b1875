// SPDX-License-Identifier: MIT
#pragma once

#include "render/canvas.hpp"

/// The signs of a plan of tags, by cairo. Angles are given as a direction on the picture.
namespace sensotwin::render {

/// Units: half a tag's mark.
inline constexpr double kTagMark = 9.5;

/// Below a ceiling tag; hollow when it is missing.
void paint_diamond(Canvas& canvas, const Vec2& c, double u, bool missing);
/// A ring with an arrow. `ring_px` is 9.5 units, or more around a robot that ended where it began.
void paint_start(Canvas& canvas, const Vec2& c, const Vec2& heading_px, double ring_px, double u);
void paint_robot(Canvas& canvas, const Vec2& c, double radius_px, const Vec2& heading_px, double u);
void paint_person(Canvas& canvas, const Vec2& c, double radius_px, double u);
/// Where a tag is believed to be.
void paint_cross(Canvas& canvas, const Vec2& c, double u);

}  // namespace sensotwin::render
