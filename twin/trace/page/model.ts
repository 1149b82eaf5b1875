// SPDX-License-Identifier: MIT
// What the page draws, without a page: places, hallways between them by compass points, and what a scene adds.
// Metres, x east and y north. Functions that take a draft change it; history.ts hands them copies.
import type { Point } from "../../../robot/telemetry/pages/common/plan_view";

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
  tags: string[];
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

/** A hallway whose far end nobody knows. Tags stay. */
export function setUnknown(draft: Doc, place: Place, letter: Letter): void {
  const tags = place.sides[letter]?.tags ?? [];
  clearSide(draft, place, letter);
  place.sides[letter] = { to: null, length: "unknown", tags, extra: {} };
}

/** A hallway from `a`, left on that side, to `b`. What was on either side is replaced, tags stay. */
export function connect(draft: Doc, a: Place, letter: Letter, b: Place): void {
  const back = opposite(letter);
  const tags = [a.sides[letter]?.tags ?? [], b.sides[back]?.tags ?? []] as const;
  if (a.sides[letter]?.to !== b.id) {
    clearSide(draft, a, letter);
  }
  if (b.sides[back]?.to !== a.id) {
    clearSide(draft, b, back);
  }
  a.sides[letter] = { to: b.id, length: "drawn", tags: tags[0], extra: {} };
  b.sides[back] = { to: a.id, length: "drawn", tags: tags[1], extra: {} };
}

/** A place on a hallway: both halves lead to it. */
export function splitHallway(draft: Doc, a: Place, letter: Letter, at: Point): Place {
  const far = placeById(draft, a.sides[letter]?.to ?? -1);
  const middle = addPlace(draft, at);
  connect(draft, a, letter, middle);
  if (far) {
    connect(draft, middle, letter, far);
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
 * the compass points that now fit them best.
 */
export function turnBy(draft: Doc, radians: number): void {
  const cos = Math.cos(radians);
  const sin = Math.sin(radians);
  const turn = (p: Point) => ({ x: cos * p.x - sin * p.y, y: sin * p.x + cos * p.y });
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
  const quarters = bestQuarters(draft, radians);
  for (const place of draft.places) {
    const sides: Place["sides"] = {};
    for (const letter of letters) {
      const side = place.sides[letter];
      if (side) {
        sides[turned(letter, -quarters)] = side;
      }
    }
    place.sides = sides;
  }
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
