// SPDX-License-Identifier: MIT
// The drawing as a whole: scaled and turned with its plan.
import type { Point } from "../../../robot/telemetry/pages/common/plan_view";
import { asBearing, bearingOf, bearingsAsDrawn, followersOf, regroup } from "./bearing";
import { hallways, letters, rounded, step, turned, type Doc, type Place, type Side } from "./model";

/** Everything that was drawn, moved in the same way. */
function moveAll(draft: Doc, move: (p: Point) => Point): void {
  const to = (p: Point) => rounded(move(p));
  for (const place of draft.places) {
    place.at = to(place.at);
  }
  const scene = draft.scene;
  scene.room = scene.room.map(to);
  scene.ceiling = scene.ceiling.map((tag) => ({ ...tag, at: to(tag.at) }));
  scene.region = scene.region && [to(scene.region[0]), to(scene.region[1])];
  scene.start = scene.start && { ...scene.start, ...to(scene.start) };
}

/** The plan is `ratio` times as large as it was; what was drawn on it stays on it. */
export function scaleBy(draft: Doc, ratio: number): void {
  if (draft.plan) {
    draft.plan.resolution_m *= ratio;
    draft.plan.origin = [draft.plan.origin[0] * ratio, draft.plan.origin[1] * ratio, draft.plan.origin[2]];
    draft.plan.scaled = true;
  }
  moveAll(draft, (p) => ({ x: p.x * ratio, y: p.y * ratio }));
}

/**
 * Turns plan and drawing counter-clockwise, so that what pointed that much clockwise of north is north. Hallways keep
 * the compass points that now fit them best, and say how far off those they leave.
 */
export function turnBy(draft: Doc, radians: number): void {
  const cos = Math.cos(radians);
  const sin = Math.sin(radians);
  const turn = (p: Point) => ({ x: cos * p.x - sin * p.y, y: sin * p.x + cos * p.y });
  const followers = new Set(
    draft.places.flatMap((place) => followersOf(draft, place).bearings.map((letter) => place.sides[letter])),
  );
  if (draft.plan) {
    const corner = turn({ x: draft.plan.origin[0], y: draft.plan.origin[1] });
    draft.plan.origin = [corner.x, corner.y, wrapAngle(draft.plan.origin[2] + radians)];
  }
  moveAll(draft, turn);
  draft.scene.without = [];
  draft.scene.unreadable = [];
  if (draft.scene.start) {
    draft.scene.start.heading_deg =
      Math.round(((draft.scene.start.heading_deg + (radians * 180) / Math.PI) % 360) * 10) / 10;
  }
  turnSides(draft, (-radians * 180) / Math.PI, bestQuarters(draft, radians), followers);
}
/**
 * \param by_deg  clockwise  \param quarters  counter-clockwise, of the compass points
 * \param followers  sides whose bearing was as drawn
 */
function turnSides(draft: Doc, by_deg: number, quarters: number, followers: Set<Side | undefined>): void {
  for (const place of draft.places) {
    const sides: Place["sides"] = {};
    for (const letter of letters) {
      const side = place.sides[letter];
      if (side) {
        const now = turned(letter, -quarters);
        sides[now] = side;
        // A neighbour that nobody drew where its compass point says is no reason to write another bearing.
        if (side.bearing_deg !== null || side.to === null) {
          side.bearing_deg = asBearing(bearingOf(side, letter) + by_deg, now);
        }
      }
    }
    place.sides = sides;
  }
  for (const place of draft.places) {
    bearingsAsDrawn(
      draft,
      place,
      letters.filter((letter) => followers.has(place.sides[letter])),
    );
  }
  regroup(draft);
}
function bestQuarters(doc: Doc, radians: number): number {
  const drawn = hallways(doc);
  if (drawn.length === 0) {
    return Math.round(radians / (Math.PI / 2));
  }
  const misfit = (quarters: number) =>
    drawn.reduce((sum, { a, b, letter }) => {
      const along = step[turned(letter, -quarters)];
      const way = { x: b.at.x - a.at.x, y: b.at.y - a.at.y };
      return sum + Math.atan2(along.x * way.y - along.y * way.x, along.x * way.x + along.y * way.y) ** 2;
    }, 0);
  return [0, 1, -1, 2].reduce((best, quarters) => (misfit(quarters) < misfit(best) - 1e-9 ? quarters : best));
}
export function wrapAngle(radians: number): number {
  return Math.atan2(Math.sin(radians), Math.cos(radians));
}
