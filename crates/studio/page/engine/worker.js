// Engine in a worker. It first receives the compiled module, then one request or file at a time.

/** @type {any} */
let engine = null;
/** @type {any} */
const post = postMessage;

// Some libraries of the module import functions of browsers. These functions are never called during a design, so they are replaced by
// empty ones.
function imports(module) {
  const all = { env: { seconds: () => performance.now() / 1000 } };
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    all[from] ??= {};
    all[from][name] ??= () => 0;
  }
  return all;
}

function given(bytes) {
  const at = engine.room(bytes.length);
  new Uint8Array(engine.memory.buffer, at, bytes.length).set(bytes);
  return at;
}

function taken(at) {
  const length = new DataView(engine.memory.buffer).getUint32(at, true);
  const bytes = new Uint8Array(engine.memory.buffer, at + 4, length).slice();
  engine.free(at);
  return bytes;
}

onmessage = async ({ data: { module, route, text, bytes } }) => {
  try {
    if (module) engine = new WebAssembly.Instance(module, imports(module)).exports;
    else if (bytes) post({ hash: new TextDecoder().decode(taken(engine.keep(given(bytes)))) });
    else {
      const answer = taken(engine.ask(given(new TextEncoder().encode(`${route}\n${text}`))));
      post({ answer }, [answer.buffer]);
    }
  } catch (error) {
    post({ broken: String(error) });
  }
};
