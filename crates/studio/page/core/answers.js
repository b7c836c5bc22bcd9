// The answers to the questions of a recording's reader belong to the recording: they are kept by the hash of its contents,
// and a scene that gets another recording loses those of the former one.

const KEPT = "gaitcam-answers";
const MOST = 40;
// Keys of `gait` that say how a recording is read, and the one that accepts what the reader has found.
const READER = ["time", "force", "unit", "rate", "mass", "kind", "period", "span", "noise"];
const OWN = [...READER, "accept"];

let all = null;
function kept() {
  try { all ??= JSON.parse(localStorage.getItem(KEPT)); } catch { /* private windows keep nothing */ }
  all ??= {};
  return all;
}

function keep(hash, answers) {
  const before = kept();
  if (JSON.stringify(before[hash] ?? {}) === JSON.stringify(answers)) return;
  const others = Object.entries(before).filter(([other]) => other !== hash);
  all = Object.fromEntries([...others, [hash, answers]].slice(-MOST));
  try { localStorage.setItem(KEPT, JSON.stringify(all)); } catch { /* as above */ }
}

const texts = (fields, keys) => Object.fromEntries(keys.map((key) => [key, fields[`gait.${key}`]?.text ?? ""]).filter(([, text]) => text));

// How the scene reads its recording.
export const options = (fields) => texts(fields, READER);

const hashOf = (version) => version?.files[version.recording?.file];

// Keeps the answers of a version's recording.
export function remember(version, fields) {
  const hash = hashOf(version);
  if (!hash || version.pending.length > 0 || version.recording.cycle) return;
  const { feet } = kept()[hash] ?? {};
  const read = version.recording.options ?? options(fields);
  keep(hash, { ...read, ...texts(fields, ["accept"]), ...feet ? { feet } : {} });
}

// An answer that the user has chosen for the recording of a version: the feet are otherwise a wish of the scene.
export function chosen(version, key, value) {
  const hash = hashOf(version);
  if (hash && key === "gait.feet") keep(hash, { ...kept()[hash], feet: value });
}

// The changes of a scene that gets a recording: the answers kept for this one, and none of the former one.
export function changesFor(hash, version, fields) {
  const next = kept()[hash] ?? {};
  const former = kept()[hashOf(version)] ?? {};
  const waiting = new Set(version.pending.flatMap((p) => p.keys));
  const present = (key) => fields[`gait.${key}`]?.text ?? "";
  const changes = OWN.filter((key) => next[key] || present(key) || waiting.has(`gait.${key}`)).map((key) => [key, next[key] ?? ""]);
  const feet = next.feet ?? (former.feet && former.feet === present("feet") ? "" : null);
  if (feet !== null) changes.push(["feet", feet]);
  return changes.map(([key, value]) => ({ set: { key: `gait.${key}`, value } }));
}

// A file's name as the name of a scene: letters, digits, - and _.
export const stem = (file) => file.replace(/\.[^.]*$/, "").replace(/[^\p{L}\p{N}_-]+/gu, "_").replace(/^_+|_+$/g, "").slice(0, 60);

let scenes = new Set();
export function load(names) {
  scenes = new Set(names);
}

// The name of the scene with a recording; null where the user has named the scene.
export function nameFor(file, version) {
  const isOwn = version.name && !scenes.has(version.name) && version.name !== stem(version.recording?.file ?? "");
  return isOwn ? null : stem(file) || null;
}
