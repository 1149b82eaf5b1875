// SPDX-License-Identifier: MIT
// What a scene adds to the drawing: mission, walls, start, carpet or ceiling tags, and what the twin says of it.
import { el } from "../../../robot/telemetry/pages/common/dom";
import type { Editor } from "./editor";
import { button, checkField, choiceField, numberField, textField } from "./forms";
import type { Doc, Scene } from "./model";

const kinds = [
  ["hallway", "Hallways: from place to place"],
  ["carpet", "Carpet: map the tiles"],
  ["ceiling", "Ceiling tags: by phase difference"],
] as const;
const explorers = ["sweep", "idfm", "dfm", "bfm", "bfm_out_and_back", "bfm_all_neighbours", "spiral"].map(
  (name) => [name, name] as const,
);

export function scenePanel(editor: Editor, saveScene: () => void): Node[] {
  const scene = editor.doc.scene;
  const set = (label: string, edit: (scene: Scene, draft: Doc) => void) =>
    editor.history.change(label, (draft) => edit(draft.scene, draft));
  const walls: [string, string][] = [
    ...(editor.doc.places.length > 0 ? [["hallways", "Both sides of every hallway drawn"] as [string, string]] : []),
    ...(editor.doc.plan ? [["plan", "What is dark on the plan"] as [string, string]] : []),
    ["room", scene.room.length > 2 ? "The room drawn" : "A room, drawn with the Room tool (O)"],
  ];
  if (!walls.some(([value]) => value === scene.walls)) {
    walls.unshift([scene.walls, "– choose –"]);
  }
  const start = scene.start;
  const names = editor.doc.places.map((place) => [place.name, place.name] as const);
  return [
    choiceField({ key: "kind", label: "Mission", value: scene.kind, choices: kinds }, (kind) =>
      set("mission", (s) => (s.kind = kind as Scene["kind"])),
    ),
    textField(
      { key: "title", label: "What it shows, in a sentence", value: scene.title, placeholder: "Traced" },
      (title) => set("title", (s) => (s.title = title)),
    ),
    el(
      "div",
      { class: "pair" },
      choiceField({ key: "walls", label: "Walls", value: scene.walls, choices: walls }, (value) =>
        set("walls", (s) => (s.walls = value as Scene["walls"])),
      ),
      numberField({ key: "seed", label: "Seed", value: scene.seed, min: 0, max: 4294967295, step: 1 }, (seed) =>
        set("seed", (s) => (s.seed = Math.floor(seed))),
      ),
    ),
    ...(scene.kind === "hallway"
      ? hallwayFields(scene, names, set)
      : scene.kind === "carpet"
        ? carpetFields(scene, set)
        : ceilingFields(scene, set)),
    el(
      "p",
      { class: "soft" },
      start
        ? `Starts at ${start.x.toFixed(2)}, ${start.y.toFixed(2)} m, heading ${start.heading_deg}°. `
        : scene.kind === "ceiling"
          ? "Press with the Start tool (P) where the robot starts. "
          : "Starts where the twin finds room; or press with the Start tool (P). ",
      ...(start ? [button("Remove start", () => set("start", (s) => (s.start = null)))] : []),
    ),
    ...sceneVerdict(editor),
    el("div", { class: "row" }, button("Save scene", saveScene, { class: "primary" })),
    el("p", { class: "soft note" }, "Runs with ", el("code", {}, `twin run ${editor.naming.name}.scene.yaml`)),
  ];
}
type Set = (label: string, edit: (scene: Scene, draft: Doc) => void) => void;

function hallwayFields(scene: Scene, names: (readonly [string, string])[], set: Set): Node[] {
  const choices = [["", "–"] as const, ...names];
  return [
    checkField({ key: "survey", label: "Survey: draw the map from one tag", value: scene.survey }, (survey) =>
      set("survey", (s) => (s.survey = survey)),
    ),
    ...(scene.survey
      ? []
      : [
          el(
            "div",
            { class: "pair" },
            choiceField({ key: "scene from", label: "From", value: scene.from, choices }, (from) =>
              set("from", (s) => (s.from = from)),
            ),
            choiceField({ key: "scene to", label: "To", value: scene.to, choices }, (to) =>
              set("to", (s) => (s.to = to)),
            ),
          ),
        ]),
  ];
}
function carpetFields(scene: Scene, set: Set): Node[] {
  return [
    el(
      "div",
      { class: "pair" },
      numberField({ key: "tile", label: "Tile, m", value: scene.tile_m, min: 0.1, max: 5 }, (tile) =>
        set("tile", (s) => {
          s.tile_m = tile;
          s.without = [];
          s.unreadable = [];
        }),
      ),
      choiceField({ key: "explorer", label: "Explorer", value: scene.explorer, choices: explorers }, (explorer) =>
        set("explorer", (s) => (s.explorer = explorer)),
      ),
    ),
  ];
}
function ceilingFields(scene: Scene, set: Set): Node[] {
  const rows = scene.ceiling.map((tag, i) =>
    el(
      "tr",
      {},
      el(
        "td",
        {},
        textField(
          { key: `ceiling name ${i}`, label: `Name of tag ${i + 1}`, hidden: true, value: tag.name },
          (name) =>
            set("tag name", (s) => {
              (s.ceiling[i] as typeof tag).name = name;
            }),
        ),
      ),
      ...(["x", "y"] as const).map((axis) =>
        el(
          "td",
          {},
          numberField(
            {
              key: `ceiling ${axis} ${i}`,
              label: `${axis} of ${tag.name}, m`,
              hidden: true,
              value: tag.at[axis],
              min: -1000,
              max: 1000,
            },
            (value) =>
              set("tag", (s) => {
                (s.ceiling[i] as typeof tag).at[axis] = value;
              }),
          ),
        ),
      ),
      el(
        "td",
        {},
        numberField(
          {
            key: `ceiling height ${i}`,
            label: `Height of ${tag.name}, m`,
            hidden: true,
            value: tag.height_m,
            min: 0.2,
            max: 100,
          },
          (value) =>
            set("tag height", (s) => {
              (s.ceiling[i] as typeof tag).height_m = value;
            }),
        ),
      ),
      el(
        "td",
        {},
        button("×", () => set("erase", (s) => s.ceiling.splice(i, 1)), {
          "aria-label": `Remove tag ${tag.name}`,
          "data-key": `remove ceiling ${i}`,
        }),
      ),
    ),
  );
  return [
    el(
      "div",
      { class: "pair" },
      choiceField(
        {
          key: "controller",
          label: "Controller",
          value: scene.controller,
          choices: [
            ["own", "own estimator"],
            ["fuzzy", "the paper's fuzzy"],
          ],
        },
        (value) => set("controller", (s) => (s.controller = value as Scene["controller"])),
      ),
      choiceField(
        {
          key: "radio",
          label: "Reader",
          value: scene.radio,
          choices: [
            ["paper", "the paper's"],
            ["impinj_r420", "Impinj R420"],
          ],
        },
        (value) => set("radio", (s) => (s.radio = value as Scene["radio"])),
      ),
    ),
    scene.ceiling.length === 0
      ? el("p", { class: "soft" }, "No tags yet: click with the Ceiling tag tool (L).")
      : el(
          "table",
          { class: "sides ceiling" },
          el(
            "thead",
            {},
            el(
              "tr",
              {},
              ...["Tag", "x, m", "y, m", "Height, m"].map((head) => el("th", { scope: "col" }, head)),
              el("td", {}),
            ),
          ),
          el("tbody", {}, ...rows),
        ),
    button("Add ceiling tag", () =>
      set("ceiling tag", (s) => {
        const last = s.ceiling.at(-1);
        s.ceiling.push({
          name: `T${s.ceiling.length + 1}`,
          at: { x: (last?.at.x ?? -2) + 2, y: last?.at.y ?? 0 },
          height_m: last?.height_m ?? 3,
        });
      }),
    ),
  ];
}
function sceneVerdict(editor: Editor): Node[] {
  if (editor.scene?.sound) {
    const tiles = editor.doc.scene.kind === "carpet" ? ` ${editor.scene.tile_count} tiles.` : "";
    return [el("p", { class: "good", role: "status" }, `✓ The twin takes this scene.${tiles}`)];
  }
  return [
    el(
      "p",
      { class: "bad", role: "status" },
      editor.sceneProblems.length > 0 ? "The twin does not take this scene yet:" : "…",
    ),
    el(
      "ul",
      { class: "list" },
      ...editor.sceneProblems.map((problem) =>
        el(
          "li",
          { class: "bad problem" },
          `${problem.path ? `${problem.path}: ` : ""}${problem.what}${problem.hint ? `; ${problem.hint}` : ""}`,
        ),
      ),
    ),
  ];
}
