// SPDX-License-Identifier: MIT
// house.mjs TWIN PAGES OUT ROOT: while `twin run` maps the house at full speed, the page shows all 207 tiles and every
// event, is the picture that floorplan.png is, reads well to people who do not see it, and comes back after a break.
import { readFileSync, rmSync, mkdirSync } from "node:fs";
import { join } from "node:path";
import { check, openBrowser, start } from "../../robot/telemetry/browser.mjs";
import { checkEverySize } from "./served.mjs";

const [twin, pages, out, root] = process.argv.slice(2);
const browser = await openBrowser(pages);
rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });

const plan = (page) => page.locator("#plan");
const tilesShown = async (page) => Number(await plan(page).getAttribute("data-tiles"));
const untilTiles = (page, count) =>
  page.waitForFunction((n) => Number(document.querySelector("#plan")?.dataset.tiles) >= n, count, { timeout: 60_000 });

/** The picture of a canvas at points of the plan in metres: red, green, blue of each. */
const colours = (page, points) =>
  page.evaluate((at) => {
    const canvas = document.querySelector("#plan");
    const view = JSON.parse(canvas.dataset.view);
    const ratio = canvas.width / canvas.clientWidth;
    const context = canvas.getContext("2d");
    return at.map(([x, y]) => [...context.getImageData((view.x + x * view.scale) * ratio, (view.y - y * view.scale) * ratio, 1, 1).data.slice(0, 3)]);
  }, points);

/** The same of floorplan.png, whose plan begins at these pixels: the room's corner and its scale are looked for. */
async function picture(page, file) {
  const data = `data:image/png;base64,${readFileSync(file).toString("base64")}`;
  return page.evaluateHandle(async (source) => {
    const image = new Image();
    image.src = source;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, image.width, image.height);
  }, data);
}

const near = (a, b, by) => a.every((value, i) => Math.abs(value - b[i]) <= by);

try {
  // The page is there before the robot: everything arrives live.
  const folder = join(out, "run");
  const run = await start(twin, ["run", join(root, "scenes/house.yaml"), "--monitor=127.0.0.1:0", "--out", folder], /monitor at (http\S+)/);
  const page = await browser.page();
  await page.goto(run.match[1]);
  await untilTiles(page, 207);
  check((await tilesShown(page)) === 207, `the page shows ${await tilesShown(page)} tiles`);
  await page.waitForFunction(() => document.querySelector("#plan").dataset.state === "Run ended", null, { timeout: 60_000 });

  // Opened late it tells the same, from the beginning.
  const late = await browser.page();
  await late.goto(run.match[1]);
  await untilTiles(late, 207);

  // No event is missing: as many as events.jsonl has, and the newest are the same.
  for (let tries = 0; !run.lines.some((line) => line.startsWith("results in")) && tries < 300; ++tries) {
    await new Promise((done) => setTimeout(done, 100));
  }
  const written = readFileSync(join(folder, "events.jsonl"), "utf8").trim().split("\n").map((line) => JSON.parse(line));
  for (const each of [page, late]) {
    await each.waitForFunction((n) => Number(document.querySelector("#plan").dataset.events) === n, written.length, { timeout: 10_000 });
  }
  const shown = await page.locator(".events li .when").allTextContents();
  const clock = (s) => `${String(Math.floor(s / 60)).padStart(2, "0")}:${String(Math.floor(s % 60)).padStart(2, "0")}`;
  const expected = written.slice(-shown.length).reverse().map((event) => clock(event.t_s));
  check(JSON.stringify(shown) === JSON.stringify(expected), `the list of events differs: ${shown.slice(0, 5)} is not ${expected.slice(0, 5)}`);

  // Its picture is that of floorplan.png: at a quarter of each tile and of each blocked one, the same colour.
  const tile_m = 0.508;
  const points = [];
  for (let row = 0; row < 17; ++row) {
    for (let column = 0; column < 18; ++column) {
      points.push([(column + 0.8) * tile_m, (row + 0.2) * tile_m]);
    }
  }
  const png = await picture(page, join(folder, "floorplan.png"));
  const theirs = await page.evaluate(compareFloorplan, { png, points, tile_m });
  const ours = await colours(page, points);
  const closed = [0x56, 0x61, 0x6e];
  let same = 0;
  const different = [];
  points.forEach((point, i) => {
    const closedHere = near(ours[i], closed, 12);
    const closedThere = near(theirs[i], closed, 12);
    if (closedHere === closedThere) {
      same += 1;
    } else {
      different.push(`(${point}): page ${ours[i]}, floorplan.png ${theirs[i]}`);
    }
  });
  const covered = ours.filter((colour) => near(colour, closed, 12)).length;
  check(covered >= 204, `only ${covered} tiles are seen as closed`);
  // The trail or a name may lie over a probe in one picture and beside it in the other.
  check(different.length <= 3, `${different.length} of ${points.length} probes differ:\n${different.join("\n")}`);
  console.log(`${same} of ${points.length} probes agree with floorplan.png, ${covered} of them on closed tiles`);

  // Every tag tells its data, by mouse and by key.
  const view = JSON.parse(await plan(page).getAttribute("data-view"));
  const box = await plan(page).boundingBox();
  await page.mouse.move(box.x + view.x + 0.5 * tile_m * view.scale, box.y + view.y - 0.5 * tile_m * view.scale);
  await page.waitForFunction(() => document.querySelector(".tag-title").textContent.includes("column 0, row 0"));
  check(/E0[0-9A-F]{14}/.test(await page.locator('section[aria-label="Tag"]').textContent()), "a tag does not tell its number");
  await page.mouse.move(box.x + box.width - 5, box.y + 5);
  await page.getByRole("button", { name: "Next tag" }).focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector(".tag-title").textContent.includes("tag"));
  await page.getByRole("button", { name: "Next tag" }).press("Enter");

  // By key and by finger the plan moves.
  const scale = async (of) => JSON.parse(await plan(of).getAttribute("data-view")).scale;
  const before = await scale(page);
  await plan(page).focus();
  await page.keyboard.press("+");
  await page.waitForFunction((was) => JSON.parse(document.querySelector("#plan").dataset.view).scale > was, before);
  await page.getByRole("button", { name: "Fit the plan" }).click();

  await checkEverySize(browser, run.match[1], out, "house", (each) => untilTiles(each, 207));
  check(page.errors.length === 0, page.errors.join("\n"));
  await late.close();

  // The program is gone: the page says so, keeps its picture, and takes up the next run at the same address.
  const port = new URL(run.match[1]).port;
  run.child.kill("SIGINT");
  check((await run.ended) === 0, `twin ended with ${await run.ended}`);
  check((await tilesShown(page)) === 207, "the picture went with the program");
  const next = await start(twin, ["run", join(root, "scenes/lesson_2x2.yaml"), "--no-pictures", `--monitor=127.0.0.1:${port}`, "--out", join(out, "next")], /monitor at (http\S+)/);
  await page.waitForFunction(() => document.querySelector("#plan").dataset.tiles === "16", null, { timeout: 30_000 });
  next.child.kill("SIGINT");
  await next.ended;

  // Slowed down it is watched while it works.
  const live = await start(twin, ["run", join(root, "scenes/house.yaml"), "--no-pictures", "--rtf", "100", "--monitor=127.0.0.1:0", "--out", join(out, "live")], /monitor at (http\S+)/);
  const watching = await browser.page();
  await watching.goto(live.match[1]);
  await untilTiles(watching, 120);
  check((await plan(watching).getAttribute("data-state")) === "Live", "a run that goes on is not called live");
  check((await tilesShown(watching)) < 207, "at a hundred times real time the house is mapped at once");
  await watching.screenshot({ path: join(out, "live.png") });
  live.child.kill("SIGINT");
  check((await live.ended) === 130, `interrupted, twin ended with ${await live.ended}`);
  console.log("207 tiles, every event, no violation, and the next run");
} finally {
  await browser.close();
}

/** In the page: floorplan.png's colours at points of the plan. Its plan is found by its carpet: dark grey from end to end. */
function compareFloorplan({ png, points, tile_m }) {
  const at = (x, y) => [...png.data.slice(4 * (y * png.width + x), 4 * (y * png.width + x) + 3)];
  const isTile = ([r, g, b]) => Math.abs(r - 0x56) < 4 && Math.abs(g - 0x61) < 4 && Math.abs(b - 0x6e) < 4;
  let left = png.width;
  let right = 0;
  let low = 0;
  let top = png.height;
  // The legend's swatch is tile-coloured too, and stands alone at the right.
  for (let y = 0; y < png.height; ++y) {
    let run = 0;
    for (let x = 0; x < png.width; ++x) {
      run = isTile(at(x, y)) ? run + 1 : 0;
      if (run > 40) {
        left = Math.min(left, x - run + 1);
        right = Math.max(right, x);
        low = Math.max(low, y);
        top = Math.min(top, y);
      }
    }
  }
  const scale = (right - left + 1) / (18 * tile_m);
  return points.map(([x, y]) => at(Math.round(left + x * scale), Math.round(low - y * scale)));
}
