// SPDX-License-Identifier: MIT
// A `twin trace` of its own, a page on it in the common browser, and hands for both.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test, { after } from "node:test";
import { openBrowser } from "../../../robot/telemetry/browser.mjs";

const [program, pages, pictures] = process.argv.slice(2);
export const browser = await openBrowser(pages);
after(() => browser.close());

/** Runs `twin` to its end. \returns its exit code and what it said */
export function twin(...words) {
  return new Promise((ended) => {
    const child = spawn(program, words, { stdio: ["ignore", "ignore", "pipe"] });
    let said = "";
    child.stderr.on("data", (data) => (said += data));
    child.on("exit", (code) => ended({ code, said }));
  });
}

export class Bench {
  /** \param plan  words behind `twin trace`  \param size  of the window */
  static async begin({ plan = [], size = { width: 1400, height: 900 }, dark = false } = {}) {
    const bench = new Bench();
    bench.folder = mkdtempSync(join(tmpdir(), "trace-page-"));
    bench.server = spawn(program, ["trace", ...plan, "--out", bench.folder, "--quiet"], {
      stdio: ["ignore", "pipe", "inherit"],
    });
    bench.ended = new Promise((gone) => bench.server.on("exit", (code) => gone(code)));
    const url = await new Promise((found) => bench.server.stdout.once("data", (data) => found(String(data).trim())));
    bench.page = await browser.page({ viewport: size, colorScheme: dark ? "dark" : "light" });
    bench.page.setDefaultTimeout(60000);
    try {
      await bench.page.goto(url);
      await bench.quiet();
    } catch (error) {
      await bench.end();
      throw error;
    }
    return bench;
  }
  /** \returns the exit code of Ctrl-C */
  async end() {
    await this.page.close();
    this.server.kill("SIGINT");
    const code = await this.ended;
    rmSync(this.folder, { recursive: true, force: true });
    return code;
  }
  /** What went wrong in the page; refusals that a test asks for (status 4xx) are none. */
  get errors() {
    return this.page.errors.filter((line) => !line.includes("the server responded with a status of 4"));
  }

  /** Until the server's word on the last stroke is on the page, and drawn. */
  async quiet() {
    await this.page.waitForTimeout(60);
    await this.page.locator('.problems[aria-busy="false"]').waitFor();
    await this.page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
  }
  async tool(label) {
    await this.page.getByRole("toolbar", { name: "Tools" }).getByRole("button", { name: label, exact: true }).click();
  }
  async press(label) {
    await this.page.getByRole("button", { name: label, exact: true }).click();
  }
  /** Until the line at the bottom says so: it does when the answer has come. */
  async says(start) {
    await this.page.locator("footer .said", { hasText: start }).waitFor();
  }
  async said() {
    return this.page.locator("footer .said").textContent();
  }
  /** Where a point of the plan is on the screen, as the status line tells it under the mouse. */
  async calibrate() {
    const box = await this.page.locator("canvas").boundingBox();
    const at = [];
    for (const [u, v] of [
      [0.3, 0.3],
      [0.7, 0.7],
    ]) {
      const x = box.x + Math.round(box.width * u);
      const y = box.y + Math.round(box.height * v);
      await this.page.mouse.move(x, y);
      const [px, py] = (await this.page.locator("footer .where").textContent()).match(/-?[\d.]+/g).map(Number);
      at.push({ x, y, px, py });
    }
    const [a, b] = at;
    const scale = (b.x - a.x) / (b.px - a.px);
    this.toScreen = (px, py) => ({ x: a.x + (px - a.px) * scale, y: a.y - (py - a.py) * scale });
  }
  async drag(from, to) {
    const a = this.toScreen(...from);
    const b = this.toScreen(...to);
    await this.page.mouse.move(a.x, a.y);
    await this.page.mouse.down();
    await this.page.mouse.move(b.x, b.y, { steps: 6 });
    await this.page.mouse.up();
  }
  async click(at) {
    const p = this.toScreen(...at);
    await this.page.mouse.click(p.x, p.y);
  }
  async verdict() {
    await this.quiet();
    return this.page.locator(".problems [role=status]").textContent();
  }
  /** The list's row of a place. */
  place(name) {
    return this.page.locator("#panel .list .item", { has: this.page.locator(`b:text-is("${name}")`) });
  }
  field(label) {
    return this.page.getByLabel(label, { exact: true });
  }
  async fill(label, value) {
    await this.field(label).fill(value);
    await this.field(label).press("Tab");
  }
  async call(name) {
    await this.page.locator("#name").fill(name);
    await this.page.locator("#name").press("Tab");
  }
  async tab(name) {
    await this.page.getByRole("tab", { name }).click();
  }
}

/** A test with a server and a page of its own, which end with it. */
export function onThePage(name, how, body) {
  test(name, async () => {
    const bench = await Bench.begin(how);
    let code = 0;
    try {
      await body(bench);
      assert.deepEqual(bench.errors, []);
    } finally {
      code = await bench.end();
    }
    assert.equal(code, 130, "Ctrl-C ends it as docs/cli.md says");
  });
}

export async function picture(bench, name) {
  if (pictures) {
    mkdirSync(pictures, { recursive: true });
    await bench.page.mouse.move(700, 20);
    await bench.quiet();
    await bench.page.screenshot({ path: join(pictures, `${name}.png`) });
  }
}
export function saved(bench, name) {
  return readFileSync(join(bench.folder, name), "utf8");
}
export async function runs(bench, name) {
  const run = await twin(
    "run",
    join(bench.folder, `${name}.scene.yaml`),
    "--out",
    join(bench.folder, "run"),
    "--no-pictures",
    "--quiet",
  );
  const summary = JSON.parse(saved(bench, "run/summary.json"));
  assert.equal(run.code, 0, `${run.said} ${JSON.stringify(summary.expect)}`);
  return summary;
}
/** Until the reader of scenes takes what is drawn. */
export async function sceneTaken(bench, words = "") {
  await bench.page.locator("#panel .good", { hasText: `takes this scene.${words}` }).waitFor();
}
