// SPDX-License-Identifier: MIT
// The live monitor: a plan that is drawn while a robot works, and what it does in figures.
import "../common/base.css";
import "./monitor.css";
import { el, setText } from "../common/dom";
import { PlanView, type Box, type Point } from "../common/plan_view";
import { followTheme, type Theme } from "../common/theme";
import { believedPose, boxOf } from "./layout";
import { legend } from "./legend";
import { Model, type Robot } from "./model";
import { briefState, Panel, stateWords } from "./panel";
import { drawPlan } from "./plan";
import { listen, type Connection } from "./stream";
import { targetsOf, type Target } from "./targets";

/** Screen pixels within which a pointer means a tag. Chosen: half a finger. */
const reach_px = 22;

/** For those that nobody gave a title. */
const missionWords: Record<string, string> = { map: "maps floor tags", hallway: "finds its way in hallways", phase: "follows ceiling tags" };

class Page {
  private readonly model = new Model();
  private readonly title = el("h1", {}, "SensoTwin monitor");
  private readonly subtitle = el("p", { class: "soft" });
  private readonly state = el("p", { class: "state", role: "status" });
  private readonly robots = el("div", { class: "robots", role: "group", "aria-label": "Robots" });
  private readonly canvas = el("canvas", { id: "plan", tabindex: 0, role: "img", "aria-label": "Plan", "aria-describedby": "plan-help" });
  private readonly legend = legend();
  private readonly panel = new Panel();
  private readonly tools: HTMLElement;
  private readonly view: PlanView;
  private readonly roomButton: HTMLButtonElement;
  private readonly followButton: HTMLButtonElement;
  private theme: Theme | null = null;
  private connection: Connection = "connecting";
  private chosenRobot = 0;
  private withRoom = true;
  private following = false;
  private chosen: string | null = null;
  private pinned = false;
  private dirty = false;
  private shownBox = "";

  constructor(root: HTMLElement) {
    this.roomButton = el("button", { type: "button", "aria-label": "True room", "aria-pressed": "true", onclick: () => this.toggleRoom() }, el("span", { class: "wide" }, "True "), el("span", { class: "short" }, "room"));
    this.followButton = el("button", { type: "button", "aria-pressed": "false", onclick: () => this.toggleFollow() }, "Follow");
    this.tools = this.toolbar();
    root.append(
      el("header", { class: "head" }, el("div", { class: "names" }, this.title, this.subtitle), this.robots, this.state),
      el("main", { class: "stage" },
        el("div", { class: "plan" }, this.canvas, this.tools,
          el("p", { id: "plan-help", class: "visually-hidden" }, "Arrow keys move the plan, plus and minus magnify it, the buttons step through the tags."))),
      this.panel.element,
      this.legend.element,
    );
    this.view = new PlanView(this.canvas, {
      draw: (context) => this.draw(context),
      hover: (at) => this.hover(at),
      click: (at) => this.pin(at),
    });
    new ResizeObserver(() => this.refit()).observe(this.canvas);
    followTheme((theme) => {
      this.theme = theme;
      this.panel.recolour();
      this.ask();
    });
    listen("events", (data) => {
      this.model.take(data);
      this.ask();
    }, (to) => {
      this.connection = to;
      this.ask();
    });
  }

  private toolbar(): HTMLElement {
    const button = (label: string, text: string, act: () => void) =>
      el("button", { type: "button", "aria-label": label, title: label, onclick: act }, text);
    return el("div", { class: "tools", role: "toolbar", "aria-label": "Plan" },
      button("Magnify", "+", () => this.view.zoom(1.25)),
      button("Make smaller", "\u2212", () => this.view.zoom(0.8)),
      button("Fit the plan", "Fit", () => this.fit()),
      this.followButton,
      this.roomButton,
      button("Previous tag", "\u2039 Tag", () => this.step(-1)),
      button("Next tag", "Tag \u203a", () => this.step(1)));
  }

  private get robot(): Robot | null {
    return this.model.robots.get(this.chosenRobot) ?? this.model.inOrder[0] ?? null;
  }

  /** In the same room as the one that is shown. */
  private get others(): Robot[] {
    const robot = this.robot;
    return this.model.inOrder.filter((other) => other !== robot && other.scene !== null && other.scene.scene === robot?.scene?.scene);
  }

  private ask(): void {
    if (!this.dirty) {
      this.dirty = true;
      requestAnimationFrame(() => {
        this.dirty = false;
        this.show();
      });
    }
  }

  private show(): void {
    const robot = this.robot;
    const words = stateWords(robot, this.connection);
    setText(this.state, words.text);
    this.state.className = `state ${words.kind}`;
    this.canvas.dataset["state"] = words.text;
    if (!robot || !this.theme) {
      return;
    }
    const { card, scene } = robot;
    const title = card.title !== "" ? card.title : robot.name;
    setText(this.title, title);
    setText(this.subtitle, [title === robot.name ? missionWords[card.mission] ?? "" : robot.name, scene ? `seed ${scene.seed}` : "", card.source].filter((part) => part !== "").join(" \u00b7 "));
    document.title = `${robot.name}: SensoTwin monitor`;
    this.showRobots();
    this.roomButton.hidden = !scene;
    this.legend.show(robot, this.withRoom, this.others.length > 0);
    this.panel.show(robot, this.theme);
    this.panel.showTag(this.target());
    this.canvas.setAttribute("aria-label", `Plan of ${robot.name}: ${robot.tiles.size} tiles, ${robot.objects.size} landmarks, ${robot.places.size} places, ${robot.ceiling.size} ceiling tags`);
    this.canvas.dataset["tiles"] = String(robot.tilesFound);
    this.canvas.dataset["events"] = String(robot.events.size);
    this.canvas.dataset["trail"] = String(robot.trail.size);
    this.canvas.dataset["trueTrail"] = String(robot.trueTrail.size);
    this.canvas.dataset["people"] = String(robot.people.length);
    this.refit();
    const pose = believedPose(robot);
    if (this.following && pose) {
      const at = this.view.toScreen(pose);
      this.view.pan(this.view.width / 2 - at.x, this.view.height / 2 - at.y);
    }
    this.view.redraw();
  }

  private showRobots(): void {
    const all = this.model.inOrder;
    this.robots.hidden = all.length < 2;
    if (this.robots.childElementCount !== all.length) {
      this.robots.replaceChildren(...all.map((robot) =>
        el("button", { type: "button", onclick: () => this.choose(robot.id) },
          el("span", { class: "mark", "aria-hidden": "true" }), el("span", { class: "name" }), el("span", { class: "doing" }))));
    }
    all.forEach((robot, i) => {
      const button = this.robots.children[i];
      const [mark, name, doing] = button?.children ?? [];
      if (!button || !mark || !name || !doing) {
        return;
      }
      const state = briefState(robot);
      // Two of one name are told apart by where they are.
      const twice = robot.at !== "" && all.some((other) => other !== robot && other.name === robot.name);
      setText(mark, state.mark);
      setText(name, twice ? `${robot.name} (${robot.at.replace("http://", "")})` : robot.name);
      setText(doing, state.text);
      button.setAttribute("aria-pressed", String(robot === this.robot));
    });
  }

  private choose(id: number): void {
    this.chosenRobot = id;
    this.chosen = null;
    this.fit();
    this.ask();
  }

  /** As long as nobody moved the plan it shows all there is. */
  private refit(): void {
    const robot = this.robot;
    const box = robot ? boxOf(robot, this.withRoom) : null;
    if (!box || this.view.touched) {
      return;
    }
    const key = JSON.stringify([box, this.view.width, this.view.height]);
    if (key !== this.shownBox) {
      this.shownBox = key;
      this.fitTo(box);
    }
  }

  /** Clear of the buttons above and the scale below. */
  private fitTo(box: Box): void {
    this.view.fit(box, this.tools.offsetHeight + 16, 52);
  }

  private fit(): void {
    this.setFollowing(false);
    const robot = this.robot;
    const box = robot ? boxOf(robot, this.withRoom) : null;
    if (box) {
      this.fitTo(box);
    }
  }

  private setFollowing(on: boolean): void {
    this.following = on;
    this.followButton.setAttribute("aria-pressed", String(on));
  }

  private toggleFollow(): void {
    this.setFollowing(!this.following);
    if (this.following && this.view.scale < 80) {
      this.view.zoom(80 / this.view.scale);
    }
    this.ask();
  }

  private toggleRoom(): void {
    this.withRoom = !this.withRoom;
    this.roomButton.setAttribute("aria-pressed", String(this.withRoom));
    this.ask();
  }

  private target(): Target | null {
    const robot = this.robot;
    return robot && this.chosen !== null ? (targetsOf(robot).find((target) => target.key === this.chosen) ?? null) : null;
  }

  private nearest(at: Point): Target | null {
    const robot = this.robot;
    let best: Target | null = null;
    let away = reach_px / this.view.scale;
    for (const target of robot ? targetsOf(robot) : []) {
      const distance = Math.hypot(target.at.x - at.x, target.at.y - at.y);
      if (distance < away) {
        away = distance;
        best = target;
      }
    }
    return best;
  }

  private hover(at: Point | null): void {
    if (this.pinned) {
      return;
    }
    const found = at ? this.nearest(at) : null;
    if ((found?.key ?? null) !== this.chosen) {
      this.chosen = found?.key ?? null;
      this.ask();
    }
  }

  private pin(at: Point): void {
    const found = this.nearest(at);
    this.chosen = found?.key ?? null;
    this.pinned = found !== null;
    this.ask();
  }

  private step(by: number): void {
    const robot = this.robot;
    const targets = robot ? targetsOf(robot) : [];
    const at = targets.findIndex((target) => target.key === this.chosen);
    const next = targets[at < 0 ? (by > 0 ? 0 : targets.length - 1) : (at + by + targets.length) % targets.length];
    if (next) {
      this.chosen = next.key;
      this.pinned = true;
      this.ask();
    }
  }

  private draw(context: CanvasRenderingContext2D): void {
    const robot = this.robot;
    if (!robot || !this.theme) {
      return;
    }
    const theme = this.theme;
    drawPlan(context, this.view, {
      robot,
      others: this.others,
      theme,
      withRoom: this.withRoom,
      chosen: this.target(),
      tileColours: { open: theme["tile-open"], closed: theme["tile-closed"], given_up: theme["tile-given-up"] },
    });
    // For tests, which look at named places of the plan.
    const origin = this.view.toScreen({ x: 0, y: 0 });
    this.canvas.dataset["view"] = JSON.stringify({ x: origin.x, y: origin.y, scale: this.view.scale });
  }
}

const root = document.getElementById("monitor");
if (root) {
  new Page(root);
}
