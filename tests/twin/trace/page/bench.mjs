// SPDX-License-Identifier: MIT
// A `twin trace` of its own, a browser on its page, and hands for both.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";

export const twinProgram = process.env["TWIN"];
const require = createRequire(join(process.env["PAGES_PACKAGES"] ?? ".", "package.json"));
const { chromium } = require("playwright-core");
const axeScript = require.resolve("axe-core/axe.min.js");

export const flags = [
  "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync",
];

/** Runs `twin` to its end. \returns its exit code and what it printed */
export function twin(...words) {
  return new Promise((ended) => {
    const child = spawn(twinProgram, words, { stdio: ["ignore", "pipe", "pipe"] });
    let out = "";
    let said = "";
    child.stdout.on("data", (data) => (out += data));
    child.stderr.on("data", (data) => (said += data));
    child.on("exit", (code) => ended({ code, out, said }));
  });
}

export class Bench {
  /** \param size  of the window  \param words  behind `twin trace` */
  static async begin({ plan = [], size = { width: 1400, height: 900 }, dark = false } = {}) {
    const bench = new Bench();
    bench.folder = mkdtempSync(join(tmpdir(), "trace-page-"));
    bench.profile = mkdtempSync(join(tmpdir(), "trace-browser-"));
    bench.server = spawn(twinProgram, ["trace", ...plan, "--out", bench.folder, "--quiet"], { stdio: ["ignore", "pipe", "inherit"] });
    bench.ended = new Promise((gone) => bench.server.on("exit", (code) => gone(code)));
    bench.url = await new Promise((found) => bench.server.stdout.once("data", (data) => found(String(data).trim())));
    bench.browser = await chromium.launchPersistentContext(bench.profile, {
      executablePath: process.env["CHROMIUM"], args: flags, viewport: size, colorScheme: dark ? "dark" : "light",
    });
    bench.page = bench.browser.pages()[0] ?? (await bench.browser.newPage());
    bench.errors = [];
    bench.page.on("pageerror", (error) => bench.errors.push(error.message));
    bench.page.on("console", (line) => line.type() === "error" && !line.text().includes("status of 4") && bench.errors.push(line.text()));
    await bench.page.goto(bench.url);
    await bench.quiet();
    return bench;
  }
  async end() {
    await this.browser.close();
    this.server.kill("SIGINT");
    const code = await this.ended;
    rmSync(this.folder, { recursive: true, force: true });
    rmSync(this.profile, { recursive: true, force: true });
    return code;
  }

  /** Until the server's word on the last stroke is on the page. */
  async quiet() {
    await this.page.waitForTimeout(350);
    await this.page.waitForLoadState("networkidle");
    await this.page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
  }
  async tool(label) {
    await this.page.getByRole("toolbar", { name: "Tools" }).getByRole("button", { name: label, exact: true }).click();
  }
  /** Where a point of the plan is on the screen, as the status line tells it under the mouse. */
  async calibrate() {
    const box = await this.page.locator("canvas").boundingBox();
    const at = [];
    for (const [u, v] of [[0.3, 0.3], [0.7, 0.7]]) {
      const x = box.x + Math.round(box.width * u);
      const y = box.y + Math.round(box.height * v);
      await this.page.mouse.move(x, y);
      const [px, py] = (await this.page.locator("footer .where").textContent()).match(/-?[\d.]+/g).map(Number);
      at.push({ x, y, px, py });
    }
    const [a, b] = at;
    const scale = (b.x - a.x) / (b.px - a.px);
    this.toScreen = (px, py) => ({ x: a.x + (px - a.px) * scale, y: a.y - (py - a.py) * scale });
    return scale;
  }
  async drag(from, to, steps = 6) {
    const a = this.toScreen(...from);
    const b = this.toScreen(...to);
    await this.page.mouse.move(a.x, a.y);
    await this.page.mouse.down();
    await this.page.mouse.move(b.x, b.y, { steps });
    await this.page.mouse.up();
  }
  async click(at) {
    const p = this.toScreen(...at);
    await this.page.mouse.click(p.x, p.y);
  }
  async said() {
    return this.page.locator("footer .said").textContent();
  }
  async verdict() {
    await this.quiet();
    return this.page.locator(".problems [role=status]").textContent();
  }
  field(label) {
    return this.page.getByLabel(label, { exact: true });
  }
  async fill(label, value) {
    await this.field(label).fill(value);
    await this.field(label).press("Tab");
  }
  /** What axe-core finds, as "rule: target". */
  async violations() {
    await this.page.addScriptTag({ path: axeScript }).catch(() => this.page.evaluate(require("node:fs").readFileSync(axeScript, "utf8")));
    const result = await this.page.evaluate(async () => {
      const found = await globalThis.axe.run(document, { resultTypes: ["violations"] });
      return found.violations.flatMap((rule) => rule.nodes.map((node) => `${rule.id}: ${node.target} ${node.failureSummary}`));
    });
    return result;
  }
}
