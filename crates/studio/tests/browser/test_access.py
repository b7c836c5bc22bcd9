"""Results of axe-core in every tab, dialog and state of the page, in both themes and languages."""

import unittest

from axe_playwright_python.base import AXE_FILE_PATH
from studio import ROOT, Pages

RULES = (
    "{runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'], rules: {'heading-order': {enabled: true}, "
    "'label-content-name-mismatch': {enabled: true}, region: {enabled: true}}}"
)
DIALOGS = ["#open-scenes", "#open-files", "#open-save", "#open-export", "#versions", "#choose-diagrams", "#show-table", "#show-exercise"]
WALK = ROOT / "data" / "recordings" / "made_walk.csv"


class Access(Pages):
    def each(self):
        """Pages in both themes and languages, with their names. Contrasts depend on the theme alone, names on the language alone."""
        for theme, tag in [("light", "en"), ("dark", "es")]:
            page = self.page(theme=theme)
            if tag == "es":
                page.does(lambda: page.page.click("#language"))
            page.page.evaluate(AXE_FILE_PATH.read_text())
            yield page, f"{theme} {tag}"

    def passes(self, page, state):
        page.page.wait_for_timeout(200)
        found = page.page.evaluate(f"axe.run(document, {RULES})")["violations"]
        self.assertEqual([(v["id"], [n["html"][:120] + n["failureSummary"][-160:] for n in v["nodes"][:3]]) for v in found], [], state)

    def test_no_barrier_in_the_tabs(self):
        for page, where in self.each():
            for tab in ["values", "force", "programme", "compare", "text"]:
                page.page.click(f"#tab-{tab}")
                self.passes(page, f"{tab} {where}")

    def test_no_barrier_in_the_dialogs(self):
        for page, where in self.each():
            for button in DIALOGS:
                page.page.evaluate("id => document.querySelector(id).click()", button)
                self.passes(page, f"{button} {where}")
                page.page.keyboard.press("Escape")

    def test_no_barrier_in_a_refused_value_a_conflict_and_while_presenting(self):
        for page, where in self.each():
            page.page.fill('[name="limits.curvature"]', "5 kg")
            page.until("the fault is told", lambda: page.page.is_visible("#fault"))
            self.passes(page, f"refused {where}")
            page.sets("limits.curvature", "5 mm")
            page.sets("limits.stroke", "20 mm")
            page.page.wait_for_selector("#conflict .relax")
            self.passes(page, f"conflict {where}")
            page.page.click("#present")
            self.passes(page, f"presenting {where}")

    def test_no_barrier_in_recordings_runs_and_sweeps(self):
        for page, where in self.each():
            page.page.click("#tab-compare")
            page.page.click("#simulate")
            page.page.wait_for_selector("#motion .picture")
            page.page.select_option("#sweep-across", "limits.stroke")
            page.page.select_option("#sweep-down", "gait.step_frequency")
            page.page.click("#sweep")
            page.page.wait_for_selector("#grid td.unacceptable", timeout=60000)
            page.page.click("#vary")
            page.page.wait_for_selector("#tornado table", timeout=60000)
            self.passes(page, f"compare {where}")
            page.page.click("#tab-force")
            page.page.set_input_files("#pick-file", WALK)
            page.page.wait_for_selector(".found .picture svg")
            self.passes(page, f"recording {where}")


if __name__ == "__main__":
    unittest.main()
