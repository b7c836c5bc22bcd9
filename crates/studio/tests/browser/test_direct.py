"""Actions on the diagrams, small screens, print, and keyboard."""

import tempfile
import unittest
import zipfile
from pathlib import Path

from studio import ROOT, Pages

SHARED = [folder / "shared" / "data" / "gait" for folder in (ROOT.parent, ROOT.parent.parent)]
RUNNING = next((f for f in SHARED if f.is_dir()), SHARED[0]) / "opensim" / "grf_run.mot"


class Direct(Pages):
    def drags(self, page, selector, dx, dy):
        """Drags the middle of an element with the mouse."""
        box = page.page.locator(selector).first.bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        mouse = page.page.mouse
        mouse.move(x, y)
        mouse.down()
        for k in range(1, 6):
            mouse.move(x + dx * k / 5, y + dy * k / 5)
            page.page.wait_for_timeout(20)
        return mouse

    def test_a_limit_line_is_dragged_on_its_diagram_and_is_one_step_back(self):
        page = self.page()
        page.opens("camdas_09_eight_motions")
        self.assertEqual(page.value("limits.pressure_angle"), "")
        before = page.revision()
        mouse = self.drags(page, '.chart.pressure-angle .grip[data-limit="limits.pressure_angle"]', 0, 12)
        page.until("it is set", lambda: page.value("limits.pressure_angle") != "")
        # The previous design is drawn behind the new one.
        self.assertGreater(page.page.locator(".line.ghost").count(), 0)
        mouse.up()
        page.shown(before)
        value = page.value("limits.pressure_angle")
        self.assertRegex(value, r"^\d+(\.\d+)? deg$")
        self.assertLess(float(value.split()[0]), 45)
        page.does(lambda: page.page.click("#undo"))
        self.assertEqual(page.value("limits.pressure_angle"), "")
        page.until("the ghost is gone", lambda: page.page.locator(".line.ghost").count() == 0)

    def test_no_line_of_another_scene_stays_in_the_diagrams(self):
        page = self.page()
        page.sets("limits.stroke", "55 mm")
        self.assertGreater(page.page.locator(".line.ghost").count(), 0)
        page.opens("camdas_09_eight_motions")
        self.assertEqual(page.page.locator(".line.ghost").count(), 0)

    def test_a_limit_line_is_moved_by_the_arrow_keys(self):
        page = self.page()
        page.opens("camdas_09_eight_motions")
        grip = page.page.locator(".chart.pressure-angle .grip").first
        grip.focus()
        page.does(lambda: page.page.keyboard.press("ArrowDown"))
        self.assertRegex(page.value("limits.pressure_angle"), r"^4[45]")

    def test_borders_and_lifts_of_segments_are_dragged_and_the_turn_stays_whole(self):
        page = self.page()
        page.opens("camdas_09_eight_motions")
        self.assertTrue(page.page.locator(".chart.s").evaluate("e => e.classList.contains('large')"))
        before = page.revision()
        self.drags(page, '.knot[data-segment="1"]', 24, -10).up()
        page.shown(before)
        page.page.click("#tab-programme")
        read = lambda n, column: float(page.page.input_value(f'[name="law.segment.{n}.{column}"]').split()[0].strip("°"))
        self.assertAlmostEqual(sum(read(n, "angle") for n in range(1, 9)), 360)
        self.assertGreater(read(1, "angle"), 50)
        self.assertGreater(read(1, "lift"), 10)
        self.assertAlmostEqual(read(1, "lift"), -read(3, "lift"))
        self.assertNotEqual(page.verdict(), "pending")

    def test_a_diagram_is_enlarged_others_are_left_out_and_it_has_a_table(self):
        page = self.page()
        page.page.click(".chart.j .enlarge")
        self.assertTrue(page.page.locator(".chart.j").evaluate("e => e.classList.contains('large')"))
        page.page.click(".menu summary")
        page.page.click("#choose-diagrams")
        page.page.uncheck("#diagram-power")
        page.page.keyboard.press("Escape")
        self.assertEqual(page.page.locator(".chart").count(), 8)
        page.page.click("#show-table")
        self.assertEqual(page.page.locator(".data tbody tr").count(), 361)
        page.page.fill("#go-to", "90")
        self.assertEqual(page.page.locator(".data .here th").inner_text(), "90")

    def test_the_keyboard_moves_the_cursor_and_says_the_value(self):
        page = self.page()
        page.page.focus(".chart.s svg")
        page.page.keyboard.press("Home")
        page.page.keyboard.press("Shift+ArrowRight")
        page.until("the cam stands at 10°", lambda: abs(float(page.page.get_attribute("#stage", "aria-valuenow")) - 10) < 1e-6)
        self.assertRegex(page.page.inner_text("#spoken"), r"\b10\b.*mm")

    def test_at_most_sixty_tab_stops_lie_before_the_first_diagram(self):
        page = self.page()
        stops = page.page.evaluate(
            """() => {
                const all = [...document.querySelectorAll('a, button, input, select, textarea, summary, [tabindex]')];
                const first = document.querySelector('.chart svg');
                const seen = all.filter((e) => e.tabIndex >= 0 && !e.disabled && e.checkVisibility({checkVisibilityCSS: true}));
                return seen.filter((e) => e.compareDocumentPosition(first) & Node.DOCUMENT_POSITION_FOLLOWING).length;
            }"""
        )
        print(f"\n  {stops} tab stops before the first diagram")
        self.assertLessEqual(stops, 60)

    def test_the_cam_stays_in_sight_while_a_value_is_changed(self):
        for width, height in ((390, 844), (1024, 768)):
            with self.subTest(width):
                page = self.page(width=width, height=height)
                slider = page.page.locator('input[data-key="limits.stroke"]')
                slider.scroll_into_view_if_needed()
                page.page.wait_for_timeout(100)
                inside = "e => { const b = e.getBoundingClientRect(); return b.top >= -1 && b.bottom <= innerHeight + 1 && b.height > 150; }"
                self.assertTrue(page.page.locator("#stage").evaluate(inside))
                box = slider.bounding_box()
                self.assertTrue(0 <= box["y"] <= height)
                # Nothing covers the slider, and a swipe over the cam scrolls the page.
                top = page.page.evaluate("([x, y]) => document.elementFromPoint(x, y).dataset.key", [box["x"] + box["width"] / 2, box["y"] + box["height"] / 2])
                self.assertEqual(top, "limits.stroke")
                self.assertIn("pan-y", page.page.locator("#stage").evaluate("e => getComputedStyle(e).touchAction"))

    def test_presenting_shows_the_cam_and_one_diagram_in_large_type(self):
        page = self.page()
        page.page.click("#present")
        self.assertFalse(page.page.is_visible("#panel"))
        self.assertEqual(page.page.locator(".chart:visible").count(), 1)
        self.assertGreaterEqual(float(page.page.eval_on_selector("body", "e => parseFloat(getComputedStyle(e).fontSize)")), 20)
        page.page.locator("#present").evaluate("e => e.blur()")
        first = page.page.locator(".chart.large").get_attribute("data-chart")
        page.page.keyboard.press("ArrowRight")
        self.assertNotEqual(page.page.locator(".chart.large").get_attribute("data-chart"), first)
        page.page.keyboard.press("Escape")
        page.until("it ends", lambda: page.page.is_visible("#panel"))

    def test_keys_on_a_slider_give_round_numbers_and_one_step_of_the_history(self):
        page = self.page()
        page.page.focus('input[data-key="limits.curvature"]')
        for _ in range(4):
            page.does(lambda: page.page.keyboard.press("ArrowRight"))
        number = float(page.value("limits.curvature").split()[0])
        self.assertAlmostEqual(number * 10, round(number * 10))
        page.does(lambda: page.page.click("#undo"))
        self.assertEqual(page.value("limits.curvature"), "5 mm")

    def test_the_slate_names_the_values_that_differ(self):
        page = self.page()
        page.page.click("#pin")
        page.sets("gait.step_frequency", "2 Hz")
        page.page.click("#tab-compare")
        rows = page.page.eval_on_selector_all(".slate tr.input", "all => all.map(e => e.innerText)")
        self.assertEqual(len(rows), 1)
        self.assertRegex(rows[0], r"Step frequency\s+2 Hz\s+1\.85 Hz")

    def test_the_list_of_versions_goes_back_to_one(self):
        page = self.page()
        for stroke in ("61 mm", "62 mm", "63 mm"):
            page.sets("limits.stroke", stroke)
            page.page.locator("#verdict").click()
        page.page.click("#versions")
        self.assertEqual("Stroke 63 mm", page.page.inner_text('.history [aria-current="true"]'))
        page.does(lambda: page.page.click('.history [data-version="1"]'))
        self.assertEqual(page.value("limits.stroke"), "61 mm")
        page.does(lambda: page.page.click("#redo"))
        self.assertEqual(page.value("limits.stroke"), "62 mm")

    def test_all_files_come_as_one_archive(self):
        page = self.page()
        page.page.click("#open-export")
        names = page.page.eval_on_selector_all(".exports ul a[download]", "all => all.map(a => a.download).filter(n => n !== 'footbridge.html')")
        with page.page.expect_download(timeout=60_000) as waiting:
            page.page.click("#export-all")
        path = Path(tempfile.mkdtemp()) / "all.zip"
        waiting.value.save_as(path)
        with zipfile.ZipFile(path) as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual(archive.namelist(), names)

    def test_points_of_a_drawn_force_are_dragged_on_the_force_diagram(self):
        page = self.page()
        page.sets("limits.stroke", "")
        page.page.click("#tab-force")
        page.does(lambda: page.page.click("#draw-force"))
        self.assertEqual(page.page.locator(".chart.force .knot").count(), 12)
        force = page.page.get_attribute("#design", "data-force-hash")
        before = page.revision()
        self.drags(page, '.chart.force .knot[data-knot="3"]', 0, 14).up()
        page.shown(before)
        page.until("the force is another one", lambda: page.page.get_attribute("#design", "data-force-hash") != force)
        page.does(lambda: page.page.click("#undo"))
        self.assertEqual(page.page.get_attribute("#design", "data-force-hash"), force)

    def test_a_lift_of_the_programme_takes_its_return_along(self):
        page = self.page()
        page.opens("camdas_09_eight_motions")
        page.page.click("#tab-programme")
        page.does(lambda: page.page.fill('[name="law.segment.1.lift"]', "12 mm"))
        self.assertEqual(page.page.input_value('[name="law.segment.3.lift"]'), "-12 mm")
        self.assertNotEqual(page.verdict(), "pending")

    def test_lengths_are_shown_in_inches_everywhere_and_the_scene_keeps_its_own(self):
        page = self.page()
        stroke = float(page.page.locator("#figures dd").nth(2).inner_text().split()[0])
        page.page.click(".menu summary")
        page.does(lambda: page.page.select_option("#units", "in"))
        number, unit = page.page.locator("#figures dd").nth(2).inner_text().split()
        self.assertEqual(unit, "in")
        self.assertAlmostEqual(float(number), stroke / 25.4, delta=6e-4)
        self.assertRegex(page.page.inner_text(".chart.s h2"), "in$")
        self.assertRegex(page.page.inner_text(".chart.a h2"), "in/s²$")
        page.page.wait_for_timeout(300)
        for selector in ("#figures", "#limits", "#charts"):
            self.assertNotRegex(page.page.inner_text(selector), r"\d\s*(mm|m/s)")
        self.assertEqual(page.value("limits.stroke"), "60 mm")
        page.does(lambda: page.page.select_option("#units", "mm"))
        self.assertIn("mm", page.page.locator("#figures dd").nth(2).inner_text())

    def test_a_running_recording_is_taken_by_the_button_that_its_fault_offers(self):
        if not RUNNING.is_file():
            self.skipTest(f"{RUNNING} is not there")
        page = self.page()
        page.sets("limits.stroke", "")
        page.page.click("#tab-force")
        page.page.set_input_files("#pick-file", RUNNING)
        page.until("the fault offers it", lambda: page.page.locator("#fault button", has_text="running").count() == 1)
        self.assertEqual(page.verdict(), "pending")
        page.does(lambda: page.page.locator("#fault button", has_text="running").click())
        self.assertEqual(page.value("gait.kind"), "running")
        self.assertEqual(page.value("gait.file"), RUNNING.name)
        self.assertFalse(page.page.is_visible("#fault"))
        self.assertFalse(page.page.is_visible("#notice"))

    def test_a_dialog_opens_at_its_top(self):
        page = self.page()
        page.page.click("#open-scenes")
        page.page.locator("#dialog").evaluate("e => { e.scrollTop = 700; }")
        page.page.keyboard.press("Escape")
        page.page.click("#open-scenes")
        self.assertEqual(page.page.locator("#dialog").evaluate("e => e.scrollTop"), 0)


if __name__ == "__main__":
    unittest.main()
