// SPDX-License-Identifier: MIT
// How the hallways of a place lie: in which direction each leaves, and how far off its tags are.
import { el } from "../../../robot/telemetry/pages/common/dom";
import {
  apart_deg,
  asBearing,
  bearingIsDrawn,
  compass_deg,
  degrees,
  drawn_deg,
  offPoint_deg,
  setBearing,
  wrapped_deg,
} from "./bearing";
import type { Editor } from "./editor";
import { button } from "./forms";
import { letters, placeById, sideNames, type Doc, type Letter, type Place, type Side } from "./model";

/** The reader's own limits (robot/settings/hallway_file.hpp). */
const tag_m = { least: 0.1, most: 10 };

/** A number, null for an empty field, or what is wrong with it. */
type Read = { value: number | null } | { wrong: string };

function readBearing(text: string, letter: Letter): Read {
  if (text === "") {
    return { value: null };
  }
  const value = Number(text);
  if (!Number.isFinite(value) || value < -180 || value > 360) {
    return { wrong: "A bearing is a number of degrees, clockwise from north: 0 to 360." };
  }
  if (apart_deg(value, compass_deg[letter]) > offPoint_deg) {
    const [low, high] = [compass_deg[letter] - offPoint_deg, compass_deg[letter] + offPoint_deg].map(degrees);
    return { wrong: `The ${sideNames[letter]} side leaves between ${low} and ${high}: beyond that it is another side.` };
  }
  return { value: wrapped_deg(value) };
}
function readTagDistance(text: string): Read {
  const value = Number(text);
  return text === ""
    ? { value: null }
    : value >= tag_m.least && value <= tag_m.most
      ? { value }
      : { wrong: `Tags lie ${tag_m.least} to ${tag_m.most} m from the middle of the place.` };
}

interface Measure {
  key: string;
  label: string;
  value: number | null;
  placeholder: number;
  title: string;
  said: HTMLElement;
  read: (text: string) => Read;
  take: (draft: Doc, value: number | null) => void;
}
/** A field that says what is wrong while it is typed, and takes what is right when it is left. */
function measureField(editor: Editor, measure: Measure): HTMLElement {
  const field = el("input", {
    type: "text",
    inputmode: "decimal",
    autocomplete: "off",
    "data-key": measure.key,
    "aria-label": measure.label,
    "aria-describedby": measure.said.id,
    value: measure.value === null ? "" : String(measure.value),
    placeholder: String(measure.placeholder),
    title: measure.title,
    class: "figures",
  });
  const judged = (): Read => {
    const read = measure.read(field.value.trim().replace(",", ".").replace("°", ""));
    field.setAttribute("aria-invalid", String("wrong" in read));
    measure.said.textContent = "wrong" in read ? read.wrong : "";
    return read;
  };
  field.addEventListener("input", judged);
  field.addEventListener("change", () => {
    const read = judged();
    if ("value" in read && read.value !== measure.value) {
      const { value } = read;
      editor.history.change(measure.label, (draft) => measure.take(draft, value));
    }
  });
  return field;
}

function bearingField(editor: Editor, place: Place, letter: Letter, side: Side, said: HTMLElement): HTMLElement {
  return measureField(editor, {
    key: `bearing ${letter}`,
    label: `bearing ${sideNames[letter]}, degrees`,
    value: side.bearing_deg,
    placeholder: compass_deg[letter],
    title: "In which the hallway leaves, clockwise from north. Empty: along its compass point.",
    said,
    read: (text) => readBearing(text, letter),
    take: (draft, value) => {
      const there = placeById(draft, place.id);
      if (there) {
        setBearing(draft, there, letter, value);
      }
    },
  });
}
function tagDistanceField(editor: Editor, place: Place, letter: Letter, side: Side, said: HTMLElement): HTMLElement {
  return measureField(editor, {
    key: `tag distance ${letter}`,
    label: `from the ${sideNames[letter]} tags to the middle, m`,
    value: side.tag_m,
    placeholder: editor.doc.settings.tag_to_middle_m,
    title: "From this side's tags to the middle of the place. Empty: as everywhere in the building (under Plan).",
    said,
    read: readTagDistance,
    take: (draft, value) => {
      const end = placeById(draft, place.id)?.sides[letter];
      if (end) {
        end.tag_m = value;
      }
    },
  });
}

/** Whether the bearing is what is drawn, and else a button that makes it so. */
function onTheDrawing(editor: Editor, place: Place, letter: Letter, side: Side): Node {
  const soft = (text: string) => el("span", { class: "soft" }, text);
  const other = side.to === null ? undefined : placeById(editor.doc, side.to);
  if (!other) {
    return soft("–");
  }
  const drawn = drawn_deg(place.at, other.at);
  if (bearingIsDrawn(side, letter, place.at, other.at)) {
    return soft("as drawn");
  }
  const whole = degrees(Math.round(drawn));
  if (apart_deg(drawn, compass_deg[letter]) > offPoint_deg + 0.5) {
    return el("span", { class: "warn" }, `drawn ${whole}`);
  }
  return button(
    `Take ${whole}`,
    () =>
      editor.history.change("bearing as drawn", (draft) => {
        const there = placeById(draft, place.id);
        if (there) {
          setBearing(draft, there, letter, asBearing(drawn, letter));
        }
      }),
    { "data-key": `as drawn ${letter}`, "aria-label": `Take ${whole} as the bearing ${sideNames[letter]}`, class: "small" },
  );
}

/** One row for each side that has a hallway. */
export function sideDetails(editor: Editor, place: Place): Node[] {
  const open = letters.flatMap((letter) => {
    const side = place.sides[letter];
    return side ? [{ letter, side }] : [];
  });
  if (open.length === 0) {
    return [];
  }
  const said = el("p", { id: "side-details-said", class: "bad note", role: "status" });
  const rows = open.map(({ letter, side }) =>
    el(
      "tr",
      {},
      el("th", { scope: "row" }, letter),
      el("td", {}, bearingField(editor, place, letter, side, said)),
      el("td", {}, onTheDrawing(editor, place, letter, side)),
      el("td", {}, tagDistanceField(editor, place, letter, side, said)),
    ),
  );
  const heads = ["Side", "Bearing, °", "On the plan", "Tag to middle, m"];
  return [
    el(
      "table",
      { class: "sides details" },
      el("caption", { class: "visually-hidden" }, `Bearings and tag distances of ${place.name}`),
      el("thead", {}, el("tr", {}, ...heads.map((head) => el("th", { scope: "col" }, head)))),
      el("tbody", {}, ...rows),
    ),
    said,
  ];
}
