#!/usr/bin/env python3
"""Writes docs/pictures/: the pictures that the commands of the guide's pages produce.

    python3 docs/pictures.py target/release/gaitcam [CHAPTER …]    # --check: only compares, and fails if one is outdated

Every SVG is a file of gaitcam, a diagram of its report, or the animated drawing of its report with the force beside it.
The chapter `studio` has screenshots (docs/screenshots.py). They need Chromium and Playwright, which
crates/studio/tests/browser/run.sh installs.
"""

import json
import re
import subprocess
import sys
import tempfile
from importlib.util import find_spec
from pathlib import Path

from commands import ROOT, Page

TARGET = ROOT / "docs" / "pictures"
# Page and, if there is one, its Spanish translation; picture and its file, `FILE.html#ID` for a diagram in the file,
# or `FILE.html#motion` for the animated cam, or `FILE.svg#labelled` for a profile with scale and labels.
PICTURES = {
    ("first-cam", "primera-leva"): {
        "cam": "out/footbridge/cam.svg",
        "force": "out/footbridge/force.svg",
        "motion": "out/footbridge/report.html#motion",
    },
    ("recording", "registro"): {"stances": "walk.svg"},
    ("heel-tester", "tacones"): {"force": "out/heel_tester_fitted/force.svg", "svaj": "out/heel_tester/svaj.svg"},
    ("footbridge-shaker", "pasarela"): {
        "torque": "out/footbridge-front/front.svg",
        "motor": "out/plain-motor/report.html#run",
    },
    ("walkers", "caminantes"): {"band": "out/worst/walkers.svg", "cover": "out/bridges/cover.svg"},
    ("walking", "caminar"): {"resonance": "speed.svg"},
    ("limits", "limites"): {"stroke": "out/footbridge-front/front.svg"},
    ("no-cam", "sin-leva"): {"force": "out/short/force.svg"},
    ("run", "marcha"): {
        "run": "out/fast/report.html#run",
        "speeds": "out/footbridge_speeds/speeds.svg",
    },
    ("sweeps", "barridos"): {"heat": "out/grid/heat.svg", "front": "out/grid/front.svg"},
    ("workshop", None): {"profile": "out/shop/profile.svg#labelled"},
    ("teachers", "docentes"): {"svaj": "out/camdas_09_eight_motions/svaj.svg"},
    ("python", "python"): {"svaj": "out/footbridge/svaj.svg"},
}
LARGEST = 150_000


def coloured(svg, report):
    """Picture with the light colours of the report instead of CSS variables, which drawing programs do not support."""
    colours = re.search(r":root \{(.*?)color-scheme", report, re.S).group(1)
    return re.sub(r"var\(--(\w+)\)", lambda name: re.search(rf"--{name.group(1)}: (#\w+)", colours).group(1), svg)


# Height of the title above a diagram of a report, and its distance from the left edge, which is that of the frame.
TITLE, LEFT = 40, 88.4


def diagram(report, name):
    """Diagram of a report as a separate file, with the light colours of the report and a white background. Its title is the
    name of the scene and the heading of the section."""
    before, svg = re.search(rf'(.*)(<svg id="{name}".*?</svg>)', report, re.S).groups()
    scene, section = re.search(r"<h1>(.*?)</h1>", before).group(1), re.findall(r"<h2>(.*?)</h2>", before)[-1]
    width, height = re.search(r'viewBox="0 0 (\S+) (\S+)"', svg).groups()
    tall = int(height) + TITLE
    svg = svg.replace(f'viewBox="0 0 {width} {height}"', f'viewBox="0 {-TITLE} {width} {tall}"', 1)
    start = f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{tall}" font-family="sans-serif" '
    title = (f'<rect y="{-TITLE}" width="{width}" height="{tall}" fill="#fff"/>'
             f'<text x="{LEFT}" y="-12" font-size="18" fill="var(--quiet)">'
             f'<tspan font-weight="bold" fill="var(--ink)">{scene}</tspan> {section[0].lower()}{section[1:]}</text>')
    return coloured(re.sub(r"^<svg ([^>]*>)", rf"{start}\1{title}", svg), report)


def labelled(profile):
    """Profile on white paper, with a scale bar of 50 mm, the label of θ = 0 and the symbol ω below the arrow of rotation."""
    x, y, width, height = (float(v) for v in re.search(r'viewBox="([^"]+)"', profile).group(1).split())
    base = float(re.search(r'id="base-circle" r="([^"]+)"', profile).group(1))
    tall, bar = height + 10, y + height + 3
    tags = (f'<path d="M{x + 5:g} {bar - 1:g}v2m0 -1h50m0 -1v2" stroke="#000" stroke-width="0.4"/>'
            f'<g font-family="sans-serif" font-size="4" fill="#000"><text x="{x + 57:g}" y="{bar + 1.4:g}">50 mm</text>'
            f'<text y="{-base - 2:g}" text-anchor="middle">θ = 0</text>'
            f'<text y="{base + 4.5:g}" text-anchor="middle">ω</text></g></svg>')
    head = re.compile(r'width="[^"]*" height="[^"]*" viewBox="[^"]*"([^>]*>)')
    start = f'width="{6 * width:.0f}" height="{6 * tall:.0f}" viewBox="{x:g} {y:g} {width:g} {tall:g}"'
    paper = f'<rect x="{x:g}" y="{y:g}" width="{width:g}" height="{tall:g}" fill="#fff"/>'
    return head.sub(rf"{start}\1{paper}", profile, count=1).replace("</svg>", tags)


# Duration of a turn in the animation, s, and number of its key frames.
TURN, MOMENTS = 4, 72


def moving(kind, values):
    """Repeated change of position or size over a turn."""
    return (f'<animateTransform attributeName="transform" type="{kind}" values="{";".join(values)}" '
            f'dur="{TURN}s" repeatCount="indefinite"/>')


def motion(report):
    """Animated drawing of a report beside the force over the turn, as a picture."""
    data = json.loads(re.search(r'<script type="application/json" id="motion">(.*?)</script>', report, re.S).group(1))
    drawing = re.search(r'<svg (viewBox="\S+ \S+ \S+ \S+")[^>]*>(?=<g transform="scale\(1 -1\)">\n<g id="cam-turning">)(.*?)</svg>',
                        report, re.S)
    view, parts = drawing.groups()
    steps = len(data["f"]) - 1
    moments = [round(steps * k / MOMENTS) for k in range(MOMENTS + 1)]
    most = max(data["f"])
    places = {"cam-follower": ("px", "py"), "cam-push": ("cx", "cy"), "cam-contact": ("cx", "cy")}
    parts = parts.replace('<g id="cam-turning">', '<g id="cam-turning">' + moving("rotate", ["0", "360"]), 1)
    for part, (x, y) in places.items():
        path = [f"{data[x][i]:.2f} {data[y][i]:.2f}" for i in moments]
        first, moves = f' transform="translate({path[0]})">', moving("translate", path)
        parts = re.sub(rf'(<g id="{part}"[^>]*)>', lambda tag: tag.group(1) + first + moves, parts, count=1)
        parts = re.sub(rf'(<circle id="{part}"[^>]*)/>', lambda tag: tag.group(1) + first + moves + "</circle>", parts, count=1)
    # Line widths of the report are in pixels at any scale. Here they are in millimetres of the drawing.
    pixel = float(view.split()[2]) / 280
    parts = re.sub(r'stroke-width="([\d.]+)"', lambda width: f'stroke-width="{float(width.group(1)) * pixel:.3f}"', parts)
    reach = float(re.search(r'data-reach="([\d.]+)"', parts).group(1))
    head = lambda size: f"M0 0V{size:.2f}M{-6 * pixel:.2f} {size - 10 * pixel:.2f}L0 {size:.2f}L{6 * pixel:.2f} {size - 10 * pixel:.2f}"
    arrows = [head(reach * data["f"][i] / most) for i in moments]
    push = (f'<path d="{arrows[0]}" style="stroke:var(--red)" stroke-width="{2.4 * pixel:.3f}">'
            f'<animate attributeName="d" values="{";".join(arrows)}" dur="{TURN}s" repeatCount="indefinite"/></path>')
    parts = re.sub(r'<path d="M0 0H1M[^>]*/>', push, parts)
    # Force over the turn: 400 points wide, from 0 to its maximum.
    across, up = lambda i: 340 + 440 * i / steps, lambda f: 300 - 250 * f / most
    curve = "M" + "L".join(f"{across(i):.1f} {up(f):.1f}" for i, f in enumerate(data["f"]))
    along = [f"{across(i):.1f} {up(data['f'][i]):.1f}" for i in moments]
    ticks = "".join(f'<text x="{across(steps * k / 4):.0f}" y="322" text-anchor="middle">{90 * k}°</text>' for k in range(5))
    levels = "".join(
        f'<path d="M340 {up(f):.1f}H780" stroke="var(--grid)"/>'
        f'<text x="332" y="{up(f) + 5:.1f}" text-anchor="end">{f}</text>' for f in range(0, int(most) + 1, 200))
    picture = (
        '<svg xmlns="http://www.w3.org/2000/svg" width="800" height="340" viewBox="0 0 800 340" font-family="sans-serif" font-size="14">'
        '<style>text { fill: var(--quiet) }</style>'
        f'<rect width="800" height="340" fill="#fff"/><svg {view} x="10" y="10" width="280" height="320" fill="none">{parts}</svg>'
        f'{levels}{ticks}<text x="340" y="24">F, N</text><text x="787" y="304">θ</text><path d="{curve}" fill="none" stroke="var(--blue)" stroke-width="2.5"/>'
        f'<circle r="6" fill="var(--red)" transform="translate({along[0]})">{moving("translate", along)}</circle></svg>\n')
    return coloured(picture, report)


def content(folder, source):
    file, _, name = source.partition("#")
    text = (folder / file).read_text(encoding="utf-8")
    if name:
        text = {"motion": motion, "labelled": labelled}.get(name, lambda report: diagram(report, name))(text)
    assert len(text.encode()) <= LARGEST, f"{source}: {len(text.encode())} bytes"
    return text


def studio(binary, check):
    """Makes or compares the screenshots of the studio in a Python with Playwright."""
    tests = ROOT / "target" / "browser-tests" / "bin" / "python"
    python = sys.executable if find_spec("playwright") else tests
    if not Path(python).exists():
        sys.exit("the pictures of the studio need Playwright, which is not installed: "
                 "run crates/studio/tests/browser/run.sh target/release/gaitcam")
    command = [python, ROOT / "docs" / "screenshots.py", binary, *["--check"] * check]
    sys.exit(subprocess.run(command).returncode)


def main(binary, chapters, check):
    old = []
    TARGET.mkdir(exist_ok=True)
    for names, pictures in PICTURES.items():
        if chapters and names[0] not in chapters:
            continue
        for name, folder_of_pages, suffix in zip(names, ("guide", "guia"), ("", "-es")):
            path = ROOT / "docs" / folder_of_pages / f"{name}.md"
            if name is None or not path.exists():
                continue
            with tempfile.TemporaryDirectory() as folder:
                Page(path, binary, folder).run()
                for picture, source in pictures.items():
                    file = TARGET / f"{names[0]}-{picture}{suffix}.svg"
                    text = content(Path(folder), source)
                    if check:
                        old += [file.name] * (not file.exists() or file.read_text(encoding="utf-8") != text)
                        continue
                    file.write_text(text, encoding="utf-8")
                    print(f"{file.relative_to(ROOT)} {file.stat().st_size}")
    if old:
        sys.exit(f"old pictures: {', '.join(old)}; python3 docs/pictures.py {binary}")
    if not chapters or "studio" in chapters:
        studio(binary, check)


if __name__ == "__main__":
    arguments = [a for a in sys.argv[1:] if a != "--check"]
    known = [names[0] for names in PICTURES] + ["studio"]
    if not arguments or not set(arguments[1:]) <= set(known):
        sys.exit(f"{__doc__}\nChapters: {', '.join(known)}")
    main(str(Path(arguments[0]).resolve()), arguments[1:], "--check" in sys.argv)
