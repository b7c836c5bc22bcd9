"""Dialogs: scenes by group and search, files by purpose, notices above the overlay, saving."""

import io
import unittest
import zipfile
from datetime import datetime, timedelta
from pathlib import Path

from studio import ROOT, Pages, of_server


class Dialogs(Pages):
    def quiet(self, page):
        self.assertEqual(page.said, [])

    def test_scenes_stand_in_groups_and_a_search_finds_the_others(self):
        page = self.page()
        page.page.click("#open-scenes")
        self.assertGreaterEqual(page.page.locator(".gallery [data-group]").count(), 5)
        names = page.page.eval_on_selector_all("[data-scene]", "all => all.map(e => e.dataset.scene)")
        self.assertEqual(len(names), len(set(names)))
        files = {file.stem for file in (ROOT / "scenes").glob("*.toml")}
        self.assertEqual(files - set(names), {"thesis_iteration_1", "thesis_iteration_2", "thesis_iteration_3"})
        for title in page.page.eval_on_selector_all(".card b", "all => all.map(e => e.innerText)"):
            self.assertRegex(title, r"^[A-Z]")
            self.assertNotIn("_", title)
        page.page.fill("#find-scene", "iteration 2")
        self.assertEqual(page.page.locator("[data-scene]").count(), 1)
        page.does(lambda: page.page.click("[data-scene]"))
        self.assertEqual(page.page.inner_text("#scene-name"), "thesis_iteration_2")
        page.page.click("#open-scenes")
        page.page.fill("#find-scene", "no such thing")
        self.assertEqual(page.page.locator("[data-scene]").count(), 0)
        self.quiet(page)

    def test_scenes_are_found_by_words_of_the_language_without_accents(self):
        page = self.page()
        page.page.click("#language")
        page.page.click("#open-scenes")
        page.page.fill("#find-scene", "HIDRAULICO")
        self.assertEqual(page.page.get_attribute("[data-scene]", "data-scene"), "heel_tester")

    def test_the_measured_walk_brings_its_recording(self):
        page = self.page()
        page.opens("measured_walk")
        self.assertEqual(page.verdict(), "acceptable")
        self.assertEqual(page.page.inner_text("#scene-name"), "measured_walk")
        self.assertTrue(page.page.get_attribute("#design", "data-force-hash"))
        self.assertFalse(page.page.is_visible("#fault"))
        self.quiet(page)

    def test_files_stand_under_what_they_are_wanted_for(self):
        page = self.page()
        page.page.click("#open-export")
        groups = page.page.eval_on_selector_all(
            ".exports [data-intent]", "all => Object.fromEntries(all.map(e => [e.dataset.intent, [...e.querySelectorAll('a')].map(a => a.download)]))"
        )
        self.assertEqual(list(groups), ["cut", "print", "control", "show"])
        where = {name: intent for intent, names in groups.items() for name in names}
        wanted = {"profile.dxf": "cut", "cam.step": "cut", "profile.stl": "print", "profile.3mf": "print", "ecam_codesys.st": "control",
                  "law.csv": "control", "report.html": "show", "cam.gif": "show", "scene.toml": "show"}
        self.assertEqual({name: where[name] for name in wanted}, wanted)
        self.assertGreaterEqual(len(where), 26)
        texts = page.page.eval_on_selector_all(".exports small", "all => all.map(e => e.innerText)")
        self.assertFalse([text for text in texts if text.startswith("studio-")])
        self.quiet(page)

    def test_the_archive_is_deflated_and_dated_today(self):
        page = self.page()
        page.page.click("#open-export")
        with page.page.expect_download(timeout=60_000) as waiting:
            page.page.click("#export-all")
        self.assertEqual(waiting.value.suggested_filename, "footbridge.zip")
        data = Path(waiting.value.path()).read_bytes()
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            self.assertIsNone(archive.testzip())
            entries = archive.infolist()
        self.assertLess(len(data), 0.6 * sum(e.file_size for e in entries))
        for entry in entries:
            self.assertLess(abs(datetime.now() - datetime(*entry.date_time)), timedelta(days=1, hours=1))
        self.quiet(page)

    @of_server
    def test_notices_are_above_the_veil_and_can_be_closed(self):
        page = self.page()
        page.page.click("#open-files")
        page.page.fill("#open-link", "nonsense")
        page.page.keyboard.press("Enter")
        page.until("it is said", lambda: page.page.is_visible("#notice"))
        on_top = """() => {
            const {x, y, width, height} = document.querySelector("#notice-text").getBoundingClientRect();
            return document.elementFromPoint(x + width / 2, y + height / 2)?.closest("#notice") !== null;
        }"""
        self.assertTrue(page.page.evaluate(on_top))
        page.page.click("#notice-close")
        self.assertFalse(page.page.is_visible("#notice"))
        page.page.press("#open-link", "Enter")
        page.until("it is said", lambda: page.page.is_visible("#notice"))
        page.page.keyboard.press("Escape")
        self.assertTrue(page.page.evaluate("document.querySelector('#notice').parentElement === document.body"))
        self.assertTrue(page.page.evaluate(on_top))
        self.quiet(page)

    def test_an_error_of_an_export_is_above_the_veil(self):
        page = self.page()
        page.page.click("#open-export")
        page.page.fill("#tool", "-3 mm")
        page.page.click('a[download="cutter.csv"]')
        page.until("it is said", lambda: page.page.is_visible("#notice"))
        page.page.click("#notice-close")
        self.assertFalse(page.page.is_visible("#notice"))

    def test_nothing_is_saved_as_green_while_a_value_is_refused(self):
        page = self.page()
        page.page.fill('[name="cam.bore"]', "5 kg")
        page.until("it is refused", lambda: page.page.locator('#values [aria-invalid="true"]').count() == 1)
        page.page.click("#open-save")
        self.assertIn("Bore", page.page.inner_text("#save-refused"))
        self.assertEqual(page.page.locator("#dialog button[type=submit]").count(), 0)
        self.assertEqual(page.verdict(), "pending")

    def test_versions_name_values_as_the_form_does(self):
        page = self.page()
        page.sets("limits.stroke", "62 mm")
        page.page.click("#versions")
        self.assertIn("Stroke", page.page.inner_text('[aria-current="true"]'))
        self.assertNotIn("limits.", page.page.inner_text("#dialog"))

    def test_dialogs_open_in_both_languages_at_every_width(self):
        for width in (390, 1024, 1440):
            page = self.page(width=width)
            for _ in range(2):
                for button in ("#open-scenes", "#open-export", "#open-files", "#open-save", "#versions"):
                    if not page.page.is_visible(button):
                        page.page.click("#more")
                    page.page.click(button)
                    self.assertNotRegex(page.page.inner_text("#dialog"), r"(?<![\w/-])studio-")
                    wide = page.page.evaluate("document.querySelector('#dialog').scrollWidth - document.querySelector('#dialog').clientWidth")
                    self.assertLessEqual(wide, 0, (button, width))
                    page.page.keyboard.press("Escape")
                page.page.click("#language")
            self.quiet(page)


if __name__ == "__main__":
    unittest.main()
