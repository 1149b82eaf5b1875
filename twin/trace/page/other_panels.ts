// SPDX-License-Identifier: MIT
// Plan, route and problems in the side panel.
import { el } from "../../../robot/telemetry/pages/common/dom";
import type { Editor } from "./editor";
import type { FileProblem } from "./files";
import { button, checkField, choiceField, numberField, textField } from "./forms";
import { metric } from "./model";
import { turnBy } from "./placement";
import { selectByName } from "./place_panel";

export interface PlanActions {
  setResolution(metresPerPixel: number): void;
  setOpacity(opacity: number): void;
  opacity: number;
}

export function planPanel(editor: Editor, actions: PlanActions): Node[] {
  const { plan, settings } = editor.doc;
  const setting = (
    key: "north_deg" | "width_m" | "tag_to_middle_m" | "tag_reach_m",
    label: string,
    min: number,
    max: number,
  ) =>
    numberField({ key, label, value: settings[key], min, max }, (value) =>
      editor.history.change(label.toLowerCase(), (draft) => {
        draft.settings[key] = value;
      }),
    );
  const picture = plan
    ? [
        el(
          "p",
          {},
          el("b", {}, plan.name),
          el("span", { class: "soft figures" }, ` ${plan.width_px} × ${plan.height_px} pixels`),
        ),
        numberField(
          {
            key: "resolution",
            label: "Metres a pixel",
            value: Number(plan.resolution_m.toPrecision(6)),
            min: 0.0001,
            max: 10,
            note: plan.scaled ? "" : "Not set yet: draw a line with the Scale tool (S), or type it here.",
          },
          actions.setResolution,
        ),
        numberField(
          {
            key: "opacity",
            label: "Picture shows through, %",
            value: Math.round(actions.opacity * 100),
            min: 10,
            max: 100,
          },
          (percent) => actions.setOpacity(percent / 100),
        ),
        checkField({ key: "negate", label: "Light is wall, dark is floor", value: plan.negate }, (negate) =>
          editor.history.change("negate", (draft) => {
            if (draft.plan) {
              draft.plan.negate = negate;
            }
          }),
        ),
        numberField(
          {
            key: "free",
            label: "Floor is lighter than, %",
            value: Math.round((1 - plan.free_thresh) * 1000) / 10,
            min: 0,
            max: 100,
          },
          (percent) =>
            editor.history.change("threshold", (draft) => {
              if (draft.plan) {
                draft.plan.free_thresh = Math.min(1 - percent / 100, draft.plan.occupied_thresh);
              }
            }),
        ),
      ]
    : [
        el(
          "p",
          { class: "soft" },
          "No picture: an empty sheet in metres. Open one, or drop a PNG or PGM on the drawing.",
        ),
      ];
  return [
    el("h2", {}, "Picture"),
    ...picture,
    numberField(
      {
        key: "turn",
        label: "Turn the plan, degrees clockwise",
        value: 0,
        min: -360,
        max: 360,
        note: "So that north is up. Or drag the needle with the North tool (N).",
      },
      (deg) => editor.history.change("north", (draft) => turnBy(draft, (-deg * Math.PI) / 180)),
    ),
    el("h2", {}, "Building"),
    setting("width_m", "Hallways are wide, m", 0.5, 10),
    setting("tag_to_middle_m", "From a tag to the middle of its place, m", 0.1, 10),
    setting("tag_reach_m", "A tag is read within, m", 0.01, 2),
    setting("north_deg", "Plan's north from magnetic north, degrees counter-clockwise", -180, 180),
  ];
}

export function routePanel(editor: Editor): Node[] {
  const again = () => void editor.planRoute().then(() => editor.changed());
  const names = editor.doc.places.map((place) => [place.name, place.name] as const);
  const { route } = editor;
  const result: Node[] = [];
  if (route?.found) {
    const cost = route.by_length
      ? `${(route.cost ?? 0).toFixed(1)} m`
      : `${route.cost} hallways (not all lengths are known)`;
    result.push(
      el("p", { class: "cost" }, el("b", { class: "figures" }, cost), ` over ${route.steps?.length ?? 0} hallways`),
      el("p", {}, route.start_words ?? ""),
      el("ol", { class: "steps" }, ...(route.words ?? []).map((words) => el("li", {}, `${words}.`))),
      el("p", { class: "soft" }, route.steps?.length === 0 ? "It is there." : `Arrives at ${editor.routeTo}.`),
    );
  } else if (route) {
    result.push(el("p", { class: "bad" }, route.reason ?? ""));
  } else {
    result.push(
      el(
        "p",
        { class: "soft" },
        "Where does the robot stand – at a place, or over a tag – and where is it to go? Its own planner answers.",
      ),
    );
  }
  return [
    el(
      "div",
      { class: "pair" },
      textField(
        { key: "from", label: "From place or tag", value: editor.routeFrom, placeholder: "c, or tag 12" },
        (value) => {
          editor.routeFrom = value.replace(/^tag\s+/i, "");
          again();
        },
      ),
      choiceField({ key: "to", label: "To", value: editor.routeTo, choices: [["", "–"], ...names] }, (value) => {
        editor.routeTo = value;
        again();
      }),
    ),
    ...(editor.blocked.length > 0
      ? [
          el(
            "p",
            {},
            "Blocked: ",
            ...editor.blocked.map(([name, letter]) =>
              button(`${name} ${letter} ×`, () => {
                editor.blocked = editor.blocked.filter(([n, l]) => n !== name || l !== letter);
                again();
              }),
            ),
          ),
        ]
      : []),
    el("div", { role: "status" }, ...result),
  ];
}

/** What the readers say, worst first; a click selects the culprit. */
export function problemList(editor: Editor): Node[] {
  const all = [...editor.problems].sort((a, b) => Number(b.level === "error") - Number(a.level === "error"));
  const errors = all.filter((problem) => problem.level === "error").length;
  const drawn = editor.doc.places.length > 0;
  const verdict =
    errors > 0
      ? `${errors} ${errors === 1 ? "mistake" : "mistakes"}`
      : all.length > 0
        ? `Sound, ${all.length} to look at`
        : drawn
          ? "Sound"
          : "No hallways drawn";
  return [
    el("h2", {}, "Check"),
    el(
      "p",
      { role: "status", class: errors > 0 ? "bad" : drawn ? "good" : "soft" },
      verdict,
      metric(editor.doc) ? "" : " – no scale yet",
    ),
    el("ul", { class: "list" }, ...all.map((problem) => el("li", {}, problemItem(editor, problem)))),
  ];
}
function problemItem(editor: Editor, problem: FileProblem): Node {
  const where = [problem.place, problem.side].filter((part) => part !== "").join(" ") || problem.path;
  const text = `${problem.what}${problem.hint ? `; ${problem.hint}` : ""}`;
  const mark = el(
    "span",
    { class: problem.level === "error" ? "mark bad" : "mark warn" },
    problem.level === "error" ? "✕" : "!",
  );
  const level = el("span", { class: "visually-hidden" }, problem.level === "error" ? "mistake: " : "advice: ");
  return el(
    "button",
    {
      type: "button",
      class: "item problem",
      "data-key": `problem ${where} ${problem.what}`,
      onclick: () => selectByName(editor, problem.place),
    },
    mark,
    level,
    el("span", {}, el("b", {}, where), ` ${text}`),
  );
}
