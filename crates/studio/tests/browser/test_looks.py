"""Appearance at four sizes, in both themes and languages: nothing is cut off, and nothing needed is hidden."""

import itertools
import unittest

from studio import ROOT, Pages

SIZES = [(390, 844), (1024, 768), (1440, 900), (1920, 1080)]
PICTURES = ROOT / "target" / "studio-pictures"
# Choices and buttons that are wider than their boxes, and headings without their unit.
CUT_OFF = """() => {
    const pen = document.createElement("canvas").getContext("2d");
    const seen = (e) => e.checkVisibility({visibilityProperty: true}) && !e.closest(".unused");
    const wide = (e) => {
        const style = getComputedStyle(e);
        pen.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
        // An arrow takes about 18 pixels beside the text.
        const room = e.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - 18;
        return pen.measureText(e.selectedOptions[0]?.textContent ?? "").width > room + 0.5;
    };
    const selects = [...document.querySelectorAll("select")].filter((e) => seen(e) && wide(e));
    const buttons = [...document.querySelectorAll("button:not(.enlarge)")].filter((e) => seen(e) && e.scrollWidth > e.clientWidth + 1);
    const units = [...document.querySelectorAll(".chart h2 .enlarge span + span")].filter((e) => seen(e) && e.scrollWidth > e.clientWidth + 1);
    return [...selects, ...buttons, ...units].map((e) => e.id || e.name || e.textContent.slice(0, 40));
}"""


class Looks(Pages):
    def page(self, tag="en", **more):
        page = super().page(**more)
        if tag == "es":
            page.does(lambda: page.page.click("#language"))
        return page

    def test_nothing_is_cut_off_at_four_sizes_in_both_themes_and_languages(self):
        PICTURES.mkdir(parents=True, exist_ok=True)
        for (width, height), (theme, tag) in itertools.product(SIZES, [("light", "en"), ("dark", "es")]):
            with self.subTest(f"{width} {theme} {tag}"):
                page = self.page(tag, width=width, height=height, theme=theme)
                self.assertLessEqual(page.page.evaluate("document.documentElement.scrollWidth - innerWidth"), 0)
                self.assertEqual(page.page.evaluate(CUT_OFF), [])
                if width >= 1400:
                    self.seen_at_once(page, width, height)
                page.page.screenshot(path=PICTURES / f"{width}-{theme}-{tag}.png", full_page=width < 1000)
                page.opens("camdas_09_eight_motions")
                page.page.click("#tab-programme")
                page.page.wait_for_selector('[name="law.segment.1.motion"] option:nth-child(9)', state="attached")
                self.assertEqual(page.page.evaluate(CUT_OFF), [])
                self.assertLessEqual(page.page.locator("#programme .segments").evaluate("e => e.scrollWidth - e.clientWidth"), 0)

    def seen_at_once(self, page, width, height):
        boxes = "all => all.map(e => e.getBoundingClientRect()).map(b => [b.top, b.bottom, b.left, b.right])"
        seen = page.page.eval_on_selector_all("#stage, .chart svg", boxes)
        self.assertGreaterEqual(len(seen), 10)
        for top, bottom, left, right in seen:
            self.assertTrue(top >= 0 and bottom <= height and left >= 0 and right <= width, (top, bottom, left, right))
            self.assertGreater(bottom - top, 50)

    def test_presenting_fits_the_screen_and_shows_the_target_behind_the_force(self):
        for width, height in SIZES:
            page = self.page(width=width, height=height)
            page.page.click("#present")
            page.page.wait_for_timeout(100)
            for part in ("#stage", ".chart.large svg"):
                box = page.page.locator(part).first.bounding_box()
                self.assertGreater(box["height"], 200, (width, part))
                self.assertLessEqual(box["y"] + box["height"], height, (width, part))
            self.assertLessEqual(page.page.locator(".design").evaluate("e => e.scrollHeight - e.clientHeight"), 1)
            wide = "s => parseFloat(getComputedStyle(document.querySelector(s)).strokeWidth)"
            self.assertGreater(page.page.evaluate(wide, ".line.target"), 2 * page.page.evaluate(wide, ".line.main"))

    def test_on_a_phone_the_verdict_stays_with_the_cam_and_a_fault_shows_its_cure(self):
        page = self.page(width=390, height=844)
        page.sets("limits.stroke", "20 mm")
        page.page.locator('[name="limits.stroke"]').scroll_into_view_if_needed()
        page.page.wait_for_timeout(100)
        self.assertEqual(page.page.inner_text("#chip"), "Unacceptable.")
        self.assertGreaterEqual(page.page.locator("#chip").bounding_box()["y"], 0)
        page.page.fill('[name="limits.stroke"]', "20 kg")
        page.until("the fault is told", lambda: page.page.is_visible("#fault"))
        self.assertEqual(page.page.inner_text("#chip"), "–")
        self.assertLessEqual(page.page.locator("#fault").evaluate("e => e.scrollHeight - e.clientHeight"), 0)

    def test_the_picture_of_a_run_opens_large_and_its_figures_are_read_in_full(self):
        page = self.page(width=390, height=844)
        page.page.click("#tab-compare")
        page.page.click("#simulate")
        page.page.wait_for_selector("#motion .picture svg")
        cells = "all => all.filter((e) => e.scrollWidth > e.clientWidth || e.getBoundingClientRect().right > innerWidth).length"
        self.assertEqual(page.page.eval_on_selector_all("#motion td", cells), 0)
        small = page.page.locator("#motion .picture svg").bounding_box()["width"]
        page.page.click("#motion .picture button")
        self.assertGreater(page.page.locator("#dialog .enlarged svg").bounding_box()["width"], 1.5 * small)
        self.assertEqual(page.said, [])

    def test_a_frame_gives_its_last_diagram_the_whole_width(self):
        page = super().page()
        address = page.page.url.split("#")[0]
        page.page.goto(address + ("&" if "?" in address else "?") + "embed=force,s")
        page.shown(0)
        boxes = [page.page.locator(".chart").nth(k).bounding_box() for k in range(2)]
        self.assertAlmostEqual(boxes[0]["width"], boxes[1]["width"], delta=1)

if __name__ == "__main__":
    unittest.main()
