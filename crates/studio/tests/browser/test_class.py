"""Use of the page in class and laboratory: variants, differences, exercises, films, two recordings."""

import math
import re
import tempfile
import unittest
from pathlib import Path

from studio import ROOT, Pages

WALK = ROOT / "data" / "recordings" / "made_walk.csv"
# Values of a diagram at whole degrees.
MAIN = "id => document.querySelector(`.chart.${id} .line.main`).getAttribute('d')"


class Class(Pages):
    def table(self, page, diagram):
        """Table of the large diagram: value by degree."""
        if not page.page.locator(f".chart.{diagram}.large").count():
            page.page.click(f".chart.{diagram} .enlarge")
        page.page.evaluate("document.querySelector('#show-table').click()")
        rows = page.page.eval_on_selector_all(".data tbody tr", "rows => rows.map((r) => [...r.children].map((c) => c.textContent))")
        page.page.keyboard.press("Escape")
        number = lambda text: float(text.replace("−", "-"))
        return {number(degree): number(value) for degree, value, *_ in rows}

    def test_a_variant_has_a_name_and_the_diagrams_show_what_differs_from_it(self):
        page = self.page()
        before = self.table(page, "force")
        page.page.click("#pin")
        page.sets("gait.body_weight", "500 N")
        after = self.table(page, "force")
        page.page.click("#tab-compare")
        page.page.fill(".slate .variant", "sixty")
        page.page.keyboard.press("Tab")
        page.page.click(".slate [aria-label^='Diagrams show']")
        self.assertIn("Δ", page.page.inner_text(".chart.force h2"))
        difference = self.table(page, "force")
        self.assertEqual(len(difference), 361)
        worst = max(abs(difference[k] - (after[k] - before[k])) for k in difference)
        self.assertLess(worst, 1.1)
        self.assertGreater(max(map(abs, difference.values())), 100)
        # A difference cannot be dragged, and its name remains after a reload.
        self.assertEqual(page.page.locator(".chart .grip").count(), 0)
        page.page.click(".slate [aria-label^='Diagrams show']")
        self.assertNotIn("Δ", page.page.inner_text(".chart.force h2"))
        page.page.wait_for_timeout(400)
        page.page.reload()
        page.shown(0)
        page.page.click("#tab-compare")
        page.page.wait_for_selector(".slate .variant")
        self.assertEqual(page.page.input_value(".slate .variant"), "sixty")
        self.assertEqual(page.said, [])

    def test_speeds_are_shown_in_rpm_everywhere_and_the_scene_keeps_its_own(self):
        page = self.page()
        page.page.click("#tab-text")
        text = page.page.input_value("#scene-text") + '[machine]\ninertia = "2 kg m^2"\n[machine.motor]\nslope = "10 N m s/rad"\n'
        page.page.fill("#scene-text", text)
        page.does(lambda: page.page.click("#text .main"))
        self.assertRegex(page.page.inner_text(".chart.speed h2"), "rad/s")
        mean = float(re.search(r"([\d.]+) rad/s", page.page.inner_text("#figures")).group(1))
        page.page.click(".menu summary")
        page.does(lambda: page.page.select_option("#speeds", "rpm"))
        page.page.wait_for_timeout(300)
        for selector in ("#figures", "#limits", "#charts"):
            self.assertNotRegex(page.page.inner_text(selector), r"\d\s*rad/s(?![²³])")
        self.assertRegex(page.page.inner_text(".chart.speed h2"), "rpm")
        shown = float(re.search(r"Speed\s+([\d.]+)\srpm", page.page.inner_text("#figures")).group(1))
        self.assertAlmostEqual(shown, mean * 30 / math.pi, delta=0.1)
        # The speed is shown once in the figures, and its unit is changed separately from that of lengths.
        self.assertEqual(page.page.inner_text("#figures").count("rpm"), 1)
        page.does(lambda: page.page.select_option("#units", "in"))
        self.assertRegex(page.page.inner_text(".chart.speed h2"), "rpm")
        page.does(lambda: page.page.select_option("#speeds", "rad/s"))
        self.assertRegex(page.page.inner_text(".chart.speed h2"), "rad/s")
        self.assertRegex(page.page.inner_text(".chart.s h2"), "in$")

    def test_an_exercise_hides_its_answers_until_they_are_asked_for(self):
        # The first scene states its stroke and its base circle.
        for scene, answers in (("camdas_09_eight_motions", 2), ("footbridge", 4)):
            with self.subTest(scene):
                page = self.page()
                page.opens(scene)
                figures = page.page.eval_on_selector_all("#figures dd span", "all => all.map((e) => e.textContent)")
                page.page.click(".menu summary")
                page.page.click("#show-exercise")
                seen = page.page.inner_text(".sheet")
                given = page.page.inner_text(".sheet .given") + "".join(page.page.eval_on_selector_all(".sheet table", "all => all.map((e) => e.innerText)"))
                hidden = [f for f in figures if f not in given]
                self.assertGreaterEqual(len(hidden), answers)
                for figure in hidden:
                    self.assertNotIn(figure, seen)
                self.assertEqual(page.page.locator(".blank .line.main:visible").count(), 0)
                self.assertGreaterEqual(page.page.locator(".blank svg:visible").count(), 4)
                self.assertEqual(page.page.locator(".blank .target").count(), int(scene == "footbridge"))
                page.page.click("#show-answers")
                for figure in hidden:
                    self.assertIn(figure, page.page.inner_text(".answers"))
                self.assertGreaterEqual(page.page.locator(".answers .line.main:visible").count(), 4)
                # In print, the answers begin on a new page.
                page.page.click("#show-answers")
                page.page.emulate_media(media="print")
                self.assertEqual(page.page.eval_on_selector(".answers", "e => getComputedStyle(e).breakBefore"), "page")
                self.assertFalse(page.page.is_visible("#design"))
                self.assertEqual(page.said, [])

    def test_an_exercise_in_spanish_has_no_words_of_the_scene_file(self):
        page = self.page()
        page.opens("camdas_09_eight_motions")
        page.does(lambda: page.page.click("#language"))
        page.page.click(".menu summary")
        page.page.click("#show-exercise")
        page.page.wait_for_function("document.querySelector('.sheet')?.innerText.includes('cicloidal')")
        seen = page.page.inner_text(".sheet")
        for word in ("cycloidal", "dwell", "program\n", "flat-translating", "roller-translating", "fixed-axis", " deg"):
            self.assertNotIn(word, seen)

    def test_a_film_of_the_turning_cam_is_decoded_by_the_browser(self):
        page = self.page()
        page.page.click("#open-export")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "cam.gif"
            page.downloads("cam.gif", path)
            data = path.read_bytes()
        seen = page.page.evaluate(
            """async (bytes) => {
                const decoder = new ImageDecoder({data: Uint8Array.from(bytes), type: "image/gif"});
                await decoder.tracks.ready;
                await decoder.completed;
                const count = decoder.tracks.selectedTrack.frameCount;
                const [sums, lasting] = [[], []];
                for (const frameIndex of [0, 12, 24]) {
                    const {image} = await decoder.decode({frameIndex});
                    lasting.push(image.duration);
                    const canvas = new OffscreenCanvas(image.displayWidth, image.displayHeight).getContext("2d");
                    canvas.drawImage(image, 0, 0);
                    const {data} = canvas.getImageData(0, 0, image.displayWidth, image.displayHeight);
                    let dark = 0;
                    for (let i = 0; i < data.length; i += 4) dark += (data[i] + data[i + 1] + data[i + 2] < 600) * (1 + i % 977);
                    sums.push(dark);
                }
                return {count, sums, lasting};
            }""",
            list(data),
        )
        print(f"\n  {len(data) / 1e3:.0f} kB, {seen['count']} pictures")
        self.assertEqual(seen["count"], 48)
        self.assertEqual(set(seen["lasting"]), {80_000})
        self.assertEqual(len(set(seen["sums"])), 3)
        self.assertGreater(min(seen["sums"]), 0)

    def test_two_recordings_stand_side_by_side(self):
        page = self.page()
        page.sets("limits.stroke", "")
        page.page.click("#tab-force")
        other = WALK.read_text()
        with tempfile.TemporaryDirectory() as folder:
            second = Path(folder) / "second_walk.csv"
            second.write_text(other)
            for k, path in enumerate((WALK, second)):
                page.does(lambda: page.page.set_input_files("#pick-file", path))
                page.page.wait_for_selector(".found .picture svg")
                self.assertEqual(page.page.locator("#side-by-side").count(), k)
        page.page.click("#side-by-side")
        self.assertEqual(page.page.locator(".sides .found:visible").count(), 2)
        self.assertEqual(page.page.locator(".sides .found figure svg:visible").count(), 2)
        names = page.page.eval_on_selector_all(".sides h3", "all => all.map((e) => e.textContent)")
        self.assertEqual(names, ["second_walk.csv", "made_walk.csv"])
        boxes = [page.page.locator(".sides .found").nth(k).bounding_box() for k in range(2)]
        self.assertAlmostEqual(boxes[0]["y"], boxes[1]["y"], delta=2)
        self.assertGreater(boxes[1]["x"], boxes[0]["x"] + boxes[0]["width"] - 1)
        self.assertEqual(page.said, [])

    def test_a_column_of_force_and_a_doubt_are_chosen_by_buttons(self):
        page = self.page()
        page.sets("limits.stroke", "")
        # Stances of 0.65 s every 1.1 s with two peaks. The column names have no meaning.
        at = [k / 500 for k in range(2000)]
        share = [t % 1.1 / 0.65 for t in at]
        force = [700 * (math.sin(math.pi * u) + 0.35 * math.sin(3 * math.pi * u)) if u < 1 else 0 for u in share]
        rows = "".join(f"{t:.4f},{f:.2f},{5 * math.sin(t):.3f}\n" for t, f in zip(at, force))
        page.page.click("#tab-force")
        page.page.set_input_files("#pick-file", {"name": "cols.csv", "mimeType": "text/csv", "buffer": f"t,alpha,beta\n{rows}".encode()})
        choice = page.page.locator("#fault button", has_text=re.compile("alpha$"))
        choice.wait_for()
        page.does(choice.click)
        self.assertEqual(page.value("gait.force"), "alpha")
        self.assertFalse(page.page.is_visible("#fault"))
        # A recording without its stride time: the answer is beside the warning.
        single = "".join(f"{t:.4f},{f:.2f}\n" for t, f in zip(at, force) if t < 0.66)
        page.does(lambda: page.page.set_input_files("#pick-file", {"name": "one.csv", "mimeType": "text/csv", "buffer": f"t,fz\n{single}".encode()}))
        doubt = page.page.locator("#conflict .choice", has_text="time scale")
        doubt.wait_for()
        self.assertEqual(page.verdict(), "unacceptable")
        page.does(doubt.click)
        self.assertEqual(page.value("gait.accept"), "clock")
        self.assertEqual(page.page.locator("#conflict .choice:visible").count(), 0)
        self.assertEqual(page.said, [])

    def test_all_diagrams_are_zoomed_about_the_cursor_and_back(self):
        page = self.page()
        page.page.focus(".chart.s svg")
        page.page.keyboard.press("Home")
        for _ in range(9):
            page.page.keyboard.press("Shift+ArrowRight")
        # Read in one step, because a later selection may contain labels that have moved.
        across = ("() => [...document.querySelectorAll('.chart.force .tick[text-anchor=middle]')]"
                  ".map((e) => parseFloat(e.textContent)).filter(Number.isFinite)")
        whole, line = page.page.evaluate(across), page.page.evaluate(MAIN, "v")
        page.page.keyboard.press("+")
        page.page.keyboard.press("+")
        wide = lambda seen: max(seen) - min(seen)
        page.until("it is zoomed", lambda: wide(page.page.evaluate(across)) < 0.3 * wide(whole))
        near = page.page.evaluate(across)
        self.assertLess(min(near), 90)
        self.assertGreater(max(near), 90)
        # The cursor stays at the position of the pointer, and the table contains the whole turn.
        self.assertAlmostEqual(float(page.page.get_attribute("#stage", "aria-valuenow")), 90, delta=1e-6)
        self.assertEqual(len(self.table(page, "s")), 361)
        page.page.focus(".chart.s svg")
        page.page.keyboard.press("0")
        page.page.click(".chart.force .enlarge")
        page.until("the turn is whole", lambda: page.page.evaluate(across) == whole)
        self.assertEqual(page.page.evaluate(MAIN, "v"), line)


if __name__ == "__main__":
    unittest.main()
