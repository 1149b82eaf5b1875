// SPDX-License-Identifier: MIT
// The plan's picture, drawn where it lies in the world.
import type { Box, PlanView, Point } from "../../../robot/telemetry/pages/common/plan_view";
import type { Theme } from "../../../robot/telemetry/pages/common/theme";
import { pictureUrl } from "./api";
import type { Plan } from "./model";

/** Drawn instead of a large picture while it is small on the screen. */
const smallSide_px = 2048;

/** A pixel's corner, from the upper left, in the world. */
export function pixelToPlan(plan: Plan, u: number, v: number): Point {
  const x = u * plan.resolution_m;
  const y = (plan.height_px - v) * plan.resolution_m;
  const [ox, oy, yaw] = plan.origin;
  return { x: ox + Math.cos(yaw) * x - Math.sin(yaw) * y, y: oy + Math.sin(yaw) * x + Math.cos(yaw) * y };
}
export function planBox(plan: Plan): Box {
  const corners = [
    [0, 0],
    [plan.width_px, 0],
    [0, plan.height_px],
    [plan.width_px, plan.height_px],
  ].map(([u, v]) => pixelToPlan(plan, u as number, v as number));
  const xs = corners.map((p) => p.x);
  const ys = corners.map((p) => p.y);
  return { low: { x: Math.min(...xs), y: Math.min(...ys) }, high: { x: Math.max(...xs), y: Math.max(...ys) } };
}

function drawnTo(image: CanvasImageSource, width: number, height: number, filter: string): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  if (context) {
    context.filter = filter;
    context.drawImage(image, 0, 0, width, height);
  }
  return canvas;
}

export class Picture {
  /** How much of it shows through, 0 to 1. */
  opacity = 1;
  private id = "";
  private image: HTMLImageElement | null = null;
  private prepared: { dark: boolean; full: CanvasImageSource; small: CanvasImageSource } | null = null;

  constructor(private readonly loaded: () => void) {}

  get shown(): boolean {
    return this.image !== null;
  }

  private follow(plan: Plan | null): void {
    if ((plan?.id ?? "") === this.id) {
      return;
    }
    this.id = plan?.id ?? "";
    this.image = null;
    this.prepared = null;
    if (plan) {
      const image = new Image();
      image.addEventListener("load", () => {
        if (plan.id === this.id) {
          this.image = image;
          this.loaded();
        }
      });
      image.src = pictureUrl(plan);
    }
  }

  /** In dark surroundings a plan is drawn light on dark, its colours as they were. */
  private prepare(image: HTMLImageElement, dark: boolean): { full: CanvasImageSource; small: CanvasImageSource } {
    if (this.prepared?.dark !== dark) {
      const filter = dark ? "invert(0.92) hue-rotate(180deg)" : "none";
      const shrink = Math.min(1, smallSide_px / Math.max(image.naturalWidth, image.naturalHeight));
      const full = dark ? drawnTo(image, image.naturalWidth, image.naturalHeight, filter) : image;
      const small =
        shrink < 1
          ? drawnTo(image, Math.ceil(image.naturalWidth * shrink), Math.ceil(image.naturalHeight * shrink), filter)
          : full;
      this.prepared = { dark, full, small };
    }
    return this.prepared;
  }

  draw(context: CanvasRenderingContext2D, view: PlanView, plan: Plan | null, theme: Theme): void {
    this.follow(plan);
    if (!plan || !this.image) {
      return;
    }
    const dark = theme.plan.toLowerCase() < "#7";
    const { full, small } = this.prepare(this.image, dark);
    const at = view.toScreen(pixelToPlan(plan, 0, 0));
    const right = view.toScreen(pixelToPlan(plan, 1, 0));
    const down = view.toScreen(pixelToPlan(plan, 0, 1));
    context.save();
    context.globalAlpha = this.opacity;
    context.transform(right.x - at.x, right.y - at.y, down.x - at.x, down.y - at.y, at.x, at.y);
    const onScreen =
      Math.max(plan.width_px, plan.height_px) * plan.resolution_m * view.scale * (window.devicePixelRatio || 1);
    context.imageSmoothingEnabled = plan.resolution_m * view.scale < 3;
    context.drawImage(onScreen > 1.3 * smallSide_px ? full : small, 0, 0, plan.width_px, plan.height_px);
    context.restore();
  }
}

/** Scale and north of a plan, for the line at the bottom. */
export function placement(plan: Plan): string {
  const scale = plan.scaled ? `1 px = ${Number((plan.resolution_m * 100).toPrecision(3))} cm` : "no scale yet";
  const turned_deg = Number(((-plan.origin[2] * 180) / Math.PI).toFixed(1));
  return `${scale}, north is up${turned_deg === 0 ? "" : `: plan turned by ${turned_deg}°`}`;
}
