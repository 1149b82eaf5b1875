// SPDX-License-Identifier: MIT
// The map that Tsukiyama's Figure 5 shows, with the facts that section 3 tells of it: tag 9 is met on coming to c from
// the east, d lies north of c, and on the way there the robot reads tag 11.
//
//     d --- e --- ?
//     |     |
// a - c --- f
//     |
//     b

const tags = {
  a: { east: "1" },
  b: { north: "2" },
  c: { north: "6", south: "7", west: "8", east: "9" },
  d: { south: "11", east: "12" },
  e: { west: "13", south: "14", east: "15" },
  f: { north: "16", west: "17" },
};
/** All that is done to it, as undo counts: six strokes, a ?, three names. */
export const strokes = 10;

/** By mouse, on whatever lies below. The page names places in the order in which they are drawn. */
export async function drawThePapersMap(bench) {
  await bench.calibrate();
  await bench.tool("Hallway");
  await bench.drag([0, 0], [8, 0.4]); // the paper's a and c; the hand is not steady
  await bench.drag([8, 0], [8.2, -6]); // b
  await bench.drag([8, 0], [7.8, 6]); // d
  await bench.drag([8, 6], [16, 6.2]); // e
  await bench.drag([16, 6], [16.1, 0.1]); // f
  await bench.drag([16, 0], [8, 0]); // and back to c
  await bench.tool("Unknown");
  await bench.click([17, 6]);
  for (const [from, to] of [
    ["b", "x"],
    ["c", "b"],
    ["x", "c"],
  ]) {
    await bench.place(from).click();
    await bench.fill("Name", to);
  }
  await bench.quiet();
}

export async function typeTags(bench) {
  await bench.tab("Places");
  for (const [place, sides] of Object.entries(tags)) {
    await bench.place(place).click();
    for (const [side, tag] of Object.entries(sides)) {
      await bench.fill(`tags met on coming from the ${side}`, tag);
    }
  }
  await bench.quiet();
}

/** The steps in words, and all that the page says of the way. */
export async function routeOf(bench, from, to) {
  await bench.tab("Route");
  await bench.fill("From place or tag", from);
  await bench.field("To").selectOption(to);
  await bench.page.locator(".steps li", { hasText: ` to ${to} ` }).waitFor();
  return {
    steps: await bench.page.locator(".steps li").allTextContents(),
    text: await bench.page.locator("#panel [role=status]").innerText(),
  };
}
