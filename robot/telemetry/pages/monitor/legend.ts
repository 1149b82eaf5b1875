// SPDX-License-Identifier: MIT
// What the marks of the plan mean; only those that this kind of mission can have.
import { el } from "../common/dom";
import type { Robot } from "./model";

const svg = "http://www.w3.org/2000/svg";

function swatch(...shapes: [string, Record<string, string>][]): Element {
  const made = document.createElementNS(svg, "svg");
  made.setAttribute("viewBox", "0 0 24 24");
  made.setAttribute("aria-hidden", "true");
  for (const [name, attributes] of shapes) {
    const shape = document.createElementNS(svg, name);
    for (const [key, value] of Object.entries(attributes)) {
      shape.setAttribute(key, value);
    }
    made.append(shape);
  }
  return made;
}

const tile = (kind: string): [string, Record<string, string>] => ["rect", { x: "2", y: "2", width: "20", height: "20", class: kind }];
const line = (kind: string, y = "12"): [string, Record<string, string>] => ["line", { x1: "2", y1: y, x2: "22", y2: y, class: kind }];
const rhombus = (kind: string): [string, Record<string, string>] => ["path", { d: "M12 3 L21 12 L12 21 L3 12 Z", class: kind }];

interface Row {
  words: string;
  mark: Element;
  /** Of this robot; `others`: whether some are in the same room. */
  shown: (robot: Robot, withRoom: boolean, others: boolean) => boolean;
}

const ofMap = (robot: Robot) => robot.card.mission === "map";
const rows: Row[] = [
  { words: "Tile visited, a neighbour open; ring: tag not written yet", mark: swatch(tile("open"), ["circle", { cx: "12", cy: "12", r: "3", class: "ring" }]), shown: ofMap },
  { words: "Tile visited, closed; dot: tag holds its coordinates", mark: swatch(tile("closed"), ["circle", { cx: "12", cy: "12", r: "3", class: "dot" }]), shown: ofMap },
  { words: "Tile given up", mark: swatch(tile("given-up"), ["path", { d: "M8 8 L16 16 M16 8 L8 16", class: "cross" }]), shown: ofMap },
  { words: "Side that the robot found blocked", mark: swatch(line("felt")), shown: ofMap },
  { words: "Hallway; dashed with ?: its end is unknown", mark: swatch(line("hall", "8"), line("unknown", "16")), shown: (robot) => robot.card.mission === "hallway" },
  { words: "Hallway on the way now", mark: swatch(line("route")), shown: (robot) => robot.card.mission === "hallway" },
  { words: "Ceiling tag, estimated, with two sigma", mark: swatch(["ellipse", { cx: "12", cy: "12", rx: "11", ry: "7", class: "sigma" }], ["path", { d: "M12 8 L16 12 L12 16 L8 12 Z", class: "estimate" }]), shown: (robot) => robot.card.mission === "phase" },
  { words: "Landmark tag, where it was read", mark: swatch(rhombus("landmark")), shown: ofMap },
  { words: "Furniture tag, where it was read", mark: swatch(rhombus("tag")), shown: (robot) => [...robot.objects.values()].some((object) => object.event === "furniture_seen") },
  { words: "Robot, as it believes", mark: swatch(["circle", { cx: "12", cy: "12", r: "9", class: "robot" }], ["path", { d: "M10 8 L19 12 L10 16 Z", class: "nose" }]), shown: (robot) => robot.card.mission !== "serve" },
  { words: "Another robot of this room", mark: swatch(["circle", { cx: "12", cy: "12", r: "9", class: "other" }], ["path", { d: "M10 8 L19 12 L10 16 Z", class: "nose" }]), shown: (_robot, _withRoom, others) => others },
  { words: "Robot's way, as it believes", mark: swatch(line("trail")), shown: (robot) => robot.card.mission === "map" || robot.card.mission === "phase" },
  { words: "Robot in truth (twin only)", mark: swatch(["circle", { cx: "12", cy: "12", r: "9", class: "truth" }]), shown: (robot, withRoom) => withRoom && robot.truth !== null },
  { words: "Its true way (twin only)", mark: swatch(line("true-way")), shown: (robot, withRoom) => withRoom && robot.trueTrail.size > 0 },
  { words: "Person (twin only)", mark: swatch(["circle", { cx: "12", cy: "12", r: "8", class: "person" }]), shown: (robot, withRoom) => withRoom && robot.people.length > 0 },
  { words: "True room (twin only)", mark: swatch(["rect", { x: "3", y: "6", width: "18", height: "12", class: "room" }]), shown: (robot, withRoom) => withRoom && robot.scene !== null },
  { words: "Ideal path, true ceiling tags (twin only)", mark: swatch(line("ideal", "16"), ["rect", { x: "8", y: "3", width: "8", height: "8", class: "true-tag" }]), shown: (robot, withRoom) => withRoom && (robot.scene?.ceiling.length ?? 0) > 0 },
];

export function legend(): { element: HTMLElement; show: (robot: Robot, withRoom: boolean, others: boolean) => void } {
  const items = rows.map((row) => ({ row, item: el("li", {}, row.mark as HTMLElement, el("span", {}, row.words)) }));
  const element = el("section", { class: "legend-strip", "aria-label": "Legend" }, el("h2", {}, "Legend"), el("ul", { class: "legend" }, ...items.map(({ item }) => item)));
  return {
    element,
    show: (robot, withRoom, others) => {
      for (const { row, item } of items) {
        item.hidden = !row.shown(robot, withRoom, others);
      }
    },
  };
}
