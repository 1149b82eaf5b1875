// SPDX-License-Identifier: MIT
// The paper's stroke: a press, a drag along a compass point, and two places with a hallway are there. A slanted one
// says its bearing, and leaves on the side of the compass point that is nearest and free.
import { haloText, planLine } from "../../../robot/telemetry/pages/common/draw";
import type { PlanView, Point } from "../../../robot/telemetry/pages/common/plan_view";
import type { Theme } from "../../../robot/telemetry/pages/common/theme";
import { apart_deg, asBearing, degrees, drawn_deg, lettersFor } from "./bearing";
import { nearestOn } from "./editor";
import type { IconName } from "./icons";
import {
  addPlace,
  connect,
  distance,
  opposite,
  placeById,
  sideNames,
  splitHallway,
  type Doc,
  type Letter,
  type Place,
} from "./model";
import { Stroke } from "./stroke";
import { alignedPoint, crossing, isStroke, strokeEnd, strokeFrom, tolerance_deg } from "./snapping";

/** Chosen: a slanted stroke so near to the hallway that is there runs along it. */
const along_deg = 10;

/** Where a stroke begins or ends: at a place, on a hallway, or anywhere. */
interface Spot {
  at: Point;
  place: Place | null;
  hallway: { a: Place; b: Place; letter: Letter } | null;
}
/** What a stroke would make. */
interface Intent {
  start: Spot;
  end: Spot;
  letter: Letter;
  bearing: number | null;
  /** A place on the hallway that is there already, and no hallway. */
  along: boolean;
}
interface Refusal {
  start: Spot;
  end: Spot;
  /** Beside the stroke, and below the drawing. */
  short: string;
  words: string;
}

/** Where a side of a spot leads already. */
function beyond(doc: Doc, spot: Spot, letter: Letter): Place | null {
  const to = spot.place?.sides[letter]?.to;
  if (to != null) {
    return placeById(doc, to) ?? null;
  }
  const on = spot.hallway;
  return !on ? null : letter === on.letter ? on.b : letter === opposite(on.letter) ? on.a : null;
}

export class HallwayTool extends Stroke {
  name = "hallway";
  label = "Hallway";
  icon: IconName = "hallway";
  key = "h";
  readonly option = {
    label: "Slanted",
    title: "Hallways in any direction (H again, or hold Shift while you drag)",
    on: false,
  };
  private shift = false;

  get hint(): string {
    const how = this.option.on ? "in any direction: the hallway says its bearing" : "along a compass point, with Shift in any direction";
    return `Drag ${how}. Begin or end at a place to join it; click for a place alone.`;
  }
  held(down: boolean): void {
    this.shift = down;
    this.editor.view?.redraw();
  }

  private spot(at: Point): Spot {
    const { doc } = this.editor;
    const place = this.editor.placeAt(at);
    const hallway = place ? null : this.editor.hallwayAt(at);
    if (place || !hallway) {
      return { at: place?.at ?? alignedPoint(doc, at, this.scale), place, hallway };
    }
    // In line with other places only where that does not lead off the hallway.
    const snapped = alignedPoint(doc, hallway.on, this.scale);
    return { at: nearestOn(hallway.a.at, hallway.b.at, snapped), place, hallway };
  }
  /** Exactly on its compass point; where it meets a hallway, on that. */
  private straightEnd(start: Spot, to: Point, letter: Letter): Spot {
    const at = strokeEnd(this.editor.doc, start.at, to, letter, this.scale);
    const hallway = this.editor.hallwayAt(at);
    if (!hallway) {
      return { at, place: null, hallway };
    }
    const { a, b } = hallway;
    return { at: crossing(start.at, at, a.at, b.at) ?? nearestOn(a.at, b.at, at), place: null, hallway };
  }

  private intent(from: Point, to: Point): Intent | Refusal {
    const start = this.spot(from);
    const free = this.option.on || this.shift;
    let end = this.spot(to);
    const stroke = strokeFrom(start.at, end.place?.at ?? to);
    if (!free && !end.place) {
      if (stroke.off_deg > tolerance_deg) {
        const off = `${Math.round(stroke.off_deg)}° off ${sideNames[stroke.letter]}`;
        return {
          start,
          end,
          short: `${off}: hold Shift`,
          words: `No hallway: this stroke is ${off}. To draw a slanted one, hold Shift or turn on Slanted (H again).`,
        };
      }
      end = this.straightEnd(start, to, stroke.letter);
    }
    const towards = drawn_deg(start.at, end.at);
    const fitting = free || end.place ? lettersFor(towards) : [stroke.letter];
    const letter = fitting.find((each) => this.leadsOn(start, end, each));
    if (!letter) {
      return this.onAHallway(start, end, fitting, free) ?? this.taken(start, end, fitting[0] ?? stroke.letter);
    }
    const bearing = free ? asBearing(towards, letter, 0.5) : end.place ? asBearing(towards, letter) : null;
    return { start, end, letter, bearing, along: false };
  }
  /** Whether a hallway could leave and arrive by this compass point: what leads there already is drawn anew. */
  private leadsOn(start: Spot, end: Spot, letter: Letter): boolean {
    const out = beyond(this.editor.doc, start, letter);
    const home = beyond(this.editor.doc, end, opposite(letter));
    return (!out || out.id === end.place?.id) && (!home || home.id === start.place?.id);
  }
  /** A stroke along a hallway that is there puts a place on it. */
  private onAHallway(start: Spot, end: Spot, fitting: Letter[], free: boolean): Intent | null {
    for (const letter of fitting) {
      const far = beyond(this.editor.doc, start, letter);
      const off = far && apart_deg(drawn_deg(start.at, end.at), drawn_deg(start.at, far.at));
      const near = far && distance(start.at, end.at) < distance(start.at, far.at);
      if (far && !end.place && near && off !== null && off <= (free ? along_deg : tolerance_deg)) {
        const at = nearestOn(start.at, far.at, end.at);
        return { start, end: { at, place: null, hallway: null }, letter, bearing: null, along: true };
      }
    }
    return null;
  }
  private taken(start: Spot, end: Spot, letter: Letter): Refusal {
    const out = beyond(this.editor.doc, start, letter);
    const at = out ? start : end;
    const side = out ? letter : opposite(letter);
    const far = out ?? beyond(this.editor.doc, end, side);
    const who = at.place?.name ?? "The place on the hallway";
    return {
      start,
      end,
      short: `${sideNames[side]} side taken`,
      words: `${who} has a hallway to ${far?.name ?? "another place"} on its ${sideNames[side]} side; erase it first.`,
    };
  }

  protected override done(from: Point, to: Point): void {
    const { editor } = this;
    if (!isStroke(from, to, this.scale)) {
      const there = this.spot(from);
      const id = there.place?.id ?? editor.history.change("place", (draft) => this.stand(draft, there).id);
      editor.select({ kind: "place", id });
      return;
    }
    const intent = this.intent(from, to);
    if (intent.start.place !== null && intent.start.place.id === intent.end.place?.id) {
      return; // there and back
    }
    if ("words" in intent) {
      editor.say(intent.words, "bad");
    } else {
      const id = editor.history.change("hallway", (draft) => this.lay(draft, intent));
      editor.select({ kind: "place", id });
      if (intent.bearing !== null) {
        const side = sideNames[intent.letter];
        editor.say(`A slanted hallway: it leaves at ${degrees(intent.bearing)}, on the ${side} side.`);
      }
    }
  }
  /** The place of a spot, which may have to be made. */
  private stand(draft: Doc, { at, place, hallway }: Spot): Place {
    const a = hallway && placeById(draft, hallway.a.id);
    return (
      (place && placeById(draft, place.id)) ?? (a ? splitHallway(draft, a, hallway.letter, at) : addPlace(draft, at))
    );
  }
  private lay(draft: Doc, { start, end, letter, bearing, along }: Intent): number {
    const a = this.stand(draft, start);
    if (along) {
      return splitHallway(draft, a, letter, end.at).id;
    }
    const b = this.stand(draft, end);
    connect(draft, a, letter, b, bearing);
    return b.id;
  }

  draw(context: CanvasRenderingContext2D, view: PlanView, theme: Theme): void {
    if (!this.from || !this.to || !isStroke(this.from, this.to, this.scale)) {
      return;
    }
    const intent = this.intent(this.from, this.to);
    const good = !("words" in intent);
    const [start, end] = [intent.start.at, good ? intent.end.at : this.to];
    planLine(context, view, [start, end]);
    context.lineCap = "round";
    context.lineWidth = 4;
    context.strokeStyle = good ? theme.accent : theme.bad;
    context.setLineDash(good ? [] : [4, 7]);
    context.stroke();
    context.setLineDash([]);
    const at = view.toScreen(end);
    const length = this.editor.metres(distance(start, end));
    const text = !good
      ? intent.short
      : intent.bearing === null
        ? `${intent.letter}  ${length}`
        : `${degrees(intent.bearing)} (${intent.letter})  ${length}`;
    haloText(
      context,
      text,
      { x: at.x, y: at.y - 24 },
      { colour: good ? theme.accent : theme.bad, halo: theme.plan, px: 14, bold: true },
    );
  }
}
