// SPDX-License-Identifier: MIT
// What every tool is: a press, a move and a release on the drawing.
import type { PlanView, Point } from "../../../robot/telemetry/pages/common/plan_view";
import type { Theme } from "../../../robot/telemetry/pages/common/theme";
import type { Editor } from "./editor";
import type { IconName } from "./icons";

export interface Tool {
  name: string;
  label: string;
  icon: IconName;
  key: string;
  hint: string;
  /** \returns false: nothing is there to be taken, so the plan may be moved instead */
  press(at: Point): boolean;
  move(at: Point): void;
  release(at: Point): void;
  cancel(): void;
  /** Under way from a press to a release. */
  readonly busy: boolean;
  /** Another way of drawing, which the tool's key turns on and off once it is taken. */
  readonly option?: { label: string; title: string; on: boolean };
  /** Shift is down while the mouse draws, or not. */
  held?(down: boolean): void;
  draw?(context: CanvasRenderingContext2D, view: PlanView, theme: Theme): void;
}

/** Keeps where a press began and where it is now. */
export abstract class Stroke implements Tool {
  abstract name: string;
  abstract label: string;
  abstract icon: IconName;
  abstract key: string;
  abstract hint: string;
  protected from: Point | null = null;
  protected to: Point | null = null;
  constructor(protected readonly editor: Editor) {}
  get busy(): boolean {
    return this.from !== null;
  }
  get scale(): number {
    return this.editor.view?.scale ?? 50;
  }
  press(at: Point): boolean {
    this.from = at;
    this.to = at;
    return true;
  }
  move(at: Point): void {
    this.to = at;
    this.editor.view?.redraw();
  }
  release(at: Point): void {
    const from = this.from;
    this.cancel();
    if (from) {
      this.done(from, at);
    }
  }
  cancel(): void {
    this.from = null;
    this.to = null;
    this.editor.view?.redraw();
  }
  protected abstract done(from: Point, to: Point): void;
}
