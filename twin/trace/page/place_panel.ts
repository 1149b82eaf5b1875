// SPDX-License-Identifier: MIT
// The data structure of a node as the paper's Figure 5(b) prints it: the neighbour on each side, and the tags met on
// coming from there. And the list of all places, for those who do not see or point at the drawing.
import { el } from "../../../robot/telemetry/pages/common/dom";
import type { Editor } from "./editor";
import { button, textField } from "./forms";
import {
  addPlace,
  clearSide,
  connect,
  freeTag,
  kindOf,
  lengthOf,
  letters,
  metric,
  numberTags,
  opposite,
  placeById,
  placeByName,
  removePlace,
  rename,
  setLength,
  setUnknown,
  sideNames,
  type Letter,
  type Place,
  type Side,
} from "./model";
import { sideDetails } from "./side_details";

function change(editor: Editor, label: string, place: Place, edit: (place: Place) => void): void {
  editor.history.change(label, (draft) => {
    const there = placeById(draft, place.id);
    if (there) {
      edit(there);
    }
  });
}

function neighbourField(editor: Editor, place: Place, letter: Letter): HTMLElement {
  const side = place.sides[letter];
  const value = !side ? "-" : side.to === null ? "?" : String(side.to);
  const free = editor.doc.places.filter(
    (other) => other.id !== place.id && (other.sides[opposite(letter)]?.to ?? place.id) === place.id,
  );
  const field = el(
    "select",
    { "data-key": `to ${letter}`, "aria-label": `${sideNames[letter]} leads to` },
    el("option", { value: "-", selected: value === "-" }, "–  none"),
    el("option", { value: "?", selected: value === "?" }, "?  unknown"),
    ...free.map((other) =>
      el("option", { value: String(other.id), selected: value === String(other.id) }, other.name),
    ),
  );
  field.addEventListener("change", () => {
    editor.history.change("neighbour", (draft) => {
      const there = placeById(draft, place.id);
      const other = placeById(draft, Number(field.value));
      if (there && field.value === "-") {
        clearSide(draft, there, letter);
      } else if (there && field.value === "?") {
        setUnknown(draft, there, letter);
      } else if (there && other) {
        connect(draft, there, letter, other);
      }
    });
  });
  return field;
}

function lengthField(editor: Editor, place: Place, letter: Letter, side: Side): HTMLElement {
  const length = lengthOf(editor.doc, place, side);
  const drawn = side.length === "drawn";
  const field = el("input", {
    type: "text",
    inputmode: "decimal",
    "data-key": `length ${letter}`,
    "aria-label": `length ${sideNames[letter]}, m`,
    value: drawn ? "" : length === null ? "?" : String(length),
    placeholder: drawn && length !== null ? length.toFixed(2) : "?",
    title: "Metres from middle to middle. Empty: as drawn. ?: not known.",
    class: "figures short",
  });
  field.addEventListener("change", () => {
    const text = field.value.trim().replace(",", ".");
    const value = Number(text);
    const asked = text === "" ? "drawn" : text === "?" ? "unknown" : value > 0 ? value : null;
    field.setAttribute("aria-invalid", String(asked === null));
    if (asked !== null) {
      editor.history.change("length", (draft) => {
        const there = placeById(draft, place.id);
        if (there) {
          setLength(draft, there, letter, asked);
        }
      });
    }
  });
  return field;
}

function tagsField(editor: Editor, place: Place, letter: Letter, side: Side): HTMLElement {
  const field = el("input", {
    type: "text",
    "data-key": `tags ${letter}`,
    "aria-label": `tags met on coming from the ${sideNames[letter]}`,
    value: side.tags.join(", "),
    placeholder: `e.g. ${freeTag(editor.doc)}`,
    autocomplete: "off",
    spellcheck: "false",
    class: "figures",
    title: "Numbers, or unique numbers of 16 hexadecimal digits; several with commas",
  });
  field.addEventListener("change", () => {
    const tags = field.value.split(/[\s,;]+/).filter((tag) => tag !== "");
    change(editor, "tags", place, (there) => {
      const end = there.sides[letter];
      if (end) {
        end.tags = tags;
      }
    });
  });
  field.addEventListener("keydown", (event) => {
    if (event.key === "Enter") {
      field.blur();
      focusNextTags(place, letter);
    }
  });
  return field;
}
/** Enter goes from side to side, as the numbers are read off a list. */
function focusNextTags(place: Place, letter: Letter): void {
  const open = letters.filter((each) => place.sides[each]);
  const next = open[(open.indexOf(letter) + 1) % open.length];
  document.querySelector<HTMLInputElement>(`[data-key="tags ${next ?? letter}"]`)?.focus();
}

function sidesTable(editor: Editor, place: Place): HTMLElement {
  const rows = letters.map((letter) => {
    const side = place.sides[letter];
    return el(
      "tr",
      {},
      el("th", { scope: "row" }, letter),
      el("td", {}, neighbourField(editor, place, letter)),
      el(
        "td",
        {},
        side && side.to !== null ? lengthField(editor, place, letter, side) : el("span", { class: "soft" }, "–"),
      ),
      el("td", {}, side ? tagsField(editor, place, letter, side) : el("span", { class: "soft" }, "–")),
    );
  });
  return el(
    "table",
    { class: "sides" },
    el("caption", { class: "visually-hidden" }, `Sides of ${place.name}`),
    el(
      "thead",
      {},
      el(
        "tr",
        {},
        ...["Side", "Leads to", "Length, m", "Tags coming in"].map((head) => el("th", { scope: "col" }, head)),
      ),
    ),
    el("tbody", {}, ...rows),
  );
}

function placeForm(editor: Editor, place: Place): Node[] {
  const unit = metric(editor.doc) ? "m" : "no scale yet";
  return [
    el(
      "h2",
      { class: "title" },
      `${kindOf(place)} ${place.name}`,
      el("span", { class: "soft figures at" }, ` ${place.at.x.toFixed(2)}, ${place.at.y.toFixed(2)} ${unit}`),
    ),
    textField({ key: "name", label: "Name", value: place.name }, (name) => {
      if (name !== "" && name !== place.name) {
        editor.history.change("name", (draft) => {
          const there = placeById(draft, place.id);
          if (there) {
            rename(draft, there, name);
          }
        });
      }
    }),
    sidesTable(editor, place),
    ...sideDetails(editor, place),
    el(
      "div",
      { class: "row" },
      button("Remove place", () =>
        editor.history.change("erase", (draft) => {
          const there = placeById(draft, place.id);
          if (there) {
            removePlace(draft, there);
          }
        }),
      ),
    ),
  ];
}

function placeList(editor: Editor): Node[] {
  const items = editor.doc.places.map((place) => {
    const says = letters.map((letter) => {
      const side = place.sides[letter];
      const to = side?.to == null ? undefined : placeById(editor.doc, side.to);
      return el(
        "span",
        { class: "neighbour" },
        el("span", { class: "soft" }, `${letter} `),
        !side ? "–" : to ? to.name : "?",
      );
    });
    const chosen = editor.selectedPlace?.id === place.id;
    const pick = el(
      "button",
      {
        type: "button",
        class: "item",
        "aria-pressed": String(chosen),
        "data-key": `place ${place.id}`,
        onclick: () => editor.select({ kind: "place", id: place.id }),
      },
      el("b", {}, place.name),
      ...says,
    );
    return el("li", {}, pick);
  });
  return [
    el(
      "div",
      { class: "row spread" },
      el("h2", {}, `Places (${editor.doc.places.length})`),
      el(
        "span",
        { class: "row" },
        button("Add place", () => {
          const id = editor.history.change("place", (draft) => {
            const far = draft.places.reduce((most, place) => Math.max(most, place.at.x), -4);
            return addPlace(draft, { x: far + 4, y: 0 }).id;
          });
          editor.select({ kind: "place", id });
        }),
        button("Number tags", () => {
          const given = editor.history.change("number tags", numberTags);
          editor.say(given === 0 ? "Every side has its tag." : `${given} sides were given a number.`);
        }),
      ),
    ),
    editor.doc.places.length === 0
      ? el("p", { class: "soft" }, "None yet. Take the Hallway tool (H) and drag along a hallway of the plan.")
      : el("ul", { class: "list" }, ...items),
  ];
}

export function placePanel(editor: Editor): Node[] {
  const place = editor.selectedPlace;
  return [...(place ? placeForm(editor, place) : []), ...placeList(editor)];
}

/** The tag numbers of a side are to be typed now. */
export function focusTags(letter: Letter): void {
  const field = document.querySelector<HTMLInputElement>(`[data-key="tags ${letter}"]`);
  field?.focus();
  field?.select();
}
export function selectByName(editor: Editor, name: string): void {
  const place = placeByName(editor.doc, name);
  if (place) {
    editor.select({ kind: "place", id: place.id });
  }
}
