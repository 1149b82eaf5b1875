// SPDX-License-Identifier: MIT
// The colours of base.css for a canvas, which cannot read style sheets.

const names = [
  "paper", "card", "line", "ink", "soft-ink", "accent", "good", "warn", "bad",
  "plan", "wall", "robot", "trail", "tag", "landmark", "estimate",
  "furniture", "furniture-edge", "furniture-ink", "felt",
  "tile-open", "tile-closed", "tile-given-up", "tile-edge", "tile-mark", "tile-open-mark",
] as const;
export type ColourName = (typeof names)[number];
export type Theme = Record<ColourName, string>;

function themeNow(): Theme {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()])) as Theme;
}

/** The present colours, and again whenever the person turns from light to dark. */
export function followTheme(changed: (theme: Theme) => void): void {
  changed(themeNow());
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => changed(themeNow()));
}

export function prefersReducedMotion(): boolean {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}
