"""State of the page compared with a reference model: random edits, rejections, undo, redo, drops, pins, reloads in two tabs.

GAITCAM_STEPS=10000 for the long run; GAITCAM_SEED for another one."""

import copy
import hashlib
import math
import os
import random
import time
import unittest

from studio import Browser, Server

STEPS = int(os.environ.get("GAITCAM_STEPS", "150"))
SEED = int(os.environ.get("GAITCAM_SEED", "1"))
GOOD = {
    "limits.stroke": ["61 mm", "62 mm", "64 mm", "70 mm"],
    "limits.curvature": ["4 mm", "5 mm", "6 mm"],
    "cam.bore": ["10 mm", "11 mm", "12 mm"],
    "drive.speed": ["auto", "11.6 rad/s"],
    "gait.body_weight": ["650 N", "700 N", "720 N"],
}
# A value with a wrong dimension, and one that only the load model rejects.
REFUSED = {**{key: ["5 kg", "3 parsec"] for key in GOOD}, "gait.step_frequency": ["4.2 Hz"]}
START = {"limits.stroke": "60 mm", "limits.curvature": "5 mm", "cam.bore": "12 mm", "drive.speed": "auto", "gait.body_weight": "700 N", "gait.step_frequency": "1.85 Hz"}
OF_MODEL = ["gait.body_weight", "gait.step_frequency"]
# Different forces with the same name.
FILES = [
    "# critical points, period_s = 0.54\ntime_s,force_n\n" + "".join(f"{0.0135 * k:.4f},{700 + 40 * (i + 2) * math.sin(math.tau * k / 40):.3f}\n" for k in range(40))
    for i in range(3)
]
WEIGHTS = {"edit": 40, "refuse": 14, "undo": 16, "redo": 12, "drop": 6, "pin": 3, "reload": 1}

SETTLED = """async () => {
    const design = document.querySelector("#design");
    const end = performance.now() + 20000;
    const turn = () => new Promise((resolve) => setTimeout(resolve, 4));
    await turn();
    while (design.getAttribute("aria-busy") !== "false" && performance.now() < end) await turn();
    await turn();
    const fields = {};
    for (const key of KEYS) fields[key] = document.querySelector(`input[name="${key}"]`).value;
    return {
        fields,
        verdict: document.querySelector("#verdict").dataset.verdict === "pending",
        dimmed: design.classList.contains("stale"),
        hash: design.dataset.forceHash,
        undo: !document.querySelector("#undo").disabled,
        redo: !document.querySelector("#redo").disabled,
        invalid: [...document.querySelectorAll('#values [aria-invalid="true"]')].map((e) => e.name),
    };
}""".replace("KEYS", str(list(START)))


class Reference:
    """Expected state of a page."""

    def __init__(self):
        self.versions = [{"values": dict(START), "refused": {}, "force": ""}]
        self.at = 0
        self.pins = 0

    @property
    def now(self):
        return self.versions[self.at]

    def push(self, change):
        version = copy.deepcopy(self.now)
        change(version)
        self.versions = [*self.versions[: self.at + 1], version]
        self.at += 1

    def edit(self, key, value):
        self.push(lambda v: (v["values"].update({key: value}), v["refused"].pop(key, None)))

    def refuse(self, key, value):
        self.push(lambda v: v["refused"].update({key: value}))

    def drop(self, text):
        # A recording replaces the load model and its keys.
        left = dict.fromkeys(OF_MODEL, "")
        self.push(lambda v: (v["values"].update(left), v.update(force=hashlib.sha256(text.encode()).hexdigest())))

    def shown(self):
        now = self.now
        return {
            "fields": {**now["values"], **now["refused"]},
            "verdict": bool(now["refused"]),
            "dimmed": bool(now["refused"]),
            "undo": self.at > 0,
            "redo": self.at + 1 < len(self.versions),
        }


class Tab:
    """A page with its reference model."""

    def __init__(self, page):
        self.page = page
        self.reference = Reference()

    def types(self, key, value):
        self.page.page.evaluate(
            """([key, value]) => {
                const field = document.querySelector(`input[name="${key}"]`);
                field.blur();
                field.focus();
                field.value = value;
                field.dispatchEvent(new Event("input", {bubbles: true}));
                field.blur();
            }""",
            [key, value],
        )

    def step(self, kind, rng):
        reference, page = self.reference, self.page.page
        if kind == "edit":
            key = rng.choice([k for k in GOOD if k not in OF_MODEL or not reference.now["force"]])
            value = rng.choice(GOOD[key])
            self.types(key, value)
            reference.edit(key, value)
        elif kind == "refuse":
            key = rng.choice([k for k in REFUSED if k not in OF_MODEL or not reference.now["force"]])
            value = rng.choice(REFUSED[key])
            self.types(key, value)
            reference.refuse(key, value)
        elif kind == "undo" and reference.at > 0:
            page.evaluate("document.querySelector('#undo').click()")
            reference.at -= 1
        elif kind == "redo" and reference.at + 1 < len(reference.versions):
            page.evaluate("document.querySelector('#redo').click()")
            reference.at += 1
        elif kind == "drop" and not set(OF_MODEL) & set(reference.now["refused"]):
            text = rng.choice(FILES)
            page.evaluate(
                """async (text) => {
                    const data = new DataTransfer();
                    data.items.add(new File([text], "same.csv"));
                    document.body.dispatchEvent(new DragEvent("drop", {dataTransfer: data, bubbles: true, cancelable: true}));
                    const before = document.querySelector("#design").dataset.revision;
                    for (let i = 0; i < 500 && document.querySelector("#design").dataset.revision === before; i += 1) await new Promise((r) => setTimeout(r, 5));
                    document.querySelector("#tab-values").click();
                }""",
                text,
            )
            reference.drop(text)
        elif kind == "pin" and reference.pins < 4 and not reference.now["refused"]:
            page.evaluate("document.querySelector('#pin').click()")
            reference.pins += 1
        elif kind == "reload":
            page.reload()
            self.page.until("the page is there", lambda: page.locator("#values .row").count() > 10)
            self.page.until("the design is there", lambda: self.page.revision() > 0)
            self.page.until("the pins are there", lambda: page.locator(".chart.s .line.pinned").count() == reference.pins)
        else:
            return False
        return True

    def differs(self):
        seen = self.page.page.evaluate(SETTLED)
        right = self.reference.shown()
        out = {k: (seen[k], v) for k, v in right.items() if seen[k] != v}
        if self.reference.now["force"] and seen["hash"] != self.reference.now["force"]:
            out["hash"] = (seen["hash"], self.reference.now["force"])
        if not set(self.reference.now["refused"]) <= set(seen["invalid"]):
            out["invalid"] = (seen["invalid"], list(self.reference.now["refused"]))
        if not self.reference.now["refused"] and seen["invalid"]:
            out["invalid"] = (seen["invalid"], [])
        return out


class Model(unittest.TestCase):
    def test_random_steps_in_two_tabs_agree_with_the_reference(self):
        server, browser = Server(), Browser()
        self.addCleanup(server.kill)
        self.addCleanup(browser.close)
        first = browser.page(server.url, width=420, height=320)
        second = browser.page(server.url, context=first.page.context)
        tabs = [Tab(first), Tab(second)]
        rng = random.Random(SEED)
        done, log, start = {}, [], time.monotonic()
        while sum(done.values()) < STEPS:
            number = rng.randrange(2)
            kind = rng.choices(list(WEIGHTS), list(WEIGHTS.values()))[0]
            if not tabs[number].step(kind, rng):
                continue
            done[kind] = done.get(kind, 0) + 1
            log.append((number, kind))
            if len(log) % 1000 == 0:
                print(f"\n  {len(log)} steps in {time.monotonic() - start:.0f} s", flush=True)
            # The other tab must not have changed either.
            for tab in tabs if sum(done.values()) % 10 == 0 else [tabs[number]]:
                self.assertEqual(tab.differs(), {}, f"after {sum(done.values())} steps, seed {SEED}: {log[-8:]}")
        print(f"\n  {sum(done.values())} steps in {time.monotonic() - start:.0f} s, no difference: {done}")
        self.assertEqual(first.said + second.said, [])


if __name__ == "__main__":
    unittest.main()
