// SPDX-License-Identifier: MIT
// The drawing without a mouse: a cursor that arrow keys move, and Enter that presses and releases the tool there.
import { haloText } from "../../../robot/telemetry/pages/common/draw";
import type { PlanView, Point } from "../../../robot/telemetry/pages/common/plan_view";
import type { Theme } from "../../../robot/telemetry/pages/common/theme";
import type { Editor } from "./editor";
import { rounded } from "./model";
import type { Tool } from "./stroke";

/** Chosen: a quarter of a hallway's width; walks of a hallway; a hand's breadth. */
const stride_m = { plain: 0.5, shift: 5, alt: 0.1 };
const arrows: Record<string, Point> = {
  ArrowUp: { x: 0, y: 1 },
  ArrowDown: { x: 0, y: -1 },
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
};

export class Cursor {
  at: Point = { x: 0, y: 0 };
  shown = false;

  constructor(
    private readonly editor: Editor,
    private readonly tool: () => Tool,
    private readonly told: (text: string) => void,
  ) {}

  /** \returns whether the key was for the cursor */
  key(event: KeyboardEvent, view: PlanView): boolean {
    const way = arrows[event.key];
    if (way) {
      const stride = event.shiftKey ? stride_m.shift : event.altKey ? stride_m.alt : stride_m.plain;
      this.move(view, { x: this.at.x + way.x * stride, y: this.at.y + way.y * stride });
      return true;
    }
    if (event.key === "Enter") {
      this.enter();
      return true;
    }
    return false;
  }

  private move(view: PlanView, to: Point): void {
    if (!this.shown) {
      // Begins where one looks.
      const middle = view.toPlan({ x: view.width / 2, y: view.height / 2 });
      const chosen = this.editor.selectedPlace?.at;
      this.at = chosen ?? { x: Math.round(middle.x), y: Math.round(middle.y) };
      this.shown = true;
    } else {
      this.at = rounded(to);
    }
    const on = view.toScreen(this.at);
    const border = 40;
    const dx = on.x < border ? border - on.x : on.x > view.width - border ? view.width - border - on.x : 0;
    const dy = on.y < border ? border - on.y : on.y > view.height - border ? view.height - border - on.y : 0;
    if (dx !== 0 || dy !== 0) {
      view.pan(dx, dy);
    }
    if (this.tool().busy) {
      this.tool().move(this.at);
    }
    const here = this.editor.placeAt(this.at);
    this.told(`${this.at.x.toFixed(1)}, ${this.at.y.toFixed(1)} m${here ? `, place ${here.name}` : ""}`);
    view.redraw();
  }

  private enter(): void {
    const tool = this.tool();
    if (tool.busy) {
      tool.release(this.at);
    } else if (tool.press(this.at) && ["unknown", "tags", "erase", "route", "ceiling"].includes(tool.name)) {
      tool.release(this.at); // these are clicks
    }
  }

  draw(context: CanvasRenderingContext2D, view: PlanView, theme: Theme): void {
    if (!this.shown) {
      return;
    }
    const on = view.toScreen(this.at);
    for (const [colour, width] of [
      [theme.plan, 5],
      [theme.estimate, 2],
    ] as const) {
      context.strokeStyle = colour;
      context.lineWidth = width;
      context.beginPath();
      for (const [dx, dy] of [
        [1, 0],
        [-1, 0],
        [0, 1],
        [0, -1],
      ] as const) {
        context.moveTo(on.x + 5 * dx, on.y + 5 * dy);
        context.lineTo(on.x + 17 * dx, on.y + 17 * dy);
      }
      context.stroke();
    }
    haloText(
      context,
      `${this.at.x.toFixed(1)}, ${this.at.y.toFixed(1)}`,
      { x: on.x + 12, y: on.y + 16 },
      { colour: theme.estimate, halo: theme.plan, align: "left", px: 11 },
    );
  }
}
