// SPDX-License-Identifier: MIT
// sensobot_maps.mjs TWIN PAGES OUT ROOT SENSOBOT: the page of a `sensobot run` that maps a corner through a pcscd of its own:
// every tile, its tag's number, and the floor as the robot found it.
import { spawn, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, openSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { check, openBrowser, skip, start } from "../../robot/telemetry/browser.mjs";
import { countOfColour, served, telemetry, until, untilEvent, untilState } from "./served.mjs";

const [twin, pages, out, root, sensobot, inside] = process.argv.slice(2);
const driver = "/usr/lib/pcsc/drivers/serial/libifdvpcd.so";
if (!existsSync("/usr/sbin/pcscd") || !existsSync(driver)) {
  skip("pcscd or vsmartcard-vpcd is not installed");
}
if (inside === undefined) {
  // A /run of its own, so that no pcscd of this machine is in the way.
  const [flags] = [["--mount"], ["--map-root-user", "--mount"]].filter((each) => spawnSync("unshare", [...each, "true"]).status === 0);
  if (!flags) {
    skip("no mount namespace to be had");
  }
  const run = spawnSync("unshare", [...flags, process.execPath, ...process.argv.slice(1), "inside"], { stdio: "inherit" });
  process.exit(run.status ?? 1);
}
rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const browser = await openBrowser(pages);  // before /run is empty

function beginCardService() {
  check(spawnSync("mount", ["-t", "tmpfs", "none", "/run"]).status === 0, "no /run of its own");
  mkdirSync("/run/pcscd");
  const port = 20000 + (process.pid % 20000);
  const hex = port.toString(16);
  const config = join(out, "reader.conf");
  writeFileSync(config, `FRIENDLYNAME "Virtual PCD"\nDEVICENAME /dev/null:0x${hex}\nLIBPATH ${driver}\nCHANNELID 0x${hex}\n`);
  const log = openSync(join(out, "pcscd.log"), "w");
  const child = spawn("/usr/sbin/pcscd", ["--foreground", "--config", config], { stdio: ["ignore", log, log] });
  process.on("exit", () => child.kill("SIGKILL"));
  return { child, port };
}

const cards = beginCardService();
try {
  await until(() => existsSync("/run/pcscd/pcscd.comm"), "pcscd");
  const wires = await served(twin, join(root, "tests/twin/sensobot/corner.yaml"), join(out, "served"), ["--rtf", "2", "--wait-for-cards", "--vpcd", `127.0.0.1:${cards.port}`]);
  // pcscd looks at a virtual reader every 0.4 s of real time.
  const told = readFileSync(wires.robot, "utf8").replace(/(\n  floor_reader:\n(?:    .*\n)*)/, (section) =>
    section.replace(/(notice_delay_s:).*/, "$1 0.2").replace(/(notice_sigma_s:).*/, "$1 0.115"));
  writeFileSync(wires.robot, told);
  const run = await start(sensobot, ["run", wires.robot, "--devices", wires.devices, "--rate", "2", "--out", join(out, "run"), "--monitor=127.0.0.1:0"], /monitor at (http\S+)/);
  const page = await browser.page();
  await page.goto(run.match[1]);
  await untilEvent(page, "Device there: the floor reader");
  await page.waitForFunction(() => document.querySelector("#plan").dataset.tiles === "4", null, { timeout: 120_000 });
  const tiles = (await telemetry(run.match[1])).filter((each) => each.k === "tile" && each.tag);
  await page.getByRole("button", { name: "Next tag" }).click();
  await page.waitForFunction(() => document.querySelector(".tag-title").textContent.startsWith("Floor tag, column"));
  const number = /E0[0-9A-F]{14}/.exec(await page.locator('section[aria-label="Tag"]').textContent());
  check(tiles.some((tile) => tile.tag === number?.[0]), `the page's tag is ${number}, none of ${tiles.map((tile) => tile.tag)}`);

  // Ended and gone: every tile closed, as tiles.csv has them.
  check((await run.ended) === 0, `sensobot ended with ${await run.ended}:\n${run.lines.join("\n")}`);
  await untilState(page, "^Run ended, waiting for the next$");
  check(/^4 tiles/.test(await page.locator(".big").first().textContent()), "the page does not count four tiles");
  const mapped = readFileSync(join(out, "run", "tiles.csv"), "utf8").trim().split("\n").slice(1);
  check(mapped.length === 4 && tiles.every((tile) => mapped.some((line) => line.includes(tile.tag))), `tiles.csv and the page differ:\n${mapped.join("\n")}`);
  await page.screenshot({ path: join(out, "mapped.png") });
  const corners = tiles.map((tile) => ({ x: (tile.c + 0.35) * 0.508, y: (tile.w - 0.4) * 0.508 }));
  check((await countOfColour(page, corners, [0x56, 0x61, 0x6e])) === 4, "not all tiles are drawn as closed");
  check(page.errors.every((error) => /ERR_CONNECTION_REFUSED|ERR_INCOMPLETE_CHUNKED|ERR_EMPTY/.test(error)), page.errors.join("\n"));
  wires.child.kill("SIGINT");
  console.log("four tiles and their tags, on the page as in tiles.csv");
} finally {
  cards.child.kill("SIGTERM");
  await browser.close();
}
