// SPDX-License-Identifier: MIT
// The plan as it is drawn: true room (a twin's), tiles, hallways, ceiling tags, trail, landmarks, robot.
import { covarianceEllipse, haloText, planLine, robotGlyph, scaleBar } from "../common/draw";
import type { PlanView, Point } from "../common/plan_view";
import type { Theme } from "../common/theme";
import { believedPose, placePoints, toPlan, turned } from "./layout";
import type { Robot, Tile } from "./model";
import { objectName, objectPoint, type Target } from "./targets";

export interface PlanPicture {
  robot: Robot;
  /** In the same room. */
  others: Robot[];
  theme: Theme;
  tileColours: Record<Tile["state"], string>;
  withRoom: boolean;
  chosen: Target | null;
}
type Context = CanvasRenderingContext2D;

/** Below so many pixels a tile, what is in it cannot be told apart. */
const detail_px = 14;

function dot(context: Context, at: Point, radius: number, fill: string): void {
  context.fillStyle = fill;
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
  context.fill();
}

function points(of: readonly [number, number][]): Point[] {
  return of.map(([x, y]) => ({ x, y }));
}

function drawRoom(context: Context, view: PlanView, { robot, theme }: PlanPicture): void {
  const scene = robot.scene;
  if (!scene) {
    return;
  }
  for (const piece of scene.furniture) {
    context.fillStyle = theme.furniture;
    context.strokeStyle = theme["furniture-edge"];
    context.lineWidth = 1;
    if (piece.outline.length > 0) {
      planLine(context, view, points(piece.outline), true);
      context.fill();
      context.stroke();
    }
    for (const circle of piece.circles) {
      const at = view.toScreen(circle);
      context.beginPath();
      context.arc(at.x, at.y, Math.max(circle.radius * view.scale, 1.5), 0, 2 * Math.PI);
      context.fill();
      context.stroke();
    }
  }
  context.strokeStyle = theme.wall;
  context.lineJoin = "round";
  context.lineWidth = Math.min(5, Math.max(2, 0.05 * view.scale));
  for (const wall of scene.walls) {
    planLine(context, view, points(wall.points), wall.closed);
    context.stroke();
  }
  if (scene.path) {
    context.setLineDash([7, 5]);
    context.lineWidth = 2;
    context.strokeStyle = theme["soft-ink"];
    planLine(context, view, points(scene.path));
    context.stroke();
    context.setLineDash([]);
  }
  for (const tag of scene.ceiling) {
    const at = view.toScreen(tag);
    context.strokeStyle = theme["soft-ink"];
    context.lineWidth = 1.5;
    context.strokeRect(at.x - 5, at.y - 5, 10, 10);
    haloText(context, tag.name, { x: at.x, y: at.y - 15 }, { colour: theme["soft-ink"], halo: theme.plan });
  }
}

/** Names stand on top of everything that would hide them. */
function drawRoomNames(context: Context, view: PlanView, { robot, theme }: PlanPicture): void {
  for (const piece of robot.scene?.furniture ?? []) {
    const wide = Math.max(...piece.outline.map(([x]) => x)) - Math.min(...piece.outline.map(([x]) => x));
    // Seven pixels a letter: a name that is wider than its piece is left out.
    if (piece.outline.length > 0 && piece.name.length * 7 < wide * view.scale) {
      const sum = piece.outline.reduce((to, [x, y]) => ({ x: to.x + x, y: to.y + y }), { x: 0, y: 0 });
      const at = view.toScreen({ x: sum.x / piece.outline.length, y: sum.y / piece.outline.length });
      haloText(context, piece.name, at, { colour: theme["furniture-ink"], halo: theme.furniture, px: 12 });
    }
  }
}

function tileCorners(robot: Robot, tile: Tile): Point[] {
  const half = robot.card.tile_m / 2;
  const x = tile.column * robot.card.tile_m;
  const y = tile.row * robot.card.tile_m;
  return [
    { x: x + half, y: y - half },
    { x: x + half, y: y + half },
    { x: x - half, y: y + half },
    { x: x - half, y: y - half },
  ].map((corner) => toPlan(robot, corner));
}

function drawTile(context: Context, view: PlanView, picture: PlanPicture, tile: Tile): void {
  const { robot, theme } = picture;
  const corners = tileCorners(robot, tile);
  planLine(context, view, corners, true);
  context.fillStyle = picture.tileColours[tile.state];
  context.fill();
  context.strokeStyle = theme["tile-edge"];
  context.lineWidth = 1;
  context.stroke();
  const side_px = robot.card.tile_m * view.scale;
  const at = view.toScreen(toPlan(robot, { x: tile.column * robot.card.tile_m, y: tile.row * robot.card.tile_m }));
  if (side_px < detail_px) {
    return;
  }
  if (tile.state === "given_up") {
    context.strokeStyle = theme["soft-ink"];
    context.lineWidth = 1.5;
    const r = Math.min(6, side_px / 6);
    context.beginPath();
    context.moveTo(at.x - r, at.y - r);
    context.lineTo(at.x + r, at.y + r);
    context.moveTo(at.x - r, at.y + r);
    context.lineTo(at.x + r, at.y - r);
    context.stroke();
    return;
  }
  // A tag: full when its coordinates are written, else a ring; told apart without colour.
  const radius = Math.min(3.5, side_px / 12);
  const mark = tile.state === "open" ? theme["tile-open-mark"] : theme["tile-mark"];
  if (tile.written) {
    dot(context, at, radius, mark);
  } else {
    context.strokeStyle = mark;
    context.lineWidth = 1.2;
    context.beginPath();
    context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
    context.stroke();
  }
}

/** Walls as the robot has felt and seen them: sides of tiles that it cannot pass. */
function drawBlocked(context: Context, view: PlanView, { robot, theme, withRoom }: PlanPicture): void {
  context.strokeStyle = theme.felt;
  context.lineWidth = withRoom && robot.scene ? 2 : 4;
  context.lineCap = "round";
  for (const tile of robot.tiles.values()) {
    const corners = tileCorners(robot, tile);
    for (let side = 0; side < 4; ++side) {
      const from = corners[side];
      const to = corners[(side + 1) % 4];
      if ((tile.blocked & (1 << side)) !== 0 && from && to) {
        planLine(context, view, [from, to]);
        context.stroke();
      }
    }
  }
}

function inOrder(trail: Map<number, Point>): Point[] {
  return [...trail.entries()].sort(([a], [b]) => a - b).map(([, point]) => point);
}

/** What only a twin can know of those who move: the way of a robot that believes no pose, and people. */
function drawTruth(context: Context, view: PlanView, { robot, theme }: PlanPicture): void {
  context.lineJoin = "round";
  context.lineCap = "round";
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5;
  context.setLineDash([1, 4]);
  planLine(context, view, inOrder(robot.trueTrail));
  context.stroke();
  context.setLineDash([]);
  for (const person of robot.people) {
    const r = Math.max(person.radius * view.scale, 4);
    dot(context, view.toScreen(person), r + 1.5, theme.plan);
    dot(context, view.toScreen(person), r, theme.landmark);
  }
}

function drawTrail(context: Context, view: PlanView, { robot, theme }: PlanPicture): void {
  const trail = inOrder(robot.trail).map((point) => toPlan(robot, point));
  if (trail.length < 2) {
    return;
  }
  context.lineJoin = "round";
  context.lineCap = "round";
  for (const [colour, width] of [[theme.plan, 3.5], [theme.trail, 2]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    planLine(context, view, trail);
    context.stroke();
  }
}

function diamond(context: Context, at: Point, r: number, fill: string, edge: string): void {
  context.beginPath();
  context.moveTo(at.x, at.y - r);
  context.lineTo(at.x + r, at.y);
  context.lineTo(at.x, at.y + r);
  context.lineTo(at.x - r, at.y);
  context.closePath();
  context.fillStyle = fill;
  context.fill();
  context.strokeStyle = edge;
  context.lineWidth = 1.5;
  context.stroke();
}

function drawObjects(context: Context, view: PlanView, { robot, theme }: PlanPicture): void {
  for (const event of robot.objects.values()) {
    const at = view.toScreen(objectPoint(robot, event));
    diamond(context, at, 7, event.event === "furniture_seen" ? theme.tag : theme.landmark, theme.plan);
    if (view.scale > 45) {
      haloText(context, objectName(event).split(",")[0] ?? "", { x: at.x, y: at.y - 15 }, { colour: theme.ink, halo: theme.plan, px: 11 });
    }
  }
}

function drawHallways(context: Context, view: PlanView, { robot, theme }: PlanPicture): void {
  const at = placePoints(robot);
  const step: Record<string, Point> = { N: { x: 0, y: 1 }, E: { x: 1, y: 0 }, S: { x: 0, y: -1 }, W: { x: -1, y: 0 } };
  context.lineCap = "round";
  for (const place of robot.places.values()) {
    const from = at.get(place.name);
    for (const [side, leads] of Object.entries(place.sides)) {
      const to = leads.to !== undefined ? at.get(leads.to) : undefined;
      const towards = step[side];
      if (!from || !towards || leads.h === 0 || (leads.h === 2 && (!to || leads.to! < place.name))) {
        continue;
      }
      const onRoute = robot.way?.place === place.name ? leads.to === robot.way.to : leads.to === robot.way?.place && place.name === robot.way?.to;
      context.strokeStyle = onRoute ? theme.accent : theme["soft-ink"];
      context.lineWidth = onRoute ? 5 : 3;
      context.setLineDash(leads.h === 1 ? [4, 6] : []);
      const end = to ?? { x: from.x + 1.5 * towards.x, y: from.y + 1.5 * towards.y };
      planLine(context, view, [from, end]);
      context.stroke();
      context.setLineDash([]);
      if (leads.h === 1) {
        haloText(context, "?", view.toScreen({ x: from.x + 2 * towards.x, y: from.y + 2 * towards.y }), { colour: theme.ink, halo: theme.plan, bold: true });
      }
    }
  }
  for (const [name, point] of at) {
    const screen = view.toScreen(point);
    const here = robot.way?.place === name;
    dot(context, screen, 8, theme.plan);
    dot(context, screen, here ? 7 : 6, here ? theme.accent : theme["soft-ink"]);
    const label = name === robot.card.goal ? `${name} (goal)` : name;
    haloText(context, label, { x: screen.x + 11, y: screen.y - 14 }, { colour: theme.ink, halo: theme.plan, bold: true, align: "left" });
  }
}

function drawCeiling(context: Context, view: PlanView, { robot, theme }: PlanPicture): void {
  for (const tag of robot.ceiling.values()) {
    const point = toPlan(robot, tag);
    const at = view.toScreen(point);
    context.strokeStyle = theme.estimate;
    context.lineWidth = 1.5;
    covarianceEllipse(context, view, point, turned(robot, tag), 2);
    context.stroke();
    diamond(context, at, 5, theme.estimate, theme.plan);
    // Beside the ellipse, as far as that is not half the plan.
    const aside = Math.min(Math.max(9, 4 + 1.5 * Math.sqrt(Math.max(tag.xx, tag.yy)) * view.scale), 40);
    haloText(context, tag.name, { x: at.x + aside, y: at.y + aside + 3 }, { colour: theme.estimate, halo: theme.plan, align: "left", px: 11, bold: true });
  }
}

function drawRobot(context: Context, view: PlanView, picture: PlanPicture): void {
  const { robot, theme } = picture;
  if (picture.withRoom && robot.truth) {
    robotGlyph(context, view, robot.truth, robot.card.radius_m, theme.ink, theme.ink, true);
  }
  const pose = believedPose(robot);
  if (!pose) {
    return;
  }
  if (robot.sure) {
    context.strokeStyle = theme.robot;
    context.lineWidth = 1.5;
    covarianceEllipse(context, view, pose, turned(robot, robot.sure), 2);
    context.stroke();
  }
  robotGlyph(context, view, pose, robot.card.radius_m, theme.robot, theme.plan);
}

/** Other robots of the same room, with their names. */
function drawOthers(context: Context, view: PlanView, { others, theme }: PlanPicture): void {
  for (const other of others) {
    const pose = believedPose(other) ?? other.truth;
    if (pose) {
      robotGlyph(context, view, pose, other.card.radius_m, theme["soft-ink"], theme.plan);
      const at = view.toScreen(pose);
      haloText(context, other.name, { x: at.x, y: at.y + Math.max(other.card.radius_m * view.scale, 6) + 12 }, { colour: theme.ink, halo: theme.plan, px: 11 });
    }
  }
}

function drawChosen(context: Context, view: PlanView, { chosen, theme }: PlanPicture): void {
  if (!chosen) {
    return;
  }
  const at = view.toScreen(chosen.at);
  for (const [colour, width] of [[theme.plan, 6], [theme.accent, 3]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.arc(at.x, at.y, 13, 0, 2 * Math.PI);
    context.stroke();
  }
}

function drawNorth(context: Context, view: PlanView, { robot, theme }: PlanPicture): void {
  const known = robot.scene !== null || robot.card.mission === "hallway";
  if (!known) {
    return;
  }
  const yaw = robot.scene ? robot.scene.north : Math.PI / 2;
  const at = { x: view.width - 30, y: view.height - 34 };
  context.save();
  context.translate(at.x, at.y);
  context.rotate(Math.PI / 2 - yaw);
  context.beginPath();
  context.moveTo(0, -14);
  context.lineTo(7, 10);
  context.lineTo(0, 5);
  context.lineTo(-7, 10);
  context.closePath();
  context.fillStyle = theme.ink;
  context.fill();
  context.restore();
  haloText(context, "N", { x: at.x, y: at.y - 24 }, { colour: theme.ink, halo: theme.plan, bold: true });
}

export function drawPlan(context: Context, view: PlanView, picture: PlanPicture): void {
  const { robot, theme, withRoom } = picture;
  for (const tile of robot.tiles.values()) {
    drawTile(context, view, picture, tile);
  }
  drawBlocked(context, view, picture);
  if (withRoom) {
    drawRoom(context, view, picture);
  }
  drawHallways(context, view, picture);
  drawTrail(context, view, picture);
  if (withRoom) {
    drawTruth(context, view, picture);
    drawRoomNames(context, view, picture);
  }
  drawObjects(context, view, picture);
  drawCeiling(context, view, picture);
  drawOthers(context, view, picture);
  drawRobot(context, view, picture);
  drawChosen(context, view, picture);
  scaleBar(context, view, { x: 18, y: view.height - 18 }, theme);
  drawNorth(context, view, picture);
}

