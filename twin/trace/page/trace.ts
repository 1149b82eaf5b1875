// SPDX-License-Identifier: MIT
// The page of `twin trace`: toolbar, drawing, side panel and status line.
import "../../../robot/telemetry/pages/common/base.css";
import "./trace.css";
import { el, liveRegion, setText } from "../../../robot/telemetry/pages/common/dom";
import { PlanView, type Point } from "../../../robot/telemetry/pages/common/plan_view";
import { followTheme } from "../../../robot/telemetry/pages/common/theme";
import { Desk } from "./desk";
import { askLength, showHelp } from "./dialogs";
import { Drawing } from "./drawing";
import { rose } from "./compass";
import { Editor } from "./editor";
import { remade } from "./forms";
import { icon, type IconName } from "./icons";
import { Cursor } from "./keyboard";
import type { Tool } from "./stroke";
import { OptionButton, roundButton, Toolbar } from "./toolbar";
import { metric } from "./model";
import { scaleBy } from "./placement";
import { planPanel, problemList, routePanel } from "./other_panels";
import { scenePanel } from "./scene_panel";
import { Picture, placement } from "./picture";
import { CarpetTool, CeilingTool, NorthTool, RoomTool, ScaleTool, StartTool } from "./plan_tools";
import { focusTags, placePanel } from "./place_panel";
import { HallwayTool } from "./hallway_tool";
import { erase, EraseTool, RouteTool, SelectTool, TagTool, UnknownTool } from "./tools";

const tabs = ["Places", "Route", "Scene", "Plan"] as const;
type Tab = (typeof tabs)[number];

class Page {
  private readonly said = el("span", { class: "said" });
  private readonly live = liveRegion();
  private readonly editor = new Editor((text, level = "info") => {
    setText(this.said, text);
    setText(this.live, text);
    this.said.classList.toggle("bad", level === "bad");
  });
  private readonly desk = new Desk(this.editor);
  private readonly picture = new Picture(() => this.editor.changed());
  private readonly drawing = new Drawing(this.editor, this.picture, {} as Drawing["theme"]);
  private readonly select = new SelectTool(this.editor);
  private readonly tools: Tool[] = [
    this.select,
    new HallwayTool(this.editor),
    new UnknownTool(this.editor),
    new TagTool(this.editor, (_place, letter) => {
      this.show("Places");
      focusTags(letter);
    }),
    new EraseTool(this.editor, this.select),
    new ScaleTool(this.editor, (drawn) => void this.scaled(drawn)),
    new NorthTool(this.editor),
    new RouteTool(this.editor),
    new StartTool(this.editor),
    new RoomTool(this.editor),
    new CarpetTool(this.editor),
    new CeilingTool(this.editor),
  ];
  private tool: Tool = this.select;
  private tab: Tab = "Places";
  private pinched = false;
  private readonly cursor = new Cursor(
    this.editor,
    () => this.tool,
    (text) => setText(this.live, text),
  );
  private readonly canvas = el("canvas", {
    tabindex: "0",
    role: "application",
    "aria-label": "Drawing of the floor",
    "aria-describedby": "tool-hint",
  });
  private readonly hint = el("p", { id: "tool-hint", class: "hint" });
  private readonly option = new OptionButton((text) => {
    this.editor.say(text);
    setText(this.hint, this.tool.hint);
    this.view?.redraw();
  });
  private readonly where = el("span", { class: "figures where" });
  private readonly scaleText = el("span", { class: "figures" });
  private readonly panel = el("div", { class: "panel", role: "tabpanel", id: "panel", tabindex: "-1" });
  private readonly problems = el("section", { class: "problems", "aria-label": "Check" });
  private readonly name = el("input", {
    type: "text",
    id: "name",
    class: "name",
    spellcheck: "false",
    autocomplete: "off",
  });
  private readonly state = el("span", { class: "soft state" });
  private readonly undo = this.action("undo", "Undo", () => this.step("undo"));
  private readonly redo = this.action("redo", "Redo", () => this.step("redo"));
  private readonly toolbar = new Toolbar(this.tools, (tool) => this.take(tool));
  private readonly tabButtons = new Map<Tab, HTMLButtonElement>();
  private view: PlanView | null = null;

  build(root: HTMLElement): void {
    root.append(this.header(), this.toolbar.element, this.stage(), this.side(), this.status(), this.live);
    this.canvas.addEventListener("keydown", (event) => this.key(event));
    this.canvas.addEventListener("pointerdown", (event) => this.secondFinger(event));
    const view = new PlanView(this.canvas, {
      draw: (context, on) => this.draw(context, on),
      hover: (at) => this.hover(at),
      grab: (at, event) => this.grab(at, event),
      drag: (at) => this.drag(at),
      drop: (at) => this.drop(at),
    });
    this.view = view;
    this.editor.view = view;
    followTheme((theme) => {
      this.drawing.theme = theme;
      view.redraw();
    });
    this.editor.onChange(() => this.update());
    document.addEventListener("keydown", (event) => this.shortcut(event));
    for (const kind of ["keydown", "keyup"] as const) {
      document.addEventListener(kind, (event) => this.shifted(event));
    }
    window.addEventListener("beforeunload", (event) => {
      if (this.editor.history.changed) {
        event.preventDefault();
      }
    });
    root.addEventListener("dragover", (event) => event.preventDefault());
    root.addEventListener("drop", (event) => {
      event.preventDefault();
      const file = event.dataTransfer?.files[0];
      if (file) {
        void this.desk.openPicture(file);
      }
    });
    this.take(this.select);
    this.show("Places");
    this.desk
      .begin()
      .catch((error: Error) => this.editor.say(error.message, "bad"))
      .finally(() => this.editor.begun());
  }

  private action(name: IconName, label: string, run: () => void): HTMLButtonElement {
    return el(
      "button",
      { type: "button", class: "action", title: label, onclick: run },
      icon(name),
      el("span", {}, label),
    );
  }
  private header(): HTMLElement {
    this.name.addEventListener("change", () => {
      this.desk.rename(this.name.value.trim() || "plan");
      this.update();
    });
    return el(
      "header",
      {},
      el("h1", {}, "Map tracer"),
      el(
        "div",
        { class: "row" },
        el("label", { for: "name", class: "visually-hidden" }, "Name of the files"),
        this.name,
        this.state,
      ),
      el(
        "div",
        { class: "row actions" },
        this.action("open", "Open", () => void this.desk.open()),
        this.action("save", "Save", () => void this.desk.save(false)),
        this.undo,
        this.redo,
        this.action("help", "Help", () => void showHelp(this.tools)),
      ),
    );
  }
  private stage(): HTMLElement {
    return el(
      "main",
      { class: "stage" },
      this.canvas,
      el("div", { class: "over" }, this.hint, this.option.element),
      el(
        "div",
        { class: "zoom" },
        roundButton("plus", "Magnify", () => this.view?.zoom(1.25)),
        roundButton("minus", "Shrink", () => this.view?.zoom(0.8)),
        roundButton("fit", "Show everything", () => this.desk.fit()),
      ),
    );
  }
  private side(): HTMLElement {
    const list = el(
      "div",
      { role: "tablist", class: "tabs", "aria-label": "Data" },
      ...tabs.map((tab) => {
        const button = el(
          "button",
          { type: "button", role: "tab", id: `tab-${tab}`, "aria-controls": "panel", onclick: () => this.show(tab) },
          tab,
        );
        this.tabButtons.set(tab, button);
        return button;
      }),
    );
    list.addEventListener("keydown", (event) => {
      const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      if (by !== 0) {
        this.show(tabs[(tabs.indexOf(this.tab) + by + tabs.length) % tabs.length] as Tab);
        this.tabButtons.get(this.tab)?.focus();
      }
    });
    return el("aside", { class: "side", "aria-label": "Data and checks" }, list, this.panel, this.problems);
  }
  private status(): HTMLElement {
    return el("footer", {}, this.said, this.where, this.scaleText);
  }

  private take(tool: Tool): void {
    this.tool.cancel();
    this.tool = tool;
    this.toolbar.show(tool);
    setText(this.hint, tool.hint);
    this.option.show(tool);
    this.canvas.dataset["tool"] = tool.name;
    const wanted: Partial<Record<string, Tab>> = {
      route: "Route",
      start: "Scene",
      room: "Scene",
      carpet: "Scene",
      ceiling: "Scene",
      scale: "Plan",
      north: "Plan",
      hallway: "Places",
      unknown: "Places",
      tags: "Places",
    };
    const tab = wanted[tool.name];
    if (tab) {
      this.show(tab);
    }
  }
  private show(tab: Tab): void {
    this.tab = tab;
    for (const [each, button] of this.tabButtons) {
      button.setAttribute("aria-selected", String(each === tab));
      button.tabIndex = each === tab ? 0 : -1;
    }
    this.panel.setAttribute("aria-labelledby", `tab-${tab}`);
    const scene = tab === "Scene";
    if (scene && !this.editor.sceneShown) {
      this.editor.sceneShown = true;
      this.editor.soonCheck();
    }
    this.update();
  }

  private update(): void {
    const { editor } = this;
    const content = {
      Places: () => placePanel(editor),
      Route: () => routePanel(editor),
      Scene: () => scenePanel(editor, () => void this.desk.save(true)),
      Plan: () =>
        planPanel(editor, {
          opacity: this.picture.opacity,
          setOpacity: (opacity) => {
            this.picture.opacity = opacity;
            editor.changed();
          },
          setResolution: (metres) => {
            const now = editor.doc.plan?.resolution_m ?? metres;
            editor.history.change("scale", (draft) => scaleBy(draft, metres / now));
          },
        }),
    };
    remade(this.panel, content[this.tab]());
    remade(this.problems, problemList(editor));
    this.problems.setAttribute("aria-busy", String(editor.busy));
    this.undo.disabled = editor.history.undoable === null;
    this.redo.disabled = editor.history.redoable === null;
    this.undo.title = editor.history.undoable ? `Undo: ${editor.history.undoable}` : "Nothing to undo";
    this.redo.title = editor.history.redoable ? `Redo: ${editor.history.redoable}` : "Nothing to redo";
    if (document.activeElement !== this.name) {
      this.name.value = editor.naming.name;
    }
    setText(this.state, editor.history.changed ? "not saved" : "");
    const plan = editor.doc.plan;
    setText(this.scaleText, plan ? placement(plan) : "sheet in metres, north is up");
    document.title = `${editor.history.changed ? "• " : ""}${editor.naming.name} – map tracer`;
    this.view?.redraw();
  }

  private draw(context: CanvasRenderingContext2D, view: PlanView): void {
    const theme = this.drawing.theme;
    this.drawing.draw(context, view);
    this.tool.draw?.(context, view, theme);
    this.cursor.draw(context, view, theme);
    rose(context, { x: view.width - 46, y: 50 }, theme);
  }
  private hover(at: Point | null): void {
    const unit = metric(this.editor.doc) ? "m" : "(no scale yet)";
    setText(this.where, at ? `${at.x.toFixed(2)}, ${at.y.toFixed(2)} ${unit}` : "");
  }
  private grab(at: Point, event: PointerEvent): boolean {
    this.cursor.shown = false;
    this.pinched = false;
    this.tool.held?.(event.shiftKey);
    return event.button === 0 && !event.ctrlKey && this.tool.press(at);
  }
  private drag(at: Point): void {
    if (!this.pinched) {
      this.tool.move(at);
      this.hover(at);
    }
  }
  private drop(at: Point): void {
    if (!this.pinched) {
      this.tool.release(at);
    }
  }
  /** Two fingers move the plan; what the first one had begun is let go. */
  private secondFinger(event: PointerEvent): void {
    if (!event.isPrimary) {
      this.pinched = true;
      this.tool.cancel();
    }
  }

  private key(event: KeyboardEvent): void {
    const view = this.view;
    if (!view || event.ctrlKey || event.metaKey) {
      return;
    }
    const tool = this.tools.find((each) => each.key === event.key.toLowerCase());
    if (event.key === "Enter") {
      this.tool.held?.(false);
    }
    if (this.cursor.key(event, view)) {
      // moved or pressed
    } else if (event.key === "Escape") {
      this.tool.busy ? this.tool.cancel() : this.editor.select(null);
    } else if (event.key === "Delete" || event.key === "Backspace") {
      erase(this.editor);
    } else if (event.key === "0") {
      this.desk.fit();
    } else if (tool && !event.altKey) {
      tool === this.tool && tool.option ? this.option.press() : this.take(tool);
    } else {
      return;
    }
    event.preventDefault();
  }
  /** Shift under a stroke of the mouse; of the keyboard's cursor it makes the strides longer. */
  private shifted(event: KeyboardEvent): void {
    if (event.key === "Shift" && !this.cursor.shown) {
      this.tool.held?.(event.type === "keydown");
    }
  }
  private shortcut(event: KeyboardEvent): void {
    if (!(event.ctrlKey || event.metaKey) || document.querySelector("dialog[open]")) {
      return;
    }
    const typing = event.target instanceof HTMLInputElement && event.target.type === "text";
    const key = event.key.toLowerCase();
    if (key === "s") {
      (document.activeElement as HTMLElement | null)?.dispatchEvent(new Event("change"));
      void this.desk.save(false);
    } else if (key === "o") {
      void this.desk.open();
    } else if (key === "z" && !typing) {
      this.step(event.shiftKey ? "redo" : "undo");
    } else if (key === "y" && !typing) {
      this.step("redo");
    } else {
      return;
    }
    event.preventDefault();
  }
  private step(which: "undo" | "redo"): void {
    const label = which === "undo" ? this.editor.history.undo() : this.editor.history.redo();
    this.editor.say(
      label === null ? `Nothing to ${which}.` : `${which === "undo" ? "Undone" : "Done again"}: ${label}.`,
    );
  }
  private async scaled(drawn: number): Promise<void> {
    const length = await askLength(drawn, metric(this.editor.doc));
    if (length !== null) {
      this.editor.history.change("scale", (draft) => scaleBy(draft, length / drawn));
      this.desk.fit();
      this.take(this.select);
    }
    this.canvas.focus();
  }
}

new Page().build(document.getElementById("app") as HTMLElement);
