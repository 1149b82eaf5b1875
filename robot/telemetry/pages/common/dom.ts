// SPDX-License-Identifier: MIT
// Elements in one expression each. Text is always text: nothing a tag or a file says becomes markup.

type Attributes = Record<string, string | number | boolean | ((event: Event) => void)>;

/** Makes an element. Attributes that are functions listen: `onclick` to "click". false leaves an attribute out. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") {
      made.addEventListener(name.replace(/^on/, ""), value);
    } else if (value !== false) {
      made.setAttribute(name, value === true ? "" : String(value));
    }
  }
  made.append(...children);
  return made;
}

/** Sets a text only when it changed: screen readers and layout are left in peace. */
export function setText(of: Node, text: string): void {
  if (of.textContent !== text) {
    of.textContent = text;
  }
}

/** A line that screen readers read out when it changes. */
export function liveRegion(): HTMLElement {
  return el("p", { class: "visually-hidden", role: "status", "aria-live": "polite" });
}
