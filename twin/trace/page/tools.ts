// SPDX-License-Identifier: MIT
// What a press, a move and a release on the drawing do. The keyboard presses and releases at its cursor.
import type { Point } from "../../../robot/telemetry/pages/common/plan_view";
import { bearingsAsDrawn, followersOf, regroup, type Followers } from "./bearing";
import type { Editor } from "./editor";
import type { IconName } from "./icons";
import {
  clearSide,
  placeById,
  removePlace,
  setLength,
  setUnknown,
  sideNames,
  step,
  type Letter,
  type Place,
} from "./model";
import { Stroke } from "./stroke";
import { alignedPoint, isStroke } from "./snapping";

export class SelectTool extends Stroke {
  name = "select";
  label = "Select";
  icon: IconName = "select";
  key = "v";
  hint = "Click a place or hallway to see its data; drag a place to move it. Drag the empty plan to pan.";
  private moving: number | null = null;
  private followers: Followers = { bearings: [], lengths: [] };
  private drags = 0;
  private moved = false;

  override press(at: Point): boolean {
    const place = this.editor.placeAt(at);
    const hallway = place ? null : this.editor.hallwayAt(at);
    const ceiling = this.editor.doc.scene.ceiling.findIndex(
      (tag) => Math.hypot(tag.at.x - at.x, tag.at.y - at.y) * this.scale < 14,
    );
    this.moving = place?.id ?? null;
    this.followers = place ? followersOf(this.editor.doc, place) : { bearings: [], lengths: [] };
    this.drags += 1;
    this.moved = false;
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
      this.moved = true;
      this.editor.history.change(
        "move",
        (draft) => {
          const place = placeById(draft, id);
          if (place) {
            place.at = alignedPoint(draft, at, this.scale, id);
            this.followers.lengths.forEach((letter) => setLength(draft, place, letter, "drawn"));
            bearingsAsDrawn(draft, place, this.followers.bearings);
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
    const { history } = this.editor;
    // Compass points change when the hand lets go, not under it.
    if (this.moving !== null && this.moved && regroup(structuredClone(history.doc))) {
      history.change("move", regroup, `move ${this.drags}`);
    }
    this.moving = null;
    history.endMerge();
  }
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
