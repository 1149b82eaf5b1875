// SPDX-License-Identifier: MIT
// The tracer's page in a real browser: the paper's kind of map from nothing by mouse and by keys, scenes that run, no
// accessibility violation.
import assert from "node:assert/strict";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { Bench, twin } from "./bench.mjs";

/** A test with a server and a browser of its own, which end with it. */
function onThePage(name, how, body) {
  test(name, async () => {
    const bench = await Bench.begin(how);
    try {
      await body(bench);
      assert.deepEqual(bench.errors, []);
    } finally {
      // Ctrl-C ends the program as docs/cli.md says.
      assert.equal(await bench.end(), 130);
    }
  });
}

const pictures = process.env["PICTURES"];
async function picture(bench, name) {
  if (pictures) {
    mkdirSync(pictures, { recursive: true });
    await bench.page.mouse.move(700, 20);
    await bench.quiet();
    await bench.page.screenshot({ path: join(pictures, `${name}.png`) });
  }
}

/**
 * The map that Tsukiyama's Figure 5 shows, with the facts that section 3 tells of it: tag 9 is met on coming to c from
 * the east, d lies north of c, and on the way there the robot reads tag 11. The page names places in the order in which
 * they are drawn.
 *
 *     d --- e --- ?
 *     |     |
 * a - c --- f
 *     |
 *     b
 */
const tags = {
  a: { E: "1" }, b: { N: "2" }, c: { N: "6", S: "7", W: "8", E: "9" }, d: { S: "11", E: "12" },
  e: { W: "13", S: "14", E: "15" }, f: { N: "16", W: "17" },
};
const names = { N: "north", E: "east", S: "south", W: "west" };

async function typeTags(bench) {
  await bench.page.getByRole("tab", { name: "Places" }).click();
  for (const [place, sides] of Object.entries(tags)) {
    await bench.page.locator(".list .item", { has: bench.page.locator(`b:text-is("${place}")`) }).first().click();
    for (const [side, tag] of Object.entries(sides)) {
      await bench.fill(`tags met on coming from the ${names[side]}`, tag);
    }
  }
}
async function renameAll(bench, pairs) {
  for (const [from, to] of pairs) {
    await bench.page.locator(".list .item", { has: bench.page.locator(`b:text-is("${from}")`) }).first().click();
    await bench.fill("Name", to);
  }
}
/** Draws c-f, a-c and so on by hand; the page calls places a, b, c ... as they come. */
async function drawThePapersMap(bench) {
  await bench.calibrate();
  await bench.tool("Hallway");
  await bench.drag([0, 0], [8, 0.4]);      // a and b: the paper's a and c; the hand is not steady
  await bench.drag([8, 0], [8.2, -6]);     // c: b
  await bench.drag([8, 0], [7.8, 6]);      // d: d
  await bench.drag([8, 6], [16, 6.2]);     // e: e
  await bench.drag([16, 6], [16.1, 0.1]);  // f: f
  await bench.drag([16, 0], [8, 0]);       // joins f and c
  await bench.tool("Unknown");
  await bench.click([17, 6]);
  await renameAll(bench, [["b", "x"], ["c", "b"], ["x", "c"]]);
  await bench.quiet();
}
function theMap(folder, name) {
  return readFileSync(join(folder, `${name}.hallways.yaml`), "utf8");
}

async function routeOf(bench, from, to) {
  await bench.page.getByRole("tab", { name: "Route" }).click();
  await bench.fill("From place or tag", from);
  await bench.field("To").selectOption(to);
  await bench.quiet();
  return { steps: await bench.page.locator(".steps li").allTextContents(), text: await bench.page.locator("#panel [role=status]").innerText() };
}

onThePage("the paper's map is drawn from nothing by mouse, saved, loaded and planned over", {}, async (bench) => {
  await drawThePapersMap(bench);
  assert.match(await bench.verdict(), /^Sound/);
  await typeTags(bench);
  assert.equal(await bench.verdict(), "Sound");
  await bench.page.locator("#name").fill("paper");
  await bench.page.locator("#name").press("Tab");
  await bench.page.getByRole("button", { name: "Save", exact: true }).click();
  await bench.quiet();
  assert.match(await bench.said(), /^Saved paper.hallways.yaml, paper.trace.json/);
  const saved = theMap(bench.folder, "paper");
  assert.doesNotMatch(saved, /at_m: \[\d+\.\d{3,}/, "positions are whole centimetres");

  // "coming into the intersection c from the East side ... The robot ... turns to the right ... and going out to the
  // North side. Finally it will find another tag with the ID number 11" (section 3).
  const { steps } = await routeOf(bench, "9", "e");
  assert.equal(steps.length, 2);
  assert.equal(steps[0], "Turn right and go north 6.0 m to d (tag 11).");
  assert.equal(steps[1], "Turn right and go east 8.0 m to e (tag 13).");
  await picture(bench, "trace_route");

  await bench.page.reload();
  await bench.quiet();
  await bench.page.getByRole("button", { name: "Open", exact: true }).click();
  await bench.page.getByRole("button", { name: /^paper\.hallways\.yaml/ }).click();
  await bench.quiet();
  assert.equal(await bench.verdict(), "Sound");
  await bench.page.getByRole("button", { name: "Save", exact: true }).click();
  await bench.quiet();
  assert.match(await bench.said(), /^Saved paper/);
  assert.equal(theMap(bench.folder, "paper"), saved);
});

onThePage("the same map is drawn with the keyboard alone", {}, async (bench) => {
  const press = async (keys) => {
    for (const key of keys.split(" ")) {
      await bench.page.keyboard.press(key);
    }
  };
  const repeat = (key, times) => Array.from({ length: times }, () => key).join(" ");
  // Tab goes to the drawing, past the tools.
  for (let i = 0; i < 40 && (await bench.page.evaluate(() => document.activeElement?.tagName)) !== "CANVAS"; ++i) {
    await bench.page.keyboard.press("Tab");
  }
  const stroke = (way, metres) => `Enter ${repeat(way, metres * 2)} Enter`;
  await press("h ArrowRight");  // the cursor is there
  await press(stroke("ArrowRight", 8));       // a, b
  await press(stroke("ArrowUp", 6));          // c north of b
  await press(stroke("ArrowRight", 8));       // d
  await press(stroke("ArrowDown", 6));        // e, south of d
  await press(stroke("ArrowLeft", 8));        // joined with b
  await press(stroke("ArrowDown", 6));        // f south of b
  await press(`u ${repeat("ArrowUp", 24)} ${repeat("ArrowRight", 18)} Enter`);
  assert.match(await bench.verdict(), /^Sound/);
  // Tags by Tab and letters, in the list of places.
  const tabTo = async (key) => {
    for (let i = 0; i < 80; ++i) {
      await bench.page.keyboard.press("Tab");
      if ((await bench.page.evaluate(() => document.activeElement?.dataset?.key ?? "")) === key) {
        return;
      }
    }
    assert.fail(`Tab does not lead to ${key}`);
  };
  await tabTo("Number tags");
  await press("Enter");
  assert.equal(await bench.verdict(), "Sound");
  await press("Control+s");
  await bench.quiet();
  const map = theMap(bench.folder, "plan");
  assert.match(map, /to: "?\?"?/);
  assert.equal((map.match(/tags: /g) ?? []).length, 13);
  const { steps } = await routeOf(bench, "a", "d");
  assert.deepEqual(steps.map((step) => step.replace(/ \(.*/, "")), ["Go east 8.0 m to b", "Turn left and go north 6.0 m to c", "Turn right and go east 8.0 m to d"]);
});

onThePage("what was done is undone step by step and done again", {}, async (bench) => {
  await drawThePapersMap(bench);
  const count = () => bench.page.locator("#panel .list .item b").count();
  const all = await bench.page.locator("#panel .list").innerText();
  let steps = 0;
  while (await bench.page.getByRole("button", { name: "Undo" }).isEnabled()) {
    await bench.page.keyboard.press("Control+z");
    ++steps;
  }
  assert.equal(steps, 10);  // six strokes, a ?, three names
  assert.equal(await count(), 0);
  for (let i = 0; i < steps; ++i) {
    await bench.page.keyboard.press("Control+y");
  }
  assert.equal(await bench.page.locator("#panel .list").innerText(), all);
});

onThePage("a mistake is told by the robot's reader, and leads to the culprit", {}, async (bench) => {
  await drawThePapersMap(bench);
  await typeTags(bench);
  await bench.page.locator(".list .item", { has: bench.page.locator('b:text-is("f")') }).first().click();
  await bench.fill("tags met on coming from the north", "9");
  assert.match(await bench.verdict(), /^1 mistake/);
  await bench.page.locator(".list .item", { has: bench.page.locator('b:text-is("a")') }).first().click();
  await picture(bench, "trace_mistake");
  await bench.page.locator("button.problem").first().click();
  assert.equal(await bench.field("Name").inputValue(), "f");
  await bench.page.getByRole("button", { name: "Save", exact: true }).click();
  await bench.quiet();
  assert.match(await bench.said(), /^Saved as a draft \(plan.trace.json\)/);
  assert.ok(!existsSync(join(bench.folder, "plan.hallways.yaml")));
});

onThePage("hallways run along compass points: a slanting stroke makes none, and says why", {}, async (bench) => {
  await bench.calibrate();
  await bench.tool("Hallway");
  await bench.drag([0, 0], [6, 5]);
  assert.match(await bench.said(), /off east/);
  assert.equal(await bench.page.locator("#panel .list .item b").count(), 0);
});

onThePage("somebody else's file is not replaced without a question", {}, async (bench) => {
  writeFileSync(join(bench.folder, "plan.hallways.yaml"), "# theirs\n");
  await drawThePapersMap(bench);
  await bench.page.getByRole("button", { name: "Save", exact: true }).click();
  await bench.quiet();
  assert.match(await bench.page.getByRole("dialog").innerText(), /plan\.hallways\.yaml/);
  await bench.page.getByRole("button", { name: "Cancel" }).click();
  assert.equal(theMap(bench.folder, "plan"), "# theirs\n");
});

/** A floor of 300 by 200 pixels: white, a black frame, and a black wall from the middle upwards. */
function drawnPlan(file) {
  const pixels = Buffer.alloc(300 * 200, 255);
  for (let y = 0; y < 200; ++y) {
    for (let x = 0; x < 300; ++x) {
      if (x < 3 || y < 3 || x > 296 || y > 196 || (Math.abs(x - 150) < 2 && y < 100)) {
        pixels[y * 300 + x] = 0;
      }
    }
  }
  writeFileSync(file, Buffer.concat([Buffer.from("P5\n300 200\n255\n"), pixels]));
  return file;
}
/** Hallways of the paper's map, 2 m wide, as [west, south, east, north]; rooms with doors lie around them. */
const strips = [[-1, -1, 17, 1], [7, -7, 9, 7], [7, 5, 22, 7], [15, -1, 17, 7]];
const building = [-4, -10, 22, 10];
/** A floor with those hallways, as map_server keeps it: 5 cm a pixel. */
function drawnBuilding(folder) {
  const [west, south, east, north] = building;
  const margin = 1;
  const cell = 0.05;
  const wide = Math.round((east - west + 2 * margin) / cell);
  const high = Math.round((north - south + 2 * margin) / cell);
  const within = ([w, s, e, n], x, y, by = 0) => x > w - by && x < e + by && y > s - by && y < n + by;
  const hallway = (x, y, by) => strips.some((strip) => within(strip, x, y, by));
  const door = (v) => Math.abs(((v + 1.2) % 4 + 4) % 4 - 2) < 0.45;
  const wall = (x, y) => {
    if (!within(building, x, y)) {
      return within(building, x, y, 0.2);
    }
    if (hallway(x, y, 0)) {
      return false;
    }
    const doorway = hallway(x, y, 0.12) && (door(x) || door(y));
    const partition = Math.abs(((x + 2) % 4 + 4) % 4 - 2) < 0.05 || Math.abs(((y + 2) % 5 + 5) % 5 - 2.5) < 0.05;
    return !doorway && (hallway(x, y, 0.12) || partition);
  };
  const pixels = Buffer.alloc(wide * high, 254);
  for (let v = 0; v < high; ++v) {
    for (let u = 0; u < wide; ++u) {
      if (wall(west - margin + (u + 0.5) * cell, north + margin - (v + 0.5) * cell)) {
        pixels[v * wide + u] = 0;
      }
    }
  }
  writeFileSync(join(folder, "building.pgm"), Buffer.concat([Buffer.from(`P5\n${wide} ${high}\n255\n`), pixels]));
  writeFileSync(join(folder, "building.yaml"), `image: building.pgm\nresolution: ${cell}\norigin: [${west - margin}, ${south - margin}, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n`);
  return join(folder, "building.yaml");
}
const desk = mkdtempSync(join(tmpdir(), "trace-plans-"));

onThePage("a plan is given scale and north, and what is drawn on it stays on it", { plan: [drawnPlan(join(desk, "floor.pgm"))] }, async (bench) => {
  assert.match(await bench.verdict(), /no scale yet/);
  await bench.calibrate();
  // Before it has a scale a pixel counts 5 cm: the picture is 15 by 10.
  await bench.tool("Hallway");
  await bench.drag([2, 2], [12, 2]);
  await bench.tool("Scale");
  await bench.drag([0.1, 1], [14.9, 1]);
  await bench.field("Length of the line, m").fill("29.6");
  await bench.page.getByRole("button", { name: "Set scale" }).click();
  await bench.quiet();
  await bench.calibrate();
  await bench.tool("North");
  await bench.drag([10, 10], [15, 10]);  // what was east is north
  await bench.quiet();
  await bench.page.getByRole("button", { name: "Save", exact: true }).click();
  await bench.quiet();
  const saved = JSON.parse(readFileSync(join(bench.folder, "floor.trace.json"), "utf8"));
  assert.ok(Math.abs(saved.plan.resolution_m - 0.1) < 0.001, `${saved.plan.resolution_m}`);
  assert.ok(Math.abs(saved.plan.origin[2] - Math.PI / 2) < 0.01, `${saved.plan.origin}`);
  const [a, b] = saved.hallways.places;
  assert.equal(a.N.to, "b");  // the hallway was drawn east
  assert.ok(Math.abs(a.N.length_m - 20) < 0.2);
  assert.ok(Math.abs(b.at_m[1] - a.at_m[1] - 20) < 0.2 && Math.abs(b.at_m[0] - a.at_m[0]) < 0.02);
  await picture(bench, "trace_turned");

  // Opened again, picture and drawing lie as they were.
  await bench.page.reload();
  await bench.page.getByRole("button", { name: "Open", exact: true }).click();
  await bench.page.getByRole("button", { name: /^floor\.trace\.json/ }).click();
  await bench.quiet();
  assert.match(await bench.said(), /floor: 2 places/);
  assert.match(await bench.page.locator("footer").innerText(), /1 px = 10 cm/);
});

onThePage("a carpet is drawn on the walls of a plan, and the twin runs it", {}, async (bench) => {
  await bench.calibrate();
  await bench.tool("Room");
  await bench.drag([0, 0], [3, -2]);
  await bench.tool("Carpet");
  await bench.drag([0, 0], [3, -2]);
  await bench.page.waitForFunction(() => document.querySelector("#panel [role=status]")?.textContent?.startsWith("✓"));
  const tiles = async () => Number((await bench.page.locator("#panel .good").textContent()).match(/(\d+) tiles/)[1]);
  const all = await tiles();
  assert.ok(all >= 15, `${all}`);
  await bench.click([0.25, -0.4]);
  await bench.page.waitForFunction((n) => document.querySelector("#panel .good")?.textContent?.includes(`${n} tiles`), all - 1);
  await bench.fill("What it shows, in a sentence", "A carpet drawn by hand");
  await bench.page.locator("#name").fill("carpet");
  await bench.page.locator("#name").press("Tab");
  await bench.page.getByRole("button", { name: "Save scene" }).click();
  await bench.quiet();
  await picture(bench, "trace_carpet");
  const run = await twin("run", join(bench.folder, "carpet.scene.yaml"), "--out", join(bench.folder, "run"), "--no-pictures", "--json", "--quiet");
  assert.equal(run.code, 0, run.said);
  const summary = JSON.parse(readFileSync(join(bench.folder, "run", "summary.json"), "utf8"));
  assert.equal(summary.map.tiles_mapped, all - 1);
});

onThePage("ceiling tags are hung in a room, and the twin drives along them", {}, async (bench) => {
  await bench.calibrate();
  await bench.tool("Room");
  await bench.drag([-2, 3], [10, -5]);
  await bench.tool("Ceiling tag");
  for (const at of [[0, 0], [4, 0], [8, 0], [8, -3]]) {
    await bench.click(at);
  }
  await bench.tool("Start");
  await bench.drag([-1, 0], [1, 0]);
  await bench.page.waitForFunction(() => document.querySelector("#panel [role=status]")?.textContent?.startsWith("✓"));
  await bench.page.locator("#name").fill("tags");
  await bench.page.locator("#name").press("Tab");
  await bench.page.getByRole("button", { name: "Save scene" }).click();
  await bench.quiet();
  await picture(bench, "trace_ceiling");
  const run = await twin("run", join(bench.folder, "tags.scene.yaml"), "--out", join(bench.folder, "run"), "--no-pictures", "--json", "--quiet");
  assert.equal(run.code, 0, run.said);
});

onThePage("a hallway mission of the paper's map runs in the building that was drawn", {}, async (bench) => {
  await drawThePapersMap(bench);
  await typeTags(bench);
  await bench.page.getByRole("tab", { name: "Scene" }).click();
  await bench.field("From").selectOption("a");
  await bench.field("To").selectOption("e");
  await bench.page.waitForFunction(() => document.querySelector("#panel [role=status]")?.textContent?.startsWith("✓"));
  await bench.page.getByRole("button", { name: "Save scene" }).click();
  await bench.quiet();
  const run = await twin("run", join(bench.folder, "plan.scene.yaml"), "--out", join(bench.folder, "run"), "--no-pictures", "--json", "--quiet");
  const summary = JSON.parse(readFileSync(join(bench.folder, "run", "summary.json"), "utf8"));
  assert.equal(run.code, 0, `${run.said} ${JSON.stringify(summary.hallway)}`);
  // The way that the page would show is the way that the robot goes.
  const { text } = await routeOf(bench, "a", "e");
  assert.match(text, new RegExp(`^${summary.hallway.shortest_m.toFixed(1)} m`));
});

for (const dark of [false, true]) {
  for (const full of [false, true]) {
    onThePage(`axe-core finds nothing on the ${full ? "full" : "empty"} page, ${dark ? "dark" : "light"}`, { dark, plan: full ? [drawnBuilding(desk)] : [] }, async (bench) => {
      if (full) {
        await drawThePapersMap(bench);
        await typeTags(bench);
        await bench.page.locator("#panel .list .item").first().click();
        await bench.fill("tags met on coming from the east", "12");
        await bench.fill("tags met on coming from the east", "1");
      }
      const found = [];
      for (const tab of ["Places", "Route", "Scene", "Plan"]) {
        await bench.page.getByRole("tab", { name: tab }).click();
        await bench.quiet();
        if (full && tab === "Route") {
          await routeOf(bench, "9", "e");
        }
        found.push(...(await bench.violations()));
        await picture(bench, `trace_${dark ? "dark" : "light"}_${full ? "full" : "empty"}_${tab.toLowerCase()}`);
      }
      await bench.page.getByRole("button", { name: "Help" }).click();
      found.push(...(await bench.violations()));
      assert.deepEqual(found, []);
    });
  }
}

onThePage("it works on a telephone", { size: { width: 390, height: 844 } }, async (bench) => {
  await bench.calibrate();
  await bench.tool("Hallway");
  await bench.drag([4, -4], [14, -4]);
  assert.equal(await bench.page.locator("#panel .list .item b").count(), 2);
  const wide = await bench.page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 390, `${wide} px wide`);
  await picture(bench, "trace_telephone");
});
