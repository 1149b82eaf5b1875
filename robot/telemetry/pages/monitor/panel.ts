// SPDX-License-Identifier: MIT
// The cards beside the plan: what is going on in words and figures.
import { el, setText } from "../common/dom";
import type { Theme } from "../common/theme";
import { Chart } from "./chart";
import type { Robot } from "./model";
import type { Connection } from "./stream";
import type { Target } from "./targets";
import { clock, markOf, reason, sentence, severityOf } from "./words";

/** Lines of the list that are shown: further ones are counted. */
const linesShown = 200;

function number(of: Record<string, unknown>, key: string): number | null {
  const value = of[key];
  return typeof value === "number" ? value : null;
}

/** "1 event", "2 events" */
function counted(count: number, of: string): string {
  return `${count} ${of}${count === 1 ? "" : "s"}`;
}

function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** Rows of a name and a value, kept and rewritten in place. */
class Facts {
  readonly element = el("dl", { class: "facts" });
  private readonly rows = new Map<string, HTMLElement>();

  show(facts: readonly [string, string][]): void {
    const names = new Set(facts.map(([name]) => name));
    for (const [name, value] of this.rows) {
      if (!names.has(name)) {
        value.parentElement?.remove();
        this.rows.delete(name);
      }
    }
    facts.forEach(([name, text], i) => {
      const value = this.rows.get(name) ?? el("dd", { class: "figures" });
      if (!this.rows.has(name)) {
        this.rows.set(name, value);
        this.element.insertBefore(el("div", {}, el("dt", {}, name), value), this.element.children[i] ?? null);
      }
      setText(value, text);
    });
  }
}

export class Panel {
  readonly element = el("aside", { class: "panel", "aria-label": "What the robot does" });
  private readonly progressTitle = el("h2", {}, "Progress");
  private readonly big = el("p", { class: "big figures" });
  private readonly bar = el("progress", { max: 1, value: 0, "aria-label": "Share of the tiles that are mapped" });
  private readonly facts = new Facts();
  private readonly battery = new Facts();
  private readonly batteryBar = el("meter", { min: 0, max: 100, low: 20, value: 0, "aria-label": "Battery charge in percent" });
  private readonly batteryText = el("p", { class: "big figures" });
  private readonly batteryCard: HTMLElement;
  private readonly wiresCard: HTMLElement;
  private readonly tagTitle = el("p", { class: "tag-title" }, "Point at a tag, or step through them with the buttons on the plan.");
  private readonly tagFacts = new Facts();
  private readonly wires = new Facts();
  private readonly wiresWord = el("p", { class: "verdict" });
  private readonly list = el("ol", { class: "events", tabindex: 0, "aria-label": "Events, the newest first" });
  private readonly listCount = el("p", { class: "soft small figures" });
  private readonly charts = [
    new Chart({ title: "Tiles mapped over time", series: "tiles", unit: "tiles", least: 4, steps: true }),
    new Chart({ title: "Distance from the ideal path (true)", series: "error_cm", unit: "cm" }),
    new Chart({ title: "Battery over time", series: "battery", unit: "%", least: 100 }),
  ];
  private newestShown = -1;
  private shownRobot: Robot | null = null;
  /** Counts the robots and runs that were shown. */
  private run = 0;

  constructor() {
    this.batteryCard = el("section", { class: "card", "aria-label": "Battery" }, el("h2", {}, "Battery"), this.batteryText, this.batteryBar, this.battery.element);
    const tag = el("section", { class: "card", "aria-label": "Tag", "aria-live": "polite" }, el("h2", {}, "Tag"), this.tagTitle, this.tagFacts.element);
    const progress = el("section", { class: "card", "aria-label": "Progress" }, this.progressTitle, this.big, this.bar, this.facts.element);
    const wires = (this.wiresCard = el("section", { class: "card", "aria-label": "Wires" }, el("h2", {}, "Errors on the wires"), this.wiresWord, this.wires.element));
    const events = el("section", { class: "card", "aria-label": "Events" }, el("h2", {}, "Events"), this.list, this.listCount);
    this.element.append(progress, ...this.charts.slice(0, 2).map((chart) => chart.element), tag, events, this.batteryCard, ...this.charts.slice(2).map((chart) => chart.element), wires);
  }

  recolour(): void {
    this.charts.forEach((chart) => chart.forget());
  }

  show(robot: Robot, theme: Theme): void {
    if (robot !== this.shownRobot) {
      this.shownRobot = robot;
      this.run += 1;
      this.newestShown = -1;
      this.list.replaceChildren();
    }
    this.showProgress(robot);
    this.showBattery(robot);
    this.showWires(robot);
    this.showEvents(robot);
    for (const chart of this.charts) {
      chart.show(this.run, robot.samples(chart.kind.series), theme);
    }
  }

  showTag(target: Target | null): void {
    setText(this.tagTitle, target ? target.title : "Point at a tag, or step through them with the buttons on the plan.");
    this.tagTitle.classList.toggle("soft", !target);
    this.tagFacts.show(target ? target.facts : []);
  }

  private showProgress(robot: Robot): void {
    const { status, card } = robot;
    const facts: [string, string][] = [];
    const add = (name: string, value: string | null) => {
      if (value !== null) {
        facts.push([name, value]);
      }
    };
    const count = (name: string, key: string) => add(name, number(status, key)?.toString() ?? null);
    this.bar.hidden = true;
    if (Object.keys(status).length === 0) {
      setText(this.big, robot.ended ? "Ended before it began" : card.source === "sensobot run" ? "Waiting for its devices" : "Nothing heard yet");
    } else if (card.mission === "map") {
      const total = robot.total ?? 0;
      setText(this.big, total > 0 ? `${robot.tilesFound} of ${total} tiles` : `${robot.tilesFound} tiles`);
      this.bar.hidden = total === 0;
      this.bar.value = total > 0 ? robot.tilesFound / total : 0;
      count("Tags written", "written");
      count("Tags driven over", "visits");
      count("Tiles given up", "given_up");
      count("Bumps", "bumps");
      const metres = number(status, "metres");
      add("Driven", metres === null ? null : `${metres.toFixed(1)} m`);
    } else if (card.mission === "hallway") {
      const way = robot.way;
      const arrived = status["arrived"] === true;
      setText(this.big, arrived ? (card.goal !== "" ? `At the goal, ${card.goal}` : "The map is whole") : way && way.place !== "" ? `${way.to !== undefined ? "Left" : "At"} ${way.place}` : "Looking for the first place");
      add("Heading for", way?.to ?? null);
      add("Goal", card.goal !== "" ? card.goal : "the whole map");
      add("Places known", robot.places.size.toString());
      add("In this hallway", way ? `${way.way_m.toFixed(1)} m` : null);
    } else if (card.mission === "phase") {
      const leg = number(status, "leg") ?? 0;
      const legs = number(status, "legs") ?? 0;
      setText(this.big, status["to"] ? `To ${String(status["to"])}` : `All ${legs} destinations`);
      add("Destination", `${Math.min(leg + 1, legs)} of ${legs}`);
      count("Tag reads", "reads");
      add("Pose shown", status["estimated"] === true ? "estimated from the tags" : "by the wheels alone");
    } else {
      setText(this.big, `Base ${String(status["mode"] ?? "?")}`);
      const rtf = number(status, "rtf");
      add("Real-time factor", rtf === null ? null : rtf.toFixed(2));
    }
    add("Robot's clock", clock(robot.now));
    this.facts.show(facts);
  }

  private showBattery(robot: Robot): void {
    const percent = robot.samples("battery").at(-1)?.v;
    this.batteryCard.hidden = percent === undefined;
    if (percent === undefined) {
      return;
    }
    setText(this.batteryText, `${percent.toFixed(0)} %${percent < 20 ? ", low" : ""}`);
    this.batteryBar.value = percent;
    const { base } = robot;
    const facts: [string, string][] = [];
    const volt = number(base, "battery_v");
    const ampere = number(base, "battery_a");
    if (volt !== null && ampere !== null) {
      facts.push(["Voltage", `${volt.toFixed(2)} V`], ["Current", `${ampere.toFixed(2)} A`]);
    }
    if (typeof base["mode"] === "string" && base["mode"] !== "") {
      facts.push(["Base mode", base["mode"]]);
    }
    if (base["wheel_drop"] === true) {
      facts.push(["Wheels", "a wheel hangs in the air"]);
    }
    this.battery.show(facts);
  }

  private showWires(robot: Robot): void {
    const names: [string, string][] = [
      ["frames_corrupt", "Base: frames corrupt"],
      ["frames_missed", "Base: frames missed"],
      ["card_failed", "Card readers: exchanges failed"],
      ["compass_corrupt", "Compass: sentences corrupt"],
    ];
    const gone = [...robot.gone].map(([device, why]): [string, string] => [`${capital(device)} is gone`, why]);
    const counts = names.flatMap(([key, name]): [string, string][] => {
      const value = number(robot.status, key);
      return value === null ? [] : [[name, value.toString()]];
    });
    const wrong = names.reduce((sum, [key]) => sum + (number(robot.status, key) ?? 0), 0);
    const troubles = [...robot.events.values()].filter((event) => severityOf(event) === "bad").length;
    const facts = [...gone, ...counts];
    const word = facts.length === 0 ? "Nothing known yet" : wrong + troubles === 0 ? "None so far" : `${counted(wrong, "error")}, ${counted(troubles, "serious event")}`;
    this.wiresCard.hidden = robot.card.mission === "serve";
    setText(this.wiresWord, word);
    this.wiresWord.classList.toggle("bad", gone.length > 0);
    this.wires.show(facts);
  }

  private showEvents(robot: Robot): void {
    const events = robot.eventsInOrder;
    const newest = events.at(-1)?.n ?? -1;
    if (newest === this.newestShown && newest >= 0) {
      return;
    }
    const fresh = events.filter((event) => event.n > this.newestShown).slice(-linesShown);
    this.newestShown = newest;
    const lines = fresh.reverse().map((event) => {
      const severity = severityOf(event);
      return el("li", { class: severity }, el("span", { class: "mark", "aria-hidden": "true" }, markOf(severity)), el("span", { class: "when figures" }, clock(event.t)), el("span", { class: "what" }, sentence(event), el("span", { class: "why" }, reason(event))));
    });
    this.list.prepend(...lines);
    while (this.list.childElementCount > linesShown) {
      this.list.lastElementChild?.remove();
    }
    setText(this.listCount, `${counted(newest + 1, "event")}${newest + 1 > linesShown ? `, the last ${linesShown} are shown` : ""}`);
  }
}

/** What is happening, in two words, for the head of the page. */
export function stateWords(robot: Robot | null, connection: Connection): { text: string; kind: string } {
  if (connection === "refused") {
    return { text: "Another run: open the address that it printed", kind: "bad" };
  }
  if (robot?.ended) {
    const away = connection === "lost" ? ", waiting for the next" : robot.linked ? "" : ", not reached any more";
    return { text: `Run ended${outcomeWords(robot)}${away}`, kind: robot.ended.outcome === "done" ? "good" : "warn" };
  }
  if (connection === "live" && robot && !robot.linked) {
    return { text: "Robot not reached, trying again", kind: "bad" };
  }
  if (connection === "lost") {
    return { text: "Connection lost, trying again", kind: "bad" };
  }
  if (connection !== "live" || !robot) {
    return { text: "Connecting", kind: "news" };
  }
  const gone = [...robot.gone.keys()];
  const which = gone.length === 1 ? `${gone[0]} is gone` : `${gone.length} devices are gone`;
  return gone.length > 0 ? { text: `Live, but ${which}`, kind: "bad" } : { text: "Live", kind: "good" };
}

function outcomeWords(robot: Robot): string {
  const outcome = robot.ended?.outcome ?? "done";
  return outcome === "done" ? "" : `: ${outcome.replaceAll("_", " ")}`;
}

/** The same of one robot among several, for its button. */
export function briefState(robot: Robot): { text: string; mark: string } {
  if (!robot.linked) {
    return { text: "not reached", mark: markOf("bad") };
  }
  if (robot.ended) {
    const good = robot.ended.outcome === "done";
    return { text: good ? "ended" : robot.ended.outcome.replaceAll("_", " "), mark: markOf(good ? "good" : "warn") };
  }
  return robot.gone.size > 0 ? { text: "a device is gone", mark: markOf("bad") } : { text: "live", mark: markOf("news") };
}
