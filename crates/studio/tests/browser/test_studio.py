"""Use of the studio in Chromium. Run by run.sh."""

import csv
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from studio import BINARY, DIST, ROOT, Pages, Server, of_server

# A sequence of convex programs with the requested number of spans (see the test of long searches).
LONG = "heel_tester_fitted"


class Studio(Pages):
    def quiet(self, page):
        self.assertEqual(page.said, [])

    def test_every_scene_opens_and_turns_without_a_word_in_the_console(self):
        page = self.page(turns=True)
        page.page.click("#open-scenes")
        names = page.page.eval_on_selector_all("[data-scene]", "all => all.map(e => e.dataset.scene)")
        page.page.keyboard.press("Escape")
        # Three iterations of the thesis are only found by the search.
        names += [f"thesis_iteration_{i}" for i in range(1, 5) if f"thesis_iteration_{i}" not in names]
        self.assertEqual(len(names), 25)
        for name in names:
            with self.subTest(name):
                page.opens(name)
                self.assertIn(page.verdict(), ("acceptable", "not-for-high-speed", "unacceptable"))
                turn = lambda: page.page.get_attribute("#cam-turning", "transform")
                before = turn()
                page.until("it turns", lambda: turn() != before)
                # A programme without a force has no diagrams of force, torque and power.
                self.assertGreaterEqual(page.page.locator(".chart .line.main").count(), 6)
        self.quiet(page)

    def test_a_slider_leads_to_a_new_revision_and_a_verdict(self):
        page = self.page()
        slider = page.page.locator('input[data-key="limits.stroke"]')
        self.assertEqual(page.verdict(), "acceptable")
        page.does(lambda: slider.evaluate("e => { e.value = e.min; e.dispatchEvent(new Event('input', {bubbles: true})); }"))
        self.assertEqual(page.verdict(), "unacceptable")
        self.assertRegex(page.value("limits.stroke"), r"^\d+(\.\d+)? mm$")
        self.quiet(page)

    def test_wrong_values_are_named_at_their_field_and_the_last_design_stays(self):
        page = self.page()
        revision = page.revision()
        page.page.fill('[name="limits.stroke"]', "40 kg")
        page.until("the fault is shown", lambda: page.page.is_visible("#fault"))
        self.assertEqual(page.page.get_attribute('[name="limits.stroke"]', "aria-invalid"), "true")
        self.assertEqual(page.revision(), revision)
        page.sets("limits.stroke", "61 mm")
        self.assertFalse(page.page.is_visible("#fault"))
        self.quiet(page)

    def test_infeasible_then_a_relaxation_then_acceptable(self):
        page = self.page()
        page.sets("limits.stroke", "40 mm")
        self.assertEqual(page.verdict(), "unacceptable")
        page.page.wait_for_selector("button[data-relax]")
        page.until("it is tried", lambda: page.page.locator('button[data-relax="limits.stroke"]').count() == 1)
        page.does(lambda: page.page.click('button[data-relax="limits.stroke"]'))
        self.assertEqual(page.verdict(), "acceptable")
        self.assertNotEqual(page.value("limits.stroke"), "40 mm")
        self.quiet(page)

    def test_undo_and_redo_go_through_every_step(self):
        page = self.page()
        values = ["61 mm", "62 mm", "63 mm"]
        for value in values:
            page.sets("limits.stroke", value)
            page.page.locator("#verdict").click()
        for value in ["62 mm", "61 mm", "60 mm"]:
            page.does(lambda: page.page.click("#undo"))
            self.assertEqual(page.value("limits.stroke"), value)
        for value in values:
            page.does(lambda: page.page.click("#redo"))
            self.assertEqual(page.value("limits.stroke"), value)
        self.quiet(page)

    def test_the_contour_is_coloured_by_each_quantity(self):
        page = self.page()
        page.page.click(".menu summary")
        ends = {}
        for colour in ["curvature", "force", "hertz", "pressure_angle"]:
            page.does(lambda: page.page.select_option("#colour", colour))
            self.assertGreater(page.page.locator("#stage .coloured").count(), 100, colour)
            ends[colour] = page.page.inner_text("#legend")
        # The ends of the legend equal those of the diagrams and of the tables: 506.4 … 1059 N. A flat face has no angle.
        self.assertRegex(ends["force"], r"^506\s+N\s+1059\s+N$")
        self.assertRegex(ends["pressure_angle"], r"^0\s*°\s*0\s*°$")
        page.does(lambda: page.page.select_option("#colour", "none"))
        self.assertEqual(page.page.locator("#stage .coloured").count(), 0)
        self.assertTrue(page.page.locator("#legend").is_hidden())
        self.quiet(page)

    def test_the_language_changes_at_once_everywhere(self):
        page = self.page()
        self.assertEqual(page.page.get_attribute("html", "lang"), "en")
        page.does(lambda: page.page.click("#language"))
        self.assertEqual(page.page.get_attribute("html", "lang"), "es")
        text = page.page.inner_text("body")
        for word in ["Aceptable", "Carrera", "Exportar", "Fuerza", "Radio base"]:
            self.assertIn(word, text)
        for word in ["Acceptable", "Export ", "Stroke", "undefined", "studio-"]:
            self.assertNotIn(word, text)
        self.quiet(page)

    def test_a_dropped_recording_becomes_a_cam_and_contacts_can_be_left_out(self):
        page = self.page()
        file = ROOT / "data" / "gait_curves" / "setra_2Hz_700N.csv"
        page.sets("limits.stroke", "")
        page.page.click("#tab-force")
        drop = """([name, text]) => {
            const data = new DataTransfer();
            data.items.add(new File([text], name));
            for (const kind of ["dragenter", "dragover", "drop"])
                document.body.dispatchEvent(new DragEvent(kind, {dataTransfer: data, bubbles: true, cancelable: true}));
        }"""
        page.does(lambda: page.page.evaluate(drop, [file.name, file.read_text()]))
        page.page.click("#tab-values")
        self.assertEqual(page.value("gait.file"), file.name)
        self.assertFalse(list(self.server.folder.glob("*.csv")))
        self.quiet(page)

    def test_a_force_drawn_by_hand_becomes_a_cam(self):
        page = self.page()
        page.sets("limits.stroke", "")
        page.page.click("#tab-force")
        page.does(lambda: page.page.click("#draw-force"))
        page.page.wait_for_selector(".editor .knot")
        knot = page.page.locator(".editor .knot").nth(3)
        page.does(lambda: (knot.focus(), page.page.keyboard.press("ArrowUp")))
        self.assertEqual(page.page.locator(".editor .knot").count(), 12)
        page.does(lambda: page.page.click("text=Add a point"))
        self.assertEqual(page.page.locator(".editor .knot").count(), 13)
        self.quiet(page)

    def test_segments_keep_the_turn_whole(self):
        page = self.page()
        page.opens("camdas_09_eight_motions")
        page.page.click("#tab-programme")
        field = page.page.locator('[name="law.segment.2.angle"]')
        page.does(lambda: (field.fill("70 deg"), field.press("Tab")))
        angles = [page.page.input_value(f'[name="law.segment.{i}.angle"]') for i in range(1, 9)]
        total = sum(float(a.strip("°")) for a in angles)
        self.assertAlmostEqual(total, 360.0, places=6)
        self.assertFalse(page.page.is_visible("#fault"))
        page.page.click("[data-segment-row='2'] .law")
        self.assertGreater(page.page.locator(".laws tbody tr").count(), 10)
        self.quiet(page)

    def test_downloads_read_back_as_the_same_cam(self):
        page = self.page()
        page.sets("limits.stroke", "61 mm")
        page.page.click("#open-export")
        names = page.page.eval_on_selector_all("a[download]", "all => all.map(a => a.download)")
        out = Path(tempfile.mkdtemp())
        for name in names:
            page.downloads(name, out / name)
            self.assertGreater((out / name).stat().st_size, 100, name)
        again = out / "again"
        subprocess.run([BINARY, "synth", out / "scene.toml", "--out", again, "--no-png"], check=True, stdout=subprocess.DEVNULL)
        for name in ["law.csv", "profile.csv"]:
            rows, same = (list(csv.reader((folder / name).read_text().splitlines())) for folder in (out, again))
            self.assertEqual((len(rows), rows[0]), (len(same), same[0]), name)
            for one, other in zip(rows[1:], same[1:]):
                for x, y in zip(map(float, one), map(float, other)):
                    # The results of the server are identical; the engine of the page has another sine function.
                    self.assertLessEqual(abs(x - y), 1e-9 * max(abs(x), 1) if DIST else 0, name)
        self.assertEqual(len(list(csv.reader((out / "law.csv").read_text().splitlines()))), 1441)
        self.quiet(page)

    @of_server
    def test_a_scene_is_saved_beside_what_is_there(self):
        page = self.page()
        for name in ["kept.toml", "kept-2.toml"]:
            page.sets("limits.stroke", "61 mm" if name == "kept.toml" else "62 mm")
            page.page.click("#open-save")
            page.page.fill("#save-name", "kept")
            page.page.click("#dialog button[type=submit]")
            page.page.wait_for_selector(f"text={name}")
            page.page.keyboard.press("Escape")
        self.assertIn("61 mm", (self.server.folder / "kept.toml").read_text())
        page.page.click("#open-files")
        page.does(lambda: page.page.click("text=kept.toml"))
        self.assertEqual(page.value("limits.stroke"), "61 mm")
        self.quiet(page)

    def test_a_reload_and_another_tab_keep_the_state(self):
        page = self.page()
        page.sets("limits.stroke", "63 mm")
        page.until("the address holds the scene", lambda: "#s=" in page.page.url)
        page.page.wait_for_timeout(400)
        page.page.reload()
        page.shown(0)
        self.assertEqual(page.value("limits.stroke"), "63 mm")
        other = self.browser.page(page.page.url, context=page.page.context)
        self.assertEqual(other.value("limits.stroke"), "63 mm")
        other.sets("limits.stroke", "64 mm")
        page.sets("cam.bore", "13 mm")
        self.assertEqual(page.value("limits.stroke"), "63 mm")
        self.assertEqual(other.value("cam.bore"), "12 mm")
        self.quiet(page)
        self.quiet(other)

    @of_server
    def test_a_server_that_is_killed_and_started_again_is_told_and_loses_nothing(self):
        server = Server()
        page = self.browser.page(server.url)
        self.addCleanup(page.page.context.close)
        page.sets("limits.stroke", "63 mm")
        page.page.wait_for_timeout(400)
        server.kill()
        page.page.fill('[name="limits.stroke"]', "64 mm")
        page.until("it is told", lambda: page.page.is_visible("#notice"))
        self.assertEqual(page.verdict(), "pending")
        page.page.wait_for_timeout(400)
        address = page.page.url
        server.start(server.port)
        page.page.goto(server.url + "#" + address.split("#")[1])
        page.page.reload()
        page.shown(0)
        # Text typed while the server did not respond is kept.
        self.assertEqual(page.value("limits.stroke"), "64 mm")
        self.assertEqual(server.interrupt(), 0)

    def test_a_long_search_keeps_the_page_alive_and_can_be_cancelled(self):
        page = self.page()
        page.opens(LONG)
        page.sets("law.spans", "400")
        page.page.fill('[name="limits.torque"]', "3 N m")  # half a minute and more of convex programs
        page.page.wait_for_selector("#working:not([hidden])")
        self.assertIn("busy", page.page.get_attribute("#design", "class"))
        page.page.click("#tab-compare")
        page.page.click("#cancel")
        page.page.wait_for_selector("#working", state="hidden")
        page.opens("footbridge")
        self.assertEqual(page.verdict(), "acceptable")
        self.quiet(page)

    def test_pinned_designs_are_compared_and_sensitivities_computed(self):
        page = self.page()
        page.page.click("#tab-compare")
        page.page.click("#pin")
        page.page.click("#tab-values")
        page.sets("gait.step_frequency", "2 Hz")
        page.page.click("#tab-compare")
        self.assertEqual(page.page.locator(".slate thead th").count(), 2)
        self.assertGreaterEqual(page.page.locator(".line.pinned").count(), 9)
        page.page.click("#vary")
        page.page.wait_for_selector(".tornado tr")
        page.page.click("#trade")
        page.page.wait_for_selector(".front .knot", timeout=60000)
        page.does(lambda: page.page.locator(".front .knot").last.click())
        self.quiet(page)

    def test_a_cam_in_motion_and_a_sweep_belong_to_the_design_they_were_computed_from(self):
        page = self.page()
        page.page.click("#tab-compare")
        page.page.click("#simulate")
        page.page.wait_for_selector("#motion svg")
        self.assertIn("N", page.page.inner_text("#motion table"))
        page.page.select_option("#sweep-across", "drive.mass")
        page.page.click("#sweep")
        page.page.wait_for_selector("#grid tbody tr", timeout=60000)
        self.assertEqual(page.page.locator("#grid tbody tr").count(), 13)
        of_another = ":is(#motion, #grid).stale"
        self.assertEqual(page.page.locator(of_another).count(), 0)
        page.page.click("#tab-values")
        page.sets("gait.step_frequency", "2 Hz")
        page.page.click("#tab-compare")
        self.assertEqual(page.page.locator(of_another).count(), 2)
        page.page.click("#simulate")
        page.page.wait_for_selector("#motion:not(.stale) svg")
        page.does(lambda: page.page.locator("#grid td button").first.click())
        self.quiet(page)

    def test_a_log_of_the_machine_gives_its_parameters_and_the_next_cam(self):
        page = self.page()
        page.page.click("#tab-compare")
        page.page.set_input_files("#log", {"name": "short.csv", "mimeType": "text/csv", "buffer": b"time_s,force_n\n0,1\n"})
        page.until("the log is refused", lambda: "short.csv" in page.page.inner_text("#notice"))
        page.page.click("#notice-close")
        page.page.set_input_files("#log", ROOT / "data/logs/made_log.csv")
        page.page.wait_for_selector("#logged svg", timeout=30000)
        self.assertIn("drive.mass", page.page.inner_text("#logged ul"))
        page.does(lambda: page.page.click("#take-next"))
        page.page.click("#tab-text")
        self.assertIn("learned_force", page.page.input_value("#text textarea"))
        self.quiet(page)

    def test_the_keyboard_reaches_everything(self):
        page = self.page()
        page.page.reload()
        page.shown(0)
        page.page.keyboard.press("Tab")
        self.assertEqual(page.page.evaluate("document.activeElement.className"), "skip")
        page.page.focus("#stage")
        page.page.keyboard.press("Home")
        page.page.keyboard.press("ArrowRight")
        self.assertAlmostEqual(float(page.page.get_attribute("#stage", "aria-valuenow")), 1.0, places=6)
        page.page.focus("#tab-values")
        page.page.keyboard.press("ArrowRight")
        self.assertTrue(page.page.is_visible("#force"))
        self.quiet(page)


if __name__ == "__main__":
    unittest.main()
