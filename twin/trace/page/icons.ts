// SPDX-License-Identifier: MIT
// The tools' pictures: strokes on a field of 24 by 24.
const paths = {
  select: "M6 3l12 9-6 1-3 6z",
  hallway: "M4 12a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0-5 0M9 12h6M15 12a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0-5 0",
  unknown: "M4 18h3M9 18h3M8 9a4 4 0 1 1 6 3.5c-1.4.8-2 1.5-2 2.5M17 18h.01",
  tag: "M4 4h8l8 8-8 8-8-8zM8.5 8.5h.01",
  erase: "M9 19l-5-5 9-9 7 7-7 7zM9 19h11M8.5 9.5l7 7",
  route: "M6 19a2 2 0 1 0 0-.01M18 5a2 2 0 1 0 0-.01M8 19h7a3.5 3.5 0 0 0 0-7H9a3.5 3.5 0 0 1 0-7h7",
  start: "M12 3a9 9 0 1 0 .01 0M10 8l5 4-5 4z",
  scale: "M3 16L16 3l5 5L8 21zM7 12l2 2M10 9l3 3M13 6l2 2",
  north: "M12 2l4 10-4 10-4-10zM8 12h8",
  room: "M4 4h16v16h-7M4 4v16h4M13 20a5 5 0 0 0-5-5",
  carpet: "M4 4h16v16H4zM4 12h16M12 4v16",
  ceiling: "M3 4h18M12 4v5M12 9l5 5-5 5-5-5z",
  undo: "M8 5L3 10l5 5M3 10h10a6 6 0 0 1 0 12h-3",
  redo: "M16 5l5 5-5 5M21 10H11a6 6 0 0 0 0 12h3",
  open: "M3 19V5h6l2 3h10v3M3 19l3-8h16l-3 8z",
  save: "M4 4h13l3 3v13H4zM8 4v6h8V4M8 20v-6h8v6",
  fit: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
  plus: "M12 5v14M5 12h14",
  minus: "M5 12h14",
  help: "M12 3a9 9 0 1 0 .01 0M9.5 9.5a2.5 2.5 0 1 1 3.6 2.2c-.8.5-1.1 1-1.1 1.8M12 17h.01",
} as const;
export type IconName = keyof typeof paths;

export function icon(name: IconName): SVGSVGElement {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  svg.setAttribute("class", "icon");
  const path = document.createElementNS(space, "path");
  path.setAttribute("d", paths[name]);
  svg.append(path);
  return svg;
}
