// SPDX-License-Identifier: MIT
// What can be pointed at, by mouse, finger or key: tags of the floor, of walls and furniture, of the ceiling, and places.
import type { Point } from "../common/plan_view";
import { placePoints, toPlan } from "./layout";
import type { LogEvent, Robot } from "./model";
import { clock } from "./words";

export interface Target {
  key: string;
  at: Point;
  title: string;
  facts: [string, string][];
}

/** From where the robot stood when it read a tag ahead of it, to the tag. Chosen: body and reach of the antenna. */
const ahead_m = 0.25;

export function objectPoint(robot: Robot, event: LogEvent): Point {
  const value = (key: string) => (typeof event.of[key] === "number" ? (event.of[key] as number) : 0);
  const yaw = value("yaw_rad");
  return toPlan(robot, { x: value("x_m") + ahead_m * Math.cos(yaw), y: value("y_m") + ahead_m * Math.sin(yaw) });
}

export function objectName(event: LogEvent): string {
  if (event.event === "furniture_seen") {
    return "furniture";
  }
  return typeof event.of["kind"] === "string" ? event.of["kind"] : "landmark";
}

function objectFacts(event: LogEvent): [string, string][] {
  const facts: [string, string][] = [["Tag", String(event.of["tag"])]];
  for (const key of ["kind", "category", "length", "width", "color"]) {
    if (event.of[key] !== undefined) {
      facts.push([key[0]?.toUpperCase() + key.slice(1), String(event.of[key])]);
    }
  }
  facts.push(["Read at", clock(event.t)]);
  return facts;
}

/** In reading order: by rows from the top, each from the left. */
export function targetsOf(robot: Robot): Target[] {
  const targets: Target[] = [];
  for (const [key, tile] of robot.tiles) {
    if (tile.tag === undefined) {
      continue;
    }
    targets.push({
      key: `tile/${key}`,
      at: toPlan(robot, { x: tile.column * robot.card.tile_m, y: tile.row * robot.card.tile_m }),
      title: `Floor tag, column ${tile.column}, row ${tile.row}`,
      facts: [
        ["Tag", tile.tag],
        ["Coordinates", tile.written ? `${tile.column}, ${tile.row}: written and verified` : "not written yet"],
        ["Tile", tile.state === "closed" ? "visited, closed" : "visited, a neighbour is open"],
        ...(tile.found_s !== undefined ? ([["Found at", clock(tile.found_s)]] as [string, string][]) : []),
      ],
    });
  }
  for (const [key, event] of robot.objects) {
    targets.push({
      key: `object/${key}`,
      at: objectPoint(robot, event),
      title: event.event === "furniture_seen" ? "Tag on furniture" : "Tag at the wall",
      facts: objectFacts(event),
    });
  }
  for (const tag of robot.ceiling.values()) {
    const sigma = (variance: number) => `${(100 * Math.sqrt(Math.max(variance, 0))).toFixed(1)} cm`;
    targets.push({
      key: `ceiling/${tag.name}`,
      at: toPlan(robot, tag),
      title: `Ceiling tag ${tag.name}`,
      facts: [
        ["Estimated at", `${tag.x.toFixed(2)} m, ${tag.y.toFixed(2)} m`],
        ["One sigma", `${sigma(tag.xx)} along x, ${sigma(tag.yy)} along y`],
      ],
    });
  }
  const points = placePoints(robot);
  for (const place of robot.places.values()) {
    const at = points.get(place.name);
    if (at) {
      targets.push({ key: `place/${place.name}`, at, title: `Place ${place.name}`, facts: placeFacts(place.sides) });
    }
  }
  const row = (target: Target) => Math.round(target.at.y / (robot.card.tile_m / 2));
  return targets.sort((a, b) => row(b) - row(a) || a.at.x - b.at.x);
}

function placeFacts(sides: Record<string, { h: number; to?: string; tags: string[] }>): [string, string][] {
  const names: [string, string][] = [["N", "North"], ["E", "East"], ["S", "South"], ["W", "West"]];
  return names.map(([letter, name]) => {
    const side = sides[letter];
    const leads = !side || side.h === 0 ? "no hallway" : side.h === 1 ? "hallway, end unknown" : `to ${side.to ?? "?"}`;
    const tags = side && side.tags.length > 0 ? `, tag ${side.tags.join(", ")}` : "";
    return [name, leads + tags];
  });
}
