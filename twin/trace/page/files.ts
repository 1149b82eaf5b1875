// SPDX-License-Identifier: MIT
// Between the page's document and what the server reads and writes (twin/trace/trace_document.hpp).
import type { Point } from "../../../robot/telemetry/pages/common/plan_view";
import { bearingOf, reversed, unit, wrapped_deg } from "./bearing";
import {
  emptyDoc,
  lengthOf,
  letters,
  metric,
  opposite,
  placeByName,
  rounded,
  type Doc,
  type Letter,
  type Place,
  type Plan,
  type Scene,
  type Side,
} from "./model";

type Json = Record<string, unknown>;
const pair = (p: Point): [number, number] => [p.x, p.y];
const point = (value: unknown): Point | null =>
  Array.isArray(value) && typeof value[0] === "number" && typeof value[1] === "number"
    ? { x: value[0], y: value[1] }
    : null;

function sideJson(doc: Doc, place: Place, side: Side): Json {
  const other = doc.places.find((each) => each.id === side.to);
  const length = lengthOf(doc, place, side);
  return {
    ...side.extra,
    to: other ? other.name : "?",
    ...(length === null ? {} : { length_m: length }),
    ...(side.bearing_deg === null ? {} : { bearing_deg: side.bearing_deg }),
    ...(side.tags.length > 0 ? { tags: side.tags } : {}),
    ...(side.tag_m === null ? {} : { tag_m: side.tag_m }),
  };
}

function placeJson(doc: Doc, place: Place): Json {
  const json: Json = { name: place.name, ...place.extra };
  if (metric(doc)) {
    json["at_m"] = pair(place.at);
  }
  for (const letter of letters) {
    const side = place.sides[letter];
    if (side) {
      json[letter] = sideJson(doc, place, side);
    }
  }
  return json;
}

function sceneJson(doc: Doc): Json {
  const { start, room, region, ceiling, tile_m, without, unreadable, ...plain } = doc.scene;
  return {
    ...plain,
    title: plain.title || "Traced",
    ...(start ? { start: { at_m: pair(start), heading_deg: start.heading_deg } } : {}),
    room_m: room.map(pair),
    carpet: { tile_m, ...(region ? { region_m: region.map(pair) } : {}), without, unreadable },
    ceiling_tags: ceiling.map((tag) => ({ name: tag.name, at_m: pair(tag.at), height_m: tag.height_m })),
  };
}

export function docJson(doc: Doc): Json {
  const { extra, ...settings } = doc.settings;
  return {
    tracing: 1,
    plan: doc.plan,
    // Where places were drawn, of use to this page alone: a plan without a scale has no metres to save.
    drawn_at: doc.places.map((place) => pair(place.at)),
    hallways: { version: 1, ...settings, ...extra, places: doc.places.map((place) => placeJson(doc, place)) },
    scene: sceneJson(doc),
  };
}

function readSide(json: Json, place: Place, doc: Doc, guessed: boolean): Side {
  const { to, length_m, bearing_deg, tags, tag_m, ...rest } = json;
  // What is no number is the reader's to refuse.
  const extra: Json = {
    ...rest,
    ...(bearing_deg !== undefined && typeof bearing_deg !== "number" ? { bearing_deg } : {}),
    ...(tag_m !== undefined && typeof tag_m !== "number" ? { tag_m } : {}),
  };
  const other = typeof to === "string" ? placeByName(doc, to) : undefined;
  const side: Side = {
    to: other ? other.id : null,
    length: typeof length_m === "number" ? length_m : other && !metric(doc) ? "drawn" : "unknown",
    bearing_deg: typeof bearing_deg === "number" ? wrapped_deg(bearing_deg) : null,
    tags: Array.isArray(tags) ? tags.map(String) : [],
    tag_m: typeof tag_m === "number" ? tag_m : null,
    extra,
  };
  // A length that was drawn follows the drawing; any other stays as it was written until its places are moved.
  if (other && !guessed && lengthOf(doc, place, { ...side, length: "drawn" }) === side.length) {
    side.length = "drawn";
  }
  return side;
}

/** Places for a map that has no metres: each as far from its neighbour as the hallway is long, or 6 m. */
function layOut(doc: Doc, known: Set<number>): void {
  const usual = 6;
  for (const seed of doc.places) {
    if (known.size > 0 && !known.has(seed.id)) {
      continue;
    }
    known.add(seed.id);
    const open = [seed];
    for (let place = open.shift(); place; place = open.shift()) {
      for (const letter of letters) {
        const side = place.sides[letter];
        const other = doc.places.find((each) => each.id === side?.to);
        if (side && other && !known.has(other.id)) {
          const far = typeof side.length === "number" ? side.length : usual;
          const way = unit(bearingOf(side, letter));
          other.at = rounded({ x: place.at.x + far * way.x, y: place.at.y + far * way.y });
          known.add(other.id);
          open.push(other);
        }
      }
    }
  }
  // What nothing leads to stands in a row of its own.
  const lowest = Math.min(0, ...doc.places.filter((place) => known.has(place.id)).map((place) => place.at.y));
  doc.places
    .filter((place) => !known.has(place.id))
    .forEach((place, i) => (place.at = { x: usual * i, y: lowest - usual }));
}

export function readHallways(doc: Doc, json: Json, drawnAt: unknown = null): { guessed: boolean } {
  const { version: _version, places, north_deg, width_m, tag_to_middle_m, tag_reach_m, ...extra } = json;
  const number = (value: unknown, otherwise: number) => (typeof value === "number" ? value : otherwise);
  doc.settings = {
    north_deg: number(north_deg, doc.settings.north_deg),
    width_m: number(width_m, doc.settings.width_m),
    tag_to_middle_m: number(tag_to_middle_m, doc.settings.tag_to_middle_m),
    tag_reach_m: number(tag_reach_m, doc.settings.tag_reach_m),
    extra,
  };
  const list = (Array.isArray(places) ? places : []) as Json[];
  const known = new Set<number>();
  const drawn = Array.isArray(drawnAt) ? drawnAt : [];
  doc.places = list.map((one, i) => {
    const { name, at_m, N: _n, E: _e, S: _s, W: _w, ...rest } = one;
    const at = point(drawn[i]) ?? point(at_m);
    const place: Place = { id: doc.nextId++, name: String(name), at: at ?? { x: 0, y: 0 }, sides: {}, extra: rest };
    if (at) {
      known.add(place.id);
    }
    return place;
  });
  const guessed = known.size < doc.places.length;
  doc.places.forEach((place, i) => {
    for (const letter of letters) {
      const side = list[i]?.[letter];
      if (side && typeof side === "object") {
        place.sides[letter] = readSide(side as Json, place, doc, guessed);
      }
    }
  });
  mendBackways(doc);
  if (guessed) {
    layOut(doc, known);
  }
  return { guessed };
}

/** A draft may hold hallways that do not lead back; the page draws those as it would connect them. */
function mendBackways(doc: Doc): void {
  for (const place of doc.places) {
    for (const letter of letters) {
      const side = place.sides[letter];
      const other = doc.places.find((each) => each.id === side?.to);
      if (side && other && !other.sides[opposite(letter)]) {
        other.sides[opposite(letter)] = {
          to: place.id,
          length: side.length,
          bearing_deg: reversed(side.bearing_deg),
          tags: [],
          tag_m: null,
          extra: {},
        };
      }
    }
  }
}

function readScene(scene: Scene, json: Json): void {
  const known = emptyDoc().scene as unknown as Json;
  for (const key of [
    "kind",
    "walls",
    "title",
    "seed",
    "from",
    "to",
    "survey",
    "explorer",
    "controller",
    "radio",
  ] as const) {
    if (typeof json[key] === typeof known[key]) {
      (scene as unknown as Json)[key] = json[key];
    }
  }
  const start = json["start"] as Json | undefined;
  const at = point(start?.["at_m"]);
  scene.start = at ? { ...at, heading_deg: Number(start?.["heading_deg"] ?? 0) } : null;
  const points = (value: unknown) => (Array.isArray(value) ? value.map(point).filter((p) => p !== null) : []);
  scene.room = points(json["room_m"]);
  const carpet = (json["carpet"] ?? {}) as Json;
  scene.tile_m = typeof carpet["tile_m"] === "number" ? carpet["tile_m"] : scene.tile_m;
  const [a, b] = points(carpet["region_m"]);
  scene.region = a && b ? [a, b] : null;
  const cells = (value: unknown) => points(value).map(pair);
  scene.without = cells(carpet["without"]);
  scene.unreadable = cells(carpet["unreadable"]);
  const tags = Array.isArray(json["ceiling_tags"]) ? (json["ceiling_tags"] as Json[]) : [];
  scene.ceiling = tags.flatMap((tag) => {
    const where = point(tag["at_m"]);
    return where ? [{ name: String(tag["name"]), at: where, height_m: Number(tag["height_m"] ?? 3) }] : [];
  });
}

/** The document of a tracing that the server opened. */
export function readDoc(json: Json): { doc: Doc; guessed: boolean } {
  const doc = emptyDoc();
  doc.plan = (json["plan"] as Plan | null) ?? null;
  const { guessed } = readHallways(doc, (json["hallways"] ?? {}) as Json, json["drawn_at"]);
  readScene(doc.scene, (json["scene"] ?? {}) as Json);
  return { doc, guessed };
}

export interface FileProblem {
  level: "error" | "advice";
  place: string;
  side: Letter | "";
  path: string;
  what: string;
  hint: string;
}
