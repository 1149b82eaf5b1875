// SPDX-License-Identifier: MIT
// several.mjs TWIN PAGES OUT ROOT SENSOBOT: `sensobot monitor` shows a run in the twin and one of sensobot on one page. One
// of them is killed and started again: it is said to be out of reach, and comes back by itself.
import { mkdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { check, openBrowser, start } from "../../robot/telemetry/browser.mjs";
import { checkEverySize, servedByCable, untilEvent, untilState } from "./served.mjs";

const [twin, pages, out, root, sensobot] = process.argv.slice(2);
const browser = await openBrowser(pages);
rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });

const runTwin = (scene, name, address) =>
  start(twin, ["run", join(root, "scenes", scene), "--no-pictures", `--monitor=${address}`, "--out", join(out, name)], /monitor at (http\S+)/);
const port = (url) => new URL(url).port;
const button = (page, words) => page.locator(".robots button").filter({ hasText: words });
const pressed = async (page) => page.locator('.robots button[aria-pressed="true"]').textContent();

const wires = await servedByCable(twin, join(root, "tests/twin/sensobot/two_tags.yaml"), join(out, "served"));
try {
  // The room's monitor asks for its token, which the page never sees; the other is not there yet.
  const room = await runTwin("lesson_2x2.yaml", "room", "0.0.0.0:0");
  const spare = await runTwin("lesson_2x2.yaml", "spare", "127.0.0.1:0");
  const at = spare.match[1];
  spare.child.kill("SIGKILL");
  await spare.ended;
  const both = await start(sensobot, ["monitor", "--at", "127.0.0.1:0", room.match[1].replace("0.0.0.0", "127.0.0.1"), at], /monitor at (http\S+)/);
  const url = both.match[1];
  const page = await browser.page();
  await page.goto(url);
  await button(page, "lesson_2x2").waitFor();
  await button(page, `127.0.0.1:${port(at)}not reached`).waitFor();

  // It comes: its name, and what it does, by itself.
  const machine = () => start(sensobot, ["run", wires.robot, "--devices", wires.devices, "--force", "--out", join(out, "machine"), `--monitor=127.0.0.1:${port(at)}`], /monitor at (http\S+)/);
  const first = await machine();
  await button(page, "robotlive").waitFor();
  check((await pressed(page)).includes("lesson_2x2"), `the page shows ${await pressed(page)}, which nobody asked for`);
  await page.waitForFunction(() => document.querySelector("#plan").dataset.tiles === "16");
  await button(page, "robot").click();
  await page.waitForFunction(() => / 2 ceiling tags/.test(document.querySelector("#plan").ariaLabel));
  check((await page.locator("#plan").getAttribute("data-tiles")) === "0", "one robot's tiles are drawn for the other");
  check(!(await page.locator(".events").textContent()).includes("Tile found"), "one robot's events stand in the other's list");
  await checkEverySize(browser, url, out, "several", async (each) => {
    await button(each, "robot").click();
    await each.waitForFunction(() => / 2 ceiling tags/.test(document.querySelector("#plan").ariaLabel));
  });

  // Killed, it is out of reach, and what it had drawn stays; the other is not touched.
  first.child.kill("SIGKILL");
  await button(page, "robotnot reached").waitFor();
  await untilState(page, "not reached");
  check(/ 2 ceiling tags/.test(await page.locator("#plan").getAttribute("aria-label")), "the picture went with the program");
  check((await button(page, "lesson_2x2ended").count()) === 1, "the robot that was not killed is not as it was");
  await page.screenshot({ path: join(out, "killed.png") });
  const second = await machine();
  await button(page, "robotlive").waitFor();
  await untilState(page, "^Live$");
  await untilEvent(page, "Device there: the Roomba");

  // It ends in order: the outcome is said, and that nobody answers there now.
  check((await second.ended) === 0, `sensobot ended with ${await second.ended}`);
  await untilState(page, "^Run ended, not reached any more$");

  // Two in one room are drawn together, and the legend says so.
  const legend = () => page.locator(".legend li:visible").allTextContents();
  check(!(await legend()).includes("Another robot of this room"), "one robot is taken for two");
  const twins = await runTwin("lesson_2x2.yaml", "twins", `127.0.0.1:${port(at)}`);
  await button(page, "lesson_2x2").nth(1).waitFor();
  await page.waitForFunction(() => document.querySelector("#plan").dataset.tiles === "16");
  await page.waitForFunction(() => [...document.querySelectorAll(".legend li")].some((row) => !row.hidden && row.textContent === "Another robot of this room"));
  await button(page, `(127.0.0.1:${port(at)})`).waitFor();
  await page.screenshot({ path: join(out, "one_room.png") });
  twins.child.kill("SIGINT");
  await twins.ended;
  const token = new URL(room.match[1].replace("0.0.0.0", "127.0.0.1")).searchParams.get("token");
  check(/^[0-9a-f]{32}$/.test(token) && !(await page.content()).includes(token), "the page knows the room's token");
  check(page.errors.length === 0, page.errors.join("\n"));
  both.child.kill("SIGINT");
  check((await both.ended) === 0, `sensobot monitor ended with ${await both.ended}`);
  room.child.kill("SIGINT");
  console.log("two robots, one of them killed, started again and ended");
} finally {
  wires.cable.pull();
  wires.child.kill("SIGKILL");
  await browser.close();
}
