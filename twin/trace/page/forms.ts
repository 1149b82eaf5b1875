// SPDX-License-Identifier: MIT
// Fields of the side panel. They are made anew whenever the document changes; what has the focus keeps it.
import { el } from "../../../robot/telemetry/pages/common/dom";

let counter = 0;

/** What is being typed in a container, and what is to be shown in it afterwards. */
interface Typing {
  field: EventTarget | null;
  content: (Node | string)[] | null;
}
const typings = new WeakMap<HTMLElement, Typing>();
function typingIn(container: HTMLElement): Typing {
  const known = typings.get(container);
  if (known) {
    return known;
  }
  const typing: Typing = { field: null, content: null };
  typings.set(container, typing);
  container.addEventListener("input", (event) => (typing.field = event.target));
  // Before the field itself hears of it: what it changes is shown.
  container.addEventListener("change", () => (typing.field = null), true);
  container.addEventListener("focusout", () => {
    typing.field = null;
    window.setTimeout(() => {
      if (typing.content) {
        remade(container, typing.content);
      }
    });
  });
  return typing;
}

/**
 * Makes the content anew, and gives the focus back to the field with the same key. A field that somebody types in is
 * left alone until he is done: the server's answers come between two letters.
 */
export function remade(container: HTMLElement, content: (Node | string)[]): void {
  const typing = typingIn(container);
  const focused = document.activeElement;
  if (typing.field !== null && typing.field === focused) {
    typing.content = content;
    return;
  }
  typing.content = null;
  const key = focused instanceof HTMLElement && container.contains(focused) ? focused.dataset["key"] : undefined;
  const caret = focused instanceof HTMLInputElement && focused.type === "text" ? focused.selectionStart : null;
  container.replaceChildren(...content);
  if (key !== undefined) {
    const again = container.querySelector<HTMLElement>(`[data-key="${CSS.escape(key)}"]`);
    again?.focus({ preventScroll: true });
    if (again instanceof HTMLInputElement && caret !== null) {
      again.setSelectionRange(caret, caret);
    }
  }
}

interface FieldOptions {
  key: string;
  label: string;
  hidden?: boolean;
  note?: string;
}
function labelled(field: HTMLElement, options: FieldOptions): HTMLElement {
  const id = `f${++counter}`;
  field.id = id;
  field.dataset["key"] = options.key;
  const label = el("label", { for: id, class: options.hidden ? "visually-hidden" : "label" }, options.label);
  return el(
    "div",
    { class: "field" },
    label,
    field,
    ...(options.note ? [el("p", { class: "soft note" }, options.note)] : []),
  );
}

export function textField(
  options: FieldOptions & { value: string; placeholder?: string },
  take: (value: string) => void,
): HTMLElement {
  const input = el("input", {
    type: "text",
    value: options.value,
    placeholder: options.placeholder ?? "",
    autocomplete: "off",
    spellcheck: "false",
  });
  input.addEventListener("change", () => take(input.value.trim()));
  return labelled(input, options);
}
/** \param take  only numbers within the bounds */
export function numberField(
  options: FieldOptions & { value: number; min: number; max: number; step?: number },
  take: (value: number) => void,
): HTMLElement {
  const input = el("input", {
    type: "number",
    value: options.value,
    min: options.min,
    max: options.max,
    step: options.step ?? "any",
    class: "figures",
  });
  input.addEventListener("change", () => {
    const value = input.valueAsNumber;
    const good = Number.isFinite(value) && value >= options.min && value <= options.max;
    input.setAttribute("aria-invalid", String(!good));
    if (good) {
      take(value);
    }
  });
  return labelled(input, options);
}
export function choiceField(
  options: FieldOptions & { value: string; choices: readonly (readonly [string, string])[] },
  take: (value: string) => void,
): HTMLElement {
  const select = el(
    "select",
    {},
    ...options.choices.map(([value, text]) => el("option", { value, selected: value === options.value }, text)),
  );
  select.addEventListener("change", () => take(select.value));
  return labelled(select, options);
}
export function checkField(options: FieldOptions & { value: boolean }, take: (value: boolean) => void): HTMLElement {
  const input = el("input", { type: "checkbox", checked: options.value });
  input.addEventListener("change", () => take(input.checked));
  const field = labelled(input, options);
  field.classList.add("check");
  return field;
}
export function button(
  text: string,
  run: () => void,
  attributes: Record<string, string | boolean> = {},
): HTMLButtonElement {
  return el("button", { type: "button", "data-key": text, ...attributes, onclick: run }, text);
}
