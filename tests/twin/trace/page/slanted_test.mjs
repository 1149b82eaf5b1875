// SPDX-License-Identifier: MIT
// Hallways that run along no compass point, and tags at distances of their own: slanted_test.mjs TWIN PAGES [PICTURES].
// Drawn by mouse, by keys and in the table, moved, turned, saved; a robot drives through them; real buildings stay what
// they were.
import assert from "node:assert/strict";
import { copyFileSync, existsSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import test from "node:test";
import { browser, onThePage, picture, runs, saved, sceneTaken } from "./bench.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../../..");
const buildings = join(root, "scenes/buildings");
const stata = join(buildings, "stata_hallways.yaml");
const pictureOfStata = join(root, "../shared/data/maps/basement_stata_mit");

async function dragWithShift(bench, from, to) {
  await bench.page.keyboard.down("Shift");
  await bench.drag(from, to);
  await bench.page.keyboard.up("Shift");
}
/** A ring of five hallways, two of them aslant, and a way into it. */
async function drawTheRing(bench) {
  await bench.calibrate();
  await bench.tool("Hallway");
  await bench.drag([0, -12], [8, -12]); // a, b
  await dragWithShift(bench, [8, -12], [14, -7]); // c
  await bench.drag([14, -7], [14, -1]); // d
  await bench.drag([14, -1], [6, -1]); // e
  await bench.drag([6, -1], [8, -12]); // joined as they lie
  await bench.press("Number tags");
  await bench.quiet();
}
/** What the drawing says of a hallway map, as tracings keep it. */
async function tracing(bench, name = "plan") {
  await bench.press("Save");
  await bench.says("Saved");
  await bench.page.locator("header .state", { hasText: "not saved" }).waitFor({ state: "detached" });
  const { hallways } = JSON.parse(saved(bench, `${name}.trace.json`));
  return Object.fromEntries(hallways.places.map((place) => [place.name, place]));
}
/** The map as the robot's reader takes it and writes it. */
async function asReadByTheRobot(bench, file) {
  return bench.page.evaluate(async (name) => {
    const ask = async (what, body) =>
      (
        await fetch(`/api/${what}`, {
          method: "POST",
          headers: { "Content-Type": "application/json", "X-SensoTwin": "1" },
          body: JSON.stringify(body),
        })
      ).json();
    const { hallways } = await ask("open", { name });
    return (await ask("check", { document: { hallways } })).text;
  }, file);
}

onThePage("a stroke that slants says how to draw it, and with Shift is a hallway", {}, async (bench) => {
  await bench.calibrate();
  await bench.tool("Hallway");
  await bench.drag([0, 0], [6, 5]);
  assert.match(await bench.said(), /40° off east\. To draw a slanted one, hold Shift or turn on Slanted/);
  assert.match(await bench.page.locator("#panel").innerText(), /Places \(0\)/);
  await dragWithShift(bench, [0, 0], [6, 5]);
  assert.match(await bench.said(), /leaves at 50°, on the east side/);
  assert.equal(await bench.verdict(), "Sound, 1 to look at"); // no tags yet
  const { a, b } = await tracing(bench);
  assert.deepEqual([a.E.to, a.E.bearing_deg, a.E.length_m], ["b", 50, 7.81]);
  assert.deepEqual([b.W.to, b.W.bearing_deg, b.W.length_m], ["a", 230, 7.81]);
  assert.match(saved(bench, "plan.hallways.yaml"), /bearing_deg: 50\b[^]*bearing_deg: 230\b/);
  await bench.page.keyboard.press("Control+z");
  assert.match(await bench.page.locator("#panel").innerText(), /Places \(0\)/);
});

onThePage("slanted hallways are drawn with the keyboard alone", {}, async (bench) => {
  const press = async (key, times = 1) => {
    for (let i = 0; i < times; ++i) {
      await bench.page.keyboard.press(key);
    }
  };
  await bench.page.locator("canvas").focus();
  await press("h");
  await press("h");
  assert.equal(await bench.said(), "Slanted: on.");
  assert.equal(await bench.page.getByRole("button", { name: "Slanted" }).getAttribute("aria-pressed"), "true");
  await press("ArrowRight"); // the cursor is there
  await press("Enter");
  await press("ArrowRight", 6);
  await press("ArrowUp", 8);
  await press("Enter"); // 37 degrees
  await press("h");
  assert.equal(await bench.said(), "Slanted: off.");
  await press("Enter");
  await press("ArrowRight", 8);
  await press("ArrowUp", 2);
  await press("Enter"); // off, and within what a hand trembles: along its compass point
  assert.match(await bench.verdict(), /^Sound/);
  const { a, b, c } = await tracing(bench);
  assert.deepEqual([a.N.to, a.N.bearing_deg, b.S.bearing_deg], ["b", 37, 217]);
  assert.deepEqual([b.E.to, b.E.bearing_deg, c.at_m[1]], ["c", undefined, b.at_m[1]]);
});

onThePage("places that are there already are joined as they lie, unless the side is taken", {}, async (bench) => {
  await drawTheRing(bench);
  assert.equal(await bench.verdict(), "Sound");
  const { b, c, e } = await tracing(bench);
  assert.deepEqual([e.S.to, e.S.bearing_deg, b.N.bearing_deg], ["b", 170, 350]);
  assert.deepEqual([c.W.to, c.W.bearing_deg], ["b", 230]);
  await bench.tool("Hallway");
  await dragWithShift(bench, [14, -7], [6, -1]); // 307 degrees: north is too far off
  assert.match(await bench.said(), /c has a hallway to b on its west side; erase it first\./);
  await bench.drag([-2, -12], [4, -12]); // over a, to the middle of the hallway behind it
  assert.match(await bench.said(), /The place on the hallway has a hallway to a on its west side; erase it first\./);
  await bench.tab("Places");
  assert.match(await bench.page.locator("#panel").innerText(), /Places \(5\)/);
});

onThePage("a place on a slanted hallway keeps bearings and tags, and lies on it", {}, async (bench) => {
  await drawTheRing(bench);
  const before = await tracing(bench);
  await bench.tool("Hallway");
  await bench.drag([14, -10], [10.5, -10]); // from the east onto the hallway from b to c
  assert.match(await bench.said(), /erase it first/, "east of it there is no side left: c is there");
  await bench.drag([11, -14], [11, -9.7]); // from the south: g
  assert.equal(await bench.verdict(), "Sound, 1 to look at");
  const now = await tracing(bench);
  const g = now[now.b.E.to];
  assert.deepEqual([g.E.to, g.E.bearing_deg, g.W.bearing_deg], ["c", 50, 230]);
  assert.equal(g.S.to, "f");
  assert.deepEqual([now.b.E.tags, now.c.W.tags], [before.b.E.tags, before.c.W.tags]);
  assert.ok(Math.abs(g.at_m[1] - (-12 + ((g.at_m[0] - 8) * 5) / 6)) < 0.02, `${g.at_m}`);
});

onThePage("the twin's robot finds its way through slanted hallways that were drawn", {}, async (bench) => {
  await drawTheRing(bench);
  await bench.place("c").click();
  await bench.fill("from the west tags to the middle, m", "1.8");
  await bench.tab("Scene");
  await bench.field("From").selectOption("a");
  await bench.field("To").selectOption("d");
  await sceneTaken(bench);
  await bench.press("Save scene");
  await bench.says("Saved plan.hallways.yaml, plan.scene.yaml");
  const { hallway } = await runs(bench, "plan");
  assert.ok(Math.abs(hallway.shortest_m - 21.81) < 0.1, `${hallway.shortest_m} m by c`);
  await bench.tab("Places");
  await bench.place("c").click();
  await bench.press("Show everything");
  await picture(bench, "trace_slanted");
});

onThePage("bearings and tag distances are typed in the table, judged, undone and kept", {}, async (bench) => {
  await bench.calibrate();
  await bench.tool("Hallway");
  await bench.drag([0, 0], [8, 0]);
  await bench.press("Number tags");
  await bench.place("a").click();
  const bearing = bench.field("bearing east, degrees");
  const away = bench.field("from the east tags to the middle, m");
  const said = bench.page.locator("#side-details-said");
  assert.equal(await bearing.getAttribute("placeholder"), "90");
  assert.equal(await away.getAttribute("placeholder"), "1");

  for (const wrong of ["140", "north", "400"]) {
    await bearing.fill(wrong);
    assert.equal(await bearing.getAttribute("aria-invalid"), "true", wrong);
    assert.match(await said.textContent(), /between 45° and 135°|0 to 360/);
  }
  await bearing.fill("100,5");
  assert.equal(await bearing.getAttribute("aria-invalid"), "false");
  assert.equal(await said.textContent(), "");
  await bearing.press("Tab");
  await away.fill("12");
  assert.match(await said.textContent(), /0\.1 to 10 m/);
  // The server's answer to the bearing comes meanwhile, and takes no letter from the field.
  await away.fill("");
  await away.pressSequentially("2.25", { delay: 150 });
  await away.press("Tab");
  const typed = await tracing(bench);
  assert.deepEqual([typed.a.E.bearing_deg, typed.b.W.bearing_deg], [100.5, 280.5]);
  assert.deepEqual([typed.a.E.tag_m, typed.b.W.tag_m], [2.25, undefined]);

  await bench.page.reload();
  await bench.press("Open");
  await bench.page.getByRole("button", { name: /^plan\.hallways\.yaml/ }).click();
  await bench.says("plan: 2 places");
  await bench.place("a").click();
  assert.equal(await bearing.inputValue(), "100.5");
  assert.equal(await away.inputValue(), "2.25");
  await bench.fill("from the east tags to the middle, m", "");
  await bench.page.getByRole("button", { name: "Take 90° as the bearing east" }).click();
  assert.equal(await bearing.inputValue(), "");
  for (const [value, distance] of [
    ["100.5", ""],
    ["100.5", "2.25"],
  ]) {
    await bench.page.locator("canvas").focus();
    await bench.page.keyboard.press("Control+z");
    assert.deepEqual([await bearing.inputValue(), await away.inputValue()], [value, distance]);
  }
});

onThePage("what was as drawn follows the drawing, what was typed otherwise stays", {}, async (bench) => {
  await drawTheRing(bench);
  await bench.place("d").click();
  await bench.fill("bearing west, degrees", "285");
  await bench.fill("from the south tags to the middle, m", "1.5");
  await bench.tool("Select");
  await bench.drag([14, -1], [16.5, -1]);
  const { c, d, e } = await tracing(bench);
  assert.deepEqual([d.at_m, c.N.bearing_deg, d.S.bearing_deg], [[16.5, -1], 23, 203]);
  assert.deepEqual([d.W.bearing_deg, e.E.bearing_deg, d.S.tag_m], [285, 105, 1.5]);
  await bench.drag([16.5, -1], [14, -1]);
  const back = await tracing(bench);
  assert.deepEqual([back.c.N.bearing_deg, back.d.S.bearing_deg], [undefined, undefined]);
  // Farther than halfway to the next compass point it leaves by that one, with its tags.
  const { tags } = back.d.S;
  await bench.drag([14, -1], [20.5, -2]);
  const far = await tracing(bench);
  assert.deepEqual([far.d.W.to, far.d.S?.to], ["e", "c"], "west is taken, so that the reader has to say what is wrong");
  await bench.tool("Erase");
  await bench.click([13, -1.5]);
  await bench.tool("Select");
  await bench.drag([20.5, -2], [21.5, -2]);
  const alone = await tracing(bench);
  assert.deepEqual([alone.d.W.to, alone.d.W.bearing_deg, alone.d.W.tags], ["c", 236, tags]);
  assert.match(await bench.verdict(), /^Sound/);
});

onThePage("a plan that is turned turns the bearings with it", { plan: [stata] }, async (bench) => {
  await bench.tab("Plan");
  await bench.fill("Turn the plan, degrees clockwise", "-20");
  await bench.tab("Places");
  const { b, g, h } = await tracing(bench, "stata_hallways");
  assert.deepEqual([h.N.to, h.N.bearing_deg, g.S.bearing_deg], ["g", 23, 203]);
  assert.deepEqual([b.N.bearing_deg, b.E.bearing_deg], [346, 71]);
  assert.deepEqual([h.N.tag_m, h.S.tag_m, b.N.tag_m], [2, 2, undefined]);
  assert.equal(await bench.verdict(), "Sound");
});

for (const name of readdirSync(buildings).filter((each) => each.endsWith("_hallways.yaml"))) {
  const file = join(buildings, name);
  onThePage(`${name} is saved as it was opened, and loses nothing when a place is moved`, { plan: [file] }, async (bench) => {
    copyFileSync(file, join(bench.folder, "original.yaml"));
    const was = await asReadByTheRobot(bench, "original.yaml");
    const stem = name.replace(".yaml", "");
    const before = await tracing(bench, stem);
    assert.equal(saved(bench, name), was);
    assert.match(was, /tag_m: /, "there is something to lose");

    const moved = await bench.page.evaluate(() => document.querySelector("#panel .list .item b").textContent);
    await bench.calibrate();
    const [x, y] = before[moved].at_m;
    await bench.drag([x, y], [x - 1.5, y]);
    const after = await tracing(bench, stem);
    assert.ok(Math.abs(after[moved].at_m[0] - x + 1.5) < 0.3, `${after[moved].at_m}`);
    for (const [place, sides] of Object.entries(before)) {
      for (const letter of ["N", "E", "S", "W"]) {
        const [old, now] = [sides[letter], after[place][letter]];
        if (old && place !== moved && old.to !== moved) {
          assert.deepEqual(now, old, `${place} ${letter}`);
        }
        assert.equal(now?.tag_m, old?.tag_m, `${place} ${letter}`);
      }
    }
  });
}

if (existsSync(join(pictureOfStata, "map.yaml"))) {
  onThePage("a real building lies under its hallways", { plan: [stata] }, async (bench) => {
    for (const file of readdirSync(pictureOfStata)) {
      copyFileSync(join(pictureOfStata, file), join(bench.folder, file));
    }
    const before = await tracing(bench, "stata_hallways");
    await bench.press("Open");
    await bench.page.getByRole("button", { name: /^map\.yaml/ }).click();
    await bench.says("map.yaml lies under the drawing.");
    await bench.place("h").click();
    await bench.press("Show everything");
    await picture(bench, "trace_real_building");
    assert.deepEqual(await tracing(bench, "stata_hallways"), before);
  });
} else {
  test("a real building lies under its hallways", { skip: "its picture is not here" }, () => {});
}

for (const dark of [false, true]) {
  onThePage(`axe-core finds nothing on slanted hallways, ${dark ? "dark" : "light"}`, { dark }, async (bench) => {
    await drawTheRing(bench);
    await bench.place("b").click();
    await bench.fill("bearing east, degrees", "80");
    await bench.field("from the west tags to the middle, m").fill("0");
    const found = await browser.violations(bench.page);
    await picture(bench, `trace_${dark ? "dark" : "light"}_slanted`);
    await bench.tool("Hallway");
    await bench.press("Slanted");
    found.push(...(await browser.violations(bench.page)));
    await picture(bench, `trace_${dark ? "dark" : "light"}_slanted_tool`);
    assert.deepEqual(found, []);
  });
}
