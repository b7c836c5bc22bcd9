"""Form of values: names, sliders, feasible ranges, ends, languages, touch."""

import re
import unittest
from collections import Counter

from studio import Pages, of_server

STROKE = 'input[data-key="limits.stroke"]'
# A dotted key, or a word with underscores.
KEY = r"\b(?!cam\.step\b)(gait|cam|drive|law|limits|machine|accuracy)\.[a-z]\w*|\b[a-z]+_[a-z_]+\b"
DRAG = """([selector, share]) => {
    const slider = document.querySelector(selector);
    slider.dispatchEvent(new PointerEvent("pointerdown", {bubbles: true}));
    slider.value = Number(slider.min) + share * (slider.max - slider.min);
    slider.dispatchEvent(new Event("input", {bubbles: true}));
}"""
RELEASE = "selector => document.querySelector(selector).dispatchEvent(new Event('change', {bubbles: true}))"


class Values(Pages):
    def number(self, text):
        return float(re.match(r"[\d.,]+", text).group(0).replace(",", "."))

    def spanish(self, page):
        page.does(lambda: page.page.click("#language"))

    # --- words ------------------------------------------------------------------------------------

    @of_server
    def test_every_key_and_every_choice_has_a_name_in_both_languages(self):
        start = self.page().page.evaluate("fetch('start', {method: 'POST', body: '{}'}).then((r) => r.json())")
        self.assertGreater(len(start["keys"]), 120)
        for tag, words in start["words"].items():
            names = []
            for key in start["keys"]:
                name = words.get("studio-key-" + key["key"].replace(".N.", ".").replace(".", "-"))
                self.assertIsNotNone(name, f"{tag}: {key['key']} has no name")
                self.assertNotRegex(name, r"_|\w\.\w", f"{tag}: {key['key']}")
                names.append(name)
                for choice in key["choices"] if key["kind"] == "choice" else []:
                    self.assertIn(f"studio-choice-{choice}", words, f"{tag}: {key['key']}")
            twice = [name for name, n in Counter(names).items() if n > 1]
            self.assertEqual(twice, [], tag)

    def test_no_label_choice_or_help_shows_a_key(self):
        page = self.page()
        for scene in ("footbridge", "camdas_01_roller"):
            page.opens(scene)
            for _ in range(2):
                if not page.page.locator("#all-values[aria-pressed=true]").count():
                    page.page.click("#all-values")
                names = page.page.eval_on_selector_all("#values .row:not([hidden]) .term", "all => all.map((e) => e.textContent)")
                self.assertGreater(len(names), 25)
                options = page.page.eval_on_selector_all("#values option", "all => all.map((e) => [e.value, e.textContent])")
                for text in [*names, *(text for _, text in options)]:
                    self.assertNotRegex(text, KEY)
                for value, text in options:
                    if "-" in value:
                        self.assertNotEqual(value, text)
                self.assertEqual([n for n, k in Counter(names).items() if k > 1], [])
                page.page.evaluate("document.querySelectorAll('#values .row:not([hidden]) .term[aria-expanded=false]').forEach((e) => e.click())")
                sentences = page.page.eval_on_selector_all(
                    "#values .help:not([hidden])", "all => all.map((e) => [...e.childNodes].filter((n) => n.nodeType === 3).map((n) => n.data).join(''))"
                )
                self.assertEqual(len(sentences), len(names))
                for sentence in sentences:
                    self.assertNotRegex(sentence, KEY.replace(r"|\b[a-z]+_[a-z_]+\b", ""))
                page.page.evaluate("document.querySelectorAll('#values .term[aria-expanded=true]').forEach((e) => e.click())")
                self.spanish(page)
        self.assertEqual(page.said, [])

    def test_a_name_opens_its_help(self):
        page = self.page()
        name = page.page.locator('[data-row="limits.stroke"] .term')
        self.assertEqual(page.page.locator("#values .ask").count(), 0)
        self.assertFalse(page.page.is_visible("#f-limits-stroke-help"))
        name.click()
        self.assertEqual(name.get_attribute("aria-expanded"), "true")
        self.assertEqual(page.page.inner_text("#f-limits-stroke-help code"), "limits.stroke")
        # With the keyboard: F1 in the field, or the name before it.
        page.page.focus('[name="limits.stroke"]')
        page.page.keyboard.press("F1")
        self.assertFalse(page.page.is_visible("#f-limits-stroke-help"))
        page.page.keyboard.press("Shift+Tab")
        page.page.keyboard.press("Enter")
        self.assertTrue(page.page.is_visible("#f-limits-stroke-help"))

    def test_the_page_begins_in_the_language_of_the_browser(self):
        for locale, tag in (("es-ES", "es"), ("es-MX", "es"), ("en-GB", "en"), ("fr-FR", "en")):
            context = self.browser.context(locale=locale)
            self.addCleanup(context.close)
            page = self.browser.page(self.server.url, context=context)
            self.assertEqual(page.page.get_attribute("html", "lang"), tag, locale)
        # The chosen value is first.
        page.does(lambda: page.page.click("#language"))
        page.page.reload()
        page.shown(0)
        self.assertEqual(page.page.get_attribute("html", "lang"), "es")

    def test_numbers_in_fields_follow_the_language_and_both_signs_are_taken(self):
        page = self.page()
        self.spanish(page)
        self.assertEqual(page.value("gait.step_frequency"), "1,85 Hz")
        for typed in ("1,9", "1.9", "1,9 Hz"):
            page.sets("gait.step_frequency", typed)
            # The text is not changed while it is typed.
            self.assertEqual(page.value("gait.step_frequency"), typed)
            page.page.locator("#verdict").click()
            self.assertEqual(page.value("gait.step_frequency"), "1,9 Hz")
            page.sets("gait.step_frequency", "1,8")
        page.sets("name", "walk 1.5, second")
        page.page.locator("#verdict").click()
        self.assertEqual(page.value("name"), "walk 1.5, second")
        self.spanish(page)
        self.assertEqual(page.value("gait.step_frequency"), "1.8 Hz")

    def test_auto_says_what_was_taken(self):
        page = self.page()
        page.sets("drive.mass", "auto")
        page.page.locator("#verdict").click()
        taken = page.page.locator('[data-row="drive.mass"] .taken')
        self.assertEqual(taken.inner_text(), "→ 71.36 kg")
        page.sets("gait.body_weight", "500 N")
        self.assertEqual(taken.inner_text(), "→ 50.97 kg")
        page.sets("drive.mass", "")
        self.assertEqual(page.page.get_attribute('[name="drive.mass"]', "placeholder"), "auto → 50.97 kg")
        self.assertEqual(page.page.get_attribute('[name="limits.pressure_angle"]', "placeholder"), "free → 0°")
        page.sets("accuracy.rms", "")
        self.assertRegex(page.page.get_attribute('[name="accuracy.rms"]', "placeholder"), r"^free → 0\.\d+ %$")
        self.assertEqual(page.page.get_attribute('[name="limits.acceleration"]', "placeholder").split()[-1], "m/s²")

    # --- sliders ----------------------------------------------------------------------------------

    def test_ends_are_round_and_stay_until_they_are_edited_or_left(self):
        page = self.page()
        ends = lambda: [page.page.input_value(f'[data-row="limits.stroke"] .end[data-end="{e}"]') for e in ("from", "to")]
        place = lambda: page.page.eval_on_selector(STROKE, "e => (e.value - e.min) / (e.max - e.min)")
        self.assertEqual(ends(), ["2", "100"])
        page.does(lambda: page.page.evaluate(DRAG, [STROKE, 0.9]))
        page.page.evaluate(RELEASE, STROKE)
        page.page.wait_for_timeout(200)
        self.assertEqual(ends(), ["2", "100"])
        self.assertAlmostEqual(place(), 0.9, delta=0.01)
        to = page.page.locator('[data-row="limits.stroke"] .end[data-end="to"]')
        to.fill("150,5")
        to.press("Enter")
        self.assertEqual(ends(), ["2", "150.5"])
        self.assertLess(place(), 0.65)
        # The end of the slider is beyond the value; a value outside changes the ends.
        to.fill("5")
        to.press("Enter")
        self.assertAlmostEqual(float(ends()[1]), self.number(page.value("limits.stroke")), places=3)
        page.sets("limits.stroke", "300 mm")
        self.assertEqual(ends(), ["10", "500"])
        page.opens("footbridge")
        self.assertEqual(ends(), ["2", "100"])
        self.assertEqual(page.said, [])

    def shaded(self, page, selector=STROKE):
        page.until("what is possible is said", lambda: page.page.get_attribute(selector, "aria-description"))
        return page.page.get_attribute(selector, "aria-description")

    def test_a_slider_shows_where_the_design_is_acceptable(self):
        page = self.page()
        page.page.focus(STROKE)
        text = self.shaded(page)
        border, end = map(float, re.fullmatch(r"acceptable from ([\d.]+) to ([\d.]+) mm", text).groups())
        self.assertEqual(end, 100)
        self.assertIn("linear-gradient", page.page.eval_on_selector('[data-row="limits.stroke"] .possible', "e => getComputedStyle(e).backgroundImage"))
        # The designs on both sides of the limit agree.
        for value, verdict in ((border - 1, "unacceptable"), (border + 0.5, "acceptable")):
            page.sets("limits.stroke", f"{value} mm")
            self.assertEqual(page.verdict(), verdict, value)
        # The value of the slider itself has no influence, so that there is no new request; another value has.
        self.assertEqual(page.page.get_attribute(STROKE, "aria-description"), text)
        page.sets("gait.step_frequency", "1.5 Hz")
        self.assertIsNone(page.page.get_attribute(STROKE, "aria-description"))
        page.page.hover(STROKE)
        self.assertNotEqual(self.shaded(page), text)
        self.spanish(page)
        page.page.hover(STROKE)
        self.assertRegex(self.shaded(page), r"^aceptable de \d+,\d a 100 mm$")
        self.assertEqual(page.said, [])

    def test_steps_of_a_count_and_a_slider_without_a_design(self):
        page = self.page()
        page.page.focus('input[data-key="law.degree"]')
        self.assertRegex(self.shaded(page, 'input[data-key="law.degree"]'), r"^acceptable from \d to \d+$")
        page.sets("limits.acceleration", "1 m/s^2")
        page.page.focus('input[data-key="limits.acceleration"]')
        self.shaded(page, 'input[data-key="limits.acceleration"]')
        self.assertEqual(page.said, [])

    @of_server
    def test_what_is_possible_waits_for_the_hand(self):
        page = self.page()
        asked = []
        page.page.on("request", lambda r: asked.append(r.url) if r.url.endswith("/range") else None)
        for k in range(30):
            page.page.evaluate(DRAG, [STROKE, 0.6 + 0.01 * (k % 20)])
            page.page.wait_for_timeout(40)
        self.assertEqual(asked, [])
        page.page.evaluate(RELEASE, STROKE)
        page.page.focus(STROKE)
        page.until("it is asked", lambda: asked)
        # A key press during the run ends it.
        page.page.keyboard.press("Shift")
        self.shaded(page)
        self.assertEqual(page.said, [])

    def test_a_finger_scrolls_over_a_slider_and_sets_it_only_along_it(self):
        context = self.browser.context(viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
        page = self.browser.page(self.server.url, context=context)
        self.addCleanup(context.close)
        slider = page.page.locator(STROKE)
        middle = lambda: slider.evaluate("e => e.scrollIntoView({block: 'center'})")
        middle()
        page.page.wait_for_timeout(300)
        touch = context.new_cdp_session(page.page)

        def swipe(dx, dy):
            box = slider.bounding_box()
            x, y = box["x"] + 0.4 * box["width"], box["y"] + box["height"] / 2
            at = lambda k: [{"x": x + dx * k / 10, "y": y + dy * k / 10}]
            touch.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": at(0)})
            for k in range(1, 11):
                touch.send("Input.dispatchTouchEvent", {"type": "touchMove", "touchPoints": at(k)})
                page.page.wait_for_timeout(16)
            touch.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
            page.page.wait_for_timeout(300)

        before = page.page.evaluate("scrollY")
        swipe(3, -150)
        self.assertEqual(page.value("limits.stroke"), "60 mm")
        self.assertEqual(page.page.eval_on_selector(STROKE, "e => Number(e.value)"), 60)
        self.assertGreater(page.page.evaluate("scrollY"), before + 50)
        middle()
        swipe(0, 0)
        self.assertEqual(page.value("limits.stroke"), "60 mm")
        page.does(lambda: swipe(120, 4))
        self.assertNotEqual(page.value("limits.stroke"), "60 mm")
        self.assertEqual(page.said, [])

    # --- the form ---------------------------------------------------------------------------------

    def test_undo_changes_the_field_that_has_the_focus(self):
        page = self.page()
        page.sets("limits.stroke", "61")
        self.assertEqual(page.value("limits.stroke"), "61")
        page.does(lambda: page.page.keyboard.press("Control+z"))
        self.assertEqual(page.value("limits.stroke"), "60 mm")
        # The form stays visible in between.
        self.assertEqual(page.page.evaluate("document.activeElement.name"), "limits.stroke")

    def test_folded_sections_stay_folded_and_no_heading_stands_over_nothing(self):
        page = self.page()
        heading = lambda p: p.page.locator(".section summary", has_text="Drive")
        inside = '[name="drive.speed"]'
        self.assertTrue(page.page.is_visible(inside))
        heading(page).click()
        self.assertFalse(page.page.is_visible(inside))
        page.sets("limits.stroke", "61 mm")
        self.assertFalse(page.page.is_visible(inside))
        page.page.reload()
        page.shown(0)
        self.assertFalse(page.page.is_visible(inside))
        heading(page).click()
        self.assertTrue(page.page.is_visible(inside))
        for scene in ("footbridge", "camdas_09_eight_motions", "heel_tester"):
            page.opens(scene)
            empty = page.page.evaluate(
                """() => [...document.querySelectorAll("#values .section")]
                    .filter((s) => s.querySelector("summary").checkVisibility())
                    .filter((s) => ![...s.querySelectorAll(".row, [data-add]")].some((e) => e.checkVisibility() && e.getBoundingClientRect().height > 5))
                    .map((s) => s.innerText)"""
            )
            self.assertEqual(empty, [], scene)

    def test_a_search_without_a_hit_says_so(self):
        page = self.page()
        page.page.fill("#find-value", "Flywheel of cheese")
        self.assertIn("Flywheel of cheese", page.page.inner_text("#values"))
        self.assertEqual(page.page.locator("#values .section summary:visible").count(), 0)
        self.assertEqual(page.page.input_value("#find-value"), "Flywheel of cheese")
        page.page.fill("#find-value", "Natural")
        self.assertEqual(page.page.locator('[data-row="machine.natural_frequency"]:not(.unused)').count(), 1)
        self.assertEqual(page.page.locator('[data-row="limits.stroke"]:not(.unused)').count(), 0)
        page.page.fill("#find-value", "")
        self.assertTrue(page.page.is_visible(STROKE))

    def test_a_motor_a_floor_and_a_spring_are_added_at_once(self):
        for scene, what, key in (
            ("footbridge", "motor", "machine.motor.slope"),
            ("footbridge", "floor", "machine.floor.mass"),
            ("heel_tester", "motor", "machine.motor.slope"),
            ("camdas_01_roller", "spring", "drive.spring_rate"),
        ):
            with self.subTest(f"{scene} {what}"):
                page = self.page()
                page.opens(scene)
                button = page.page.locator(f'[data-add="{what}"]')
                page.does(button.click)
                self.assertNotEqual(page.value(key), "")
                self.assertFalse(page.page.is_visible("#fault"))
                self.assertNotEqual(page.verdict(), "pending")
                self.assertEqual(button.count(), 0)
                self.assertEqual(page.page.locator("#values .faulty").count(), 0)
                page.does(lambda: page.page.click("#undo"))
                self.assertEqual(page.value(key), "")


if __name__ == "__main__":
    unittest.main()
