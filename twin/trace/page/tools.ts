// SPDX-License-Identifier: MIT
// What a press, a move and a release on the drawing do. The keyboard presses and releases at its cursor.
import { haloText, planLine } from "../../../robot/telemetry/pages/common/draw";
import type { PlanView, Point } from "../../../robot/telemetry/pages/common/plan_view";
import type { Theme } from "../../../robot/telemetry/pages/common/theme";
import type { Editor } from "./editor";
import type { IconName } from "./icons";
import {
  addPlace,
  clearSide,
  connect,
  placeById,
  removePlace,
  setUnknown,
  sideNames,
  splitHallway,
  step,
  type Doc,
  type Letter,
  type Place,
} from "./model";
import { Stroke } from "./stroke";
import { alignedPoint, isStroke, strokeEnd, strokeFrom, tolerance_deg } from "./snapping";

export class SelectTool extends Stroke {
  name = "select";
  label = "Select";
  icon: IconName = "select";
  key = "v";
  hint = "Click a place or hallway to see its data; drag a place to move it. Drag the empty plan to pan.";
  private moving: number | null = null;
  private drags = 0;

  override press(at: Point): boolean {
    const place = this.editor.placeAt(at);
    const hallway = place ? null : this.editor.hallwayAt(at);
    const ceiling = this.editor.doc.scene.ceiling.findIndex(
      (tag) => Math.hypot(tag.at.x - at.x, tag.at.y - at.y) * this.scale < 14,
    );
    this.moving = place?.id ?? null;
    this.drags += 1;
    this.editor.select(
      place
        ? { kind: "place", id: place.id }
        : ceiling >= 0 && this.editor.doc.scene.kind === "ceiling"
          ? { kind: "ceiling", index: ceiling }
          : hallway
            ? { kind: "hallway", id: hallway.a.id, letter: hallway.letter }
            : null,
    );
    return this.editor.selection !== null && super.press(at);
  }
  override move(at: Point): void {
    super.move(at);
    const chosen = this.editor.selection;
    if (!this.from || !isStroke(this.from, at, this.scale)) {
      return;
    }
    const key = `move ${this.drags}`;
    if (this.moving !== null) {
      const id = this.moving;
      this.editor.history.change(
        "move",
        (draft) => {
          const place = placeById(draft, id);
          if (place) {
            place.at = alignedPoint(draft, at, this.scale, id);
          }
        },
        key,
      );
    } else if (chosen?.kind === "ceiling") {
      this.editor.history.change(
        "move tag",
        (draft) => {
          const tag = draft.scene.ceiling[chosen.index];
          if (tag) {
            tag.at = alignedPoint(draft, at, this.scale);
          }
        },
        key,
      );
    }
  }
  protected override done(): void {
    this.moving = null;
    this.editor.history.endMerge();
  }
}

/** The paper's stroke: a press, a drag along a compass point, and two places with a hallway are there. */
export class HallwayTool extends Stroke {
  name = "hallway";
  label = "Hallway";
  icon: IconName = "hallway";
  key = "h";
  hint =
    "Drag along a compass point: two places and their hallway. Drag from a place to go on. Click for a place alone.";

  /** Where a stroke begins: at a place, on a hallway, or anywhere. */
  private begin(draft: Doc, at: Point): Place {
    const near = this.editor.placeAt(at);
    const hallway = near ? null : this.editor.hallwayAt(at);
    if (near) {
      return placeById(draft, near.id) ?? addPlace(draft, at);
    }
    if (hallway) {
      const a = placeById(draft, hallway.a.id);
      if (a) {
        return splitHallway(draft, a, hallway.letter, alignedPoint(draft, hallway.on, this.scale));
      }
    }
    return addPlace(draft, alignedPoint(draft, at, this.scale));
  }

  protected override done(from: Point, to: Point): void {
    const { editor } = this;
    if (!isStroke(from, to, this.scale)) {
      const there = editor.placeAt(from);
      const id = there ? there.id : editor.history.change("place", (draft) => this.begin(draft, from).id);
      editor.select({ kind: "place", id });
      return;
    }
    const start = editor.placeAt(from);
    const origin = start?.at ?? from;
    const target = editor.placeAt(to);
    const { letter, off_deg } = strokeFrom(origin, target?.at ?? to);
    if (off_deg > tolerance_deg) {
      editor.say(
        `Hallways run north, east, south or west: this stroke is ${Math.round(off_deg)}° off ${sideNames[letter]}.`,
        "bad",
      );
      return;
    }
    if (target && target.id === start?.id) {
      return;
    }
    const taken = start?.sides[letter];
    const beyond = taken?.to == null ? undefined : placeById(editor.doc, taken.to);
    if (beyond && beyond.id !== target?.id && !between(origin, beyond.at, to, letter)) {
      editor.say(
        `${start?.name} has a hallway to ${beyond.name} on its ${sideNames[letter]} side; erase it first.`,
        "bad",
      );
      return;
    }
    const id = editor.history.change("hallway", (draft) => this.lay(draft, from, to, letter, target));
    editor.select({ kind: "place", id });
  }

  private lay(draft: Doc, from: Point, to: Point, letter: Letter, target: Place | null): number {
    const a = this.begin(draft, from);
    const far = placeById(draft, a.sides[letter]?.to ?? -1);
    const end = strokeEnd(draft, a.at, to, letter, this.scale);
    const known = target ? placeById(draft, target.id) : undefined;
    if (known) {
      connect(draft, a, letter, known);
      return known.id;
    }
    if (far) {
      return splitHallway(draft, a, letter, end).id;
    }
    const across = this.editor.hallwayAt(end);
    const other = across ? placeById(draft, across.a.id) : undefined;
    const b =
      across && other && other.id !== a.id ? splitHallway(draft, other, across.letter, end) : addPlace(draft, end);
    connect(draft, a, letter, b);
    return b.id;
  }

  draw(context: CanvasRenderingContext2D, view: PlanView, theme: Theme): void {
    if (!this.from || !this.to || !isStroke(this.from, this.to, this.scale)) {
      return;
    }
    const start = this.editor.placeAt(this.from)?.at ?? alignedPoint(this.editor.doc, this.from, this.scale);
    const target = this.editor.placeAt(this.to);
    const { letter, off_deg } = strokeFrom(start, target?.at ?? this.to);
    const good = off_deg <= tolerance_deg;
    const end = target?.at ?? (good ? strokeEnd(this.editor.doc, start, this.to, letter, this.scale) : this.to);
    planLine(context, view, [start, end]);
    context.lineCap = "round";
    context.lineWidth = 4;
    context.strokeStyle = good ? theme.accent : theme.bad;
    context.setLineDash(good ? [] : [4, 7]);
    context.stroke();
    context.setLineDash([]);
    const at = view.toScreen(end);
    const text = good
      ? `${letter}  ${this.editor.metres(Math.hypot(end.x - start.x, end.y - start.y))}`
      : `${Math.round(off_deg)}° off ${letter}`;
    haloText(
      context,
      text,
      { x: at.x, y: at.y - 24 },
      { colour: good ? theme.accent : theme.bad, halo: theme.plan, px: 14, bold: true },
    );
  }
}
function between(a: Point, b: Point, p: Point, letter: Letter): boolean {
  const along = (q: Point) => (q.x - a.x) * step[letter].x + (q.y - a.y) * step[letter].y;
  return along(p) > 0 && along(p) < along(b);
}

/** "?" on a side of a place; once more: "-", no hallway. */
export class UnknownTool extends Stroke {
  name = "unknown";
  label = "Unknown";
  icon: IconName = "unknown";
  key = "u";
  hint = "Click beside a place: a hallway whose far end nobody knows (?). Click it again: no hallway there (-).";

  protected override done(_from: Point, to: Point): void {
    const { editor } = this;
    const found = editor.sideAt(to);
    if (!found) {
      editor.say("Click beside a place, on the side that the hallway leaves it.");
      return;
    }
    const { place, letter } = found;
    const side = place.sides[letter];
    if (side && side.to !== null) {
      editor.say(
        `The ${sideNames[letter]} side of ${place.name} leads to a known place; erase that hallway first.`,
        "bad",
      );
      return;
    }
    editor.history.change(side ? "no hallway" : "unknown hallway", (draft) => {
      const there = placeById(draft, place.id);
      if (there) {
        side ? clearSide(draft, there, letter) : setUnknown(draft, there, letter);
      }
    });
    editor.select({ kind: "place", id: place.id });
  }
}

/** The paper's second mode: click a side, give the numbers of its tags. */
export class TagTool extends Stroke {
  name = "tags";
  label = "Tags";
  icon: IconName = "tag";
  key = "t";
  hint = "Click a place on the side from which a robot comes to it, and type the numbers of the tags that it meets.";
  constructor(
    editor: Editor,
    private readonly edit: (place: Place, letter: Letter) => void,
  ) {
    super(editor);
  }
  protected override done(_from: Point, to: Point): void {
    const found = this.editor.sideAt(to);
    if (!found) {
      this.editor.say("Click beside a place, on the side from which a robot comes to it.");
    } else if (!found.place.sides[found.letter]) {
      this.editor.select({ kind: "place", id: found.place.id });
      this.editor.say(`${found.place.name} has no hallway on its ${sideNames[found.letter]} side.`, "bad");
    } else {
      this.editor.select({ kind: "place", id: found.place.id });
      this.edit(found.place, found.letter);
    }
  }
}

export function erase(editor: Editor): void {
  const chosen = editor.selection;
  if (!chosen) {
    return;
  }
  editor.history.change("erase", (draft) => {
    if (chosen.kind === "ceiling") {
      draft.scene.ceiling.splice(chosen.index, 1);
      return;
    }
    const place = placeById(draft, chosen.id);
    if (place && chosen.kind === "place") {
      removePlace(draft, place);
    } else if (place && chosen.kind === "hallway") {
      clearSide(draft, place, chosen.letter);
    }
  });
}

export class EraseTool extends Stroke {
  name = "erase";
  label = "Erase";
  icon: IconName = "erase";
  key = "e";
  hint = "Click a place, a hallway, a ? or a ceiling tag to remove it. Undo brings it back.";
  constructor(
    editor: Editor,
    private readonly select: SelectTool,
  ) {
    super(editor);
  }
  protected override done(_from: Point, to: Point): void {
    this.select.press(to);
    this.select.cancel();
    const { editor } = this;
    const near = editor.selection ? null : editor.sideAt(to);
    if (near?.place.sides[near.letter]?.to === null) {
      editor.select({ kind: "hallway", id: near.place.id, letter: near.letter });
    }
    if (!editor.selection) {
      editor.say("There is nothing to erase here.");
    }
    erase(editor);
  }
}

export class RouteTool extends Stroke {
  name = "route";
  label = "Try route";
  icon: IconName = "route";
  key = "r";
  hint = "Click where the robot stands, then where it is to go. Click a hallway to block it, or open it again.";

  protected override done(_from: Point, to: Point): void {
    const { editor } = this;
    const place = editor.placeAt(to);
    const hallway = place ? null : editor.hallwayAt(to);
    if (place) {
      if (!editor.routeFrom || editor.routeTo) {
        editor.routeFrom = place.name;
        editor.routeTo = "";
      } else {
        editor.routeTo = place.name;
      }
    } else if (hallway) {
      const { a, letter } = hallway;
      const before = editor.blocked.length;
      const b = placeById(editor.doc, a.sides[letter]?.to ?? -1);
      editor.blocked = editor.blocked.filter(
        ([name, side]) =>
          !(
            (name === a.name && side === letter) ||
            (b && name === b.name && b.sides[side]?.to === a.id && step[side].x === -step[letter].x)
          ),
      );
      if (editor.blocked.length === before) {
        editor.blocked.push([a.name, letter]);
      }
    }
    void editor.planRoute().then(() => editor.changed());
  }
}
