// SPDX-License-Identifier: MIT
// The tracer's page in a real browser: page_test.mjs TWIN PAGES [PICTURES]. The paper's kind of map from nothing by mouse
// and by keys, mistakes, plans, scenes that run, and no accessibility violation.
//   PAGES     where script/pages built, with npm's packages
//   PICTURES  a folder for screenshots
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
import { browser, onThePage, picture, runs, saved, sceneTaken } from "./bench.mjs";
import { drawThePapersMap, routeOf, strokes, typeTags } from "./papers_map.mjs";
import { drawnBuilding, drawnFloor } from "./plans.mjs";

const desk = mkdtempSync(join(tmpdir(), "trace-plans-"));
after(() => rmSync(desk, { recursive: true, force: true }));

onThePage("the paper's map is drawn from nothing by mouse, saved, loaded and planned over", {}, async (bench) => {
  await drawThePapersMap(bench);
  assert.match(await bench.verdict(), /^Sound/);
  await typeTags(bench);
  assert.equal(await bench.verdict(), "Sound");
  await bench.call("paper");
  await bench.press("Save");
  await bench.says("Saved paper.hallways.yaml, paper.trace.json");
  const map = saved(bench, "paper.hallways.yaml");
  assert.doesNotMatch(map, /at_m: \[-?\d+\.\d{3,}/, "positions are whole centimetres");

  // "coming into the intersection c from the East side ... turns to the right at the intersection and going out to the
  // North side. Finally it will find another tag with the ID number 11" (section 3).
  const { steps } = await routeOf(bench, "9", "e");
  assert.deepEqual(steps, [
    "Turn right and go north 6.0 m to d (tag 11).",
    "Turn right and go east 8.0 m to e (tag 13).",
  ]);

  await bench.page.reload();
  await bench.press("Open");
  await bench.page.getByRole("button", { name: /^paper\.hallways\.yaml/ }).click();
  await bench.says("paper: 6 places");
  assert.equal(await bench.verdict(), "Sound");
  await bench.press("Save");
  await bench.says("Saved paper.hallways.yaml");
  assert.equal(saved(bench, "paper.hallways.yaml"), map);
});

onThePage("the same map is drawn with the keyboard alone", {}, async (bench) => {
  const press = async (...keys) => {
    for (const key of keys) {
      await bench.page.keyboard.press(key);
    }
  };
  const times = (key, count) => Array.from({ length: count }, () => key);
  const tabTo = async (there) => {
    for (let i = 0; i < 80; ++i) {
      if (await bench.page.evaluate(there)) {
        return;
      }
      await press("Tab");
    }
    assert.fail(`Tab does not lead to ${there}`);
  };
  const stroke = (way, metres) => press("Enter", ...times(way, 2 * metres), "Enter");
  await tabTo(() => document.activeElement?.tagName === "CANVAS");
  await press("h", "ArrowRight"); // the cursor is there
  await stroke("ArrowRight", 8); // a, b
  await stroke("ArrowUp", 6); // c, north of b
  await stroke("ArrowRight", 8); // d
  await stroke("ArrowDown", 6); // e, south of d
  await stroke("ArrowLeft", 8); // joined with b
  await stroke("ArrowDown", 6); // f, south of b
  await press("u", ...times("ArrowUp", 24), ...times("ArrowRight", 18), "Enter");
  assert.match(await bench.verdict(), /^Sound/);
  await tabTo(
    () => document.activeElement?.dataset.key === "tags N" || document.activeElement?.dataset.key === "tags E",
  );
  await bench.page.keyboard.type("21");
  await tabTo(() => document.activeElement?.dataset.key === "Number tags");
  await press("Enter");
  assert.equal(await bench.verdict(), "Sound");
  await press("Control+s");
  await bench.says("Saved plan.hallways.yaml");
  const map = saved(bench, "plan.hallways.yaml");
  assert.equal((map.match(/tags: /g) ?? []).length, 13);
  assert.match(map, /"21"/);
  const { steps } = await routeOf(bench, "a", "d");
  assert.deepEqual(
    steps.map((step) => step.replace(/ \(.*/, "")),
    ["Go east 8.0 m to b", "Turn left and go north 6.0 m to c", "Turn right and go east 8.0 m to d"],
  );
});

onThePage("what was done is undone step by step and done again", {}, async (bench) => {
  await drawThePapersMap(bench);
  const list = () => bench.page.locator("#panel").innerText();
  const all = await list();
  let steps = 0;
  while (await bench.page.getByRole("button", { name: "Undo" }).isEnabled()) {
    await bench.page.keyboard.press("Control+z");
    ++steps;
  }
  assert.equal(steps, strokes);
  assert.match(await list(), /Places \(0\)/);
  for (let i = 0; i < steps; ++i) {
    await bench.page.keyboard.press("Control+y");
  }
  await bench.place("c").click();
  assert.equal(await list(), all);
});

onThePage("a mistake is told by the robot's reader, and leads to the culprit", {}, async (bench) => {
  await drawThePapersMap(bench);
  await typeTags(bench);
  await bench.place("f").click();
  await bench.fill("tags met on coming from the north", "9");
  assert.match(await bench.verdict(), /^1 mistake/);
  await bench.place("a").click();
  await picture(bench, "trace_mistake");
  await bench.page.locator("button.problem").first().click();
  assert.equal(await bench.field("Name").inputValue(), "f");
  await bench.press("Save");
  await bench.says("Saved as a draft (plan.trace.json)");
  assert.ok(!existsSync(join(bench.folder, "plan.hallways.yaml")));
});

onThePage("a blocked hallway is gone round", {}, async (bench) => {
  await drawThePapersMap(bench);
  await routeOf(bench, "c", "e");
  await bench.tool("Try route");
  await bench.click([8, 3]);
  await bench.page.locator(".steps li", { hasText: "to f" }).waitFor();
  assert.deepEqual(await bench.page.locator(".steps li").count(), 2);
});

onThePage("somebody else's file is not replaced without a question", {}, async (bench) => {
  writeFileSync(join(bench.folder, "plan.hallways.yaml"), "# theirs\n");
  await drawThePapersMap(bench);
  await bench.press("Save");
  assert.match(await bench.page.getByRole("dialog").innerText(), /plan\.hallways\.yaml/);
  await bench.press("Cancel");
  await bench.says("Nothing was saved");
  assert.equal(saved(bench, "plan.hallways.yaml"), "# theirs\n");
  await bench.press("Save");
  await bench.press("Overwrite");
  await bench.says("Saved plan.hallways.yaml");
  assert.match(saved(bench, "plan.hallways.yaml"), /places:/);
});

onThePage(
  "a plan is given scale and north, and what is drawn on it stays on it",
  { plan: [drawnFloor(desk)] },
  async (bench) => {
    assert.match(await bench.verdict(), /no scale yet/);
    await bench.calibrate();
    // Before it has a scale a pixel counts 5 cm: the picture is 15 by 10.
    await bench.tool("Hallway");
    await bench.drag([2, 2], [12, 2]);
    await bench.tool("Scale");
    await bench.drag([0.1, 1], [14.9, 1]);
    await bench.field("Length of the line, m").fill("29.6");
    await bench.press("Set scale");
    await bench.quiet();
    await bench.calibrate();
    await bench.tool("North");
    await bench.drag([10, 10], [15, 10]); // what was east is north
    await bench.press("Save");
    await bench.says("Saved floor");
    const { plan, hallways } = JSON.parse(saved(bench, "floor.trace.json"));
    // To what a hand draws: the line's ends are pixels of the screen.
    assert.ok(Math.abs(plan.resolution_m - 0.1) < 0.001, `${plan.resolution_m}`);
    assert.ok(Math.abs(plan.origin[2] - Math.PI / 2) < 0.01, `${plan.origin}`);
    const [a, b] = hallways.places;
    assert.equal(a.N.to, "b"); // it was drawn east
    assert.ok(Math.abs(a.N.length_m - 20) < 0.2, `${a.N.length_m}`);
    assert.ok(Math.abs(b.at_m[0] - a.at_m[0]) < 0.1 && Math.abs(b.at_m[1] - a.at_m[1] - 20) < 0.2, `${b.at_m}`);

    await bench.page.reload();
    await bench.press("Open");
    await bench.page.getByRole("button", { name: /^floor\.trace\.json/ }).click();
    await bench.says("floor: 2 places");
    assert.match(await bench.page.locator("footer").innerText(), /1 px = 10 cm/);
  },
);

onThePage("a picture that is none is refused in words", {}, async (bench) => {
  await bench.press("Open");
  await bench.page.setInputFiles("#upload", {
    name: "notes.png",
    mimeType: "image/png",
    buffer: Buffer.from("no picture"),
  });
  await bench.says("notes.png");
  assert.match(await bench.said(), /error|is /);
});

onThePage("a carpet is laid in a room, and the twin maps it", {}, async (bench) => {
  await bench.calibrate();
  await bench.tool("Room");
  await bench.drag([0, 0], [3, -2]);
  await bench.tool("Carpet");
  await bench.drag([0, 0], [3, -2]);
  await sceneTaken(bench, " 24 tiles");
  await bench.click([0.25, -0.4]);
  await sceneTaken(bench, " 23 tiles");
  await bench.fill("What it shows, in a sentence", "A carpet drawn by hand");
  await bench.call("carpet");
  await bench.press("Save scene");
  await bench.says("Saved carpet.scene.yaml");
  await bench.press("Show everything");
  await picture(bench, "trace_carpet");
  assert.equal((await runs(bench, "carpet")).map.tiles_mapped, 23);
});

onThePage(
  "a carpet is laid on the floor of a plan, and the twin maps it",
  { plan: [drawnBuilding(desk)] },
  async (bench) => {
    await bench.calibrate();
    await bench.tool("Carpet");
    await bench.drag([0, -0.9], [5, 0.9]);
    await sceneTaken(bench);
    await bench.press("Save scene");
    await bench.says("Saved building.map.pgm, building.map.yaml");
    const summary = await runs(bench, "building");
    assert.equal(summary.map.tiles_mapped, summary.map.tiles_reachable);
  },
);

onThePage("ceiling tags are hung in a room, and the twin drives along them", {}, async (bench) => {
  await bench.calibrate();
  await bench.tool("Room");
  await bench.drag([-2, 3], [10, -5]);
  await bench.tool("Ceiling tag");
  for (const at of [
    [0, 0],
    [4, 0],
    [8, 0],
    [8, -3],
  ]) {
    await bench.click(at);
  }
  await bench.tool("Start");
  await bench.drag([-1, 0], [1, 0]);
  await sceneTaken(bench);
  await bench.call("tags");
  await bench.press("Save scene");
  await bench.says("Saved tags.scene.yaml");
  await bench.press("Show everything");
  await picture(bench, "trace_ceiling");
  assert.equal((await runs(bench, "tags")).path.arrived, 1);
});

onThePage(
  "a hallway mission runs through the building that was drawn, by the way that the page plans",
  {},
  async (bench) => {
    await drawThePapersMap(bench);
    await typeTags(bench);
    await bench.tab("Scene");
    await bench.field("From").selectOption("a");
    await bench.field("To").selectOption("e");
    await sceneTaken(bench);
    await bench.press("Save scene");
    await bench.says("Saved plan.hallways.yaml, plan.scene.yaml");
    const summary = await runs(bench, "plan");
    const { text } = await routeOf(bench, "a", "e");
    assert.match(text, new RegExp(`^${summary.hallway.shortest_m.toFixed(1)} m`));
  },
);

for (const dark of [false, true]) {
  for (const full of [false, true]) {
    const name = `${dark ? "dark" : "light"}_${full ? "full" : "empty"}`;
    onThePage(
      `axe-core finds nothing on the page, ${name.replace("_", " and ")}`,
      { dark, plan: full ? [drawnBuilding(desk)] : [] },
      async (bench) => {
        if (full) {
          await drawThePapersMap(bench);
          await typeTags(bench);
          await bench.place("e").click();
          await bench.quiet();
        }
        const found = [];
        for (const tab of ["Places", "Route", "Scene", "Plan"]) {
          await bench.tab(tab);
          if (full && tab === "Route") {
            await routeOf(bench, "9", "e");
          }
          await bench.quiet();
          found.push(...(await browser.violations(bench.page)));
          await picture(bench, `trace_${name}_${tab.toLowerCase()}`);
        }
        await bench.press("Help");
        found.push(...(await browser.violations(bench.page)));
        await bench.press("Close");
        await bench.press("Open");
        found.push(...(await browser.violations(bench.page)));
        assert.deepEqual(found, []);
      },
    );
  }
}

onThePage("it works on a telephone", { size: { width: 390, height: 844 } }, async (bench) => {
  await bench.tool("Hallway");
  const box = await bench.page.locator("canvas").boundingBox();
  await bench.page.mouse.move(box.x + 80, box.y + 160);
  await bench.page.mouse.down();
  await bench.page.mouse.move(box.x + 230, box.y + 165, { steps: 5 });
  await bench.page.mouse.up();
  assert.match(await bench.page.locator("#panel").innerText(), /Places \(2\)/);
  const wide = await bench.page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 390, `${wide} px wide`);
  await picture(bench, "trace_telephone");
});
