// SPDX-License-Identifier: MIT
// Scale and north of the plan; walls, carpet and ceiling tags of a scene.
import { haloText, planLine } from "../../../robot/telemetry/pages/common/draw";
import type { PlanView, Point } from "../../../robot/telemetry/pages/common/plan_view";
import type { Theme } from "../../../robot/telemetry/pages/common/theme";
import { drawNeedle } from "./compass";
import type { Editor } from "./editor";
import type { IconName } from "./icons";
import { distance, rounded, type Doc } from "./model";
import { turnBy } from "./placement";
import { alignedPoint, isStroke } from "./snapping";
import { Stroke } from "./stroke";

function guide(context: CanvasRenderingContext2D, view: PlanView, a: Point, b: Point, colour: string): void {
  planLine(context, view, [a, b]);
  context.lineWidth = 3;
  context.lineCap = "round";
  context.strokeStyle = colour;
  context.stroke();
}

export class ScaleTool extends Stroke {
  name = "scale";
  label = "Scale";
  icon: IconName = "scale";
  key = "s";
  hint = "Draw a line along something whose length you know, then say how long it is.";
  constructor(
    editor: Editor,
    private readonly ask: (drawn: number) => void,
  ) {
    super(editor);
  }
  protected override done(from: Point, to: Point): void {
    if (isStroke(from, to, this.scale)) {
      this.ask(distance(from, to));
    }
  }
  draw(context: CanvasRenderingContext2D, view: PlanView, theme: Theme): void {
    if (this.from && this.to) {
      guide(context, view, this.from, this.to, theme.estimate);
      const at = view.toScreen(this.to);
      haloText(
        context,
        this.editor.metres(distance(this.from, this.to)),
        { x: at.x, y: at.y - 20 },
        { colour: theme.estimate, halo: theme.plan, px: 14, bold: true },
      );
    }
  }
}

export class NorthTool extends Stroke {
  name = "north";
  label = "North";
  icon: IconName = "north";
  key = "n";
  hint = "Drag the needle, from anywhere, to where north is on the plan. The plan is turned so that north is up.";

  protected override done(from: Point, to: Point): void {
    if (isStroke(from, to, this.scale)) {
      // To the tenth of a degree: nobody draws more finely.
      const yaw = Math.round((Math.atan2(to.x - from.x, to.y - from.y) * 1800) / Math.PI) / 10;
      this.editor.history.change("north", (draft) => turnBy(draft, (yaw * Math.PI) / 180));
    }
  }
  draw(context: CanvasRenderingContext2D, view: PlanView, theme: Theme): void {
    const centre = this.from ? view.toScreen(this.from) : { x: view.width / 2, y: view.height / 2 };
    const tip = this.to ? view.toScreen(this.to) : { x: centre.x, y: centre.y - 1 };
    drawNeedle(context, centre, Math.atan2(tip.x - centre.x, centre.y - tip.y), 90, theme);
  }
}

export class RoomTool extends Stroke {
  name = "room";
  label = "Room";
  icon: IconName = "room";
  key = "o";
  hint =
    "Drag a room from corner to corner, or click its corners one by one. The walls of the scene are then this room's.";

  protected override done(from: Point, to: Point): void {
    const { editor } = this;
    const a = alignedPoint(editor.doc, from, this.scale);
    const b = alignedPoint(editor.doc, to, this.scale);
    editor.history.change("room", (draft) => {
      if (isStroke(from, to, this.scale)) {
        draft.scene.room = [a, { x: b.x, y: a.y }, b, { x: a.x, y: b.y }].map(rounded);
      } else {
        const last = draft.scene.room.at(-1);
        // A room drawn whole is begun anew by a click.
        draft.scene.room = editor.history.undoable === "room" && last ? [...draft.scene.room, a] : [a];
      }
      draft.scene.walls = "room";
    });
  }
  draw(context: CanvasRenderingContext2D, view: PlanView, theme: Theme): void {
    if (this.from && this.to && isStroke(this.from, this.to, this.scale)) {
      const [a, b] = [this.from, this.to];
      planLine(context, view, [a, { x: b.x, y: a.y }, b, { x: a.x, y: b.y }], true);
      context.lineWidth = 3;
      context.strokeStyle = theme.wall;
      context.stroke();
      const at = view.toScreen(b);
      haloText(
        context,
        `${Math.abs(b.x - a.x).toFixed(1)} x ${Math.abs(b.y - a.y).toFixed(1)} m`,
        { x: at.x, y: at.y - 16 },
        { colour: theme.ink, halo: theme.plan, bold: true },
      );
    }
  }
}

export class CarpetTool extends Stroke {
  name = "carpet";
  label = "Carpet";
  icon: IconName = "carpet";
  key = "c";
  hint = "Drag where carpet lies. Click a tile: left out; once more: its tag is dead; once more: a tile again.";

  protected override done(from: Point, to: Point): void {
    const { editor } = this;
    if (isStroke(from, to, this.scale)) {
      editor.history.change("carpet", (draft) => {
        draft.scene.region = [rounded(from), rounded(to)];
        draft.scene.without = [];
        draft.scene.unreadable = [];
        draft.scene.kind = "carpet";
        this.wallsFor(draft);
      });
      return;
    }
    const answer = editor.scene;
    if (!answer?.tile_origin_m || !answer.tile_m) {
      editor.say("Drag over the plan first, where carpet lies.");
      return;
    }
    const [ox, oy] = answer.tile_origin_m;
    const tile: [number, number] = [Math.floor((to.x - ox) / answer.tile_m), Math.floor((to.y - oy) / answer.tile_m)];
    const laid = answer.tiles?.some(([c, r]) => c === tile[0] && r === tile[1]) ?? false;
    editor.history.change("tile", (draft) => nextState(draft, tile, laid));
  }
  private wallsFor(draft: Doc): void {
    if (draft.scene.walls === "hallways") {
      draft.scene.walls = draft.plan ? "plan" : "room";
    }
  }
  draw(context: CanvasRenderingContext2D, view: PlanView, theme: Theme): void {
    if (this.from && this.to) {
      const [a, b] = [this.from, this.to];
      planLine(context, view, [a, { x: b.x, y: a.y }, b, { x: a.x, y: b.y }], true);
      context.lineWidth = 2;
      context.strokeStyle = theme.landmark;
      context.stroke();
    }
  }
}
/** Laid, left out, laid with a dead tag, laid. */
function nextState(draft: Doc, tile: [number, number], laid: boolean): void {
  const scene = draft.scene;
  const among = (list: [number, number][]) => list.some(([c, r]) => c === tile[0] && r === tile[1]);
  const minus = (list: [number, number][]) => list.filter(([c, r]) => c !== tile[0] || r !== tile[1]);
  if (among(scene.without)) {
    scene.without = minus(scene.without);
    scene.unreadable = [...minus(scene.unreadable), tile];
  } else if (among(scene.unreadable)) {
    scene.unreadable = minus(scene.unreadable);
  } else if (laid) {
    scene.without = [...scene.without, tile];
  }
}

export class CeilingTool extends Stroke {
  name = "ceiling";
  label = "Ceiling tag";
  icon: IconName = "ceiling";
  key = "l";
  hint = "Click where a tag hangs under the ceiling. The robot goes from one to the next in the order of the list.";

  protected override done(_from: Point, to: Point): void {
    const at = alignedPoint(this.editor.doc, to, this.scale);
    const index = this.editor.history.change("ceiling tag", (draft) => {
      const scene = draft.scene;
      const taken = new Set(scene.ceiling.map((tag) => tag.name));
      let number = 0;
      const name = () => (number < 26 ? String.fromCharCode(65 + number) : `T${number + 1}`);
      while (taken.has(name())) {
        ++number;
      }
      scene.ceiling.push({ name: name(), at, height_m: scene.ceiling.at(-1)?.height_m ?? 3 });
      if (scene.kind !== "ceiling") {
        scene.kind = "ceiling";
        scene.walls = draft.plan ? "plan" : "room";
      }
      return scene.ceiling.length - 1;
    });
    this.editor.select({ kind: "ceiling", index });
  }
}

export class StartTool extends Stroke {
  name = "start";
  label = "Start";
  icon: IconName = "start";
  key = "p";
  hint = "Press where the robot starts, drag to where it looks.";

  protected override done(from: Point, to: Point): void {
    const at = rounded(alignedPoint(this.editor.doc, from, this.scale));
    const turn = isStroke(from, to, this.scale)
      ? Math.round((Math.atan2(to.y - from.y, to.x - from.x) * 180) / Math.PI / 5) * 5
      : null;
    this.editor.history.change("start", (draft) => {
      draft.scene.start = { ...at, heading_deg: turn ?? draft.scene.start?.heading_deg ?? 0 };
    });
  }
  draw(context: CanvasRenderingContext2D, view: PlanView, theme: Theme): void {
    if (this.from && this.to) {
      planLine(context, view, [this.from, this.to]);
      context.lineWidth = 3;
      context.strokeStyle = theme.robot;
      context.stroke();
    }
  }
}
