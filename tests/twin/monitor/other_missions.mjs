// SPDX-License-Identifier: MIT
// other_missions.mjs TWIN PAGES OUT ROOT: the page of a run in hallways, of one along ceiling tags, of a served scene,
// and of one that is asked for from another machine, which needs the token.
import { mkdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { check, openBrowser, start } from "../../robot/telemetry/browser.mjs";
import { untilState } from "./served.mjs";

const [twin, pages, out, root] = process.argv.slice(2);
const browser = await openBrowser(pages);
rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });

const progress = (page) => page.locator('section[aria-label="Progress"]').textContent();

/** Runs a scene to its end and shows its page. */
async function shown(name, args, scene, address, look) {
  const run = await start(twin, [...args, join(root, "scenes", scene), `--monitor=${address}`, "--out", join(out, name)], /monitor at (http\S+)/);
  const page = await browser.page();
  try {
    await look(page, run.match[1].replace("0.0.0.0", "127.0.0.1"));
    const violations = await browser.violations(page);
    check(violations.length === 0, `axe-core, ${name}:\n${violations.join("\n")}`);
    await page.screenshot({ path: join(out, `${name}.png`) });
    check(page.errors.length === 0, `${name}: ${page.errors.join("\n")}`);
  } finally {
    await page.close();
    run.child.kill("SIGINT");
    await run.ended;
  }
}

const untilEnded = (page) =>
  page.waitForFunction(() => document.querySelector("#plan")?.dataset.state === "Run ended", null, { timeout: 90_000 });

try {
  await shown("hallway", ["run", "--no-pictures"], "office.yaml", "127.0.0.1:0", async (page, url) => {
    await page.goto(url);
    await untilEnded(page);
    const label = await page.locator("#plan").getAttribute("aria-label");
    check(Number(/(\d+) places/.exec(label)[1]) > 3, `no places: ${label}`);
    check((await progress(page)).includes("Goal"), "the goal is not named");
    await page.getByRole("button", { name: "Next tag" }).click();
    await page.waitForFunction(() => document.querySelector(".tag-title").textContent.startsWith("Place "));
  });

  // What a robot that knows no metres cannot tell the twin does: its true way, and who is about.
  await shown("people", ["run", "--variant", "people", "--no-pictures"], "office.yaml", "127.0.0.1:0", async (page, url) => {
    await page.goto(url);
    await untilEnded(page);
    const { trail, trueTrail, people } = await page.evaluate(() => ({ ...document.querySelector("#plan").dataset }));
    check(trail === "0" && Number(trueTrail) > 200 && people === "1", `trails of ${trail} and ${trueTrail} points, ${people} people`);
    check((await page.locator(".legend li:visible").allTextContents()).includes("Person (twin only)"), "the legend does not know people");
  });

  await shown("ceiling", ["run", "--variant", "own", "--no-pictures"], "hallway.yaml", "127.0.0.1:0", async (page, url) => {
    await page.goto(url);
    await untilEnded(page);
    const label = await page.locator("#plan").getAttribute("aria-label");
    check(Number(/(\d+) ceiling tags/.exec(label)[1]) > 1, `no ceiling tags: ${label}`);
    check((await progress(page)).includes("estimated from the tags"), "it is not said where the pose comes from");
  });

  await shown("served", ["serve", "--no-cards"], "house.yaml", "127.0.0.1:0", async (page, url) => {
    await page.goto(url);
    await page.waitForFunction(() => document.querySelector(".big")?.textContent.startsWith("Base "), null, { timeout: 20_000 });
  });

  // Reached from other machines it wants the token that only the person who started it has seen.
  await shown("token", ["run", "--no-pictures"], "lesson_2x2.yaml", "0.0.0.0:0", async (page, url) => {
    const bare = url.replace(/\?.*/, "");
    const refused = await page.goto(bare);
    check(refused.status() === 401, `without a token: ${refused.status()}`);
    await page.goto(url);
    check(!page.url().includes("token"), `the token stays in the address: ${page.url()}`);
    await page.waitForFunction(() => document.querySelector("#plan")?.dataset.tiles === "16", null, { timeout: 20_000 });
    page.errors.splice(0, page.errors.length, ...page.errors.filter((error) => !error.includes("401")));  // the first try
    check(!(await page.evaluate(() => document.cookie)).includes("sensotwin"), "a script can read the token");
  });

  // Started again it has another token, which the page cannot know: it says what to do.
  const lesson = (name, address) => start(twin, ["run", join(root, "scenes/lesson_2x2.yaml"), "--no-pictures", `--monitor=${address}`, "--out", join(out, name)], /monitor at (http\S+)/);
  const until16 = (page) => page.waitForFunction(() => document.querySelector("#plan")?.dataset.tiles === "16", null, { timeout: 20_000 });
  const before = await lesson("token_before", "0.0.0.0:0");
  const page = await browser.page();
  await page.goto(before.match[1].replace("0.0.0.0", "127.0.0.1"));
  await until16(page);
  before.child.kill("SIGINT");
  await before.ended;
  const after = await lesson("token_after", `0.0.0.0:${new URL(before.match[1]).port}`);
  await untilState(page, "^Another run: open the address that it printed$");
  await page.goto(after.match[1].replace("0.0.0.0", "127.0.0.1"));
  await until16(page);
  after.child.kill("SIGINT");
  await after.ended;
  console.log("hallways, ceiling tags, a served scene and the token");
} finally {
  await browser.close();
}
