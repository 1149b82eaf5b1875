// SPDX-License-Identifier: MIT
// The compass rose on the drawing, and the needle that is dragged to north.
import { haloText } from "../../../robot/telemetry/pages/common/draw";
import type { Point } from "../../../robot/telemetry/pages/common/plan_view";
import type { Theme } from "../../../robot/telemetry/pages/common/theme";

/** North is up. */
export function rose(context: CanvasRenderingContext2D, at: Point, theme: Theme): void {
  context.save();
  context.translate(at.x, at.y);
  context.beginPath();
  context.arc(0, 0, 32, 0, 2 * Math.PI);
  context.fillStyle = theme.card;
  context.globalAlpha = 0.9;
  context.fill();
  context.globalAlpha = 1;
  context.strokeStyle = theme.line;
  context.lineWidth = 1;
  context.stroke();
  context.beginPath();
  context.moveTo(0, -15);
  context.lineTo(5, 2);
  context.lineTo(-5, 2);
  context.closePath();
  context.fillStyle = theme.bad;
  context.fill();
  context.font = "600 11px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const [letter, x, y] of [
    ["N", 0, -23],
    ["E", 23, 0],
    ["S", 0, 23],
    ["W", -23, 0],
  ] as const) {
    context.fillStyle = letter === "N" ? theme.bad : theme["soft-ink"];
    context.fillText(letter, x, y);
  }
  context.restore();
}

/** A compass needle. \param turn  clockwise from up, rad */
export function drawNeedle(
  context: CanvasRenderingContext2D,
  at: Point,
  turn: number,
  long: number,
  theme: Theme,
): void {
  context.save();
  context.translate(at.x, at.y);
  context.beginPath();
  context.arc(0, 0, long, 0, 2 * Math.PI);
  context.fillStyle = theme.card;
  context.globalAlpha = 0.85;
  context.fill();
  context.globalAlpha = 1;
  context.lineWidth = 2;
  context.strokeStyle = theme["soft-ink"];
  context.stroke();
  context.rotate(turn);
  for (const [half, colour] of [
    [-1, theme.bad],
    [1, theme["soft-ink"]],
  ] as const) {
    context.beginPath();
    context.moveTo(0, half * (long - 8));
    context.lineTo(long * 0.12, 0);
    context.lineTo(-long * 0.12, 0);
    context.closePath();
    context.fillStyle = colour;
    context.fill();
  }
  haloText(context, "N", { x: 0, y: -long - 12 }, { colour: theme.bad, halo: theme.plan, px: 16, bold: true });
  context.restore();
}
