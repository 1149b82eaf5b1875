// SPDX-License-Identifier: MIT
// Questions that must be answered before work goes on.
import { el } from "../../../robot/telemetry/pages/common/dom";
import type { FileEntry } from "./api";

/** A modal question; resolves to the value of the button that closed it, "" when it was dismissed. */
function ask(title: string, content: (Node | string)[], buttons: [string, string][]): Promise<string> {
  const dialog = el("dialog", { "aria-label": title });
  const form = el(
    "form",
    { method: "dialog" },
    el("h2", { class: "title" }, title),
    ...content,
    el(
      "div",
      { class: "row end" },
      ...buttons.map(([value, text], i) =>
        el("button", { value, class: i === buttons.length - 1 ? "primary" : "" }, text),
      ),
    ),
  );
  // Enter answers with the last button, not with the first.
  form.addEventListener("keydown", (event) => {
    const target = event.target;
    if (event.key === "Enter" && target instanceof HTMLInputElement) {
      event.preventDefault();
      dialog.close(buttons.at(-1)?.[0] ?? "");
    }
  });
  dialog.append(form);
  document.body.append(dialog);
  dialog.showModal();
  return new Promise((answered) => {
    dialog.addEventListener("close", () => {
      dialog.remove();
      answered(dialog.returnValue);
    });
  });
}

/** How long a line is that was drawn on the plan; null: never mind. */
export async function askLength(drawn: number, scaled: boolean): Promise<number | null> {
  const input = el("input", {
    type: "number",
    min: 0.01,
    step: "any",
    required: true,
    value: scaled ? drawn.toFixed(2) : "",
    id: "line-length",
    class: "figures",
  });
  const field = el(
    "div",
    { class: "field" },
    el("label", { class: "label", for: "line-length" }, "Length of the line, m"),
    input,
  );
  const answer = ask(
    "How long is it?",
    [field, el("p", { class: "soft" }, "Everything drawn on the plan stays on it.")],
    [
      ["", "Cancel"],
      ["ok", "Set scale"],
    ],
  );
  input.focus();
  input.select();
  return (await answer) === "ok" && input.valueAsNumber > 0 ? input.valueAsNumber : null;
}

export async function askOverwrite(names: string[]): Promise<"overwrite" | "reload" | ""> {
  const answer = await ask(
    "Changed by somebody else",
    [
      el(
        "p",
        {},
        "Since you opened or saved them, these files were written by another program, or were there before:",
      ),
      el("ul", {}, ...names.map((name) => el("li", {}, el("code", {}, name)))),
      el("p", { class: "soft" }, "Cancel keeps both: save under another name."),
    ],
    [
      ["", "Cancel"],
      ["reload", "Open theirs"],
      ["overwrite", "Overwrite"],
    ],
  );
  return answer === "overwrite" || answer === "reload" ? answer : "";
}

export async function askLeave(): Promise<boolean> {
  return (
    (await ask(
      "Unsaved changes",
      [el("p", {}, "What you drew since the last save would be lost.")],
      [
        ["", "Keep drawing"],
        ["ok", "Go on"],
      ],
    )) === "ok"
  );
}

const kinds: Record<FileEntry["kind"], string> = {
  tracing: "tracing",
  hallways: "hallway map",
  map: "map_server map",
  picture: "picture",
  scene: "scene",
};
/** A file of the folder, a picture from this machine, or nothing. */
export async function askOpen(folder: string, files: FileEntry[]): Promise<{ name: string } | { file: File } | null> {
  const upload = el("input", { type: "file", accept: ".png,.pgm,image/png", id: "upload", class: "visually-hidden" });
  const openable = files.filter((file) => file.kind !== "scene");
  const items = openable.map((file) =>
    el(
      "li",
      {},
      el(
        "button",
        { value: `f:${file.name}`, class: "item" },
        el("b", {}, file.name),
        el("span", { class: "soft" }, kinds[file.kind]),
      ),
    ),
  );
  const picker = el("label", { for: "upload", class: "as-button" }, "Picture from this machine …");
  const answer = ask(
    "Open",
    [
      el("p", { class: "soft" }, folder),
      openable.length > 0
        ? el("ul", { class: "list tall" }, ...items)
        : el("p", {}, "Nothing in this folder that could be opened."),
      el("div", { class: "row" }, upload, picker),
    ],
    [
      ["", "Cancel"],
      ["new", "New sheet"],
    ],
  );
  const dialog = upload.closest("dialog");
  upload.addEventListener("change", () => dialog?.close("upload"));
  const value = await answer;
  const file = upload.files?.[0];
  if (value === "upload" && file) {
    return { file };
  }
  return value === "new" ? { name: "" } : value.startsWith("f:") ? { name: value.slice(2) } : null;
}

export async function showHelp(tools: { label: string; key: string; hint: string }[]): Promise<void> {
  const keys: [string, string][] = [
    ["Arrow keys", "move the cursor by half a metre; with Shift by 5 m, with Alt by 10 cm"],
    ["Enter", "presses the tool at the cursor; once more releases it: Enter, arrows, Enter draws a hallway"],
    ["Shift while drawing, or H again", "hallways in any direction: slanted ones"],
    ["Escape", "lets go of what is under way, or of the selection"],
    ["Delete", "removes what is selected"],
    ["Ctrl+Z, Ctrl+Y", "undo, redo"],
    ["Ctrl+S, Ctrl+O", "save, open"],
    ["+, -, 0", "magnify, shrink, show everything"],
  ];
  await ask(
    "Tools and keys",
    [
      el(
        "p",
        { class: "soft" },
        "Letters and arrows work while the drawing has the focus. Touch: one finger draws, two move and magnify.",
      ),
      el(
        "div",
        { class: "help", tabindex: "0", role: "group", "aria-label": "Tools and keys" },
        el(
          "dl",
          {},
          ...tools.flatMap((tool) => [
            el("dt", {}, el("kbd", {}, tool.key.toUpperCase()), ` ${tool.label}`),
            el("dd", {}, tool.hint),
          ]),
        ),
        el("dl", {}, ...keys.flatMap(([key, what]) => [el("dt", {}, el("kbd", {}, key)), el("dd", {}, what)])),
      ),
    ],
    [["", "Close"]],
  );
}
