// SPDX-License-Identifier: MIT
// Builds each page to a bundle of one HTML, one script and one style sheet, with no name that changes from build to
// build: what lies in bundle/ is committed and embedded into the programs.
import { existsSync } from "node:fs";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "vite";

const here = dirname(fileURLToPath(import.meta.url));
const project = resolve(here, "../../..");

const pages = [
  { name: "monitor", source: resolve(here, "monitor"), bundle: resolve(here, "bundle") },
  {
    name: "trace",
    source: resolve(project, "twin/trace/page"),
    bundle: resolve(project, "twin/trace/page/bundle"),
  },
];

for (const { name, source, bundle } of pages) {
  if (!existsSync(resolve(source, `${name}.html`))) {
    continue;
  }
  await build({
    configFile: false,
    root: source,
    base: "./",
    logLevel: "warn",
    publicDir: false,
    build: {
      outDir: bundle,
      emptyOutDir: true,
      target: "es2022",
      modulePreload: false,
      cssCodeSplit: false,
      assetsInlineLimit: 0,
      chunkSizeWarningLimit: 1000,
      rollupOptions: {
        input: resolve(source, `${name}.html`),
        output: {
          entryFileNames: `${name}.js`,
          assetFileNames: `${name}[extname]`,
          codeSplitting: false,
        },
      },
    },
  });
}
