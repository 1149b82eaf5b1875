// SPDX-License-Identifier: MIT
// What a place has on its sides: "-", "?", the tags that are met there, and how long the hallway is.
import { haloText } from "../../../robot/telemetry/pages/common/draw";
import type { PlanView, Point } from "../../../robot/telemetry/pages/common/plan_view";
import type { Theme } from "../../../robot/telemetry/pages/common/theme";
import { bearingIsDrawn, bearingOf, compass_deg, degrees, unit } from "./bearing";
import { lengthOf, letters, placeById, type Doc, type Letter, type Place, type Side } from "./model";

const family = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif';
/** CSS pixels: a tag's chip never comes nearer to its place than this. */
const chipGap = 7;
const chipHeight = 17;
export const pillHeight = 24;

type Context = CanvasRenderingContext2D;

/** Of the oval with a place's name. */
export function pillWidth(place: Place, context: Context): number {
  context.font = `650 13px ${family}`;
  return Math.max(pillHeight, context.measureText(place.name).width + 14);
}

/** How far along `way` a box of this size reaches from its middle. */
function reach(way: Point, wide: number, high: number): number {
  return Math.min(wide / 2 / Math.max(Math.abs(way.x), 1e-6), high / 2 / Math.max(Math.abs(way.y), 1e-6));
}
/** A side of a place on the screen: from where, and in which direction, y down. */
interface Way {
  at: Point;
  way: Point;
  pill: number;
}

export class SideDrawing {
  constructor(
    private readonly doc: Doc,
    private readonly context: Context,
    private readonly view: PlanView,
    private readonly theme: Theme,
  ) {}

  draw(place: Place): void {
    const at = this.view.toScreen(place.at);
    const pill = pillWidth(place, this.context);
    const towards = (deg: number): Way => ({ at, way: { x: unit(deg).x, y: -unit(deg).y }, pill });
    for (const letter of letters) {
      const side = place.sides[letter];
      const other = side?.to == null ? undefined : placeById(this.doc, side.to);
      if (!side) {
        this.absent(towards(compass_deg[letter]));
      } else if (side.to === null) {
        this.unknown(towards(bearingOf(side, letter)), side);
      } else if (other) {
        const far = this.view.toScreen(other.at);
        const long = Math.hypot(far.x - at.x, far.y - at.y) || 1;
        this.chip({ at, way: { x: (far.x - at.x) / long, y: (far.y - at.y) / long }, pill }, side, long / 2);
        if (place.id < other.id) {
          this.lengthLabel(place, letter, side, other);
        }
      }
    }
  }

  /** Written when there is room between the chips; with the bearing, where it is not a compass point's. */
  private lengthLabel(place: Place, letter: Letter, side: Side, other: Place): void {
    const a = this.view.toScreen(place.at);
    const b = this.view.toScreen(other.at);
    const length = lengthOf(this.doc, place, side);
    const room = Math.hypot(b.x - a.x, b.y - a.y);
    const flat = Math.abs(b.x - a.x) > 2.5 * Math.abs(b.y - a.y);
    if (room < (flat ? 190 : 120)) {
      return;
    }
    const metres = length === null ? "? m" : `${Number(length.toFixed(2))} m`;
    const bearing = side.bearing_deg === null ? "" : `  ${degrees(Math.min(side.bearing_deg, (side.bearing_deg + 180) % 360))}`;
    // To the right of what stands upright; there a line that falls leaves the upper corner free, one that rises the lower.
    const rises = (b.x - a.x) * (b.y - a.y) < 0;
    const lean = Math.min(Math.abs((b.x - a.x) / (b.y - a.y || 1)), 1) * (rises ? 9 : -9);
    const at = { x: (a.x + b.x) / 2 + (flat ? 0 : 8), y: (a.y + b.y) / 2 + (flat ? -11 : lean) };
    haloText(this.context, metres + bearing, at, {
      colour: bearingIsDrawn(side, letter, place.at, other.at) ? this.theme["soft-ink"] : this.theme.warn,
      halo: this.theme.plan,
      align: flat ? "center" : "left",
    });
  }

  /** The paper's "-": a short bar across. */
  private absent({ at, way, pill }: Way): void {
    const { context } = this;
    const edge = reach(way, pill, pillHeight) + 6;
    const from = { x: at.x + way.x * edge, y: at.y + way.y * edge };
    context.strokeStyle = this.theme["soft-ink"];
    context.lineWidth = 2;
    context.lineCap = "round";
    context.beginPath();
    context.moveTo(from.x + way.y * 5, from.y - way.x * 5);
    context.lineTo(from.x - way.y * 5, from.y + way.x * 5);
    context.stroke();
  }

  /** The paper's "?": a dashed stub. */
  private unknown(side_way: Way, side: Side): void {
    const { context, theme } = this;
    const { at, way, pill } = side_way;
    const edge = reach(way, pill, pillHeight) + 2;
    const chip = side.tags.length > 0 ? 2 * reach(way, this.chipWidth(side), chipHeight) : 0;
    const nearest = edge + (chip > 0 ? chipGap + chip + 26 : 20);
    const long = Math.max(1.6 * this.view.scale, nearest) + 11;
    const end = { x: at.x + way.x * long, y: at.y + way.y * long };
    context.strokeStyle = theme.warn;
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
    context.fillStyle = theme.card;
    context.fill();
    context.lineWidth = 2;
    context.stroke();
    haloText(
      context,
      "?",
      { x: end.x, y: end.y + 0.5 },
      { colour: theme.warn, halo: theme.card, px: 14, bold: true },
    );
    this.chip(side_way, side, long - 11);
  }

  private chipText(side: Side): string {
    const first = side.tags[0] ?? "";
    const short = first.length > 6 ? `…${first.slice(-4)}` : first;
    return side.tags.length > 1 ? `${short} +${side.tags.length - 1}` : short;
  }
  private chipWidth(side: Side): number {
    this.context.font = `600 11.5px ${family}`;
    return this.context.measureText(this.chipText(side)).width + 10;
  }

  /** A tag's number where it is met; a dot where there is no room for it. */
  private chip({ at, way, pill }: Way, side: Side, room: number): void {
    if (side.tags.length === 0) {
      return;
    }
    const { context, theme } = this;
    const wide = this.chipWidth(side);
    const half = reach(way, wide, chipHeight);
    // Two boxes lie clear of each other when they do so in one direction.
    const nearest = reach(way, pill + wide + 2 * (chipGap + 2), pillHeight + chipHeight + 2 * (chipGap + 2));
    const from = Math.max((side.tag_m ?? this.doc.settings.tag_to_middle_m) * this.view.scale, nearest);
    const fits = nearest + half + 2 <= room;
    const along = fits ? Math.min(from, room - half - 2) : Math.max(reach(way, pill, pillHeight) + 7, room * 0.7);
    const middle = { x: at.x + way.x * along, y: at.y + way.y * along };
    context.fillStyle = theme.tag;
    context.beginPath();
    if (!fits) {
      context.arc(middle.x, middle.y, 3.5, 0, 2 * Math.PI);
      context.fill();
      return;
    }
    context.roundRect(middle.x - wide / 2, middle.y - chipHeight / 2, wide, chipHeight, 5);
    context.fill();
    context.lineWidth = 1.5;
    context.strokeStyle = theme.plan;
    context.stroke();
    context.fillStyle = theme.plan;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText(this.chipText(side), middle.x, middle.y + 0.5);
  }
}
