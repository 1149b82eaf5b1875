// SPDX-License-Identifier: MIT
// What the page draws, without a page: places, hallways between them by compass points, and what a scene adds.
// Metres, x east and y north. Functions that take a draft change it; history.ts hands them copies.
import type { Point } from "../../../robot/telemetry/pages/common/plan_view";
import { reversed } from "./bearing";

export const letters = ["N", "E", "S", "W"] as const;
export type Letter = (typeof letters)[number];
export const step: Readonly<Record<Letter, Point>> = {
  N: { x: 0, y: 1 },
  E: { x: 1, y: 0 },
  S: { x: 0, y: -1 },
  W: { x: -1, y: 0 },
};
export const sideNames: Readonly<Record<Letter, string>> = { N: "north", E: "east", S: "south", W: "west" };

/** Keys of the file that this page does not know: kept as they are. */
type Extra = Record<string, unknown>;

/** A hallway as it leaves a place on one side. `to` null: nobody knows where it leads. */
export interface Side {
  to: number | null;
  length: "drawn" | "unknown" | number;
  /** In which it leaves, clockwise from north; null: along its compass point. */
  bearing_deg: number | null;
  tags: string[];
  /** From these tags to the middle of the place; null: as everywhere in the building. */
  tag_m: number | null;
  extra: Extra;
}
export interface Place {
  id: number;
  name: string;
  at: Point;
  sides: Partial<Record<Letter, Side>>;
  extra: Extra;
}
/** A floor plan's picture and where it lies, as map_server spells it. */
export interface Plan {
  id: string;
  name: string;
  width_px: number;
  height_px: number;
  resolution_m: number;
  scaled: boolean;
  origin: [number, number, number];
  negate: boolean;
  occupied_thresh: number;
  free_thresh: number;
}
export interface CeilingTag {
  name: string;
  at: Point;
  height_m: number;
}
export interface Scene {
  kind: "hallway" | "carpet" | "ceiling";
  walls: "hallways" | "plan" | "room";
  title: string;
  seed: number;
  start: (Point & { heading_deg: number }) | null;
  from: string;
  to: string;
  survey: boolean;
  room: Point[];
  tile_m: number;
  region: [Point, Point] | null;
  without: [number, number][];
  unreadable: [number, number][];
  explorer: string;
  ceiling: CeilingTag[];
  controller: "own" | "fuzzy";
  radio: "paper" | "impinj_r420";
}
export interface Settings {
  north_deg: number;
  width_m: number;
  tag_to_middle_m: number;
  tag_reach_m: number;
  extra: Extra;
}
export interface Doc {
  plan: Plan | null;
  settings: Settings;
  places: Place[];
  scene: Scene;
  nextId: number;
}

export function emptyDoc(): Doc {
  return {
    plan: null,
    settings: { north_deg: 0, width_m: 2, tag_to_middle_m: 1, tag_reach_m: 0.3, extra: {} },
    places: [],
    scene: {
      kind: "hallway",
      walls: "hallways",
      title: "",
      seed: 7,
      start: null,
      from: "",
      to: "",
      survey: false,
      room: [],
      tile_m: 0.508,
      region: null,
      without: [],
      unreadable: [],
      explorer: "sweep",
      ceiling: [],
      controller: "own",
      radio: "paper",
    },
    nextId: 1,
  };
}

export function opposite(letter: Letter): Letter {
  return turned(letter, 2);
}
/** Clockwise by quarter turns. */
export function turned(letter: Letter, quarters: number): Letter {
  return letters[(((letters.indexOf(letter) + quarters) % 4) + 4) % 4] as Letter;
}
export function distance(a: Point, b: Point): number {
  return Math.hypot(b.x - a.x, b.y - a.y);
}
/** To the centimetre, so that files hold 7 and not 7.000000000001. */
export function rounded(p: Point): Point {
  const cm = (v: number) => Math.round(v * 100) / 100 + 0;
  return { x: cm(p.x), y: cm(p.y) };
}

export function placeById(doc: Doc, id: number): Place | undefined {
  return doc.places.find((place) => place.id === id);
}
export function placeByName(doc: Doc, name: string): Place | undefined {
  return doc.places.find((place) => place.name === name);
}
/** Whether metres mean anything: on a blank sheet they do, on a plan once it has a scale. */
export function metric(doc: Doc): boolean {
  return doc.plan === null || doc.plan.scaled;
}

export interface HallwayEnd {
  place: Place;
  letter: Letter;
  side: Side;
}
/** Every hallway whose ends are both known, once. */
export function hallways(doc: Doc): { a: Place; b: Place; letter: Letter; side: Side }[] {
  const found: { a: Place; b: Place; letter: Letter; side: Side }[] = [];
  for (const a of doc.places) {
    for (const letter of letters) {
      const side = a.sides[letter];
      const b = side?.to == null ? undefined : placeById(doc, side.to);
      if (side && b && (a.id < b.id || b.sides[opposite(letter)]?.to !== a.id)) {
        found.push({ a, b, letter, side });
      }
    }
  }
  return found;
}
/** The length that the file will say, m; null: none. */
export function lengthOf(doc: Doc, place: Place, side: Side): number | null {
  if (typeof side.length === "number") {
    return side.length;
  }
  const other = side.to === null ? undefined : placeById(doc, side.to);
  if (side.length === "unknown" || !other || !metric(doc)) {
    return null;
  }
  return Math.round(distance(place.at, other.at) * 100) / 100;
}
/** Intersection, junction, bend, passage or end, by its hallways. */
export function kindOf(place: Place): string {
  const open = letters.filter((letter) => place.sides[letter]);
  if (open.length === 2) {
    return opposite(open[0] as Letter) === open[1] ? "Passage" : "Bend";
  }
  return ["Place", "End", "Bend", "Junction", "Intersection"][open.length] as string;
}

/** a, b ... z, aa ...: the first name that is free. */
export function freeName(doc: Doc): string {
  for (let i = 0; ; ++i) {
    const name = i < 26 ? String.fromCharCode(97 + i) : String.fromCharCode(96 + Math.floor(i / 26), 97 + (i % 26));
    if (!placeByName(doc, name)) {
      return name;
    }
  }
}
/** The lowest number that no side has yet. */
export function freeTag(doc: Doc): string {
  const taken = new Set(doc.places.flatMap((place) => letters.flatMap((letter) => place.sides[letter]?.tags ?? [])));
  let number = 1;
  while (taken.has(String(number))) {
    ++number;
  }
  return String(number);
}

export function addPlace(draft: Doc, at: Point): Place {
  const place: Place = { id: draft.nextId++, name: freeName(draft), at: rounded(at), sides: {}, extra: {} };
  draft.places.push(place);
  return place;
}

/** No hallway on this side any more; its other end leads nowhere either. */
export function clearSide(draft: Doc, place: Place, letter: Letter): void {
  const side = place.sides[letter];
  delete place.sides[letter];
  const other = side?.to == null ? undefined : placeById(draft, side.to);
  if (other?.sides[opposite(letter)]?.to === place.id) {
    delete other.sides[opposite(letter)];
  }
}

/** A side that leads nowhere yet, with what was said of the one that was there: its tags, where they lie, its bearing. */
function sideLike(old: Side | undefined): Side {
  return {
    to: null,
    length: "unknown",
    bearing_deg: old?.bearing_deg ?? null,
    tags: old?.tags ?? [],
    tag_m: old?.tag_m ?? null,
    extra: {},
  };
}

/** A hallway whose far end nobody knows. Tags and bearing stay. */
export function setUnknown(draft: Doc, place: Place, letter: Letter): void {
  const side = sideLike(place.sides[letter]);
  clearSide(draft, place, letter);
  place.sides[letter] = side;
}

/**
 * A hallway from `a`, left on that side, to `b`. What was on either side is replaced, tags stay.
 * \param bearing  left out: as the sides said before
 */
export function connect(draft: Doc, a: Place, letter: Letter, b: Place, bearing?: number | null): void {
  const back = opposite(letter);
  const out = sideLike(a.sides[letter]);
  const home = sideLike(b.sides[back]);
  const leaves = bearing === undefined ? (out.bearing_deg ?? reversed(home.bearing_deg)) : bearing;
  if (a.sides[letter]?.to !== b.id) {
    clearSide(draft, a, letter);
  }
  if (b.sides[back]?.to !== a.id) {
    clearSide(draft, b, back);
  }
  a.sides[letter] = { ...out, to: b.id, length: "drawn", bearing_deg: leaves };
  b.sides[back] = { ...home, to: a.id, length: "drawn", bearing_deg: reversed(leaves) };
}

/** A place on a hallway: both halves lead to it, and keep the bearing and the tags of the ends. */
export function splitHallway(draft: Doc, a: Place, letter: Letter, at: Point): Place {
  const far = placeById(draft, a.sides[letter]?.to ?? -1);
  const home = far?.sides[opposite(letter)];
  const bearing = a.sides[letter]?.bearing_deg ?? null;
  const middle = addPlace(draft, at);
  connect(draft, a, letter, middle, bearing);
  if (far) {
    if (home) {
      far.sides[opposite(letter)] = sideLike(home);
    }
    connect(draft, middle, letter, far, bearing);
  }
  return middle;
}

/** Both ends of a hallway say the same length. */
export function setLength(draft: Doc, place: Place, letter: Letter, length: Side["length"]): void {
  const side = place.sides[letter];
  if (!side) {
    return;
  }
  side.length = length;
  const back = side.to === null ? undefined : placeById(draft, side.to)?.sides[opposite(letter)];
  if (back && back.to === place.id) {
    back.length = length;
  }
}

export function removePlace(draft: Doc, place: Place): void {
  for (const letter of letters) {
    clearSide(draft, place, letter);
  }
  draft.places = draft.places.filter((each) => each !== place);
  for (const key of ["from", "to"] as const) {
    if (draft.scene[key] === place.name) {
      draft.scene[key] = "";
    }
  }
}

export function rename(draft: Doc, place: Place, name: string): void {
  for (const key of ["from", "to"] as const) {
    if (draft.scene[key] === place.name) {
      draft.scene[key] = name;
    }
  }
  place.name = name;
}

/** Numbers for all sides that are met without a tag. \returns how many */
export function numberTags(draft: Doc): number {
  let given = 0;
  for (const place of draft.places) {
    for (const letter of letters) {
      const side = place.sides[letter];
      if (side && side.tags.length === 0) {
        side.tags = [freeTag(draft)];
        ++given;
      }
    }
  }
  return given;
}
