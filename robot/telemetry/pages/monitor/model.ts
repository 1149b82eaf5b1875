// SPDX-License-Identifier: MIT
// What the page knows of each robot, built from telemetry messages (docs/monitor.md). Coordinates: metres, in the
// robot's own frame M, but for the true room and the true pose of a twin, which are in the room's frame W.
import type { Point } from "../common/plan_view";

export interface Pose extends Point {
  yaw: number;
  t: number;
}
export type TileState = "open" | "closed" | "given_up";
export interface Tile {
  column: number;
  row: number;
  state: TileState;
  /** Bits: 1 east, 2 north, 4 west, 8 south. */
  blocked: number;
  tag?: string;
  written: boolean;
  found_s?: number;
}
export interface LogEvent {
  n: number;
  t: number;
  event: string;
  of: Record<string, unknown>;
}
export interface PlaceSide {
  /** 0 none, 1 unknown, 2 leads to a place. */
  h: number;
  to?: string;
  m?: number;
  tags: string[];
}
export interface Place {
  name: string;
  at: Point | null;
  sides: Record<string, PlaceSide>;
}
export interface Way {
  place: string;
  way_m: number;
  heading?: number;
  /** Of the hallway that it is in: radians, counter-clockwise from the plan's north, as heading. */
  axis?: number;
  leaving?: string;
  to?: string;
}
export interface CeilingTag extends Point {
  name: string;
  xx: number;
  xy: number;
  yy: number;
  kept: boolean;
}
export interface SceneWall {
  points: [number, number][];
  closed: boolean;
}
export interface SceneFurniture {
  name: string;
  outline: [number, number][];
  circles: { x: number; y: number; radius: number }[];
}
export interface Scene {
  scene: string;
  title: string;
  seed: string;
  north: number;
  walls: SceneWall[];
  furniture: SceneFurniture[];
  ceiling: (Point & { name: string })[];
  landmarks: (Point & { name: string })[];
  path?: [number, number][];
}
export interface Card {
  name: string;
  title: string;
  source: string;
  mission: string;
  tile_m: number;
  radius_m: number;
  goal: string;
}
type Figures = Record<string, unknown>;

export class Robot {
  card: Card = { name: "", title: "", source: "", mission: "map", tile_m: 0.508, radius_m: 0.17, goal: "" };
  scene: Scene | null = null;
  /** Tiles that can be reached, where a twin knows it. */
  total: number | null = null;
  frame: Pose | null = null;
  pose: Pose | null = null;
  truth: Pose | null = null;
  sure: { xx: number; xy: number; yy: number } | null = null;
  readonly trail = new Map<number, Point>();
  /** Of a twin whose program believes no pose. */
  readonly trueTrail = new Map<number, Point>();
  /** Of a twin: who walks about. */
  people: (Point & { radius: number })[] = [];
  readonly tiles = new Map<string, Tile>();
  readonly objects = new Map<string, LogEvent>();
  readonly places = new Map<string, Place>();
  way: Way | null = null;
  readonly ceiling = new Map<string, CeilingTag>();
  readonly events = new Map<number, LogEvent>();
  readonly series = new Map<string, Map<number, { t: number; v: number }>>();
  /** Of a robot whose monitor this program reads: whether that one answers. */
  linked = true;
  /** Where that monitor is. */
  at = "";
  /** Of the machine: what is wrong with each device that is not there. */
  readonly gone = new Map<string, string>();
  status: Figures = {};
  base: Figures = {};
  ended: { t: number; outcome: string } | null = null;
  now = 0;

  constructor(readonly id: number) {}

  /** As its card says; before that, where it is looked for. */
  get name(): string {
    return this.card.name !== "" ? this.card.name : this.at !== "" ? this.at.replace("http://", "") : "robot";
  }
  get tilesFound(): number {
    let found = 0;
    for (const tile of this.tiles.values()) {
      found += tile.state === "given_up" ? 0 : 1;
    }
    return found;
  }
  /** Events in the order in which they happened. */
  get eventsInOrder(): LogEvent[] {
    return [...this.events.values()].sort((a, b) => a.n - b.n);
  }
  samples(of: string): { t: number; v: number }[] {
    return [...(this.series.get(of)?.values() ?? [])].sort((a, b) => a.t - b.t);
  }
}

/** As many as the program keeps: what it has forgotten is forgotten here too. */
const eventsKept = 2000;
const trailKept = 8192;

function forgetOld<T>(of: Map<number, T>, newest: number, kept: number): void {
  of.delete(newest - kept);
}

type Message = Record<string, unknown> & { k: string; r: number };

function num(of: Message, key: string): number {
  const value = of[key];
  return typeof value === "number" ? value : 0;
}
function text(of: Message, key: string): string {
  const value = of[key];
  return typeof value === "string" ? value : "";
}
function pose(of: Message): Pose {
  return { x: num(of, "x"), y: num(of, "y"), yaw: num(of, "yaw"), t: num(of, "t") };
}

function leave(trail: Map<number, Point>, of: Message): void {
  trail.set(num(of, "n"), { x: num(of, "x"), y: num(of, "y") });
  forgetOld(trail, num(of, "n"), trailKept);
}

export class Model {
  readonly robots = new Map<number, Robot>();

  get inOrder(): Robot[] {
    return [...this.robots.values()].sort((a, b) => a.id - b.id);
  }

  robot(id: number): Robot {
    const known = this.robots.get(id);
    if (known) {
      return known;
    }
    const made = new Robot(id);
    this.robots.set(id, made);
    return made;
  }

  /** Takes the data of one server-sent event. What it does not know it leaves: pages and programs may differ in age. */
  take(data: string): void {
    const message = JSON.parse(data) as Message;
    if (message.k === "reset") {
      this.robots.clear();
      return;
    }
    if (message.k === "restarted") {
      const old = this.robot(num(message, "r"));
      this.robots.set(old.id, Object.assign(new Robot(old.id), { linked: old.linked, at: old.at }));
    }
    const robot = this.robot(num(message, "r"));
    if (typeof message["t"] === "number" && message.k !== "tile") {
      robot.now = Math.max(robot.now, message["t"]);
    }
    takers[message.k]?.(robot, message);
  }
}

const takers: Record<string, (robot: Robot, of: Message) => void> = {
  total: (robot, of) => {
    robot.total = num(of, "tiles");
  },
  link: (robot, of) => {
    robot.linked = of["up"] === true;
    robot.at = text(of, "at");
  },
  robot: (robot, of) => {
    robot.card = of as unknown as Card;
  },
  scene: (robot, of) => {
    robot.scene = of as unknown as Scene;
  },
  frame: (robot, of) => {
    robot.frame = pose(of);
  },
  pose: (robot, of) => {
    robot.pose = pose(of);
  },
  truth: (robot, of) => {
    robot.truth = pose(of);
  },
  sure: (robot, of) => {
    robot.sure = { xx: num(of, "xx"), xy: num(of, "xy"), yy: num(of, "yy") };
  },
  trail: (robot, of) => leave(robot.trail, of),
  true_trail: (robot, of) => leave(robot.trueTrail, of),
  people: (robot, of) => {
    robot.people = of["at"] as Robot["people"];
  },
  tile: (robot, of) => {
    const key = `${num(of, "c")},${num(of, "w")}`;
    if (text(of, "s") === "unknown") {
      robot.tiles.delete(key);
      return;
    }
    robot.tiles.set(key, {
      column: num(of, "c"),
      row: num(of, "w"),
      state: text(of, "s") as TileState,
      blocked: num(of, "b"),
      written: of["written"] === true,
      ...(typeof of["tag"] === "string" ? { tag: of["tag"] } : {}),
      ...(typeof of["t"] === "number" ? { found_s: of["t"] } : {}),
    });
  },
  object: (robot, of) => {
    const event = of as unknown as LogEvent;
    robot.objects.set(String(event.of["tag"]), event);
  },
  event: (robot, of) => {
    const event = of as unknown as LogEvent;
    robot.events.set(event.n, event);
    const device = event.of["device"];
    if (event.event === "device_gone") {
      robot.gone.set(String(device), String(event.of["why"] ?? ""));
    } else if (event.event === "device_there") {
      robot.gone.delete(String(device));
    }
    forgetOld(robot.events, num(of, "n"), eventsKept);
  },
  place: (robot, of) => {
    const at = typeof of["x"] === "number" ? { x: num(of, "x"), y: num(of, "y") } : null;
    robot.places.set(text(of, "name"), { name: text(of, "name"), at, sides: of["sides"] as Place["sides"] });
  },
  way: (robot, of) => {
    robot.way = of as unknown as Way;
  },
  ceiling: (robot, of) => {
    robot.ceiling.set(text(of, "name"), of as unknown as CeilingTag);
  },
  sample: (robot, of) => {
    const name = text(of, "of");
    const series = robot.series.get(name) ?? new Map<number, { t: number; v: number }>();
    series.set(num(of, "n"), { t: num(of, "t"), v: num(of, "v") });
    robot.series.set(name, series);
  },
  status: (robot, of) => {
    robot.status = of;
  },
  base: (robot, of) => {
    robot.base = of;
  },
  ended: (robot, of) => {
    robot.ended = { t: num(of, "t"), outcome: text(of, "outcome") };
  },
};
