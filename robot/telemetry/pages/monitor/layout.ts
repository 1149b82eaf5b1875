// SPDX-License-Identifier: MIT
// Where things of a robot's frame lie on the plan that is shown: the room's frame W where a twin knows it, else the
// robot's own M. And where places of a hallway map lie that nobody drew: laid out by their compass points.
import type { Box, Point } from "../common/plan_view";
import type { Pose, Robot } from "./model";

const unit: Record<string, Point> = {
  N: { x: 0, y: 1 },
  E: { x: 1, y: 0 },
  S: { x: 0, y: -1 },
  W: { x: -1, y: 0 },
};
/** A hallway whose length nobody knows. Chosen: as long as it takes to tell two places apart. */
const hallway_m = 6;

export function toPlan(robot: Robot, p: Point): Point {
  const frame = robot.frame;
  if (!frame) {
    return p;
  }
  const c = Math.cos(frame.yaw);
  const s = Math.sin(frame.yaw);
  return { x: frame.x + c * p.x - s * p.y, y: frame.y + s * p.x + c * p.y };
}

export function yawOnPlan(robot: Robot, yaw: number): number {
  return yaw + (robot.frame?.yaw ?? 0);
}

/** A covariance of M on the plan. */
export function turned(robot: Robot, of: { xx: number; xy: number; yy: number }): { xx: number; xy: number; yy: number } {
  const c = Math.cos(robot.frame?.yaw ?? 0);
  const s = Math.sin(robot.frame?.yaw ?? 0);
  return {
    xx: c * c * of.xx - 2 * c * s * of.xy + s * s * of.yy,
    xy: c * s * (of.xx - of.yy) + (c * c - s * s) * of.xy,
    yy: s * s * of.xx + 2 * c * s * of.xy + c * c * of.yy,
  };
}

/** Every place: as drawn, else beside a neighbour that has a place already. */
export function placePoints(robot: Robot): Map<string, Point> {
  const at = new Map<string, Point>();
  for (const place of robot.places.values()) {
    if (place.at) {
      at.set(place.name, place.at);
    }
  }
  const first = robot.places.values().next().value;
  if (at.size === 0 && first) {
    at.set(first.name, { x: 0, y: 0 });
  }
  const queue = [...at.keys()];
  for (let name = queue.shift(); name !== undefined; name = queue.shift()) {
    const from = at.get(name);
    const place = robot.places.get(name);
    for (const [side, leads] of Object.entries(place?.sides ?? {})) {
      const step = unit[side];
      if (from && step && leads.h === 2 && leads.to !== undefined && !at.has(leads.to)) {
        const length = leads.m && leads.m > 0 ? leads.m : hallway_m;
        at.set(leads.to, { x: from.x + step.x * length, y: from.y + step.y * length });
        queue.push(leads.to);
      }
    }
  }
  return at;
}

/** Where a robot in hallways believes that it is: so far along the hallway that it entered at its last place. */
export function poseOnWay(robot: Robot, points: Map<string, Point>): Pose | null {
  const way = robot.way;
  const from = way ? points.get(way.place) : undefined;
  if (!way || !from) {
    return null;
  }
  const side = way.leaving !== undefined ? unit[way.leaving] : undefined;
  const limit = way.to !== undefined ? points.get(way.to) : undefined;
  const most = limit ? Math.hypot(limit.x - from.x, limit.y - from.y) : way.way_m;
  const axis = Math.PI / 2 + (way.axis ?? 0);
  // Along the hallway as it is drawn, which a compass point names only roughly.
  const drawn = limit && most > 0 ? { x: (limit.x - from.x) / most, y: (limit.y - from.y) / most } : undefined;
  const step = (side && drawn) ?? side ?? { x: Math.cos(axis), y: Math.sin(axis) };
  const gone = side ? Math.min(way.way_m, most) : 0;
  const yaw = way.heading !== undefined ? way.heading + Math.PI / 2 : Math.atan2(step.y, step.x);
  return { x: from.x + step.x * gone, y: from.y + step.y * gone, yaw, t: robot.now };
}

export function believedPose(robot: Robot): Pose | null {
  if (robot.card.mission === "hallway") {
    return poseOnWay(robot, placePoints(robot));
  }
  if (!robot.pose) {
    return null;
  }
  return { ...toPlan(robot, robot.pose), yaw: yawOnPlan(robot, robot.pose.yaw), t: robot.pose.t };
}

/** Round everything of a robot that is drawn. */
export function boxOf(robot: Robot, withRoom: boolean): Box | null {
  const low = { x: Infinity, y: Infinity };
  const high = { x: -Infinity, y: -Infinity };
  const add = (p: Point, by: number) => {
    low.x = Math.min(low.x, p.x - by);
    low.y = Math.min(low.y, p.y - by);
    high.x = Math.max(high.x, p.x + by);
    high.y = Math.max(high.y, p.y + by);
  };
  for (const tile of robot.tiles.values()) {
    add(toPlan(robot, { x: tile.column * robot.card.tile_m, y: tile.row * robot.card.tile_m }), robot.card.tile_m / 2);
  }
  for (const point of placePoints(robot).values()) {
    add(point, 1.5);
  }
  for (const tag of robot.ceiling.values()) {
    add(toPlan(robot, tag), 0.3);
  }
  for (const point of robot.trail.values()) {
    add(toPlan(robot, point), 0.3);
  }
  if (withRoom && robot.scene) {
    for (const wall of robot.scene.walls) {
      for (const [x, y] of wall.points) {
        add({ x, y }, 0.1);
      }
    }
    for (const tag of robot.scene.ceiling) {
      add(tag, 0.3);
    }
    for (const [x, y] of robot.scene.path ?? []) {
      add({ x, y }, 0.2);
    }
  }
  const pose = believedPose(robot);
  if (pose) {
    add(pose, 0.5);
  }
  return low.x <= high.x ? { low, high } : null;
}
