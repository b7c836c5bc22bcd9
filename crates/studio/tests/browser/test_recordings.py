"""The answers belong to their recording; faults of data have clear messages; a scene without a design shows its values."""

import re
import unittest

from studio import DIST, ROOT, Pages
from walks import ASKS_CLOCK, ASKS_MASS, SMALL, one_stance, walk

SCENES = sorted(p.stem for p in (ROOT / "scenes").glob("*.toml"))
ENDINGS = "csv|toml|json|mot|sto|c3d|txt|step|dxf|svg|nc|tsv|html|png"
KEY = re.compile(rf"\b[a-z]+\.(?!(?:{ENDINGS})\b)[a-z_]{{2,}}\b| = \"|\[\[?[a-z.]+\]\]?")


class Recordings(Pages):
    def take(self, page, file):
        name, data = file
        before = page.revision()
        page.page.set_input_files("#pick-file", {"name": name, "mimeType": "text/csv", "buffer": data})
        page.until("it is read or refused", lambda: page.revision() > before or page.page.is_visible("#fault"))
        page.until("it is at rest", lambda: page.page.get_attribute("#design", "aria-busy") == "false")

    def begun(self):
        page = self.page()
        page.sets("limits.stroke", "")
        page.page.click("#tab-force")
        return page

    def applies(self, page, toml):
        page.page.click("#tab-text")
        page.page.fill("#scene-text", toml)
        page.page.click("#text .main")

    def test_what_was_accepted_for_one_recording_is_not_for_the_next(self):
        page = self.begun()
        self.take(page, ASKS_MASS)
        self.assertEqual(page.verdict(), "unacceptable")
        page.page.locator("#conflict .choice", has_text="mass of the walker").first.wait_for()
        page.does(lambda: page.page.locator("#conflict .choice", has_text="mass of the walker").first.click())
        self.assertEqual(page.verdict(), "acceptable")
        self.assertIn("Accepted by you: mass of the walker.", page.page.inner_text("#accepted"))
        self.take(page, ("other.csv", walk(seed=8, times=0.19, head="time (s),Left Fz,Right Fz\n", digits=3)))
        self.assertEqual(page.verdict(), "unacceptable")
        self.assertEqual(page.value("gait.accept"), "")
        self.assertFalse(page.page.is_visible("#accepted"))
        # The same file gets its answers again, with a message.
        self.take(page, ASKS_MASS)
        page.until("it is accepted as before", lambda: page.verdict() == "acceptable")
        self.assertTrue(page.page.is_visible("#accepted"))
        page.page.click("#language")
        page.until("it is said in Spanish", lambda: "Aceptado por usted" in page.page.inner_text("#accepted"))
        page.does(lambda: page.page.click("#accepted button"))
        self.assertEqual(page.verdict(), "unacceptable")
        self.assertFalse(page.page.is_visible("#accepted"))
        self.assertEqual(page.said, [])

    def test_two_questions_are_accepted_one_after_the_other(self):
        page = self.begun()
        self.take(page, ("both.csv", one_stance(weight=120)))
        for _ in range(4):
            choice = page.page.locator("#conflict .choice:visible", has_text="Accepted")
            page.page.wait_for_timeout(400)
            if choice.count() == 0:
                break
            page.does(choice.first.click)
        accepted = page.value("gait.accept")
        self.assertEqual(page.page.locator("#accepted button").count(), len(accepted.split(",")))

    def test_reader_options_of_one_recording_do_not_spoil_the_next(self):
        for key, value in [("gait.force", "nothing"), ("gait.kind", "running"), ("gait.time", "nothing"), ("gait.unit", "BW"), ("gait.rate", "7 Hz"), ("gait.mass", "5 kg"), ("gait.period", "90 s")]:
            with self.subTest(key):
                page = self.begun()
                self.take(page, SMALL)
                page.page.click("#tab-values")
                page.page.evaluate("([key, value]) => { const f = document.querySelector(`[name=\"${key}\"]`); f.value = value;"
                                   "f.dispatchEvent(new Event('input', { bubbles: true })); f.dispatchEvent(new Event('change', { bubbles: true })); }", [key, value])
                page.page.wait_for_timeout(700)
                page.until("it is at rest", lambda: page.page.get_attribute("#design", "aria-busy") == "false")
                page.page.click("#tab-force")
                self.take(page, ("good.csv", walk(seed=11)))
                page.until("it is read", lambda: page.verdict() != "pending")
                self.assertFalse(page.page.is_visible("#fault"))
                self.assertEqual(page.value(key), "")
                self.assertEqual(page.value("name"), "good")

    def test_a_contour_and_a_table_without_force_are_called_what_they_are(self):
        page = self.begun()
        cam = ROOT / "data" / "recordings" / "made_cam.csv"
        self.take(page, (cam.name, cam.read_bytes()))
        page.until("it is said", lambda: "contour of a cam" in page.page.inner_text("#fault"))
        self.assertEqual(page.page.locator("#fault button", has_text="x_mm").count(), 0)
        rows = "".join(f"{k},{1e300 * (k % 9 + 1):.3e},{2e300:.3e}\n" for k in range(200))
        self.take(page, ("huge_values.csv", f"first,second,third\n{rows}".encode()))
        page.until("it is said", lambda: "huge_values.csv" in page.page.inner_text("#fault"))
        self.assertNotIn("no names", page.page.inner_text("#fault"))

    def test_a_fault_offers_its_remedies_as_data_and_shows_no_key(self):
        faults = [
            ("limits.stroke", "5 kg"), ("machine.motor.slope", "10 N m s/rad"), ("machine.floor.mass", "100 kg"), ("law.polydyne", "true"),
            ("drive.kind", "hydraulic"), ("gait.step_frequency", "9 Hz"), ("gait.model", "setra"), ("cam.keyway", "auto"), ("law.family", "program"),
            ("gait.band", "spread"), ("law.degree", "30"), ("cam.follower", "barrel"), ("gait.feet", "left"), ("limits.residual", "1 N"), ("cam.base_radius", "50 mm"),
        ]
        page = self.page()
        said = 0
        for key, value in faults:
            with self.subTest(f"{key} = {value}"):
                page.page.goto("about:blank")
                page.page.goto(self.server.url)
                page.until("the page is there", lambda: page.revision() > 0)
                page.page.evaluate(TYPE, [key, value])
                page.page.wait_for_timeout(900)
                page.until("it is at rest", lambda: page.page.get_attribute("#design", "aria-busy") == "false")
                page.page.wait_for_timeout(500)
                for _ in range(2):
                    words = " ".join(page.page.locator("#fault, #verdict, #conflict").all_inner_texts())
                    self.assertIsNone(KEY.search(words), words)
                    page.page.click("#language")
                    page.page.wait_for_timeout(900)
                said += page.page.is_visible("#fault")
        self.assertGreater(said, 5)

    def test_a_scene_that_cannot_be_designed_never_shows_another_scene(self):
        page = self.page()
        scenes = SCENES[::3] if len(SCENES) > 12 else SCENES
        for name in scenes:
            with self.subTest(name):
                page.opens("footbridge")
                own = (ROOT / "scenes" / f"{name}.toml").read_text()
                spoilt = own.replace("[cam]", "[cam]\nbore = \"900 mm\"", 1) if "bore" not in own else re.sub(r"bore = \"[^\"]*\"", 'bore = "900 mm"', own)
                self.applies(page, re.sub(r'^name = .*$', f'name = "{name}_spoilt"', spoilt, flags=re.M))
                page.until("it is told", lambda: page.page.is_visible("#fault") or page.page.inner_text("#scene-name") == f"{name}_spoilt")
                page.page.wait_for_timeout(900)
                page.until("it is at rest", lambda: page.page.get_attribute("#design", "aria-busy") == "false")
                if not page.page.is_visible("#fault"):
                    continue
                self.assertEqual(page.page.inner_text("#scene-name"), f"{name}_spoilt")
                self.assertEqual(page.verdict(), "pending")
                self.assertEqual(page.value("name"), f"{name}_spoilt")
                self.assertIn(page.value("cam.bore"), ("900 mm", ""))
                self.assertIn(f"{name}_spoilt", page.page.input_value("#scene-text"))
                self.assertEqual(page.page.locator("#stage").evaluate("e => getComputedStyle(e).visibility"), "hidden")

    def test_a_scene_without_its_recording_shows_its_own_values(self):
        page = self.page()
        page.opens("camdas_01_roller")
        own = (ROOT / "scenes" / "measured_walk.toml").read_text().replace("[gait]", '[gait]\nfile = "not_here.c3d"')
        self.applies(page, own)
        page.until("the fault is named", lambda: page.page.is_visible("#fault"))
        self.assertEqual(page.page.inner_text("#scene-name"), "measured_walk")
        self.assertEqual((page.value("name"), page.value("cam.follower")), ("measured_walk", "flat-translating"))
        self.assertEqual(page.value("gait.file"), "not_here.c3d")
        self.assertEqual(page.page.locator("#stage").evaluate("e => getComputedStyle(e).visibility"), "hidden")
        page.page.click("#undo")
        page.until("the former is back", lambda: page.verdict() != "pending")
        self.assertEqual(page.page.locator("#stage").evaluate("e => getComputedStyle(e).visibility"), "visible")
        self.assertEqual(page.value("name"), "camdas_01_roller")

    def test_a_recorded_walk_is_compared_with_the_cam_at_resonance(self):
        page = self.begun()
        page.page.click("#tab-compare")
        self.assertEqual(page.page.locator("#resonance").count(), 0)
        page.page.click("#tab-force")
        self.take(page, ("long.csv", (ROOT / "data/recordings/made_long_walk.csv").read_bytes()))
        page.page.click("#tab-compare")
        page.page.click("#resonance")
        page.page.wait_for_selector("#walking .picture svg")
        self.assertIn("1.16 times as severe as the recorded walk", page.page.inner_text("#walking"))
        self.assertEqual(page.page.locator("#walking tbody tr").count(), 3)
        self.assertEqual(page.said, [])

    def test_notices_of_files_go_away(self):
        page = self.begun()
        page.page.evaluate(DROP_LARGE)
        page.until("it is said", lambda: "64 MiB" in page.page.inner_text("#notice"))
        self.take(page, SMALL)
        self.assertFalse(page.page.is_visible("#notice"))
        page.does(lambda: page.page.evaluate(DROP_TWO, walk(seed=4).decode()))
        page.until("the second is named", lambda: "one.csv" in page.page.inner_text("#notice"))
        self.assertEqual(page.value("gait.file"), "one.csv")
        self.assertEqual(page.page.inner_text("#scene-name"), "one")

    def test_a_name_that_the_user_gave_stays(self):
        page = self.page()
        page.sets("name", "my cam")
        page.sets("limits.stroke", "")
        page.page.click("#tab-force")
        self.take(page, SMALL)
        self.assertEqual(page.page.inner_text("#scene-name"), "my cam")

    @unittest.skipIf(DIST, "asked of the native engine")
    def test_limits_come_before_the_goal_and_several_limits_are_offered_beside_it(self):
        page = self.page()
        asked = []
        page.page.on("response", lambda r: asked.append(r) if r.url.split("?")[0].endswith("/relax") else None)
        page.sets("limits.acceleration", "1 m/s^2")
        page.sets("limits.stroke", "20 mm")
        page.until("it is asked", lambda: len(asked) > 0)
        page.page.wait_for_timeout(2500)
        answer = asked[-1].json()
        kinds = [r["kind"] for r in answer["relaxations"]]
        self.assertEqual(kinds, sorted(kinds, key=lambda kind: kind == "goal"))
        goal = [r for r in answer["relaxations"] if r["kind"] == "goal"]
        self.assertTrue(all(r["cost"] > 0.5 for r in goal))
        self.assertEqual({r["key"] for r in answer["together"]} >= {"limits.stroke", "limits.acceleration"}, True, answer)
        self.assertTrue(all(r["kind"] == "limit" for r in answer["together"]))


TYPE = """([key, value]) => {
    const field = document.querySelector(`[name="${key}"]`);
    field.focus();
    field.value = value;
    field.dispatchEvent(new Event("input", { bubbles: true }));
    field.dispatchEvent(new Event("change", { bubbles: true }));
    field.blur();
}"""
DROP_LARGE = """() => {
    const file = new File(["x"], "large.csv");
    Object.defineProperty(file, "size", { value: 65 * 2 ** 20 });
    const event = new DragEvent("drop", { bubbles: true, cancelable: true });
    Object.defineProperty(event, "dataTransfer", { value: { types: ["Files"], files: [file] } });
    document.body.dispatchEvent(event);
}"""
DROP_TWO = """(text) => {
    const data = new DataTransfer();
    for (const name of ["one.csv", "two.csv"]) data.items.add(new File([text], name));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
}"""

if __name__ == "__main__":
    unittest.main()
