// SPDX-License-Identifier: MIT
// In which direction hallways leave: degrees clockwise from north, as bearing_deg of the file says it.
import type { Point } from "../../../robot/telemetry/pages/common/plan_view";
import { hallways, letters, opposite, placeById, type Doc, type Letter, type Place, type Side } from "./model";

export const compass_deg: Readonly<Record<Letter, number>> = { N: 0, E: 90, S: 180, W: 270 };

/** So far off its compass point a hallway may leave: the reader's own limit (robot/topology/hallway_map.hpp). */
export const offPoint_deg = 45;
/** Chosen: as straight as a hand draws; the robot corrects 5 degrees by what the walls show (docs/hallways.md). */
const square_deg = 3;
/** Bearings are written to the degree. */
const sameBearing_deg = 1;
/** Chosen: lengths are often written to the decimetre. */
const sameLength_m = 0.051;

export function wrapped_deg(deg: number): number {
  return (((deg % 360) + 360) % 360) + 0;
}
/** Between two directions, from 0 to 180. */
export function apart_deg(a: number, b: number): number {
  return Math.abs(wrapped_deg(a - b + 180) - 180);
}
export function drawn_deg(a: Point, b: Point): number {
  return wrapped_deg((Math.atan2(b.x - a.x, b.y - a.y) * 180) / Math.PI);
}
/** As words on the page say it: 43°. */
export function degrees(deg: number): string {
  return `${Number(wrapped_deg(deg).toFixed(1))}°`;
}
export function unit(deg: number): Point {
  return { x: Math.sin((deg * Math.PI) / 180), y: Math.cos((deg * Math.PI) / 180) };
}

/** As the file says it. */
export function bearingOf(side: Side | undefined, letter: Letter): number {
  return side?.bearing_deg ?? compass_deg[letter];
}
/** As the drawing shows a side: towards its neighbour, else as the file says it. */
export function shown_deg(doc: Doc, place: Place, letter: Letter): number {
  const side = place.sides[letter];
  const other = side?.to == null ? undefined : placeById(doc, side.to);
  return other ? drawn_deg(place.at, other.at) : bearingOf(side, letter);
}
/** The whole degree; null where that is the compass point itself, or too near to it to be meant. */
export function asBearing(deg: number, letter: Letter, least_deg = square_deg): number | null {
  return apart_deg(deg, compass_deg[letter]) < least_deg ? null : wrapped_deg(Math.round(deg));
}
/** Compass points that a hallway in this direction may have, nearest first. */
export function lettersFor(deg: number): Letter[] {
  return letters
    .filter((letter) => apart_deg(deg, compass_deg[letter]) <= offPoint_deg + 0.5)
    .sort((one, other) => apart_deg(deg, compass_deg[one]) - apart_deg(deg, compass_deg[other]));
}

/** Whether the file says of a hallway what the drawing shows. */
export function bearingIsDrawn(side: Side, letter: Letter, a: Point, b: Point): boolean {
  const off = apart_deg(bearingOf(side, letter), drawn_deg(a, b));
  return off <= (side.bearing_deg === null ? square_deg : sameBearing_deg);
}

/** Both ends of a hallway say the same direction; null: along the compass point. */
export function setBearing(draft: Doc, place: Place, letter: Letter, bearing: number | null): void {
  const side = place.sides[letter];
  if (!side) {
    return;
  }
  side.bearing_deg = bearing;
  const back = side.to === null ? undefined : placeById(draft, side.to)?.sides[opposite(letter)];
  if (back && back.to === place.id) {
    back.bearing_deg = reversed(bearing);
  }
}
export function reversed(bearing: number | null): number | null {
  return bearing === null ? null : wrapped_deg(bearing + 180);
}

/** What of the hallways at a place follows it when it is moved: what was as drawn, not what was typed otherwise. */
export interface Followers {
  bearings: Letter[];
  lengths: Letter[];
}
export function followersOf(doc: Doc, place: Place): Followers {
  const known = letters.flatMap((letter) => {
    const side = place.sides[letter];
    const other = side?.to == null ? undefined : placeById(doc, side.to);
    return side && other ? [{ letter, side, other }] : [];
  });
  return {
    bearings: known
      .filter(({ letter, side, other }) => bearingIsDrawn(side, letter, place.at, other.at))
      .map(({ letter }) => letter),
    lengths: known
      .filter(
        ({ side, other }) =>
          typeof side.length === "number" &&
          Math.abs(side.length - Math.hypot(other.at.x - place.at.x, other.at.y - place.at.y)) < sameLength_m,
      )
      .map(({ letter }) => letter),
  };
}
export function bearingsAsDrawn(draft: Doc, place: Place, followers: readonly Letter[]): void {
  for (const letter of followers) {
    setBearing(draft, place, letter, asBearing(shown_deg(draft, place, letter), letter));
  }
}

/**
 * Hallways that leave too far off their compass point by now go over to the one that is nearer, with their tags, where
 * it is free at both ends. \returns whether any did
 */
export function regroup(draft: Doc): boolean {
  let any = false;
  // One that makes room for another is seen to in the next pass.
  for (let pass = 0; pass < letters.length; ++pass) {
    for (const { a, b, letter, side } of hallways(draft)) {
      const bearing = bearingOf(side, letter);
      const better = lettersFor(bearing)[0];
      const late = apart_deg(bearing, compass_deg[letter]) > offPoint_deg + 0.5;
      const back = b.sides[opposite(letter)];
      if (late && better && back && !a.sides[better] && !b.sides[opposite(better)]) {
        delete a.sides[letter];
        delete b.sides[opposite(letter)];
        a.sides[better] = side;
        b.sides[opposite(better)] = back;
        setBearing(draft, a, better, asBearing(bearing, better));
        any = true;
      }
    }
  }
  return any;
}
