// SPDX-License-Identifier: MIT
// A real browser for tests of pages: Debian's chromium, driven by playwright-core. Packages are those that script/pages
// installed into the build folder.
import { createRequire } from "node:module";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";

/** This machine cannot run the test: ctest counts 77 as skipped. */
export function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(77);
}

/** Stops the test with a reason unless `condition`. */
export function check(condition, reason) {
  if (!condition) {
    throw new Error(reason);
  }
}

/** \param pages  the folder that script/pages built in */
export async function openBrowser(pages) {
  const home = resolve(pages, "robot/telemetry/pages");
  const chromium = ["/usr/bin/chromium", "/usr/bin/chromium-browser"].find(existsSync);
  if (!existsSync(join(home, "node_modules/playwright-core"))) {
    skip(`playwright-core is not there: script/pages --into ${pages}`);
  }
  if (!chromium) {
    skip("chromium is not there");
  }
  const require = createRequire(join(home, "package.json"));
  const playwright = require("playwright-core");
  const profile = mkdtempSync(join(tmpdir(), "sensotwin-browser-"));
  const flags = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"];
  const context = await playwright.chromium.launchPersistentContext(profile, {
    executablePath: chromium, headless: true, args: flags, viewport: { width: 1440, height: 900 },
  });
  const axe = require("axe-core").source;
  return {
    context,
    /** A page, and `errors` that it met. With `touch` it is on a phone of 390 by 844 points, 2 pixels each. */
    async page(options = {}) {
      const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };
      const page = await (options.touch ? await context.browser().newContext(phone) : context).newPage();
      const errors = [];
      page.on("pageerror", (error) => errors.push(String(error)));
      // A page without an icon of its own, as that of a refusal, makes the browser ask for one when it likes.
      const ofIcon = (message) => message.location().url.endsWith("/favicon.ico");
      page.on("console", (message) => message.type() === "error" && !ofIcon(message) && errors.push(message.text()));
      if (options.viewport) {
        await page.setViewportSize(options.viewport);
      }
      await page.emulateMedia({ colorScheme: options.colorScheme ?? "light", reducedMotion: options.reducedMotion ?? "no-preference" });
      return Object.assign(page, { errors });
    },
    /** What axe-core finds wrong with a page, one line for each. */
    async violations(page) {
      await page.evaluate(axe);
      const result = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
      return result.violations.flatMap((found) => found.nodes.map((node) => `${found.id}: ${node.html}: ${node.failureSummary}`));
    },
    async close() {
      await context.close();
      rmSync(profile, { recursive: true, force: true });
    },
  };
}

/** Starts a program and waits until a line of its stderr matches. \returns the process, the match, and the lines so far */
export async function start(program, args, pattern, options = {}) {
  const child = spawn(program, args, { stdio: ["ignore", "ignore", "pipe"], ...options });
  process.on("exit", () => child.kill("SIGKILL"));  // however the test ends
  const lines = [];
  const ended = new Promise((done) => child.on("exit", (code) => done(code)));
  const match = await new Promise((done, fail) => {
    createInterface({ input: child.stderr }).on("line", (line) => {
      lines.push(line);
      const found = pattern.exec(line);
      if (found) {
        done(found);
      }
    });
    ended.then((code) => fail(new Error(`${program} ended with ${code}:\n${lines.join("\n")}`)));
  });
  return { child, match, lines, ended };
}
