import "./browser.js";
import { test } from "node:test";
import { deepEqual, equal, rejects } from "node:assert/strict";
import { Lane } from "../../page/engine/wasm.js";

// Workers of which each does as told: "answer", "silent", "fail".
function workers(...manners) {
  const all = [];
  const begun = async () => {
    const manner = manners[all.length] ?? "answer";
    const worker = {
      ended: false,
      terminate() { this.ended = true; },
      postMessage(message) {
        if (manner === "answer") setTimeout(() => this.onmessage({ data: { answer: message } }));
        if (manner === "fail") setTimeout(() => this.onerror({ message: "out of memory" }));
      },
    };
    all.push(worker);
    return worker;
  };
  return { all, begun };
}

test("a worker that is silent too long is ended, and the next question begins another one", async () => {
  const { all, begun } = workers("silent", "answer");
  const lane = new Lane(begun, 20);
  deepEqual(await lane.ask("a"), { broken: "no answer" });
  equal(all[0].ended, true);
  deepEqual(await lane.ask("b"), { answer: "b" });
});

test("a worker that fails says why, and the question behind it is answered", async () => {
  const { begun } = workers("fail", "answer");
  const lane = new Lane(begun, 1000);
  const [first, second] = await Promise.all([lane.ask("a"), lane.ask("b")]);
  deepEqual([first, second], [{ broken: "out of memory" }, { answer: "b" }]);
});

test("a question that is given up ends the worker that works on it, one that waits ends none", async () => {
  const { all, begun } = workers("silent", "answer");
  const lane = new Lane(begun, 1000);
  const [busy, waiting] = [new AbortController(), new AbortController()];
  const first = lane.ask("a", busy.signal);
  const second = lane.ask("b", waiting.signal);
  waiting.abort();
  await rejects(second);
  await new Promise((resolve) => setTimeout(resolve, 5));
  equal(all[0].ended, false);
  busy.abort();
  await rejects(first);
  equal(all[0].ended, true);
});
