"""Links, reloads and exported pages contain the whole scene with its recording. A damaged link is reported."""

import os
import random
import re
import unittest

from playwright.sync_api import Error
from studio import DIST, ROOT, Page, Pages
from walks import ASKS_CLOCK, ASKS_MASS, BINARY, LONG, LONG_ASKS_CLOCK, SMALL

STEPS = int(os.environ.get("GAITCAM_SHARING_STEPS", "24"))
SEED = int(os.environ.get("GAITCAM_SEED", "1"))
DIGITS = 1e-9


def data(response):
    """The data of an answer; nothing of one before the last navigation."""
    try:
        return response.json()
    except Error:
        return {}


class Sharing(Pages):
    def fresh(self, address=""):
        """Page in another browser."""
        context = self.browser.context(viewport={"width": 1400, "height": 900})
        self.addCleanup(context.close)
        page = self.browser.page(None, context=context)
        page.answers = []
        page.page.on("response", lambda r: page.answers.append(r) if r.url.split("?")[0].endswith("/design") else None)
        page.page.goto(self.server.url + address)
        page.until("the page is there", lambda: page.revision() > 0 or page.page.is_visible("#fault"))
        page.until("it is at rest", lambda: page.page.get_attribute("#design", "aria-busy") == "false")
        if page.page.is_visible("#welcome-close"):
            page.page.click("#welcome-close")
        return page

    def take(self, page, file):
        name, data = file
        page.page.click("#tab-force")
        before = page.revision()
        page.page.set_input_files("#pick-file", {"name": name, "mimeType": "text/csv", "buffer": data})
        page.until("it is read or refused", lambda: page.revision() > before or page.page.is_visible("#fault"))
        page.until("it is at rest", lambda: page.page.get_attribute("#design", "aria-busy") == "false")

    def link(self, page):
        """Packed scene, and its contents according to the dialog."""
        page.page.click("#link")
        page.page.wait_for_selector("#share-link")
        text = page.page.input_value("#share-link")
        inside = page.page.eval_on_selector_all("[data-inside]", "all => all.map((e) => e.dataset.inside)")
        page.page.click("#dialog-close")
        return re.search(r"#s=[\w-]+$", text).group(0), inside

    def shown(self, page):
        """Verdict, accepted questions and figures; with the native engine also the numbers."""
        figures = page.page.eval_on_selector_all("#figures dd", "all => all.map((e) => e.textContent)")
        accepted = page.page.eval_on_selector_all("[data-accepted]", "all => all.map((e) => e.dataset.accepted)")
        numbers = {}
        if not DIST:
            last = [a for a in (data(r) for r in page.answers[-8:]) if "numbers" in a and not a["quick"]]
            numbers = last[-1]["numbers"] if last else {}
        return page.verdict(), accepted, figures, numbers

    def assert_same(self, one, other, what=""):
        self.assertEqual(one[:3], other[:3], what)
        for key, x in one[3].items():
            y = other[3][key]
            equal = x == y or (x is not None and y is not None and abs(x - y) <= DIGITS * max(abs(x), abs(y), 1e-3))
            self.assertTrue(equal, f"{what}: {key} is {x} and {y}")

    def page_with(self, file, accept=False):
        page = self.fresh()
        page.sets("limits.stroke", "")
        self.take(page, file)
        if accept:
            page.page.locator("#conflict .choice").first.wait_for()
            page.does(lambda: page.page.locator("#conflict .choice").first.click())
        return page

    def test_a_link_gives_the_same_design_in_another_browser_for_every_kind_of_recording(self):
        kinds = [(SMALL, False, "whole"), (LONG, False, "cycle"), (BINARY, False, "cycle"), (ASKS_CLOCK, False, "whole"), (ASKS_CLOCK, True, "whole"),
                 (LONG_ASKS_CLOCK, False, "cycle"), (LONG_ASKS_CLOCK, True, "cycle"), (ASKS_MASS, True, "whole")]
        for file, accept, how in kinds:
            with self.subTest(f"{file[0]}, accepted: {accept}"):
                page = self.page_with(file, accept)
                before = self.shown(page)
                self.assertEqual(bool(before[1]), accept)
                link, inside = self.link(page)
                self.assertEqual(inside, [how])
                self.assert_same(before, self.shown(self.fresh(link)), file[0])
                # The link is valid after a reload too.
                page.until("the address holds it", lambda: "#s=" in page.page.url)
                page.page.wait_for_timeout(600)
                page.page.reload()
                page.shown(0)
                again, inside = self.link(page)
                self.assertEqual(inside, [how])
                self.assert_same(before, self.shown(self.fresh(again)), f"{file[0]} after a reload")
                self.assertEqual(page.said, [])

    def test_the_address_is_as_good_as_a_link(self):
        page = self.page_with(LONG)
        before = self.shown(page)
        page.page.wait_for_timeout(1500)
        address = re.search(r"#s=.*$", page.page.url).group(0)
        self.assert_same(before, self.shown(self.fresh(address)))

    def test_contacts_and_picture_survive_where_the_file_is_and_else_the_panel_says_so(self):
        page = self.page_with(LONG)
        page.page.wait_for_selector("#contact-2")
        page.does(lambda: page.page.click("#contact-2"))
        before = self.shown(page)
        link, _ = self.link(page)
        other = self.fresh(link)
        self.assert_same(before, self.shown(other), "with a contact left out")
        other.page.click("#tab-force")
        self.assertIn(LONG[0], other.page.inner_text("#cycle-only"))
        page.page.wait_for_timeout(600)
        page.page.reload()
        page.shown(0)
        page.page.click("#tab-force")
        page.page.wait_for_selector("#contact-2")
        self.assertFalse(page.page.is_checked("#contact-2"))
        self.assertTrue(page.page.is_checked("#contact-1"))
        # A new tab of the same browser contains the file too.
        tab = self.browser.page(self.server.url + link, context=page.page.context)
        tab.page.click("#tab-force")
        tab.page.wait_for_selector("#contact-2")
        self.assertEqual(tab.page.locator("#cycle-only").count(), 0)

    def test_what_a_link_cannot_hold_is_said_before_it_is_copied(self):
        page = self.fresh()
        rows = "".join(f"{k},{k % 7}.25,{k % 5}.5\n" for k in range(9000))
        self.take(page, ("table.csv", f"a,b,c\n{rows}".encode()))
        page.until("it is refused", lambda: page.page.is_visible("#fault"))
        page.page.click("#link")
        page.page.wait_for_selector("[data-inside=not]")
        self.assertIn("table.csv", page.page.inner_text("#share-inside"))

    def test_a_short_link_has_a_qr_code_and_a_long_one_says_why_not(self):
        page = self.fresh()
        page.page.click("#link")
        page.page.wait_for_selector("svg#share-code")
        page.page.click("#dialog-close")
        self.take(page, SMALL)
        page.page.click("#link")
        page.page.wait_for_selector("p#share-code")
        self.assertRegex(page.page.inner_text("#share-code"), r"\d{4}")

    def test_a_damaged_link_says_so_and_the_page_opens_its_default_scene(self):
        page = self.fresh()
        page.sets("limits.stroke", "66 mm")
        link, _ = self.link(page)
        middle = len(link) // 2
        other = "A" if link[middle] != "A" else "B"
        for broken in (link[:-20], link[:middle], "#s=", "#s=abc", link[:middle] + other + link[middle + 1 :]):
            with self.subTest(broken[:12] + f"… {len(broken)}"):
                page = self.fresh(broken)
                page.until("it is said", lambda: page.page.is_visible("#notice"))
                self.assertIn("damaged", page.page.inner_text("#notice"))
                self.assertEqual(page.page.inner_text("#scene-name"), "footbridge")
                self.assertEqual(page.value("limits.stroke"), "60 mm")
                page.page.wait_for_timeout(7000 if broken == "#s=" else 0)
                self.assertTrue(page.page.is_visible("#notice"))

    def test_description_and_preview_are_in_the_page(self):
        page = self.fresh()
        for name in ("meta[name=description]", "meta[property='og:title']", "meta[property='og:description']"):
            self.assertGreater(len(page.page.get_attribute(name, "content")), 10, name)
        if DIST:
            self.assertTrue(page.page.get_attribute("meta[property='og:image']", "content").endswith("preview.png"))

    @unittest.skipUnless(DIST, "the page in one file is made by the static page")
    def test_the_exported_page_has_the_whole_recording(self):
        page = self.page_with(LONG)
        before = self.shown(page)
        page.page.click("#link")
        with page.page.expect_download() as waiting:
            page.page.click("#share-page")
        self.assertEqual(waiting.value.suggested_filename, "long_walk.html")
        path = waiting.value.path()
        one = self.browser.context().new_page()
        self.addCleanup(one.close)
        one.goto(f"file://{path}")
        opened = Page(one)
        opened.shown(0)
        self.assert_same(before, self.shown(opened))
        one.click("#tab-force")
        one.wait_for_selector("#contact-2")


class Driver:
    """Random steps on a page. Its contents are compared with those of its link in another browser."""

    FILES = [SMALL, LONG, BINARY, ASKS_CLOCK, ASKS_MASS]

    def __init__(self, test, page, rng):
        self.test, self.page, self.rng = test, page, rng
        self.log = []

    def rest(self):
        self.page.until("it is at rest", lambda: self.page.page.get_attribute("#design", "aria-busy") == "false")
        self.page.page.wait_for_timeout(60)
        self.page.until("it is at rest", lambda: self.page.page.get_attribute("#design", "aria-busy") == "false")

    def step(self):
        kind = self.rng.choice(["drop", "drop", "option", "edit", "undo", "redo", "reload", "answer", "tick"])
        page = self.page.page
        if kind == "drop":
            file = self.rng.choice(self.FILES)
            self.test.take(self.page, file)
            self.log.append(f"drop {file[0]}")
        elif kind == "option":
            key, value = self.rng.choice([("gait.kind", "running"), ("gait.kind", ""), ("gait.mass", "70 kg"), ("gait.rate", ""), ("gait.period", "1.1 s")])
            page.evaluate(TYPE, [key, value])
            self.log.append(f"{key} = {value}")
        elif kind == "edit":
            value = self.rng.choice(["", "120 mm", "90 mm"])
            page.evaluate(TYPE, ["limits.stroke", value])
            self.log.append(f"stroke {value}")
        elif kind in ("undo", "redo"):
            page.evaluate(f"document.querySelector('#{kind}').click()")
            self.log.append(kind)
        elif kind == "reload":
            page.wait_for_timeout(700)
            page.reload()
            self.page.until("the page is there", lambda: self.page.revision() > 0 or page.is_visible("#fault"))
            self.log.append(kind)
        elif kind == "answer":
            choice = page.locator("#conflict .choice:visible, #fault button:visible, [data-accepted]:visible")
            if choice.count() > 0:
                choice.first.click()
                self.log.append(kind)
        else:
            page.click("#tab-force")
            page.wait_for_timeout(300)
            if page.locator("#contact-1").count() > 0:
                page.click("#contact-1")
                page.wait_for_timeout(300)
                self.log.append(kind)
        self.rest()


TYPE = """([key, value]) => {
    const field = document.querySelector(`[name="${key}"]`);
    if (!field || field.disabled) return;
    field.focus();
    field.value = value;
    field.dispatchEvent(new Event("input", { bubbles: true }));
    field.dispatchEvent(new Event("change", { bubbles: true }));
    field.blur();
}"""


class Model(Sharing):
    def test_after_random_steps_the_link_shows_the_same_in_another_browser(self):
        rng = random.Random(SEED)
        page = self.fresh()
        driver = Driver(self, page, rng)
        compared = 0
        for _ in range(STEPS):
            driver.step()
            before = self.shown(page)
            link, inside = self.link(page)
            if "not" in inside:
                continue
            other = self.fresh(link)
            said = f"seed {SEED}: {driver.log[-8:]}"
            if before[0] == "pending":
                self.assertEqual(other.verdict(), "pending", said)
            else:
                self.assert_same(before, self.shown(other), said)
                compared += 1
            other.page.context.close()
        self.assertGreater(compared, STEPS // 4, driver.log)


for name in [n for n in dir(Sharing) if n.startswith("test_")]:
    setattr(Model, name, None)

if __name__ == "__main__":
    unittest.main()
