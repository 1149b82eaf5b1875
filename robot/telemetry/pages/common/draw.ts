// SPDX-License-Identifier: MIT
// What plans consist of, drawn in screen coordinates.
import type { PlanView, Point } from "./plan_view";
import type { Theme } from "./theme";

export interface TextStyle {
  colour: string;
  halo: string;
  px?: number;
  bold?: boolean;
  align?: CanvasTextAlign;
  baseline?: CanvasTextBaseline;
}

const family = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif';

/** Text that stays readable on whatever lies below it. */
export function haloText(context: CanvasRenderingContext2D, text: string, at: Point, style: TextStyle): void {
  context.font = `${style.bold ? "600 " : ""}${style.px ?? 12}px ${family}`;
  context.textAlign = style.align ?? "center";
  context.textBaseline = style.baseline ?? "middle";
  context.lineJoin = "round";
  context.lineWidth = 3;
  context.strokeStyle = style.halo;
  context.strokeText(text, at.x, at.y);
  context.fillStyle = style.colour;
  context.fillText(text, at.x, at.y);
}

/** A line through points of the plan. */
export function planLine(context: CanvasRenderingContext2D, view: PlanView, points: readonly Point[], closed = false): void {
  context.beginPath();
  points.forEach((point, i) => {
    const at = view.toScreen(point);
    if (i === 0) {
      context.moveTo(at.x, at.y);
    } else {
      context.lineTo(at.x, at.y);
    }
  });
  if (closed) {
    context.closePath();
  }
}

/** The largest 1, 2 or 5 times a power of ten not above `length`. */
export function roundLength(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  return [5, 2, 1].map((step) => step * power).find((step) => step <= length) ?? power;
}

/** A scale bar with its length, its lower left corner at `at` (screen). */
export function scaleBar(context: CanvasRenderingContext2D, view: PlanView, at: Point, theme: Theme): void {
  const metres = roundLength(140 / view.scale);
  const wide = metres * view.scale;
  const label = metres >= 1 ? `${metres} m` : `${Math.round(metres * 100)} cm`;
  context.lineCap = "butt";
  for (const [colour, width] of [[theme.plan, 5], [theme.ink, 2]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.moveTo(at.x, at.y - 6);
    context.lineTo(at.x, at.y);
    context.lineTo(at.x + wide, at.y);
    context.lineTo(at.x + wide, at.y - 6);
    context.stroke();
  }
  haloText(context, label, { x: at.x + wide / 2, y: at.y - 11 }, { colour: theme.ink, halo: theme.plan });
}

/** A round robot with a nose. Yaw in radians, counter-clockwise from the plan's x. */
export function robotGlyph(
  context: CanvasRenderingContext2D,
  view: PlanView,
  pose: Point & { yaw: number },
  radius: number,
  fill: string,
  edge: string,
  ghost = false,
): void {
  const at = view.toScreen(pose);
  const r = Math.max(radius * view.scale, 6);
  context.save();
  context.translate(at.x, at.y);
  context.rotate(-pose.yaw);
  context.lineWidth = 2;
  context.setLineDash(ghost ? [4, 3] : []);
  context.strokeStyle = edge;
  context.fillStyle = fill;
  context.beginPath();
  context.arc(0, 0, r, 0, 2 * Math.PI);
  if (!ghost) {
    context.fill();
  }
  context.stroke();
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(0.25 * r, 0.45 * r);
  context.lineTo(0.85 * r, 0);
  context.lineTo(0.25 * r, -0.45 * r);
  context.closePath();
  context.fillStyle = ghost ? fill : edge;
  context.fill();
  context.restore();
}

/** An ellipse of standard deviations: a covariance of plan coordinates, m². */
export function covarianceEllipse(
  context: CanvasRenderingContext2D,
  view: PlanView,
  centre: Point,
  covariance: { xx: number; xy: number; yy: number },
  sigmas: number,
): void {
  const mean = (covariance.xx + covariance.yy) / 2;
  const root = Math.hypot((covariance.xx - covariance.yy) / 2, covariance.xy);
  const turn = 0.5 * Math.atan2(2 * covariance.xy, covariance.xx - covariance.yy);
  const at = view.toScreen(centre);
  const axis = (variance: number) => sigmas * Math.sqrt(Math.max(variance, 0)) * view.scale;
  context.beginPath();
  context.ellipse(at.x, at.y, axis(mean + root), axis(mean - root), -turn, 0, 2 * Math.PI);
}
