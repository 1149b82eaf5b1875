// SPDX-License-Identifier: MIT
// Buttons: of the tools, and those that lie on the drawing.
import { el } from "../../../robot/telemetry/pages/common/dom";
import { icon, type IconName } from "./icons";
import type { Tool } from "./stroke";

const groups: [string, string[]][] = [
  ["Map", ["select", "hallway", "unknown", "tags", "erase"]],
  ["Plan", ["scale", "north"]],
  ["Try", ["route"]],
  ["Scene", ["start", "room", "carpet", "ceiling"]],
];

export class Toolbar {
  readonly element: HTMLElement;
  private readonly buttons = new Map<Tool, HTMLButtonElement>();

  constructor(
    tools: readonly Tool[],
    private readonly take: (tool: Tool) => void,
  ) {
    const bar = el("div", { class: "toolbar", role: "toolbar", "aria-label": "Tools" });
    for (const [title, names] of groups) {
      const heading = el("span", { class: "group-title", "aria-hidden": "true" }, title);
      const picks = names.flatMap((name) =>
        tools.filter((tool) => tool.name === name).map((tool) => this.button(tool)),
      );
      bar.append(el("div", { class: "group", role: "group", "aria-label": title }, heading, ...picks));
    }
    this.element = el("section", { class: "tools", "aria-label": "Tools" }, bar);
  }

  show(taken: Tool): void {
    for (const [tool, button] of this.buttons) {
      button.setAttribute("aria-pressed", String(tool === taken));
    }
  }

  private button(tool: Tool): HTMLButtonElement {
    const made = el(
      "button",
      {
        type: "button",
        class: "tool",
        "aria-pressed": "false",
        title: `${tool.label} (${tool.key.toUpperCase()})`,
        "aria-keyshortcuts": tool.key,
        onclick: () => this.take(tool),
      },
      icon(tool.icon),
      el("span", {}, tool.label),
    );
    this.buttons.set(tool, made);
    return made;
  }
}

/** A round button on the drawing. */
export function roundButton(name: IconName, label: string, run: () => void): HTMLElement {
  return el(
    "button",
    { type: "button", class: "round", "aria-label": label, title: label, onclick: run },
    icon(name),
  );
}
