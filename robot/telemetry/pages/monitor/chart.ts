// SPDX-License-Identifier: MIT
// A value over the robot's time, by uPlot.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { el, setText } from "../common/dom";
import type { Theme } from "../common/theme";
import { clock } from "./words";

export interface ChartKind {
  title: string;
  series: string;
  unit: string;
  /** The value's axis begins at 0 and never ends below this. */
  least?: number;
  steps?: boolean;
}

const height_px = 130;

export class Chart {
  readonly element: HTMLElement;
  private readonly plotAt = el("div", { class: "plot", role: "img" });
  private readonly summary = el("p", { class: "soft figures small" });
  private plot: uPlot | null = null;
  private shown = "";

  constructor(readonly kind: ChartKind) {
    this.element = el("section", { class: "card", "aria-label": kind.title }, el("h2", {}, kind.title), this.plotAt, this.summary);
    this.element.hidden = true;
    new ResizeObserver(() => {
      const wide = this.plotAt.clientWidth;
      if (this.plot && wide > 0) {
        this.plot.setSize({ width: wide, height: height_px });
      }
    }).observe(this.plotAt);
  }

  /** In other colours from the next show() on. */
  forget(): void {
    this.plot?.destroy();
    this.plot = null;
    this.shown = "";
  }

  /** \param run  tells these samples from those of another robot or run */
  show(run: number, samples: readonly { t: number; v: number }[], theme: Theme): void {
    const last = samples.at(-1);
    if (!last || samples.length < 2) {
      this.element.hidden = true;
      return;
    }
    this.element.hidden = false;
    const key = `${run} ${samples.length} ${last.t}`;
    if (key === this.shown) {
      return;
    }
    this.shown = key;
    const words = `${clock(last.t)}: ${Number(last.v.toFixed(1))} ${this.kind.unit}`;
    setText(this.summary, words);
    this.plotAt.setAttribute("aria-label", `${this.kind.title}, ${samples.length} points; last, at ${words}`);
    const data: uPlot.AlignedData = [samples.map((s) => s.t / 60), samples.map((s) => s.v)];
    if (this.plot) {
      this.plot.setData(data);
    } else {
      this.plot = new uPlot(this.options(theme), data, this.plotAt);
    }
  }

  private options(theme: Theme): uPlot.Options {
    const axis: uPlot.Axis = {
      stroke: theme["soft-ink"],
      font: "11px system-ui, sans-serif",
      grid: { stroke: theme.line, width: 1 },
      ticks: { stroke: theme.line, width: 1, size: 4 },
    };
    const { least, steps } = this.kind;
    return {
      width: Math.max(this.plotAt.clientWidth, 100),
      height: height_px,
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false },
        y: least === undefined ? {} : { range: (_plot, _low, high) => [0, Math.max(high * 1.05, least)] },
      },
      axes: [
        { ...axis, size: 28, values: (_plot, splits) => splits.map((v) => ((splits.at(-1) ?? 0) < 2 ? `${Math.round(v * 60)} s` : `${Number(v.toFixed(2))} min`)) },
        { ...axis, size: 44 },
      ],
      series: [
        {},
        {
          stroke: theme.accent,
          width: 2,
          points: { show: false },
          ...(steps && uPlot.paths.stepped ? { paths: uPlot.paths.stepped({ align: 1 }) } : {}),
        },
      ],
    };
  }
}
