// SPDX-License-Identifier: MIT
// Floor plans that the tests draw themselves.
import { writeFileSync } from "node:fs";
import { join } from "node:path";

function pgm(wide, high, dark) {
  const pixels = Buffer.alloc(wide * high, 254);
  for (let v = 0; v < high; ++v) {
    for (let u = 0; u < wide; ++u) {
      if (dark(u, v)) {
        pixels[v * wide + u] = 0;
      }
    }
  }
  return Buffer.concat([Buffer.from(`P5\n${wide} ${high}\n255\n`), pixels]);
}

/** 300 by 200 pixels: a frame, and a wall from the middle upwards. Nothing says how large it is. */
export function drawnFloor(folder) {
  const file = join(folder, "floor.pgm");
  writeFileSync(
    file,
    pgm(300, 200, (u, v) => u < 3 || v < 3 || u > 296 || v > 196 || (Math.abs(u - 150) < 2 && v < 100)),
  );
  return file;
}

/** Hallways of the paper's map, 2 m wide, as [west, south, east, north]; rooms with doors lie around them. */
const strips = [
  [-1, -1, 17, 1],
  [7, -7, 9, 7],
  [7, 5, 22, 7],
  [15, -1, 17, 7],
];
const [west, south, east, north] = [-4, -10, 22, 10];
const margin = 1;
const cell = 0.05;
const wall_m = 0.12;

function within([w, s, e, n], x, y, by = 0) {
  return x > w - by && x < e + by && y > s - by && y < n + by;
}
function inHallway(x, y, by) {
  return strips.some((strip) => within(strip, x, y, by));
}
/** Every four metres, 0.9 m wide. */
function inDoor(v) {
  return Math.abs(((((v + 1.2) % 4) + 4) % 4) - 2) < 0.45;
}
function isWall(x, y) {
  if (!within([west, south, east, north], x, y)) {
    return within([west, south, east, north], x, y, 0.2);
  }
  if (inHallway(x, y, 0)) {
    return false;
  }
  const border = inHallway(x, y, wall_m);
  const doorway = border && (inDoor(x) || inDoor(y));
  const partition = Math.abs((((x % 4) + 4) % 4) - 2) < wall_m / 2 || Math.abs(Math.abs(y) - 5.5) < wall_m / 2;
  return !doorway && (border || partition);
}

/** A floor with those hallways, as map_server keeps it. */
export function drawnBuilding(folder) {
  const wide = Math.round((east - west + 2 * margin) / cell);
  const high = Math.round((north - south + 2 * margin) / cell);
  const picture = pgm(wide, high, (u, v) =>
    isWall(west - margin + (u + 0.5) * cell, north + margin - (v + 0.5) * cell),
  );
  writeFileSync(join(folder, "building.pgm"), picture);
  const file = join(folder, "building.yaml");
  writeFileSync(
    file,
    `image: building.pgm\nresolution: ${cell}\norigin: [${west - margin}, ${south - margin}, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n`,
  );
  return file;
}
