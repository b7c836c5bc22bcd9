"""Programmes from an empty page: templates, rows, locks, the remaining angle, and a model of random changes.

GAITCAM_STEPS and GAITCAM_SEED as in test_model."""

import os
import random
import re
import tomllib
import unittest

from studio import ROOT, Pages

STEPS = int(os.environ.get("GAITCAM_STEPS", "120"))
SEED = int(os.environ.get("GAITCAM_SEED", "1"))
# Rows shown in the page, segments of the last designed scene, and state of the page.
SEEN = """() => {
    const value = (row, column) => row.querySelector(`[name$=".${column}"]`)?.value ?? "";
    const rows = [...document.querySelectorAll("[data-segment-row]")].map((row) => ({
        motion: value(row, "motion"), lift: value(row, "lift"), angle: value(row, "angle"),
        locked: row.querySelector(".lock").getAttribute("aria-pressed") === "true", rest: row.querySelector("[type=radio]").checked,
    }));
    return {rows, gap: Number(document.querySelector(".turn")?.dataset.gap ?? 0), refused: document.querySelector("#design").classList.contains("stale")};
}"""


def texts(value):
    """Table with all its numbers as texts: a scene may contain "0" or 0."""
    if isinstance(value, dict):
        return {key: texts(inner) for key, inner in value.items()}
    return [texts(inner) for inner in value] if isinstance(value, list) else str(value)


class Programme(Pages):
    def programme(self, scene=None):
        page = self.page()
        if scene:
            page.opens(scene)
        page.page.click("#tab-programme")
        return page

    def seen(self, page):
        page.page.wait_for_timeout(10)
        page.until("it is at rest", lambda: page.page.get_attribute("#design", "aria-busy") == "false")
        return page.page.evaluate(SEEN)

    def scene(self, page):
        """Scene of the page as a table, from the tab File."""
        page.page.click("#tab-text")
        text = page.page.input_value("#scene-text")
        page.page.click("#tab-programme")
        return tomllib.loads(text)

    def types(self, page, number, column, text):
        field = page.page.locator(f'[name="law.segment.{number}.{column}"]')
        field.fill(text)
        field.press("Tab")

    def angles(self, page):
        return [row["angle"] for row in self.seen(page)["rows"]]

    def quiet(self, page):
        self.assertEqual(page.said, [])

    def test_a_double_dwell_is_built_by_mouse_in_few_steps(self):
        page = self.programme()
        page.does(lambda: page.page.click('[data-template="double-dwell"]'))
        self.assertEqual(self.angles(page), ["120°", "60°", "120°", "60°"])
        for number, angle in ((1, "60"), (2, "120"), (3, "60"), (4, "120")):
            self.types(page, number, "angle", angle)
        self.assertEqual(self.angles(page), ["60°", "120°", "60°", "120°"])
        self.assertEqual(page.verdict(), "acceptable")
        law = self.scene(page)["law"]
        self.assertEqual(law["family"], "program")
        self.assertEqual([s.get("lift") for s in law["segment"]], ["20 mm", None, "-20 mm", None])
        self.assertEqual([s["angle"] for s in law["segment"]], ["60 deg", "120 deg", "60 deg", "120 deg"])
        self.assertIn("Load model", page.page.inner_text("#set-aside"))
        self.quiet(page)

    def test_a_double_dwell_is_built_by_keyboard(self):
        page = self.programme()
        page.page.focus('[data-template="double-dwell"]')
        page.does(lambda: page.page.keyboard.press("Enter"))
        for number, angle in ((4, "120"), (1, "60"), (3, "60"), (2, "120")):
            page.page.focus(f'[name="law.segment.{number}.angle"]')
            page.page.keyboard.type(angle)
            page.page.keyboard.press("Enter")
        self.assertEqual(self.angles(page), ["60°", "120°", "60°", "120°"])
        self.assertEqual(page.verdict(), "acceptable")
        self.quiet(page)

    def test_it_is_built_row_by_row_too(self):
        page = self.programme()
        for count in (1, 2, 3, 4):
            page.page.click("#add-segment")
            self.assertEqual(page.page.locator("[data-segment-row]").count(), count)
        page.page.select_option('[name="law.segment.1.motion"]', "cycloidal")
        self.assertEqual(self.seen(page)["refused"], True)
        page.page.select_option('[name="law.segment.3.motion"]', "cycloidal")
        seen = self.seen(page)
        self.assertEqual([row["lift"] for row in seen["rows"]], ["20 mm", "", "-20 mm", ""])
        self.assertEqual((seen["gap"], seen["refused"], page.verdict()), (0, False, "acceptable"))
        self.assertEqual(self.scene(page)["law"]["family"], "program")
        self.quiet(page)

    def test_the_first_segment_makes_a_programme_and_the_last_brings_the_former_law_back(self):
        for scene in ("footbridge", "heel_tester", "footbridge_double_harmonic"):
            with self.subTest(scene):
                page = self.programme(scene)
                before = self.scene(page)
                page.does(lambda: page.page.click("#add-segment"))
                self.assertEqual(self.scene(page)["law"]["family"], "program")
                page.does(lambda: page.page.click('[aria-label="Remove 1"]'))
                self.assertEqual(texts(self.scene(page)), texts(before))
                self.quiet(page)

    def test_rows_are_added_and_removed_in_every_scene_with_a_programme(self):
        for file in sorted((ROOT / "scenes").glob("*.toml")):
            segments = tomllib.loads(file.read_text()).get("law", {}).get("segment")
            if not segments:
                continue
            with self.subTest(file.stem):
                page = self.programme(file.stem)
                self.seen(page)
                rows = page.page.locator("[data-segment-row]")
                before = page.page.evaluate(SEEN)
                self.assertEqual(rows.count(), len(segments))
                page.page.click(f'[aria-label="Insert below {len(segments)}"]')
                self.assertEqual(rows.count(), len(segments) + 1)
                self.assertEqual(self.seen(page)["gap"], 0)
                self.assertEqual(rows.count(), len(segments) + 1)
                page.page.click('[aria-label="Remove 1"]')
                self.assertEqual(rows.count(), len(segments))
                self.seen(page)
                self.assertEqual(rows.count(), len(segments))
                page.page.click("#undo")
                page.page.click("#undo")
                self.assertEqual(self.seen(page), before)
                page.page.click("#redo")
                self.seen(page)
                self.assertEqual(rows.count(), len(segments) + 1)
                self.quiet(page)
                page.page.close()

    def test_an_angle_that_does_not_fit_says_what_does(self):
        page = self.programme()
        page.does(lambda: page.page.click('[data-template="double-dwell"]'))
        self.types(page, 1, "angle", "200")
        seen = self.seen(page)
        self.assertEqual([row["angle"] for row in seen["rows"]], ["200°", "60°", "120°", "60°"])
        self.assertEqual((seen["gap"], seen["refused"]), (-80, True))
        self.assertIn("179°", page.page.inner_text('[data-segment-row="1"] .misfit'))
        self.assertEqual(page.page.locator(".turn .over").count(), 1)
        page.does(lambda: page.page.click('[data-segment-row="1"] .misfit button'))
        self.assertEqual(self.angles(page), ["179°", "60°", "120°", "1°"])
        self.assertEqual(page.page.locator(".misfit").count(), 0)
        self.quiet(page)

    def test_locked_angles_stay_and_undo_brings_locks_back(self):
        page = self.programme("camdas_09_eight_motions")
        for number in (2, 4, 6):
            page.page.click(f'[aria-label="Lock the angle {number}"]')
        page.page.check('[aria-label="Takes the rest of the turn 7"]')
        self.types(page, 1, "angle", "40")
        self.assertEqual(self.angles(page), ["40°", "40°", "50°", "40°", "50°", "40°", "60°", "40°"])
        page.page.click("#rebalance")
        self.assertEqual([self.angles(page)[i] for i in (1, 3, 5)], ["40°"] * 3)
        for _ in range(3):
            page.page.click("#undo")
        seen = self.seen(page)
        self.assertEqual([row["locked"] for row in seen["rows"]], [False, True, False, True, False, True, False, False])
        self.assertEqual([row["rest"] for row in seen["rows"]].index(True), 7)
        self.assertEqual(seen["rows"][0]["angle"], "50°")
        self.quiet(page)

    def test_numbers_take_the_unit_shown_and_a_return_the_unit_typed(self):
        page = self.programme("camdas_09_eight_motions")
        self.types(page, 1, "angle", "55")
        self.assertEqual(self.angles(page)[0], "55°")
        self.types(page, 1, "lift", "0.5 in")
        rows = self.seen(page)["rows"]
        self.assertEqual((rows[0]["lift"], rows[2]["lift"]), ("0.5 in", "-0.5 in"))
        page.page.click("#language")
        self.types(page, 1, "lift", "12,5 mm")
        rows = self.seen(page)["rows"]
        self.assertEqual((rows[0]["lift"], rows[2]["lift"]), ("12,5 mm", "-12,5 mm"))
        self.assertIn("cicloidal", page.page.inner_text('[data-segment-row="3"] select'))
        self.assertEqual(self.scene(page)["law"]["segment"][0]["lift"], "12.5 mm")
        self.quiet(page)

    def test_a_law_of_the_catalogue_is_set_in_its_row(self):
        page = self.programme("camdas_01_roller")
        page.page.click('[aria-label="Catalogue of laws 2"]')
        self.assertEqual(page.page.inner_text(".laws tr:has([data-law=cycloidal]) td:nth-of-type(8)"), "R–R")
        page.does(lambda: page.page.click("[data-law=cycloidal]"))
        self.assertEqual(self.seen(page)["rows"][1]["motion"], "cycloidal")
        self.assertFalse(page.page.is_visible("#dialog"))
        self.quiet(page)

    def test_rows_and_picture_light_each_other(self):
        page = self.programme("camdas_09_eight_motions")
        page.page.hover('[data-segment-row="3"] b')
        self.assertIn("hot", page.page.get_attribute('.turn [data-row="3"]', "class"))
        page.page.hover('.turn [data-row="5"]')
        self.assertIn("hot", page.page.get_attribute('[data-segment-row="5"]', "class"))
        self.assertEqual(page.page.locator(".turn .part").count(), 8)
        self.assertRegex(page.page.get_attribute("#turn-cursor", "x1"), r"%$")

    def test_random_changes_agree_with_a_model(self):
        """Model: a changed angle affects its row and the row with the remaining angle, and no other angle."""
        page = self.programme()
        page.page.set_viewport_size({"width": 1000, "height": 500})
        page.does(lambda: page.page.click('[data-template="double-dwell"]'))
        rng = random.Random(SEED)
        number = lambda text: float(re.sub(r"[^\d.-]", "", text) or 0)
        log, shown = [], [self.seen(page)]
        at = 0
        for step in range(STEPS):
            before = shown[at]
            rows = before["rows"]
            n = len(rows)
            kind = rng.choices(["angle", "add", "remove", "lock", "rest", "move", "undo", "redo"], [8, 2, 2, 2, 1, 1, 3, 2])[0]
            i = rng.randrange(n)
            if (kind == "add" and n > 7) or (kind == "remove" and n < 3) or (kind == "move" and i == 0):
                continue
            if (kind == "undo" and at == 0) or (kind == "redo" and at + 1 == len(shown)):
                continue
            if kind == "rest" and (rows[i]["locked"] or rows[i]["rest"]):
                continue
            typed = rng.choice([10, 20, 35, 60, 90, 250])
            if kind == "angle":
                if rows[i]["angle"] == f"{typed}°":
                    continue
                self.types(page, i + 1, "angle", str(typed))
            elif kind == "add":
                page.page.click(f'[aria-label="Insert below {i + 1}"]')
            elif kind == "remove":
                page.page.click(f'[aria-label="Remove {i + 1}"]')
            elif kind == "lock":
                page.page.click(f'[aria-label="Lock the angle {i + 1}"]')
            elif kind == "rest":
                page.page.check(f'[aria-label="Takes the rest of the turn {i + 1}"]')
            elif kind == "move":
                page.page.click(f'[aria-label="Move up {i + 1}"]')
            else:
                page.page.click(f"#{kind}")
            log.append((kind, i + 1, typed))
            after = self.seen(page)
            why = f"after {log[-6:]}, seed {SEED}"
            if kind in ("undo", "redo"):
                at += {"undo": -1, "redo": 1}[kind]
                self.assertEqual(after, shown[at], why)
                continue
            del shown[at + 1 :]
            shown.append(after)
            at += 1
            angles = [[number(r["angle"]) for r in s["rows"]] for s in (before, after)]
            changed = [k for k in range(min(map(len, angles))) if angles[0][k] != angles[1][k]]
            # The page shows four digits.
            self.assertAlmostEqual(after["gap"], 360 - sum(angles[1]), delta=0.1 * n, msg=why)
            if kind == "angle":
                self.assertEqual(angles[1][i], typed, why)
                self.assertLessEqual(len(changed), 2, why)
                self.assertTrue(all(k == i or after["rows"][k]["rest"] for k in changed), why)
                self.assertFalse(any(rows[k]["locked"] for k in changed if k != i), why)
            elif kind in ("lock", "rest"):
                self.assertEqual(changed, [], why)
            elif kind == "move":
                self.assertEqual(sorted(angles[0]), sorted(angles[1]), why)
            else:
                self.assertEqual(len(angles[1]), n + {"add": 1, "remove": -1}[kind], why)
            if not after["refused"]:
                scene = self.scene(page)
                self.assertEqual(len(scene["law"]["segment"]), len(after["rows"]), why)
                self.assertAlmostEqual(sum(number(s["angle"]) for s in scene["law"]["segment"]), 360, 6, why)
        self.quiet(page)


if __name__ == "__main__":
    unittest.main()
