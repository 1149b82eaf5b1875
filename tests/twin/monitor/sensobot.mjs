// SPDX-License-Identifier: MIT
// sensobot.mjs TWIN PAGES OUT ROOT SENSOBOT: the page of `sensobot run` behind `twin serve`, by pseudo-terminals and TCP.
// It draws what the robot does, says what goes wrong on a wire, keeps its last picture when the program is gone, tells
// somebody who comes late the whole, and takes up the next run at its address by itself.
import { mkdirSync, readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { check, openBrowser, start } from "../../robot/telemetry/browser.mjs";
import { checkEverySize, countOfColour, pause, servedByCable, state, telemetry, untilEvent, untilState } from "./served.mjs";

const [twin, pages, out, root, sensobot] = process.argv.slice(2);
const browser = await openBrowser(pages);
rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const scene = join(root, "tests/twin/sensobot/two_tags.yaml");
/** base.css, in light. */
const [robotColour, trailColour, estimateColour] = [[0xd5, 0x5e, 0x00], [0x0b, 0x62, 0xa8], [0xb0, 0x40, 0x7a]];

const wires = await servedByCable(twin, scene, join(out, "served"));
const run = (name, port, options = []) =>
  start(sensobot, ["run", wires.robot, "--devices", wires.devices, "--out", join(out, name), `--monitor=127.0.0.1:${port}`, ...options], /monitor at (http\S+)/);
const card = (page, name) => page.locator(`section[aria-label="${name}"]`).textContent();
const eventsShown = async (page) => Number(await page.locator("#plan").getAttribute("data-events"));
const eventsOf = (name) => readFileSync(join(out, name, "events.jsonl"), "utf8").trim().split("\n").map((line) => JSON.parse(line));

try {
  const first = await run("first", 0);
  const url = first.match[1];
  const page = await browser.page();
  await page.goto(url);

  // While it drives: tags with their places, trail, battery, and no error.
  await page.waitForFunction(() => / 2 ceiling tags/.test(document.querySelector("#plan").ariaLabel) && Number(document.querySelector("#plan").dataset.trail) > 10, null, { timeout: 30_000 });
  check((await state(page)) === "Live", `a robot that drives is called ${await state(page)}`);
  // Steps that this machine was too busy for are counted; anything else would be a mistake.
  check(/None so far|0 serious events/.test(await card(page, "Wires")), `errors before there are any: ${await card(page, "Wires")}`);
  check(/\d+ %.*Voltage1\d\.\d\d V.*Base mode(safe|full)/s.test(await card(page, "Battery")), `battery: ${await card(page, "Battery")}`);
  check((await page.getByRole("button", { name: "True room" }).count()) === 0, "a machine has no true room");

  // The UHF reader's cable is pulled: an error, in the head, among the wires and in the list, until it is put in again.
  wires.cable.pull();
  await untilState(page, "^Live, but the UHF reader is gone$");
  await untilEvent(page, "Device gone: the UHF reader");
  check((await page.locator(".events li.bad").filter({ hasText: "Device gone: the UHF reader" }).count()) === 1, "a device that is gone is not marked as bad");
  check(/The UHF reader is gone/.test(await card(page, "Wires")), `wires: ${await card(page, "Wires")}`);
  await page.screenshot({ path: join(out, "cable_pulled.png") });
  await pause(500);
  await wires.cable.put();
  await untilEvent(page, "Device there: the UHF reader");
  await untilState(page, "^Live$");

  // Opened in the middle it is told all from the start.
  const late = await browser.page();
  await late.goto(url);
  await untilEvent(late, "Device gone: the UHF reader");

  // It ends, and the program with it: both pages keep the last picture and say how it ended.
  check((await first.ended) === 0, `sensobot ended with ${await first.ended}:\n${first.lines.join("\n")}`);
  const written = eventsOf("first");
  for (const each of [page, late]) {
    await untilState(each, "^Run ended, waiting for the next$");
    check((await eventsShown(each)) === written.length, `${await eventsShown(each)} of ${written.length} events are shown`);
  }
  check((await page.locator("#plan").getAttribute("data-trail")) === (await late.locator("#plan").getAttribute("data-trail")), "the late page has another trail");
  await page.screenshot({ path: join(out, "ended.png") });
  await late.close();

  // A second run at the same address is taken up by itself, with nothing of the first.
  const again = await run("second", new URL(url).port, ["--patience", "20"]);
  check(again.match[1] === url, `the second run is at ${again.match[1]}`);
  await untilState(page, "^Live$");
  await page.waitForFunction(() => Number(document.querySelector("#plan").dataset.trail) > 12, null, { timeout: 30_000 });
  check(!(await page.locator(".events").textContent()).includes("Device gone"), "events of the first run stand in the list of the second");

  // What is at the other end hangs for a second, then is gone for good.
  wires.child.kill("SIGSTOP");
  await pause(1200);
  wires.child.kill("SIGCONT");
  await page.waitForFunction(() => /[1-9]\d* errors?,/.test(document.querySelector(".verdict").textContent), null, { timeout: 10_000 });
  wires.child.kill("SIGKILL");
  wires.cable.pull();
  const allGone = (each) => untilState(each, "^Live, but 3 devices are gone$");
  await allGone(page);

  // The robot stands: it, its trail and its tags are drawn where the telemetry says.
  const told = await telemetry(url);
  const of = (kind) => told.filter((each) => each.k === kind);
  const [pose] = of("pose").slice(-1);
  const away = ({ x, y }) => Math.hypot(x - pose.x, y - pose.y) > 0.25;
  const trail = of("trail").filter(away);
  const tags = of("ceiling").filter(away);
  check((await countOfColour(page, [pose], robotColour)) === 1, `no robot at ${pose.x}, ${pose.y}`);
  check(trail.length >= 5 && (await countOfColour(page, trail, trailColour)) >= 0.8 * trail.length, `no trail at its ${trail.length} points`);
  check(tags.length > 0 && (await countOfColour(page, tags, estimateColour)) === tags.length, `no mark of ${tags.map((tag) => tag.name)}`);
  await page.screenshot({ path: join(out, "gone.png") });
  await checkEverySize(browser, url, out, "sensobot", allGone);
  check((await again.ended) === 69, `without its devices sensobot ended with ${await again.ended}`);
  await untilState(page, "^Run ended: device lost, waiting for the next$");

  // A third one that finds no device says which, and the page tells it.
  const third = await run("third", new URL(url).port, ["--wait", "4"]);
  await page.waitForFunction(() => document.querySelector(".big").textContent === "Waiting for its devices", null, { timeout: 10_000 });
  await untilState(page, "^Run ended: device missing, waiting for the next$");
  check((await third.ended) === 69, `without a device sensobot ended with ${await third.ended}`);
  check(JSON.stringify(eventsOf("third").map((event) => event.device)) === JSON.stringify(["the Roomba", "the sensor board", "the UHF reader"]), "events.jsonl does not name what is missing");
  await untilEvent(page, "Device gone: the sensor board");
  check(page.errors.every((error) => /ERR_CONNECTION_REFUSED|ERR_INCOMPLETE_CHUNKED|ERR_EMPTY/.test(error)), page.errors.join("\n"));
  console.log("live, a cable pulled, ended, the next run, and one without devices");
} finally {
  wires.cable.pull();
  await browser.close();
}
