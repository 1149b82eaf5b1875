// SPDX-License-Identifier: MIT
// The drawing: a plan under hallways, places, their tags by side, what a scene adds, and the way that was planned.
import { haloText, planLine, scaleBar } from "../../../robot/telemetry/pages/common/draw";
import type { PlanView, Point } from "../../../robot/telemetry/pages/common/plan_view";
import type { Theme } from "../../../robot/telemetry/pages/common/theme";
import type { Editor } from "./editor";
import {
  hallways,
  lengthOf,
  letters,
  metric,
  opposite,
  placeByName,
  step,
  type Letter,
  type Place,
  type Side,
} from "./model";
import type { Picture } from "./picture";
import { SceneDrawing } from "./scene_drawing";

const family = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif';
/** CSS pixels: a tag's chip never comes nearer to its place than this. */
const chipGap = 7;
const chipHeight = 17;
const pillHeight = 24;

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
    for (const place of this.editor.doc.places) {
      this.sides(context, view, place);
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
    for (const { a, b } of drawn) {
      const from = view.toScreen(a.at);
      const to = view.toScreen(b.at);
      context.moveTo(from.x, from.y);
      context.lineTo(to.x, to.y);
    }
    context.lineCap = "square";
    context.lineJoin = "miter";
    context.strokeStyle = theme.accent;
    context.globalAlpha = 0.14;
    context.lineWidth = Math.max(editor.doc.settings.width_m * view.scale, 10);
    context.stroke();
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

  /** Lengths are written when there is room between the chips. */
  private lengthLabel(context: Context, view: PlanView, place: Place, side: Side, other: Place): void {
    const a = view.toScreen(place.at);
    const b = view.toScreen(other.at);
    const length = lengthOf(this.editor.doc, place, side);
    const room = Math.hypot(b.x - a.x, b.y - a.y);
    const upright = Math.abs(b.y - a.y) > Math.abs(b.x - a.x);
    if (room < (upright ? 120 : 190)) {
      return;
    }
    const text = length === null ? "? m" : `${Number(length.toFixed(2))} m`;
    const at = { x: (a.x + b.x) / 2 + (upright ? 8 : 0), y: (a.y + b.y) / 2 - (upright ? 0 : 11) };
    haloText(context, text, at, {
      colour: this.theme["soft-ink"],
      halo: this.theme.plan,
      align: upright ? "left" : "center",
    });
  }

  private pill(place: Place, context: Context): number {
    context.font = `650 13px ${family}`;
    return Math.max(pillHeight, context.measureText(place.name).width + 14);
  }

  private sides(context: Context, view: PlanView, place: Place): void {
    const at = view.toScreen(place.at);
    const half = this.pill(place, context) / 2;
    for (const letter of letters) {
      const side = place.sides[letter];
      const edge = (letter === "E" || letter === "W" ? half : pillHeight / 2) + 2;
      if (!side) {
        this.absent(context, at, letter, edge);
      } else if (side.to === null) {
        this.unknown(context, view, at, letter, side, edge);
      } else {
        const other = this.editor.doc.places.find((each) => each.id === side.to);
        if (other) {
          const far = view.toScreen(other.at);
          this.chip(context, view, at, far, side, edge, Math.hypot(far.x - at.x, far.y - at.y) / 2);
          if (place.id < other.id) {
            this.lengthLabel(context, view, place, side, other);
          }
        }
      }
    }
  }

  /** The paper's "-": a short bar across. */
  private absent(context: Context, at: Point, letter: Letter, edge: number): void {
    const way = step[letter];
    const from = { x: at.x + way.x * (edge + 4), y: at.y - way.y * (edge + 4) };
    context.strokeStyle = this.theme["soft-ink"];
    context.lineWidth = 2;
    context.lineCap = "round";
    context.beginPath();
    context.moveTo(from.x - way.y * 5, from.y - way.x * 5);
    context.lineTo(from.x + way.y * 5, from.y + way.x * 5);
    context.stroke();
  }

  /** The paper's "?": a dashed stub. */
  private unknown(context: Context, view: PlanView, at: Point, letter: Letter, side: Side, edge: number): void {
    const way = step[letter];
    const tagged = side.tags.length > 0;
    const chip = tagged ? this.chipSize(context, side, letter) : 0;
    const nearest = edge + (tagged ? chipGap + chip + 26 : 20);
    const long = Math.max(1.6 * view.scale, nearest) + 11;
    const end = { x: at.x + way.x * long, y: at.y - way.y * long };
    context.strokeStyle = this.theme.warn;
    context.lineWidth = 2.5;
    context.lineCap = "butt";
    context.setLineDash([6, 5]);
    context.beginPath();
    context.moveTo(at.x, at.y);
    context.lineTo(end.x, end.y);
    context.stroke();
    context.setLineDash([]);
    context.beginPath();
    context.arc(end.x, end.y, 10, 0, 2 * Math.PI);
    context.fillStyle = this.theme.card;
    context.fill();
    context.lineWidth = 2;
    context.stroke();
    haloText(
      context,
      "?",
      { x: end.x, y: end.y + 0.5 },
      { colour: this.theme.warn, halo: this.theme.card, px: 14, bold: true },
    );
    this.chip(context, view, at, end, side, edge, long - 11);
  }

  private chipText(side: Side): string {
    const first = side.tags[0] ?? "";
    const short = first.length > 6 ? `…${first.slice(-4)}` : first;
    return side.tags.length > 1 ? `${short} +${side.tags.length - 1}` : short;
  }
  private chipSize(context: Context, side: Side, letter: Letter): number {
    context.font = `600 11.5px ${family}`;
    return letter === "E" || letter === "W" ? context.measureText(this.chipText(side)).width + 10 : chipHeight;
  }

  /** A tag's number where it is met; a dot where there is no room for it. */
  private chip(context: Context, view: PlanView, at: Point, to: Point, side: Side, edge: number, room: number): void {
    if (side.tags.length === 0) {
      return;
    }
    const far = Math.hypot(to.x - at.x, to.y - at.y) || 1;
    const way = { x: (to.x - at.x) / far, y: (to.y - at.y) / far };
    context.font = `600 11.5px ${family}`;
    const text = this.chipText(side);
    const wide = context.measureText(text).width + 10;
    const half = Math.abs(way.x) > Math.abs(way.y) ? wide / 2 : chipHeight / 2;
    const nearest = edge + chipGap + half;
    const from = Math.max(this.editor.doc.settings.tag_to_middle_m * view.scale, nearest);
    const fits = nearest + half + 2 <= room;
    const along = fits ? Math.min(from, room - half - 2) : Math.max(edge + 5, room * 0.7);
    const middle = { x: at.x + way.x * along, y: at.y + way.y * along };
    context.fillStyle = this.theme.tag;
    context.beginPath();
    if (!fits) {
      context.arc(middle.x, middle.y, 3.5, 0, 2 * Math.PI);
      context.fill();
      return;
    }
    context.roundRect(middle.x - wide / 2, middle.y - chipHeight / 2, wide, chipHeight, 5);
    context.fill();
    context.lineWidth = 1.5;
    context.strokeStyle = this.theme.plan;
    context.stroke();
    context.fillStyle = this.theme.plan;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText(text, middle.x, middle.y + 0.5);
  }

  private place(context: Context, view: PlanView, place: Place): void {
    const { editor, theme } = this;
    const at = view.toScreen(place.at);
    const wide = this.pill(place, context);
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
