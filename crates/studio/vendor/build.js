// Joins the libraries of the page to one file: `npm run vendor`, or `npm run vendor -- --check` to compare it with the one there.

import { readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const OUT = new URL("../page/core/vendor.js", import.meta.url);
const ABOUT = "// @ts-nocheck\n/* Made by `npm run vendor` from crates/studio/vendor/libraries.js. lit-html: BSD-3-Clause, Google LLC. fflate: MIT, Arjun Barrett. gifenc: MIT, Matt DesLauriers. uqr: MIT, Anthony Fu. */";

const options = { entryPoints: ["vendor/libraries.js"], bundle: true, format: "esm", minify: true, legalComments: "inline", write: false };
const { outputFiles: [{ text }] } = await build({ ...options, banner: { js: ABOUT } });
if (!process.argv.includes("--check")) await writeFile(OUT, text);
else if (await readFile(OUT, "utf8") !== text) throw new Error("core/vendor.js is not what `npm run vendor` makes");
