// SPDX-License-Identifier: MIT
// What is on the desk: the document, what is selected, what the server said of it. Knows the view, no buttons.
import type { PlanView, Point } from "../../../robot/telemetry/pages/common/plan_view";
import * as api from "./api";
import { apart_deg, drawn_deg, shown_deg } from "./bearing";
import { docJson, type FileProblem } from "./files";
import { History } from "./history";
import {
  distance,
  emptyDoc,
  hallways,
  letters,
  metric,
  placeById,
  placeByName,
  step,
  type Doc,
  type Letter,
  type Place,
} from "./model";

export type Selection =
  | { kind: "place"; id: number }
  | { kind: "hallway"; id: number; letter: Letter }
  | { kind: "ceiling"; index: number }
  | null;

/** Chosen: shorter than between two strokes, longer than between two keys. */
const checkAfter_ms = 250;
const sceneAfter_ms = 600;

export class Editor {
  readonly history = new History(emptyDoc());
  view: PlanView | null = null;
  selection: Selection = null;
  problems: FileProblem[] = [];
  sceneProblems: FileProblem[] = [];
  fileText = "";
  route: api.RouteAnswer | null = null;
  routeFrom = "";
  routeTo = "";
  blocked: [string, Letter][] = [];
  scene: api.SceneAnswer | null = null;
  /** Whether the scene is being worked on: only then is it tried. */
  sceneShown = false;
  naming: api.Naming = { name: "plan", hallways_file: "plan.hallways.yaml" };
  stamps: Record<string, string> = {};
  /** Questions that the server has not answered yet; the first is what there is to open. */
  private waiting = 1;
  private readonly listeners: (() => void)[] = [];
  private checkTimer = 0;
  private sceneTimer = 0;

  constructor(readonly say: (text: string, level?: "info" | "bad") => void) {
    this.history.onChange(() => {
      this.dropDeadSelection();
      this.soonCheck();
      this.changed();
    });
  }

  get doc(): Doc {
    return this.history.doc;
  }
  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }
  changed(): void {
    for (const listener of this.listeners) {
      listener();
    }
    this.view?.redraw();
  }
  select(selection: Selection): void {
    this.selection = selection;
    this.changed();
  }
  /** What was asked about another drawing. */
  forget(): void {
    this.selection = null;
    this.route = null;
    this.routeFrom = "";
    this.routeTo = "";
    this.blocked = [];
    this.scene = null;
  }
  get selectedPlace(): Place | null {
    const chosen = this.selection;
    return chosen && chosen.kind !== "ceiling" ? (placeById(this.doc, chosen.id) ?? null) : null;
  }

  /** Everything said by the server is about the document as it was asked. */
  soonCheck(): void {
    this.checkTimer = this.later(this.checkTimer, checkAfter_ms, () => this.check());
    if (this.sceneShown) {
      this.sceneTimer = this.later(this.sceneTimer, sceneAfter_ms, () => this.tryScene());
    }
  }
  /** Whether what is shown of the checks may be out of date. */
  get busy(): boolean {
    return this.waiting > 0;
  }
  /** What there is to open has been opened. */
  begun(): void {
    this.waiting -= 1;
    this.changed();
  }
  private later(timer: number, after_ms: number, ask: () => Promise<void>): number {
    window.clearTimeout(timer);
    this.waiting += timer === 0 ? 1 : 0;
    const now = window.setTimeout(() => {
      // From here on a further change asks anew, and this answer is one too many at most.
      if (now === this.checkTimer) {
        this.checkTimer = 0;
      } else {
        this.sceneTimer = 0;
      }
      void ask().finally(() => {
        this.waiting -= 1;
        this.changed();
      });
    }, after_ms);
    return now;
  }
  async check(): Promise<void> {
    const asked = this.doc;
    try {
      const answer = await api.check(docJson(asked));
      if (asked === this.doc) {
        this.problems = answer.problems;
        this.fileText = answer.text;
        await this.planRoute();
        this.changed();
      }
    } catch (error) {
      this.say(String((error as Error).message), "bad");
    }
  }
  async planRoute(): Promise<void> {
    if (!this.routeFrom || !this.routeTo) {
      this.route = null;
      return;
    }
    try {
      this.route = await api.route(docJson(this.doc), this.routeFrom, this.routeTo, this.blocked);
    } catch (error) {
      this.route = { found: false, reason: (error as Error).message };
    }
  }
  async tryScene(): Promise<void> {
    const asked = this.doc;
    try {
      const answer = await api.scene(docJson(asked), this.naming);
      if (asked === this.doc) {
        this.scene = answer;
        this.sceneProblems = answer.problems;
      }
    } catch (error) {
      this.scene = null;
      const what = (error as Error).message;
      this.sceneProblems = [{ level: "error", place: "", side: "", path: "", what, hint: "" }];
    }
    this.changed();
  }

  /** The place nearest to a point, within so many CSS pixels. */
  placeAt(at: Point, slop_px = 18): Place | null {
    const reach = slop_px / (this.view?.scale ?? 50);
    let best: Place | null = null;
    for (const place of this.doc.places) {
      if (distance(place.at, at) <= reach && (!best || distance(place.at, at) < distance(best.at, at))) {
        best = place;
      }
    }
    return best;
  }
  /** The hallway under a point. */
  hallwayAt(at: Point, slop_px = 9): { a: Place; b: Place; letter: Letter; on: Point } | null {
    const reach = slop_px / (this.view?.scale ?? 50);
    for (const { a, b, letter } of hallways(this.doc)) {
      const on = nearestOn(a.at, b.at, at);
      if (distance(on, at) <= reach) {
        return { a, b, letter, on };
      }
    }
    return null;
  }
  /** The side of a place that a point lies on: nearest place, then direction. */
  sideAt(at: Point): { place: Place; letter: Letter } | null {
    const place = this.placeAt(at, 90);
    if (!place) {
      return null;
    }
    const towards = drawn_deg(place.at, at);
    const off = (letter: Letter) => apart_deg(shown_deg(this.doc, place, letter), towards);
    return { place, letter: letters.reduce((best, letter) => (off(letter) < off(best) ? letter : best)) };
  }
  worstOf(name: string): "error" | "advice" | null {
    const found = this.problems.filter((problem) => problem.place === name);
    return found.some((problem) => problem.level === "error") ? "error" : found.length > 0 ? "advice" : null;
  }
  isBlocked(a: Place, letter: Letter, b: Place): boolean {
    return this.blocked.some(
      ([name, side]) =>
        (name === a.name && side === letter) ||
        (name === b.name && step[side].x === -step[letter].x && step[side].y === -step[letter].y),
    );
  }
  metres(value: number): string {
    return metric(this.doc) ? `${value.toFixed(2)} m` : `${value.toFixed(2)} ?`;
  }

  private dropDeadSelection(): void {
    const chosen = this.selection;
    const dead =
      (chosen?.kind === "place" && !placeById(this.doc, chosen.id)) ||
      (chosen?.kind === "hallway" && !placeById(this.doc, chosen.id)?.sides[chosen.letter]) ||
      (chosen?.kind === "ceiling" && chosen.index >= this.doc.scene.ceiling.length);
    if (dead) {
      this.selection = null;
    }
    this.blocked = this.blocked.filter(([name, letter]) => placeByName(this.doc, name)?.sides[letter]);
  }
}

export function nearestOn(a: Point, b: Point, p: Point): Point {
  const way = { x: b.x - a.x, y: b.y - a.y };
  const square = way.x ** 2 + way.y ** 2;
  const t = square === 0 ? 0 : Math.min(1, Math.max(0, ((p.x - a.x) * way.x + (p.y - a.y) * way.y) / square));
  return { x: a.x + t * way.x, y: a.y + t * way.y };
}
