// SPDX-License-Identifier: MIT
// The drawing: a plan under hallways, places, their tags by side, what a scene adds, and the way that was planned.
import { haloText, planLine, scaleBar } from "../../../robot/telemetry/pages/common/draw";
import type { PlanView, Point } from "../../../robot/telemetry/pages/common/plan_view";
import type { Theme } from "../../../robot/telemetry/pages/common/theme";
import type { Editor } from "./editor";
import { hallways, metric, opposite, placeByName, type Place } from "./model";
import type { Picture } from "./picture";
import { SceneDrawing } from "./scene_drawing";
import { pillHeight, pillWidth, SideDrawing } from "./side_drawing";

const family = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif';

type Context = CanvasRenderingContext2D;

export class Drawing {
  private readonly scene: SceneDrawing;

  constructor(
    private readonly editor: Editor,
    private readonly picture: Picture,
    public theme: Theme,
  ) {
    this.scene = new SceneDrawing(editor);
  }

  draw(context: Context, view: PlanView): void {
    this.picture.draw(context, view, this.editor.doc.plan, this.theme);
    this.grid(context, view);
    this.scene.below(context, view, this.theme);
    this.hallwayLines(context, view);
    this.routeLine(context, view);
    const sides = new SideDrawing(this.editor.doc, context, view, this.theme);
    for (const place of this.editor.doc.places) {
      sides.draw(place);
    }
    for (const place of this.editor.doc.places) {
      this.place(context, view, place);
    }
    this.scene.above(context, view, this.theme);
    if (metric(this.editor.doc)) {
      scaleBar(context, view, { x: 18, y: view.height - 18 }, this.theme);
    }
  }

  private grid(context: Context, view: PlanView): void {
    const every = [0.5, 1, 2, 5, 10, 20, 50, 100].find((metres) => metres * view.scale >= 28) ?? 100;
    const low = view.toPlan({ x: 0, y: view.height });
    const high = view.toPlan({ x: view.width, y: 0 });
    context.lineWidth = 1;
    context.strokeStyle = this.theme.line;
    context.globalAlpha = this.picture.shown ? 0.35 : 0.75;
    context.beginPath();
    for (let x = Math.ceil(low.x / every) * every; x <= high.x; x += every) {
      const at = Math.round(view.toScreen({ x, y: 0 }).x) + 0.5;
      context.moveTo(at, 0);
      context.lineTo(at, view.height);
    }
    for (let y = Math.ceil(low.y / every) * every; y <= high.y; y += every) {
      const at = Math.round(view.toScreen({ x: 0, y }).y) + 0.5;
      context.moveTo(0, at);
      context.lineTo(view.width, at);
    }
    context.stroke();
    context.globalAlpha = 1;
  }

  private hallwayLines(context: Context, view: PlanView): void {
    const { editor, theme } = this;
    const chosen = editor.selection;
    const drawn = hallways(editor.doc);
    // One path for all, so that bands do not darken each other where they meet.
    context.beginPath();
    const half = Math.max(editor.doc.settings.width_m * view.scale, 10) / 2;
    for (const { a, b } of drawn) {
      band(context, view.toScreen(a.at), view.toScreen(b.at), half);
    }
    context.fillStyle = theme.accent;
    context.globalAlpha = 0.14;
    context.fill();
    context.globalAlpha = 1;
    context.lineCap = "round";
    for (const { a, b, letter } of drawn) {
      const selected =
        chosen?.kind === "hallway" &&
        ((chosen.id === a.id && chosen.letter === letter) ||
          (chosen.id === b.id && chosen.letter === opposite(letter)));
      const blocked = editor.isBlocked(a, letter, b);
      planLine(context, view, [a.at, b.at]);
      context.strokeStyle = blocked ? theme.bad : theme.accent;
      context.lineWidth = selected ? 6 : 2.5;
      context.setLineDash(blocked ? [2, 6] : []);
      context.stroke();
      context.setLineDash([]);
    }
  }

  private place(context: Context, view: PlanView, place: Place): void {
    const { editor, theme } = this;
    const at = view.toScreen(place.at);
    const wide = pillWidth(place, context);
    const selected = editor.selectedPlace?.id === place.id && editor.selection?.kind === "place";
    const worst = editor.worstOf(place.name);
    const box = (grow: number) => {
      context.beginPath();
      context.roundRect(
        at.x - wide / 2 - grow,
        at.y - pillHeight / 2 - grow,
        wide + 2 * grow,
        pillHeight + 2 * grow,
        pillHeight / 2 + grow,
      );
    };
    if (selected) {
      box(5);
      context.fillStyle = theme.accent;
      context.globalAlpha = 0.28;
      context.fill();
      context.globalAlpha = 1;
    }
    box(0);
    context.fillStyle = selected ? theme.accent : theme.card;
    context.fill();
    context.lineWidth = 2.5;
    context.strokeStyle = worst === "error" ? theme.bad : theme.accent;
    context.stroke();
    context.fillStyle = selected ? theme.plan : theme.ink;
    context.font = `650 13px ${family}`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText(place.name, at.x, at.y + 0.5);
    if (worst === "error") {
      context.beginPath();
      context.arc(at.x + wide / 2 - 1, at.y - pillHeight / 2 + 1, 7.5, 0, 2 * Math.PI);
      context.fillStyle = theme.bad;
      context.fill();
      haloText(
        context,
        "!",
        { x: at.x + wide / 2 - 1, y: at.y - pillHeight / 2 + 1.5 },
        { colour: theme.plan, halo: theme.bad, px: 11, bold: true },
      );
    }
  }

  private routeLine(context: Context, view: PlanView): void {
    const steps = this.editor.route?.steps ?? [];
    const points = [this.editor.route?.start ?? "", ...steps.map((one) => one.to)]
      .map((name) => placeByName(this.editor.doc, name)?.at)
      .filter((p) => p !== undefined);
    if (points.length === 0) {
      return;
    }
    context.lineJoin = "round";
    context.lineCap = "round";
    for (const [colour, width] of [
      [this.theme.plan, 11],
      [this.theme.robot, 6],
    ] as const) {
      planLine(context, view, points);
      context.strokeStyle = colour;
      context.lineWidth = width;
      context.stroke();
    }
    points.slice(1).forEach((b, i) => this.arrow(context, view.toScreen(points[i] as Point), view.toScreen(b)));
    for (const [p, ring] of [
      [points[0], 19],
      [points.at(-1), 19],
    ] as const) {
      const at = view.toScreen(p as Point);
      context.beginPath();
      context.arc(at.x, at.y, ring, 0, 2 * Math.PI);
      context.lineWidth = 3;
      context.strokeStyle = this.theme.robot;
      context.stroke();
    }
  }
  private arrow(context: Context, a: Point, b: Point): void {
    const turn = Math.atan2(b.y - a.y, b.x - a.x);
    context.save();
    context.translate(a.x + 0.62 * (b.x - a.x), a.y + 0.62 * (b.y - a.y));
    context.rotate(turn);
    context.beginPath();
    context.moveTo(11, 0);
    context.lineTo(-7, -9);
    context.lineTo(-7, 9);
    context.closePath();
    context.fillStyle = this.theme.robot;
    context.strokeStyle = this.theme.plan;
    context.lineWidth = 2;
    context.stroke();
    context.fill();
    context.restore();
  }
}

/** A hallway's floor as the twin draws its walls: square ends along compass points, round ones of what is slanted. */
function band(context: Context, a: Point, b: Point, half: number): void {
  const along = Math.atan2(b.y - a.y, b.x - a.x);
  const off = (Math.abs(along) * 180) / Math.PI % 90;
  const [left, right] = [along - Math.PI / 2, along + Math.PI / 2];
  // All of them turn the same way, so that none takes the floor away from another.
  if (Math.min(off, 90 - off) > 1) {
    context.moveTo(b.x + half * Math.cos(left), b.y + half * Math.sin(left));
    context.arc(b.x, b.y, half, left, right);
    context.arc(a.x, a.y, half, right, left + 2 * Math.PI);
  } else {
    const corner = (p: Point, forward: number, side: number): [number, number] => [
      p.x + half * (forward * Math.cos(along) + Math.cos(side)),
      p.y + half * (forward * Math.sin(along) + Math.sin(side)),
    ];
    context.moveTo(...corner(b, 1, left));
    context.lineTo(...corner(b, 1, right));
    context.lineTo(...corner(a, -1, right));
    context.lineTo(...corner(a, -1, left));
  }
  context.closePath();
}
