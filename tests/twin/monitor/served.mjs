// SPDX-License-Identifier: MIT
// A served scene, the wires to it, and what a monitor's page shows: for tests of what sensobot serves.
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { execFileSync } from "node:child_process";
import { connect, createServer } from "node:net";
import { join } from "node:path";
import { check, start } from "../../robot/telemetry/browser.mjs";

export const pause = (ms) => new Promise((done) => setTimeout(done, ms));

/** Waits until `wanted` gives something, for ten seconds. */
export async function until(wanted, what) {
  for (let tries = 0; tries < 200; ++tries) {
    const got = await wanted();
    if (got) {
      return got;
    }
    await pause(50);
  }
  throw new Error(`never came: ${what}`);
}

/** A cable to a TCP port of this machine that can be pulled out and put in again. */
async function cableTo(port) {
  const ends = new Set();
  const server = createServer((near) => {
    const far = connect(port, "127.0.0.1");
    for (const [end, other] of [[near, far], [far, near]]) {
      ends.add(end);
      end.on("error", () => {});
      end.on("close", () => {
        ends.delete(end);
        other.destroy();
      });
    }
    near.pipe(far).pipe(near);
  });
  const put = (at) => new Promise((done) => server.listen(at, "127.0.0.1", done));
  await put(0);
  const { port: here } = server.address();
  return {
    port: here,
    put: () => put(here),
    pull() {
      server.close();
      ends.forEach((end) => end.destroy());
    },
  };
}

/** `twin serve` of a scene and its robot file. \returns the process, and the paths of both files for sensobot */
export async function served(twin, scene, folder, options) {
  const server = await start(twin, ["serve", scene, "--out", folder, ...options], /./);
  const devices = join(folder, "devices.yaml");
  await until(() => existsSync(devices), devices);
  const robot = join(folder, "robot.yaml");
  writeFileSync(robot, execFileSync(twin, ["show", scene, "--robot"]));
  return { child: server.child, ended: server.ended, devices, robot };
}

/** The same of a scene along ceiling tags, with a cable to the UHF reader. */
export async function servedByCable(twin, scene, folder) {
  const server = await served(twin, scene, folder, ["--no-cards", "--llrp", "127.0.0.1:0"]);
  const written = readFileSync(server.devices, "utf8");
  const cable = await cableTo(Number(/llrp: "127\.0\.0\.1:(\d+)"/.exec(written)[1]));
  const cabled = join(folder, "cabled.yaml");
  writeFileSync(cabled, written.replace(/llrp: .*/, `llrp: "127.0.0.1:${cable.port}"`));
  return { ...server, cable, devices: cabled };
}

/** What a monitor tells somebody who comes now and stays for a second: of each key the newest. */
export async function telemetry(url) {
  const stop = new AbortController();
  const told = [];
  try {
    setTimeout(() => stop.abort(), 1000);
    const answer = await fetch(new URL("events", url), { signal: stop.signal });
    for await (const part of answer.body.pipeThrough(new TextDecoderStream())) {
      told.push(part);
    }
  } catch (error) {
    check(error.name === "AbortError", String(error));
  }
  const messages = told.join("").split("\n").filter((line) => line.startsWith("data: ")).map((line) => JSON.parse(line.slice(6)));
  return [...new Map(messages.map((each) => [each.key, each])).values()];
}

/** What stands in a page's head: how it goes. */
export const state = (page) => page.locator("#plan").getAttribute("data-state");
export const untilState = (page, words) =>
  page.waitForFunction((pattern) => new RegExp(pattern).test(document.querySelector("#plan")?.dataset.state), words, { timeout: 60_000 });
export const untilEvent = (page, words) =>
  page.waitForFunction((text) => [...document.querySelectorAll(".events li")].some((line) => line.textContent.includes(text)), words, { timeout: 30_000 });

/** The colours of a page's plan at points in metres: how many of them are `colour`, within a few levels. */
export const countOfColour = (page, points, colour) =>
  page.evaluate(([at, wanted]) => {
    const canvas = document.querySelector("#plan");
    const view = JSON.parse(canvas.dataset.view);
    const ratio = canvas.width / canvas.clientWidth;
    const context = canvas.getContext("2d");
    const seen = at.map(({ x, y }) => context.getImageData((view.x + x * view.scale) * ratio, (view.y - y * view.scale) * ratio, 1, 1).data);
    return seen.filter((data) => wanted.every((level, i) => Math.abs(level - data[i]) <= 12)).length;
  }, [points, colour]);

/**
 * Shows a monitor on a desk and on a phone, in light and dark: nothing that axe-core knows of is wrong, nothing is wider
 * than the screen, and on the phone every button is large enough for a finger and does something.
 */
export async function checkEverySize(browser, url, out, name, ready) {
  for (const [size, options] of [["desk", {}], ["desk_dark", { colorScheme: "dark" }], ["phone", { touch: true }], ["phone_dark", { touch: true, colorScheme: "dark", reducedMotion: "reduce" }]]) {
    const page = await browser.page(options);
    await page.goto(url);
    await ready(page);
    await page.waitForTimeout(300);
    const violations = await browser.violations(page);
    check(violations.length === 0, `axe-core, ${name}, ${size}:\n${violations.join("\n")}`);
    const wide = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
    check(wide[0] <= wide[1] && (!options.touch || wide[1] === 390), `${name}, ${size}: the page is ${wide[0]} wide on a screen of ${wide[1]}`);
    if (options.touch) {
      await checkButtons(page, `${name}, ${size}`);
    }
    await page.screenshot({ path: join(out, `${name}_${size}.png`) });
    if (options.touch) {
      await page.screenshot({ path: join(out, `${name}_${size}_whole.png`), fullPage: true });
    }
    check(page.errors.length === 0, `${name}, ${size}: ${page.errors.join("\n")}`);
    await page.close();
  }
}

async function checkButtons(page, where) {
  const boxes = await page.evaluate(() =>
    [...document.querySelectorAll("button")].filter((button) => button.checkVisibility()).map((button) => {
      const box = button.getBoundingClientRect();
      return { name: button.textContent, width: box.width, height: box.height, left: box.left, right: box.right, cut: button.scrollWidth > button.clientWidth };
    }));
  check(boxes.length >= 6, `${where}: only ${boxes.length} buttons`);
  for (const box of boxes) {
    check(box.height >= 44 && box.width >= 40, `${where}: ${box.name} is ${box.width} by ${box.height}`);
    check(box.left >= 0 && box.right <= 390 && !box.cut, `${where}: ${box.name} does not fit`);
  }
  const scale = () => page.evaluate(() => JSON.parse(document.querySelector("#plan").dataset.view).scale);
  const before = await scale();
  await page.getByRole("button", { name: "Magnify" }).tap();
  await page.waitForFunction((was) => JSON.parse(document.querySelector("#plan").dataset.view).scale > was, before);
  await page.getByRole("button", { name: "Next tag" }).tap();
  await page.waitForFunction(() => !document.querySelector(".tag-title").classList.contains("soft"));
  await page.getByRole("button", { name: "Fit the plan" }).tap();
}
