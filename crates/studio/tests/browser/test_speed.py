"""Delay between an input event and its picture, with each engine.

The time of a picture is measured from the input event with its value to the frame in which the page has painted it. Events that are
superseded before their request have no separate picture; their time to the next picture is measured too. The required times hold for an
idle reference machine. A fixed sum and a fixed sort are measured in the page, and the limits are multiplied by the larger ratio to
their reference times. A sum uses neither branches nor memory; pictures and designs use both.
"""

import statistics
import unittest

from studio import DIST, Pages

# Required times, ms: of 95 % of the pictures of the built-in scenes, of all events, and the median of the slowest scene.
PICTURE, EVENT, LONGEST = 50, 100, 150
LONG = "heel_tester_fitted"
DRAG = """async () => {
    const design = document.querySelector("#design");
    const sliders = [...document.querySelectorAll('#values .row.set input[type="range"]')].filter((s) => s.checkVisibility());
    const slider = sliders.find((s) => /^limits\\.|^cam\\./.test(s.dataset.key)) ?? sliders[0];
    if (!slider) return null;
    const [from, pictures, events, start] = [Number(slider.value), [], [], performance.now()];
    let [open, grey, k] = [[], 0, 0];
    const seen = new MutationObserver(() => {
        const [now, ms] = [performance.now(), Number(design.dataset.ms)];
        pictures.push(ms);
        // Events up to the one that this picture shows.
        const answered = (at) => at <= now - ms + 1;
        events.push(...open.filter(answered).map((at) => now - at));
        open = open.filter((at) => !answered(at));
    });
    seen.observe(design, {attributes: true, attributeFilter: ["data-revision"]});
    // On a machine with other work two pictures may take longer than the drag.
    const over = () => performance.now() - start;
    while (over() < 1200 || (pictures.length < 2 && over() < 5000)) {
        k += 1;
        slider.value = from * (1 + 0.02 * Math.sin(k / 5));
        open.push(performance.now());
        slider.dispatchEvent(new Event("input", {bubbles: true}));
        await new Promise(requestAnimationFrame);
        grey += design.matches(".busy");
    }
    slider.dispatchEvent(new Event("change", {bubbles: true}));
    await new Promise((done) => setTimeout(done, 100));
    seen.disconnect();
    return {pictures, events, grey};
}"""


def p95(times):
    return statistics.quantiles(times, n=20)[-1]


# A sum that takes 17.3 ms on the reference machine; mean over five, ms.
SUM, REFERENCE = """() => {
    const from = performance.now();
    let sum = 0;
    for (let k = 0; k < 5; k += 1) for (let i = 0; i < 2e6; i += 1) sum += Math.sin(i) * i;
    return sum && (performance.now() - from) / 5;
}""", 17.3
# A sort, ms. Its reference time is derived: on a machine where the sort takes 21.7 ms and the sum 17.6 ms, pictures and designs take
# 1.45 times as long as on the reference machine.
SORT, SORT_REFERENCE = """() => {
    const from = performance.now();
    let seed = 1;
    for (let k = 0; k < 5; k += 1) {
        const all = new Float64Array(2e5).map(() => (seed = (seed * 1103515245 + 12345) % 2147483648));
        all.sort();
    }
    return (performance.now() - from) / 5;
}""", 15.0


# Slowness above which other programs take whole time slices of this machine. The 95 % quantile of the times then measures these slices:
# the same program that has a ratio of 0.7 on a machine slower by 1.6 has 1.4 on one slower by 2.4.
OVERLOADED = 2.0


def slowness(page):
    """Factor by which this machine is slower at its present load; at least 1."""
    return max(1.0, page.page.evaluate(SUM) / REFERENCE, page.page.evaluate(SORT) / SORT_REFERENCE)


class Speed(Pages):
    def rests(self, page):
        page.until("it is at rest", lambda: page.page.get_attribute("#design", "aria-busy") == "false")

    def dragged(self, page, names):
        """Drags a slider in each scene. Returns the times of the pictures and of the events, and the median of each scene, as fractions of the
        required times on this machine."""
        pictures, events, medians, grey, stretch = [], [], {}, 0, []
        for name in names:
            page.opens(name)
            stretch.append(slowness(page))
            found = page.page.evaluate(DRAG)
            self.rests(page)
            if found is None or len(found["pictures"]) < 2:
                continue
            grey += found["grey"]
            medians[name] = statistics.median(found["pictures"])
            if name != LONG:
                pictures += found["pictures"]
                events += found["events"]
        factor = statistics.mean(stretch)
        worst = ", ".join(f"{name} {ms:.0f}" for name, ms in sorted(medians.items(), key=lambda x: -x[1])[:4])
        print(
            f"\n  {'worker' if DIST else 'native'} engine, {len(medians)} of {len(names)} scenes, {len(pictures)} pictures: median "
            f"{statistics.median(pictures):.0f} ms, 95 % {p95(pictures):.0f} ms ({PICTURE} asked); all {len(events)} events: median "
            f"{statistics.median(events):.0f} ms, 95 % {p95(events):.0f} ms; slowest medians {worst}; this machine is slower by {factor:.2f}"
        )
        self.assertGreater(len(medians), 15)
        self.assertEqual(grey, 0)
        measure = p95
        if factor > OVERLOADED:
            print("  other programs slow this machine too much for the 95 % quantile: the medians are compared")
            measure = statistics.median
        return [measure(pictures) / PICTURE / factor, measure(events) / EVENT / factor, medians[LONG] / LONGEST / factor]

    def test_hand_to_picture_over_the_scenes(self):
        """Drags a slider for a second in each scene, with an event in every frame. Other programs on the machine make the times longer, never
        shorter, so up to two more passes are measured where the first one is too long."""
        page = self.page()
        page.page.click("#open-scenes")
        names = page.page.eval_on_selector_all("[data-scene]", "all => all.map((e) => e.dataset.scene)")
        page.page.keyboard.press("Escape")
        for _ in range(3):
            parts = self.dragged(page, names)
            if max(parts) < 1:
                break
        self.assertLess(max(parts), 1, parts)
        self.assertEqual(page.said, [])

    def test_an_animation_has_a_picture_in_every_frame(self):
        page = self.page(turns=True)
        stretch = slowness(page)
        page.page.wait_for_timeout(500)
        frames = """async () => {
            const [stage, times] = [document.querySelector("#stage"), []];
            let [moved, before, last] = [0, stage.getAttribute("aria-valuenow"), performance.now()];
            for (let k = 0; k < 120; k += 1) {
                await new Promise(requestAnimationFrame);
                times.push(performance.now() - last);
                last = performance.now();
                moved += stage.getAttribute("aria-valuenow") !== before;
                before = stage.getAttribute("aria-valuenow");
            }
            return {times, moved};
        }"""
        found = page.page.evaluate(frames)
        rate = 1000 / statistics.mean(found["times"])
        print(f"\n  animation: {rate:.1f} pictures a second, the cam moved in {found['moved']} of 120 frames; this machine is slower by {stretch:.2f}")
        self.assertGreater(rate, 57 / stretch)
        self.assertGreaterEqual(found["moved"], 118)

    def test_the_first_design_stands_within_a_second(self):
        times = []
        for _ in range(3):
            page = self.page()
            stretch = slowness(page)
            first = page.page.evaluate("performance.getEntriesByName('first-design')[0].startTime")
            times.append(first / stretch)
        print(f"\n  first design {min(times):.0f} ms after the navigation began")
        self.assertLess(min(times), 1000)


if __name__ == "__main__":
    unittest.main()
