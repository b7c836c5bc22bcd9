// Answers to the open questions about a recording. They are stored by the hash of its contents. If a scene gets another recording, the
// answers about the former one are removed.

const KEPT = "gaitcam-answers";
const MOST = 40;
// Keys of `gait` that describe how a recording is read, and the key that accepts the interpretation.
const READER = ["time", "force", "unit", "rate", "mass", "kind", "period", "span", "noise"];
const OWN = [...READER, "accept"];

let all = null;
function kept() {
  try { all ??= JSON.parse(localStorage.getItem(KEPT)); } catch { /* A private window stores nothing. */ }
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

// Reading options of the recording in the scene.
export const options = (fields) => texts(fields, READER);

const hashOf = (version) => version?.files[version.recording?.file];

// Stores the answers about the recording of a version.
export function remember(version, fields) {
  const hash = hashOf(version);
  if (!hash || version.pending.length > 0 || version.recording.cycle) return;
  const { feet } = kept()[hash] ?? {};
  const read = version.recording.options ?? options(fields);
  keep(hash, { ...read, ...texts(fields, ["accept"]), ...feet ? { feet } : {} });
}

// Stores the feet that the user has selected for the recording of a version. Feet that the scene sets for another reason are not stored.
export function chosen(version, key, value) {
  const hash = hashOf(version);
  if (hash && key === "gait.feet") keep(hash, { ...kept()[hash], feet: value });
}

// Changes of a scene that gets a recording: sets the stored answers about this recording and removes those about the former one.
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

// Name of a file as the name of a scene: letters, digits, - and _.
export const stem = (file) => file.replace(/\.[^.]*$/, "").replace(/[^\p{L}\p{N}_-]+/gu, "_").replace(/^_+|_+$/g, "").slice(0, 60);

let scenes = new Set();
export function load(names) {
  scenes = new Set(names);
}

// Name of the scene with a recording; null if the user has named the scene.
export function nameFor(file, version) {
  const isOwn = version.name && !scenes.has(version.name) && version.name !== stem(version.recording?.file ?? "");
  return isOwn ? null : stem(file) || null;
}
