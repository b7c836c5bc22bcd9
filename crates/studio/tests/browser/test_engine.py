"""The page with each of its engines: that of the server, and the one inside the page. Run by run.sh."""

import time
import unittest
from pathlib import Path
from zipfile import ZipFile

from studio import DIST, Browser, Native, Server


class Engine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def page(self, url, **more):
        page = self.browser.page(url, **more)
        self.addCleanup(page.page.context.close)
        return page

    def served(self):
        server = Server()
        self.addCleanup(server.kill)
        return server

    def kind(self, page):
        return page.page.evaluate("document.documentElement.dataset.engine")

    def test_the_page_says_which_engine_it_has(self):
        page = self.page(self.served().url)
        self.assertEqual(self.kind(page), "wasm" if DIST else "native")
        self.assertEqual(page.verdict(), "acceptable")
        self.assertRegex(page.page.get_attribute("#design", "data-force-hash"), "^[0-9a-f]{64}$")

    @unittest.skipIf(DIST, "static files have no server to restart")
    def test_a_restart_on_the_same_folder_is_found_again(self):
        server = Native()
        page = self.page(server.url)
        before = server.url
        server.kill()
        server.start()
        self.addCleanup(server.kill)
        self.assertEqual(server.url, before)
        page.sets("limits.stroke", "71 mm")
        self.assertEqual(page.value("limits.stroke"), "71 mm")

    @unittest.skipUnless(DIST, "the page in one file is made by web/build.sh")
    def test_one_file_opens_without_any_server(self):
        start = time.monotonic()
        page = self.page((Path(DIST).resolve() / "gaitcam.html").as_uri())
        took = time.monotonic() - start
        self.assertEqual(self.kind(page), "wasm")
        self.assertEqual(page.verdict(), "acceptable")
        load = page.page.evaluate("performance.getEntriesByType('navigation')[0].loadEventEnd")
        first = page.page.evaluate("performance.now()")
        print(f"\n  one file: load {load:.0f} ms, first design at most {first:.0f} ms after the start, {took:.2f} s with the test")
        page.sets("limits.stroke", "71 mm")
        self.assertEqual(page.said, [])

    @unittest.skipUnless(DIST, "the page in one file is made by web/build.sh")
    def test_one_file_gives_every_file_and_saves_under_a_chosen_name(self):
        page = self.page((Path(DIST).resolve() / "gaitcam.html").as_uri())
        page.page.click("#open-export")
        names = page.page.eval_on_selector_all(".exports li a[download]", "all => all.map(a => a.download)")
        with page.page.expect_download() as waiting:
            page.page.click("#export-all")
        files = ZipFile(waiting.value.path())
        self.assertEqual(files.namelist(), [n for n in names if n != "footbridge.html"])
        for name, begins in (("drawing.pdf", b"%PDF-"), ("profile.xlsx", b"PK"), ("cam.step", b"ISO-10303-21"), ("cam.png", b"\x89PNG")):
            self.assertEqual(files.read(name)[: len(begins)], begins, name)
        page.page.keyboard.press("Escape")
        page.page.click("#open-save")
        page.page.fill("#save-name", "my walk")
        with page.page.expect_download() as waiting:
            page.page.click("#dialog button[type=submit]")
        self.assertEqual(waiting.value.suggested_filename, "my walk.toml")
        self.assertIn("[gait]", Path(waiting.value.path()).read_text())
        self.assertEqual(page.said, [])

    @unittest.skipUnless(DIST, "the server of the studio must run")
    def test_after_the_first_visit_it_opens_without_a_network(self):
        server = Server()
        page = self.page(server.url)
        page.page.evaluate("navigator.serviceWorker.ready.then(() => true)")
        page.until("the files are kept", lambda: page.page.evaluate("caches.keys().then((k) => k.length > 0)"))
        server.kill()
        page.page.reload()
        page.shown(0)
        page.sets("limits.stroke", "71 mm")
        self.assertEqual(page.verdict(), "acceptable")

    @unittest.skipUnless(DIST, "the native engine is cancelled in test_studio")
    def test_a_search_that_is_given_up_leaves_the_engine_free(self):
        page = self.page(self.served().url)
        page.opens("heel_tester_fitted")
        page.page.fill('[name="limits.pressure_angle"]', "21 deg")
        page.page.wait_for_timeout(40)
        before = time.monotonic()
        page.opens("footbridge")
        self.assertEqual(page.verdict(), "acceptable")
        self.assertLess(time.monotonic() - before, 10)


if __name__ == "__main__":
    unittest.main()
