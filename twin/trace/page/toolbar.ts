// SPDX-License-Identifier: MIT
// Buttons: of the tools, and those that lie on the drawing.
import { el, setText } from "../../../robot/telemetry/pages/common/dom";
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

/** Turns another way of drawing on and off, where the tool has one. */
export class OptionButton {
  readonly element = el("button", { type: "button", class: "option", onclick: () => this.press() });
  private tool: Tool | null = null;

  constructor(private readonly said: (text: string) => void) {}

  show(tool: Tool): void {
    this.tool = tool;
    const { option } = tool;
    this.element.hidden = option === undefined;
    if (option) {
      setText(this.element, option.label);
      this.element.title = option.title;
      this.element.setAttribute("aria-pressed", String(option.on));
    }
  }
  press(): void {
    const option = this.tool?.option;
    if (this.tool && option) {
      option.on = !option.on;
      this.show(this.tool);
      this.said(`${option.label}: ${option.on ? "on" : "off"}.`);
    }
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
