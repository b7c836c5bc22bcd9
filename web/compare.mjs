// Compares the engine of the page with the command: every number of summary.json for the built-in scenes, with a tolerance of 1e-9.
//
//     node web/compare.mjs web/dist target/release/gaitcam

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { runInThisContext } from "node:vm";
import { gunzipSync } from "node:zlib";

const [dist, command] = process.argv.slice(2);
const TOLERANCE = 1e-9;
// The difference of angles, fractions of a weight and residuals of a solver is relative to 1 (rad, weight, unit of the objective). The
// difference of all other numbers is relative to the number itself, but at least to a picometre.
const TO_ONE = /(_rad|load_factors\.\d+\.(target|achieved)|(duality|relative|global)_gap|stationarity|violation)$/;
const NOTHING = 1e-12;
// Numbers within a sentence belong to the certificate and are ignored.
const NUMBERS = /[-+]?\d[\d.]*(e[-+]?\d+)?/g;
// Durations, which are ignored.
const CLOCK = /(^|\.)(timing|time|solve_s|total_s|seconds)/;
const RECORDING = "data/recordings/made_walk.csv";

// Worker of the page, run as in a browser.
let said = null;
globalThis.postMessage = (data) => said(data);
runInThisContext(readFileSync(join(dist, "engine/worker.js"), "utf8"));
const tell = (data) => new Promise((resolve) => { said = resolve; globalThis.onmessage({ data }); });
const module = new WebAssembly.Module(gunzipSync(readFileSync(join(dist, "engine/whole.wasm.gz"))));
globalThis.onmessage({ data: { module } });
await new Promise((resolve) => setTimeout(resolve, 200));

async function ask(route, question) {
  const { answer, broken } = await tell({ route, text: JSON.stringify(question) });
  if (broken) throw new Error(`${route}: ${broken}`);
  return Buffer.from(answer);
}

const plain = (x) => (typeof x === "string" ? x.replace(NUMBERS, "#").replace(/.*\/(?=data\/)/, "") : x);

function differences(a, b, path = "", out = []) {
  if (CLOCK.test(path)) return out;
  if (typeof a === "number" && typeof b === "number") {
    const share = Math.abs(a - b) / Math.max(Math.abs(a), Math.abs(b), TO_ONE.test(path) ? 1 : NOTHING);
    out.count = (out.count ?? 0) + 1;
    out.largest = Math.max(out.largest ?? 0, share);
    if (share > TOLERANCE) out.push(`${path}: ${a} and ${b}`);
  } else if (a && b && typeof a === "object" && typeof b === "object") {
    for (const key of new Set([...Object.keys(a), ...Object.keys(b)])) differences(a[key], b[key], path ? `${path}.${key}` : key, out);
  } else if (plain(a) !== plain(b)) out.push(`${path}: ${JSON.stringify(a)} and ${JSON.stringify(b)}`);
  return out;
}

const { scenes } = JSON.parse(await ask("start", {}));
const folder = mkdtempSync(join(tmpdir(), "gaitcam-compare-"));
const { hash } = await tell({ bytes: readFileSync(RECORDING) });
let [faults, numbers, largest] = [0, 0, 0];
for (const { name, toml } of scenes) {
  const waits = name === "measured_walk";
  const text = waits ? JSON.parse(await ask("read", { scene: toml, changes: [{ set: { key: "gait.file", value: RECORDING } }], files: [{ name: RECORDING, hash }] })).scene : toml;
  const began = performance.now();
  const file = await ask("export", { scene: text, name: "summary.json", files: waits ? [{ name: RECORDING, hash }] : [] });
  const took = performance.now() - began;
  const own = JSON.parse(file.subarray(file.indexOf(10) + 1));
  const out = join(folder, name);
  try {
    execFileSync(command, ["synth", name, ...(waits ? ["--set", `gait.file=${RECORDING}`] : []), "--out", out], { stdio: "ignore" });
  } catch (error) {
    if (error.status !== 3) throw error;
  }
  const found = differences(JSON.parse(readFileSync(join(out, "summary.json"))), own);
  console.log(`${name.padEnd(32)} ${String(found.count).padStart(4)} numbers, largest difference ${(found.largest ?? 0).toExponential(1)}, ${took.toFixed(0)} ms`);
  for (const line of found.slice(0, 8)) console.log(`    ${line}`);
  [faults, numbers, largest] = [faults + found.length, numbers + found.count, Math.max(largest, found.largest)];
}
rmSync(folder, { recursive: true });
console.log(`${scenes.length} scenes, ${numbers} numbers, largest relative difference ${largest.toExponential(1)}`);
process.exit(faults > 0 || scenes.length < 25 ? 1 : 0);
