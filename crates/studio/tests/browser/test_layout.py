"""Layout: cause and effect in one view at every size, complete texts, print, page in a frame."""

import itertools
import re
import unittest

from studio import Pages

SIZES = [(390, 844), (820, 1180), (1024, 768), (1440, 900), (1920, 1080)]
# Texts that are wider than their boxes.
CUT_OFF = """() => {
    const texts = "h1, h2, dt, dd, dd span, small, p, li, button, summary, .scene-name, figcaption, .enlarge, label, td, th";
    const seen = (e) => e.checkVisibility({visibilityProperty: true}) && !e.closest(".unused, .hidden, .skip, [role=tabpanel]");
    return [...document.querySelectorAll(texts)].filter((e) => seen(e) && e.clientWidth > 0 && e.scrollWidth > e.clientWidth + 1)
        .map((e) => `${e.tagName} ${e.id} ${e.className} ${e.textContent.trim().slice(0, 40)}`);
}"""
# Numbers of an axis that extend beyond the left edge of their picture.
LABELS_OUT = """() => [...document.querySelectorAll(".chart .tick")]
    .filter((e) => e.getBoundingClientRect().left < e.closest(".chart").getBoundingClientRect().left - 0.5).map((e) => e.textContent)"""
SIDEWAYS = "document.documentElement.scrollWidth - innerWidth"


class Layout(Pages):
    def page(self, tag="en", **more):
        page = super().page(**more)
        if tag == "es":
            page.does(lambda: page.page.click("#language"))
        return page

    def share(self, page, selector):
        """Part of an element that is inside the window."""
        inside = """e => {
            const b = e.getBoundingClientRect();
            const part = (low, high, size) => Math.max(0, Math.min(high, size) - Math.max(low, 0)) / (high - low);
            return part(b.left, b.right, innerWidth) * part(b.top, b.bottom, innerHeight);
        }"""
        return page.page.locator(selector).first.evaluate(inside)

    def test_cam_and_force_are_seen_while_a_slider_is_moved(self):
        for width, height in SIZES:
            with self.subTest(f"{width}x{height}"):
                page = self.page(width=width, height=height)
                slider = page.page.locator('[data-key="limits.stroke"]')
                slider.scroll_into_view_if_needed()
                page.page.wait_for_timeout(100)
                self.assertGreater(self.share(page, '[data-key="limits.stroke"]'), 0.99)
                self.assertGreater(self.share(page, "#stage"), 0.95)
                # On a phone, a part of the force is visible beside the cam, and the rest after a swipe.
                self.assertGreater(self.share(page, ".chart.large"), 0.4 if width < 700 else 0.95)
                covered = "e => { const b = e.getBoundingClientRect(); return e.contains(document.elementFromPoint(b.left + b.width / 2, b.top + b.height / 2)); }"
                self.assertTrue(page.page.locator("#stage").evaluate(covered))
                self.assertTrue(slider.evaluate(covered))
                self.assertLessEqual(page.page.evaluate(SIDEWAYS), 0)
                if width < 700:
                    page.page.evaluate("document.querySelector('.swipe').scrollTo({left: 1000})")
                    page.page.wait_for_timeout(600)
                    page.page.evaluate("document.querySelector('.chart.large').scrollIntoView({inline: 'center', block: 'nearest'})")
                    page.page.wait_for_timeout(600)
                    self.assertGreater(self.share(page, ".chart.large"), 0.95)

    def test_no_text_is_cut_at_five_sizes_in_both_languages(self):
        for (width, height), tag in itertools.product(SIZES, ["en", "es"]):
            with self.subTest(f"{width} {tag}"):
                page = self.page(tag, width=width, height=height)
                page.sets("limits.stroke", "20 mm")
                page.page.wait_for_selector("#conflict .relax", state="attached")
                self.assertEqual(page.page.evaluate(CUT_OFF), [])
                self.assertEqual(page.page.evaluate(LABELS_OUT), [])
                self.assertLessEqual(page.page.evaluate(SIDEWAYS), 0)

    def test_a_name_of_900_characters_leaves_the_page_as_wide_as_the_window(self):
        for width, height in [(390, 844), (1024, 768), (1440, 900)]:
            with self.subTest(width):
                page = self.page(width=width, height=height)
                page.sets("name", "long " + "n" * 895)
                self.assertLessEqual(page.page.evaluate(SIDEWAYS), 0)
                self.assertGreater(self.share(page, "#stage"), 0.5)

    def test_small_numbers_of_an_axis_are_read_in_full(self):
        page = self.page(width=1440, height=900)
        page.sets("gait.body_weight", "0.01 N")
        self.assertEqual(page.page.evaluate(LABELS_OUT), [])
        lefts = page.page.evaluate("[...document.querySelectorAll('.chart .grid')].map((e) => e.getAttribute('d').match(/M([\\d.]+)/)[1])")
        self.assertEqual(len(set(lefts)), 1, lefts)

    def test_the_chip_of_a_phone_opens_reason_and_changes(self):
        page = self.page(width=390, height=844)
        page.sets("limits.stroke", "20 mm")
        page.page.wait_for_selector("#conflict .relax", state="attached")
        page.page.locator('[data-key="limits.stroke"]').scroll_into_view_if_needed()
        self.assertEqual(page.page.get_attribute("#chip", "aria-expanded"), "false")
        self.assertFalse(page.page.is_visible("#conflict"))
        page.page.click("#chip")
        self.assertEqual(page.page.get_attribute("#chip", "aria-expanded"), "true")
        self.assertTrue(page.page.is_visible("#verdict-reasons"))
        page.does(lambda: page.page.locator("#conflict .relax").first.click())
        self.assertEqual(page.verdict(), "acceptable")

    def test_the_header_of_a_phone_has_one_row_and_a_menu(self):
        page = self.page(width=390, height=844)
        self.assertLess(page.page.locator(".bar").bounding_box()["height"], 50)
        self.assertFalse(page.page.is_visible("#open-export"))
        page.page.click("#more")
        page.page.click("#open-export")
        self.assertTrue(page.page.is_visible("#dialog .exports"))
        page.page.keyboard.press("Escape")
        self.assertFalse(page.page.is_visible("#open-export"))

    def test_the_verdict_is_said_once_and_the_changes_are_buttons_only(self):
        page = self.page(width=1440, height=900)
        page.sets("limits.stroke", "20 mm")
        page.page.wait_for_selector("#conflict .relax")
        self.assertEqual(page.page.inner_text("body").count("Unacceptable"), 1)
        values = page.page.eval_on_selector_all("#conflict b", "all => all.map((e) => e.textContent)")
        for value in values:
            self.assertNotIn(value, page.page.inner_text("#verdict-reasons"))
        digits = re.findall(r"\d[\d.,]*", page.page.inner_text("#verdict") + page.page.inner_text("#conflict"))
        self.assertLessEqual(max(len(re.sub(r"\D", "", d).lstrip("0")) for d in digits), 4)
        # A change that worsens the objective is offered last, and in grey.
        kinds = page.page.eval_on_selector_all("#conflict .relax", "all => all.map((e) => e.classList.contains('goal'))")
        self.assertEqual(kinds, sorted(kinds))

    def test_a_programme_without_force_shows_no_diagram_of_forces(self):
        page = self.page()
        page.opens("camdas_09_eight_motions")
        shown = page.page.eval_on_selector_all(".chart", "all => all.map((e) => e.dataset.chart)")
        self.assertFalse({"force", "torque", "power"} & set(shown), shown)
        self.assertIn("s", shown)
        self.assertIn("CAM-DAS", page.page.inner_text("#limits"))
        self.assertNotIn("CAM-DAS", page.page.inner_text("#verdict"))
        page.page.click(".menu summary")
        page.page.click("#choose-diagrams")
        page.page.check("#diagram-force")
        page.page.keyboard.press("Escape")
        self.assertTrue(page.page.is_visible(".chart.force"))

    def test_the_lines_on_the_cam_have_names(self):
        page = self.page()
        page.opens("heel_tester_fitted")
        names = page.page.inner_text("#parts")
        for name in ("base circle", "prime circle", "pitch curve", "limit reached"):
            self.assertIn(name, names)
        self.assertIn("at-limit", page.page.eval_on_selector_all(".checks li", "all => all.map((e) => e.className)"))

    def test_the_welcome_goes_with_the_first_change(self):
        page = super().page()
        page.page.evaluate("localStorage.clear()")
        page.page.reload()
        page.shown(0)
        self.assertTrue(page.page.is_visible("#welcome"))
        page.sets("limits.stroke", "61 mm")
        self.assertFalse(page.page.is_visible("#welcome"))

    def test_paper_has_one_or_two_pages_with_values_verdict_and_diagrams(self):
        page = self.page(theme="dark")
        page.sets("limits.stroke", "40 mm")
        page.page.wait_for_selector("#conflict .relax")
        page.page.wait_for_timeout(600)
        for landscape in (False, True):
            pages = len(re.findall(rb"/Type\s*/Page\b", page.page.pdf(format="A4", landscape=landscape)))
            self.assertIn(pages, (1, 2), landscape)
        page.page.emulate_media(media="print")
        page.page.wait_for_selector("#paper svg")
        text = page.page.inner_text("#paper")
        for part in ("footbridge", "Unacceptable.", "Step frequency", "1.85 Hz", "→", "rms", "Remarks"):
            self.assertIn(part, text)
        self.assertRegex(text, r"\b20\d\d\b")
        self.assertTrue(page.page.is_visible("#paper .code svg"))
        self.assertEqual(page.page.locator("button:visible").count(), 0)
        self.assertGreaterEqual(page.page.locator("#paper .copy svg").count(), 9)
        # Numbers of at least 7 pt on a sheet of 186 mm between its margins.
        page.page.set_viewport_size({"width": 703, "height": 1000})
        size = page.page.evaluate("""() => Math.min(...[...document.querySelectorAll("#paper .copy svg")].map((e) =>
            e.getBoundingClientRect().width / e.viewBox.baseVal.width * parseFloat(getComputedStyle(e.querySelector(".tick")).fontSize)))""")
        self.assertGreaterEqual(size * 0.75, 7)

    def test_the_blank_axes_of_an_exercise_have_no_numbers(self):
        page = self.page()
        page.page.evaluate("document.querySelector('#show-exercise').click()")
        self.assertEqual(page.page.locator(".blank .tick.up:visible").count(), 0)
        self.assertGreater(page.page.locator(".blank .tick:visible").count(), 0)

    def test_a_frame_shows_cam_and_diagrams_in_its_height_and_links_to_the_page(self):
        for width, height in [(900, 600), (600, 400), (390, 600)]:
            with self.subTest(width):
                page = super().page(width=width, height=height)
                address = page.page.url.split("#")[0]
                page.page.goto(address + ("&" if "?" in address else "?") + "embed=force,s")
                page.shown(0)
                page.page.wait_for_timeout(200)
                for part in ("#stage", ".chart.force", ".chart.s"):
                    self.assertGreater(self.share(page, part), 0.99, part)
                    self.assertGreater(page.page.locator(part).bounding_box()["height"], 60, part)
                self.assertNotIn("embed", page.page.locator("#whole").evaluate("e => e.href"))
                self.assertTrue(page.page.is_visible("#whole"))


if __name__ == "__main__":
    unittest.main()
