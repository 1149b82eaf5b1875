// SPDX-License-Identifier: MIT
// What a scene adds to the drawing: the room and the carpet below the hallways, ceiling tags and the robot above them.
import { haloText, planLine, robotGlyph } from "../../../robot/telemetry/pages/common/draw";
import type { PlanView } from "../../../robot/telemetry/pages/common/plan_view";
import type { Theme } from "../../../robot/telemetry/pages/common/theme";
import type { Editor } from "./editor";

type Context = CanvasRenderingContext2D;

export class SceneDrawing {
  constructor(private readonly editor: Editor) {}

  below(context: Context, view: PlanView, theme: Theme): void {
    this.carpet(context, view, theme);
    this.room(context, view, theme);
  }
  above(context: Context, view: PlanView, theme: Theme): void {
    this.ceiling(context, view, theme);
    this.start(context, view, theme);
  }

  private carpet(context: Context, view: PlanView, theme: Theme): void {
    const { editor } = this;
    const scene = editor.doc.scene;
    if (scene.kind !== "carpet") {
      return;
    }
    const answer = editor.scene;
    if (answer?.tiles && answer.tile_origin_m && answer.tile_m) {
      const side = answer.tile_m * view.scale;
      const dead = new Set(scene.unreadable.map(String));
      for (const [column, row] of answer.tiles) {
        const at = view.toScreen({
          x: answer.tile_origin_m[0] + column * answer.tile_m,
          y: answer.tile_origin_m[1] + (row + 1) * answer.tile_m,
        });
        const unreadable = dead.has(String([column, row]));
        context.fillStyle = unreadable ? theme.bad : theme.landmark;
        context.globalAlpha = unreadable ? 0.35 : 0.16;
        context.fillRect(at.x, at.y, side, side);
        context.globalAlpha = 0.5;
        context.strokeStyle = theme.landmark;
        context.lineWidth = 1;
        context.strokeRect(at.x + 0.5, at.y + 0.5, side - 1, side - 1);
        context.globalAlpha = 1;
        if (side > 9) {
          context.beginPath();
          context.arc(at.x + side / 2, at.y + side / 2, Math.min(3, side / 8), 0, 2 * Math.PI);
          context.fillStyle = unreadable ? theme.bad : theme.tag;
          context.fill();
        }
      }
    }
    if (scene.region) {
      const [a, b] = scene.region;
      planLine(context, view, [a, { x: b.x, y: a.y }, b, { x: a.x, y: b.y }], true);
      context.strokeStyle = theme.landmark;
      context.lineWidth = 2;
      context.setLineDash([8, 5]);
      context.stroke();
      context.setLineDash([]);
    }
  }

  private room(context: Context, view: PlanView, theme: Theme): void {
    const { room, walls } = this.editor.doc.scene;
    if (room.length === 0 || (walls !== "room" && room.length > 2)) {
      return;
    }
    planLine(context, view, room, true);
    context.lineWidth = 4;
    context.lineJoin = "miter";
    context.strokeStyle = theme.wall;
    context.stroke();
    for (const corner of room) {
      const at = view.toScreen(corner);
      context.fillStyle = theme.wall;
      context.fillRect(at.x - 4, at.y - 4, 8, 8);
    }
  }

  private ceiling(context: Context, view: PlanView, theme: Theme): void {
    const { editor } = this;
    const tags = editor.doc.scene.ceiling;
    if (tags.length === 0 || editor.doc.scene.kind !== "ceiling") {
      return;
    }
    planLine(
      context,
      view,
      tags.map((tag) => tag.at),
    );
    context.strokeStyle = theme.tag;
    context.lineWidth = 1.5;
    context.setLineDash([3, 5]);
    context.stroke();
    context.setLineDash([]);
    tags.forEach((tag, i) => {
      const at = view.toScreen(tag.at);
      const selected = editor.selection?.kind === "ceiling" && editor.selection.index === i;
      context.save();
      context.translate(at.x, at.y);
      context.rotate(Math.PI / 4);
      context.fillStyle = theme.tag;
      context.strokeStyle = selected ? theme.accent : theme.plan;
      context.lineWidth = selected ? 4 : 2;
      context.fillRect(-8, -8, 16, 16);
      context.strokeRect(-8, -8, 16, 16);
      context.restore();
      haloText(
        context,
        `${tag.name}  ${tag.height_m} m`,
        { x: at.x, y: at.y - 21 },
        { colour: theme.ink, halo: theme.plan, bold: true },
      );
    });
  }

  private start(context: Context, view: PlanView, theme: Theme): void {
    const start = this.editor.doc.scene.start;
    if (!start || !this.editor.sceneShown) {
      return;
    }
    const yaw = (start.heading_deg * Math.PI) / 180;
    robotGlyph(context, view, { ...start, yaw }, 0.17, theme.robot, theme.plan);
  }
}
