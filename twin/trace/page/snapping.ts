// SPDX-License-Identifier: MIT
// Strokes become hallways along compass points.
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
/** Whether a stroke is long enough to be meant. */
export function isStroke(a: Point, b: Point, scale: number): boolean {
  return distance(a, b) * scale > 14;
}
