// SPDX-License-Identifier: MIT
// Strokes snap to compass points, to other places and to hallways.
import type { Point } from "../../../robot/telemetry/pages/common/plan_view";
import { distance, letters, rounded, step, type Doc, type Letter } from "./model";

/** A stroke within this of a compass point runs along it. Chosen: a hand without a ruler; beyond, it is not clear. */
export const tolerance_deg = 30;
/** CSS pixels within which a stroke ends in line with another place. */
const alignment_px = 9;

export interface Stroke {
  letter: Letter;
  off_deg: number;
}
/** The compass point that a stroke runs along, and how far off it is. */
export function strokeFrom(a: Point, b: Point): Stroke {
  const way = { x: b.x - a.x, y: b.y - a.y };
  const off = (letter: Letter) =>
    Math.abs(
      Math.atan2(step[letter].x * way.y - step[letter].y * way.x, step[letter].x * way.x + step[letter].y * way.y),
    );
  const letter = letters.reduce((best, each) => (off(each) < off(best) ? each : best));
  return { letter, off_deg: (off(letter) * 180) / Math.PI };
}

/** In line with another place where one is near, else on a grid of 10 cm. */
function aligned(value: number, others: number[], scale: number): number {
  const near = others.filter((other) => Math.abs(other - value) * scale <= alignment_px);
  return near.length > 0
    ? near.reduce((best, other) => (Math.abs(other - value) < Math.abs(best - value) ? other : best))
    : Math.round(value * 10) / 10;
}
export function alignedPoint(doc: Doc, p: Point, scale: number, without = -1): Point {
  const others = doc.places.filter((place) => place.id !== without).map((place) => place.at);
  return rounded({
    x: aligned(
      p.x,
      others.map((at) => at.x),
      scale,
    ),
    y: aligned(
      p.y,
      others.map((at) => at.y),
      scale,
    ),
  });
}
/** Where a stroke from `a` towards `p` ends: exactly on its compass point. */
export function strokeEnd(doc: Doc, a: Point, p: Point, letter: Letter, scale: number): Point {
  const end = alignedPoint(doc, p, scale);
  return letter === "E" || letter === "W" ? { x: end.x, y: a.y } : { x: a.x, y: end.y };
}
/** Where the line from `a` through `b` meets the one from `c` to `d`, to the centimetre; null: it does not. */
export function crossing(a: Point, b: Point, c: Point, d: Point): Point | null {
  const way = { x: b.x - a.x, y: b.y - a.y };
  const across = { x: d.x - c.x, y: d.y - c.y };
  const turn = way.x * across.y - way.y * across.x;
  // Nearly side by side: the point would lie anywhere.
  if (Math.abs(turn) < 0.1 * distance(a, b) * distance(c, d)) {
    return null;
  }
  const t = ((a.x - c.x) * way.y - (a.y - c.y) * way.x) / -turn;
  return t < 0 || t > 1 ? null : rounded({ x: c.x + t * across.x, y: c.y + t * across.y });
}
/** Whether a stroke is long enough to be meant. */
export function isStroke(a: Point, b: Point, scale: number): boolean {
  return distance(a, b) * scale > 14;
}
