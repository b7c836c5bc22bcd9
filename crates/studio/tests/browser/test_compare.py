"""Comparison of designs: pinned designs, trade-off, map of designs, and runs."""

import unittest

from studio import Pages


class Compare(Pages):
    def pinned(self, page):
        page.page.click("#pin")
        page.sets("limits.stroke", "40 mm")
        page.page.click("#pin")
        page.sets("gait.step_frequency", "2 Hz")
        page.page.click("#pin")
        page.page.click("#tab-compare")

    def test_pins_are_named_by_what_differs_and_drawn_dashed_with_a_legend(self):
        page = self.page(width=1440, height=900)
        self.pinned(page)
        names = page.page.eval_on_selector_all(".slate .variant", "all => all.map((e) => e.value)")
        self.assertEqual(names, ["footbridge", "footbridge, Stroke 40 mm", "footbridge, Step frequency 2 Hz"])
        for legend in (".chart.large .names", "#parts"):
            for name in names:
                self.assertIn(name, page.page.inner_text(legend))
        dashes = page.page.eval_on_selector_all(".stage .pinned, .line.pinned", "all => all.map((e) => getComputedStyle(e).strokeDasharray)")
        self.assertGreater(len(dashes), 20)
        self.assertNotIn("none", dashes)
        page.page.fill(".slate .variant >> nth=1", "short")
        page.page.keyboard.press("Tab")
        page.until("the legend follows", lambda: "short" in page.page.inner_text("#parts"))
        # Four columns in the panel, without a line break within a word.
        table = page.page.locator(".slate .scroll")
        self.assertLessEqual(table.evaluate("e => e.scrollWidth - e.clientWidth"), 0)
        self.assertEqual(page.page.locator(".slate thead th").count(), 4)
        self.assertEqual(page.said, [])

    def test_the_trade_off_marks_the_present_design_and_its_numbers_stand_apart(self):
        page = self.page(width=1440, height=900)
        page.page.click("#tab-compare")
        page.page.click("#trade")
        page.page.wait_for_selector(".front .knot", timeout=60000)
        self.assertEqual(page.page.locator(".front .present").count(), 1)
        heights = page.page.eval_on_selector_all(".front .knot", "all => all.map((e) => Number(e.getAttribute('cy')))")
        self.assertGreater(max(heights) - min(heights), 100)
        overlaps = page.page.evaluate("""() => {
            const all = [...document.querySelectorAll(".front text")].map((e) => e.getBoundingClientRect());
            return all.some((a, i) => all.some((b, k) => k > i && a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom));
        }""")
        self.assertFalse(overlaps)

    def test_the_map_fits_outlines_the_present_design_and_says_why_a_design_is_not_there(self):
        for theme in ("light", "dark"):
            with self.subTest(theme):
                page = self.page(width=1440, height=900, theme=theme)
                page.page.click("#tab-compare")
                page.page.select_option("#sweep-across", "limits.stroke")
                page.page.select_option("#sweep-down", "gait.step_frequency")
                page.page.click("#sweep")
                page.page.wait_for_selector("#grid tbody tr", timeout=60000)
                self.assertEqual(page.page.locator("#grid thead th").count(), 7)
                fits = "e => e.getBoundingClientRect().right <= document.querySelector('#compare').getBoundingClientRect().right"
                self.assertTrue(page.page.locator("#grid table").evaluate(fits))
                self.assertEqual(page.page.locator("#grid td.here").count(), 1)
                self.assertIn("current", page.page.get_attribute("#grid td.here button", "aria-label"))
                missing = page.page.eval_on_selector_all("#grid button", "all => all.filter((e) => e.textContent === '–').map((e) => e.title)")
                self.assertTrue(all(missing), missing)
                # The contrast of text and background of every cell is sufficient in both themes.
                contrast = page.page.evaluate("""() => {
                    const light = (text) => { const [r, g, b] = text.match(/[\\d.]+/g).map((x) => { const c = x / 255; return c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4; });
                        return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
                    return Math.min(...[...document.querySelectorAll("#grid td[style*=background]")].map((td) => {
                        const [a, b] = [light(getComputedStyle(td).backgroundColor), light(getComputedStyle(td.firstElementChild).color)];
                        return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
                    }));
                }""")
                self.assertGreaterEqual(contrast, 4.5)

    def test_the_results_of_a_machine_come_without_a_button(self):
        page = self.page()
        page.page.click("#tab-text")
        text = page.page.input_value("#scene-text") + '[machine]\nstiffness = "2e6 N/m"\n'
        page.page.fill("#scene-text", text)
        page.does(lambda: page.page.click("#text .main"))
        page.page.click("#tab-compare")
        page.page.wait_for_selector("#motion table", timeout=30000)
        self.assertEqual(page.page.locator("#motion.stale").count(), 0)
        self.assertEqual(page.said, [])


if __name__ == "__main__":
    unittest.main()
