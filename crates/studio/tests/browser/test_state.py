"""Versions of the scene: nothing shown belongs to another version."""

import json
import re
import time
import unittest

from studio import ROOT, Pages, of_server

CYCLE = "# critical points, period_s = 0.54\ntime_s,force_n\n"
DROP = """([name, text]) => {
    const data = new DataTransfer();
    data.items.add(new File([text], name));
    document.body.dispatchEvent(new DragEvent("drop", {dataTransfer: data, bubbles: true, cancelable: true}));
}"""


def cycle(peak):
    return CYCLE + f"0,650\n0.135,{peak}\n0.27,700\n0.405,560\n"


def after(seconds):
    """Handler that delays a request."""
    return lambda route: (time.sleep(seconds), route.fallback())


class State(Pages):
    def drop(self, page, name, text):
        page.does(lambda: page.page.evaluate(DROP, [name, text]))

    def drop_refused(self, page, name, data):
        page.page.evaluate(DROP.replace("[text]", "[new Uint8Array(text)]"), [name, list(data)])
        page.until("it is said", lambda: page.page.is_visible("#fault") or page.page.is_visible("#notice"))

    def figure(self, page, number):
        return page.page.locator("#figures dd").nth(number).inner_text()

    def force_hash(self, page):
        return page.page.get_attribute("#design", "data-force-hash")

    def refuses(self, page, key, value):
        page.page.fill(f'[name="{key}"]', value)
        page.until(f"{key} is refused", lambda: page.page.get_attribute(f'[name="{key}"]', "aria-invalid") == "true")

    def test_a_force_dropped_again_under_its_name_is_the_new_one_every_time(self):
        page = self.page()
        page.sets("limits.stroke", "")
        for k in range(24):
            peak = 800 + 20 * (k % 5)
            self.drop(page, "same.csv", cycle(peak))
            most = float(re.search(r"… ([\d.]+)", self.figure(page, 1)).group(1))
            self.assertAlmostEqual(most, peak, delta=8, msg=str(k))

    def test_two_tabs_with_files_of_one_name_keep_their_own(self):
        one = self.page()
        two = self.browser.page(self.server.url, context=one.page.context)
        for page, peak in ((one, 820), (two, 960)):
            page.sets("limits.stroke", "")
            self.drop(page, "same.csv", cycle(peak))
        first, second = self.figure(one, 1), self.figure(two, 1)
        self.assertNotEqual(first, second)
        self.assertNotEqual(self.force_hash(one), self.force_hash(two))
        one.page.click("#tab-values")
        one.sets("limits.curvature", "6 mm")
        self.assertEqual(self.figure(one, 1), first)

    def test_undo_brings_every_point_of_a_drawn_force_back(self):
        page = self.page()
        page.sets("limits.stroke", "")
        page.page.click("#tab-force")
        page.does(lambda: page.page.click("#draw-force"))
        knots = lambda: page.page.eval_on_selector_all(".editor .knot", "all => all.map(e => [e.getAttribute('cx'), e.getAttribute('cy')])")
        seen = [(knots(), self.force_hash(page))]
        for k in (2, 5, 8):
            knot = page.page.locator(".editor .knot").nth(k)
            page.does(lambda: (knot.focus(), page.page.keyboard.press("ArrowUp")))
            seen.append((knots(), self.force_hash(page)))
        for points, force in reversed(seen[:-1]):
            page.does(lambda: page.page.click("#undo"))
            self.assertEqual(self.force_hash(page), force)
            page.until("the points are back", lambda: [p[0] for p in knots()] == [p[0] for p in points])
        self.assertEqual(len({force for _, force in seen}), 4)

    def test_undo_brings_the_ticks_of_contacts_back(self):
        page = self.page()
        file = ROOT / "data" / "recordings" / "made_walk.csv"
        page.sets("limits.stroke", "")
        self.drop(page, file.name, file.read_text())
        page.page.wait_for_selector("#contact-1")
        before = self.force_hash(page)
        page.does(lambda: page.page.click("#contact-1"))
        self.assertNotEqual(self.force_hash(page), before)
        page.does(lambda: page.page.click("#undo"))
        self.assertEqual(self.force_hash(page), before)
        page.until("the tick is back", lambda: page.page.is_checked("#contact-1"))
        page.does(lambda: page.page.click("#redo"))
        page.until("it is gone again", lambda: not page.page.is_checked("#contact-1"))
        page.page.wait_for_timeout(400)
        page.page.reload()
        page.shown(0)
        page.page.click("#tab-force")
        page.until("a reload keeps it", lambda: page.page.locator("#contact-1").count() == 1 and not page.page.is_checked("#contact-1"))

    def test_a_refused_value_blocks_no_other_and_one_undo_takes_one_step_back(self):
        page = self.page()
        self.refuses(page, "gait.step_frequency", "4.2 Hz")
        self.assertEqual(page.verdict(), "pending")
        before = self.figure(page, 2)
        page.sets("gait.body_weight", "900 N")
        self.assertIn("900", self.figure(page, 1))
        page.sets("limits.curvature", "6 mm")
        self.assertEqual(page.value("gait.step_frequency"), "4.2 Hz")
        self.assertEqual(page.verdict(), "pending")
        page.does(lambda: page.page.click("#undo"))
        self.assertEqual([page.value(k) for k in ("limits.curvature", "gait.body_weight", "gait.step_frequency")], ["5 mm", "900 N", "4.2 Hz"])
        page.does(lambda: page.page.click("#redo"))
        self.assertEqual(page.value("limits.curvature"), "6 mm")
        page.sets("gait.step_frequency", "2 Hz")
        self.assertEqual(page.verdict(), "acceptable")
        self.assertEqual(page.value("gait.body_weight"), "900 N")
        self.assertTrue(before)

    def test_a_refused_value_dims_the_picture_and_is_neither_saved_nor_exported(self):
        for width in (390, 1400):
            page = self.page(width=width)
            self.refuses(page, "limits.curvature", "5 kg")
            self.assertEqual(page.page.inner_text("#verdict-name"), "–")
            # The figures of a phone are behind the verdict.
            for selector in (".cam", "#charts", *(["#figures"] if width > 390 else [])):
                style = lambda: page.page.eval_on_selector(selector, "e => [Number(getComputedStyle(e).opacity), getComputedStyle(e).filter]")
                # The text is grey, but readable.
                page.until("it is dimmed", lambda: style()[0] < 0.7 and style()[1] == "grayscale(1)")
        page.sets("limits.stroke", "61 mm")
        page.page.click("#open-save")
        self.assertIn("Minimum radius", page.page.inner_text("#save-refused"))
        self.assertNotIn("limits.", page.page.inner_text("#save-refused"))
        self.assertEqual(page.page.locator("#save-name").count(), 0)
        page.page.keyboard.press("Escape")
        page.page.click("#open-export")
        self.assertTrue(page.page.is_visible("#notice"))
        self.assertFalse(page.page.is_visible("#dialog"))

    def test_a_scene_without_its_recording_has_its_own_name_and_no_verdict(self):
        page = self.page()
        page.page.click("#tab-text")
        page.page.fill("#scene-text", (ROOT / "scenes" / "measured_walk.toml").read_text())
        page.page.click("#text .main")
        page.until("the fault is named", lambda: page.page.is_visible("#fault"))
        self.assertEqual(page.page.inner_text("#scene-name"), "measured_walk")
        self.assertEqual(page.verdict(), "pending")
        page.page.click("#open-save")
        self.assertEqual(page.page.input_value("#save-name"), "measured_walk.toml")
        page.page.keyboard.press("Escape")
        file = ROOT / "data" / "recordings" / "made_walk.csv"
        self.drop(page, file.name, file.read_text())
        self.assertNotEqual(page.verdict(), "pending")

    def test_a_notice_that_lasts_is_closed_by_hand_or_by_the_next_good_file(self):
        page = self.page()
        page.sets("limits.stroke", "")
        self.drop_refused(page, "photo.png", b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 40)
        words = page.page.inner_text("#fault") if page.page.is_visible("#fault") else page.page.inner_text("#notice")
        self.assertIn("photo.png", words)
        self.assertRegex(words, "picture|PNG")
        self.assertNotRegex(words, "processor|byte")
        self.drop(page, "same.csv", cycle(900))
        page.until("nothing is left of it", lambda: not page.page.is_visible("#fault") and not page.page.is_visible("#notice"))
        self.assertEqual(page.verdict() == "pending", False)

    def test_spanish_shows_every_number_with_a_comma(self):
        page = self.page()
        for scene in ("footbridge", "heel_tester", "camdas_09_eight_motions"):
            page.opens(scene)
            if page.page.get_attribute("html", "lang") == "en":
                page.does(lambda: page.page.click("#language"))
            for tab in ("values", "force", "compare"):
                page.page.click(f"#tab-{tab}")
                page.page.wait_for_timeout(100)
                shown = re.findall(r"\S*\d\.\d\S*", page.page.inner_text("body"))
                held = page.page.eval_on_selector_all("[placeholder]", "all => all.map((e) => e.placeholder)")
                shown += [h for h in held if re.search(r"\d\.\d", h)]
                self.assertEqual(shown, [], f"{scene} {tab}")

    def test_forced_colours_keep_the_cursor_and_the_chosen_tab(self):
        page = self.page()
        page.page.emulate_media(forced_colors="active")
        page.page.wait_for_timeout(100)
        edges = page.page.eval_on_selector_all(".tabs button", "all => all.map((e) => [e.getAttribute('aria-selected'), getComputedStyle(e).borderBottomColor])")
        chosen = {colour for selected, colour in edges if selected == "true"}
        others = {colour for selected, colour in edges if selected != "true"}
        self.assertEqual(len(chosen), 1)
        self.assertFalse(chosen & others, edges)
        paper, cursor = page.page.evaluate("[document.querySelector('.chart'), document.querySelector('.cursor')].map((e) => getComputedStyle(e).backgroundColor)")
        self.assertNotEqual(paper, cursor)

    def test_a_copied_link_holds_the_scene_and_nothing_of_this_machine(self):
        page = self.page()
        page.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
        page.sets("limits.stroke", "")
        self.drop(page, "mine.csv", cycle(850))
        force = self.force_hash(page)
        page.page.click("#link")
        page.page.click("#copy-link")
        page.until("it is copied", lambda: page.page.is_visible("#notice"))
        text = page.page.evaluate("navigator.clipboard.readText()")
        self.assertRegex(text, r"^#s=[\w-]+$")
        self.assertNotRegex(text, "127|token")
        other = self.page()
        other.page.click("#open-files")
        other.page.fill("#open-link", "https://anywhere.example/page/" + text)
        other.does(lambda: other.page.click("#dialog form button"))
        self.assertEqual(self.force_hash(other), force)
        self.assertEqual(other.value("gait.file"), "mine.csv")

    def test_a_reload_keeps_the_versions_and_the_pins(self):
        page = self.page()
        for stroke in ("61 mm", "62 mm"):
            page.sets("limits.stroke", stroke)
            page.page.locator("#verdict").click()
        page.page.click("#pin")
        page.page.wait_for_timeout(400)
        page.page.reload()
        page.shown(0)
        page.until("the pin is drawn", lambda: page.page.locator(".line.pinned").count() > 0)
        for stroke in ("61 mm", "60 mm"):
            page.does(lambda: page.page.click("#undo"))
            self.assertEqual(page.value("limits.stroke"), stroke)
        page.does(lambda: page.page.click("#redo"))
        self.assertEqual(page.value("limits.stroke"), "61 mm")

    def test_a_reload_that_began_before_the_address_was_written_keeps_the_versions(self):
        page = self.page()
        address = lambda: page.page.evaluate("location.hash")
        page.until("the address is written", address)
        before = address()
        page.sets("limits.stroke", "61 mm")
        page.until("the address is written again", lambda: address() != before)
        page.page.evaluate("before => history.replaceState(null, '', before)", before)
        page.page.reload()
        page.shown(0)
        page.until("the stroke is back", lambda: page.value("limits.stroke") == "61 mm")
        self.assertTrue(page.page.is_enabled("#undo"))

    def test_numbers_are_taken_in_the_unit_shown_and_with_a_decimal_comma(self):
        page = self.page()
        for text, shown in (("61,5", "61.5 mm"), ("62", "62 mm"), ("5,5 cm", "5.5 cm"), ("2*31 mm", "62 mm"), ("60 mm", "60 mm")):
            page.sets("limits.stroke", text)
            page.page.locator("#verdict").click()
            self.assertNotEqual(page.verdict(), "pending", text)
            page.does(lambda: page.page.click("#language"))
            # The language and the decimal sign have changed.
            is_spanish = page.page.get_attribute("html", "lang") == "es"
            self.assertEqual(page.value("limits.stroke"), shown.replace(".", ",") if is_spanish else shown, text)

    def test_a_slider_ends_where_the_scene_ends(self):
        page = self.page()
        for key, end, low, high in (("gait.step_frequency", "max", 2.6, 2.8), ("gait.step_frequency", "min", 1, 1.1), ("law.degree", "max", 8, 9), ("law.degree", "min", 3, 4)):
            slider = page.page.locator(f'input[data-key="{key}"]')
            page.does(lambda: slider.evaluate("(e, end) => { e.value = e[end]; e.dispatchEvent(new Event('input', {bubbles: true})); e.dispatchEvent(new Event('change')); }", end))
            page.until("the border is found", lambda: page.verdict() != "pending")
            page.page.wait_for_timeout(300)
            value = float(page.value(key).split()[0])
            self.assertTrue(low <= value <= high, (key, end, value))
            self.assertNotEqual(page.verdict(), "pending")
        for _ in range(4):
            page.does(lambda: page.page.click("#undo"))
        self.assertEqual([page.value("gait.step_frequency"), page.value("law.degree")], ["1.85 Hz", "5"])

    def test_a_fault_is_announced_once_when_the_hand_rests(self):
        page = self.page()
        page.page.evaluate(
            """() => {
                window.said = 0;
                new MutationObserver(() => { if (!document.querySelector("#fault").hidden) window.said += 1; })
                    .observe(document.querySelector("#fault"), {childList: true, attributes: true});
            }"""
        )
        page.page.focus('[name="limits.curvature"]')
        page.page.keyboard.press("Control+A")
        page.page.keyboard.type("4 kg per m", delay=60)
        self.assertEqual(page.page.evaluate("window.said"), 0)
        page.until("it is said", lambda: page.page.is_visible("#fault"))
        page.page.wait_for_timeout(600)
        # Contents and appearance are announced together.
        self.assertLessEqual(page.page.evaluate("window.said"), 2)

    @of_server
    def test_nothing_is_greyed_below_a_second_and_nothing_moves_while_a_design_is_made(self):
        page = self.page()
        page.page.evaluate(
            """() => {
                window.seen = {busy: 0, tops: []};
                const tick = () => {
                    window.seen.busy += document.querySelector("#design").classList.contains("busy");
                    window.seen.tops.push(Math.round(document.querySelector("#stage").getBoundingClientRect().top));
                    requestAnimationFrame(tick);
                };
                tick();
            }"""
        )
        for wait, greyed in ((600, False), (1800, True)):
            page.page.route("**/design*", after(wait / 1000))
            page.sets("limits.stroke", f"{61 + wait // 600} mm")
            page.page.unroute("**/design*")
            seen = page.page.evaluate("window.seen")
            self.assertEqual(seen["busy"] > 0, greyed, wait)
            self.assertEqual(len(set(seen["tops"])), 1, set(seen["tops"]))

    @of_server
    def test_no_placeholder_of_a_text_reaches_the_page(self):
        start = json.loads(self.page().page.evaluate("fetch('start', {method: 'POST', body: '{}'}).then((r) => r.text())"))
        for tag, words in start["words"].items():
            for key, text in words.items():
                self.assertNotIn("{$", text.replace(" ", ""), f"{tag} {key}")
                self.assertRegex(re.sub(r"\{\w+\}", "", text), r"^[^{}]*$", f"{tag} {key}")


if __name__ == "__main__":
    unittest.main()
