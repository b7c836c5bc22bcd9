#!/usr/bin/env python3
"""Writes docs/reference/laws.md and its picture from the catalogue of the program and the formulas below.

    python3 docs/laws.py target/release/gaitcam [--check]

Every formula is evaluated. Its peak velocity and acceleration must be those of the catalogue. With --check nothing is
written, and page and picture in the repository must equal the output.
"""

import json
import subprocess
import sys
from math import cos, pi, sin
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE, PICTURE = ROOT / "docs/reference/laws.md", ROOT / "docs/pictures/laws.svg"
STEPS = 600


def scca(b, c, d):
    """Law of sine, constant and cosine acceleration, integrated twice; peak and duration 1."""

    def shape(x):
        if x > 0.5:
            return -shape(1 - x)
        if x < b / 2:
            return sin(pi * x / b)
        return 1.0 if x <= (b + c) / 2 else cos(pi * (x - (b + c) / 2) / d)

    fine, v, s, rows = 40, 0.0, 0.0, [0.0]
    for i in range(STEPS * fine):
        step = 1 / (STEPS * fine)
        a = shape((i + 0.5) * step)
        s += v * step + a * step * step / 2
        v += a * step
        if (i + 1) % fine == 0:
            rows.append(s)
    return lambda x: rows[round(x * STEPS)] / rows[-1]


def powers(*terms):
    return lambda x: sum(c * x**k for k, c in terms)


def sines(*terms):
    return lambda x: x - sum(c * sin(k * pi * x) for k, c in terms)


ALPHA = 1125 / 1192
# Name in the catalogue, with the formula and the function.
LAWS = {
    "constant-velocity": ("x", lambda x: x),
    "parabolic": ("2x², then 1 − 2(1 − x)²", lambda x: 2 * x * x if x < 0.5 else 1 - 2 * (1 - x) ** 2),
    "cubic": ("3x² − 2x³", powers((2, 3), (3, -2))),
    "simple-harmonic": ("½(1 − cos πx)", lambda x: (1 - cos(pi * x)) / 2),
    "double-harmonic": ("½[(1 − cos πx) − ¼(1 − cos 2πx)]", lambda x: (1 - cos(pi * x) - (1 - cos(2 * pi * x)) / 4) / 2),
    "cycloidal": ("x − sin(2πx)/2π", sines((2, 1 / (2 * pi)))),
    "semiharmonic-start": ("1 − cos(πx/2)", lambda x: 1 - cos(pi * x / 2)),
    "semiharmonic-end": ("sin(πx/2)", lambda x: sin(pi * x / 2)),
    "semicycloidal-start": ("x − sin(πx)/π", sines((1, 1 / pi))),
    "semicycloidal-end": ("x + sin(πx)/π", sines((1, -1 / pi))),
    "modified-trapezoid": ("SCCA b = ¼, c = ½, d = ¼", scca(0.25, 0.5, 0.25)),
    "modified-sine": ("SCCA b = ¼, c = 0, d = ¾", scca(0.25, 0, 0.75)),
    "scca": ("SCCA: sine, constant, cosine acceleration; b = c = ¼, d = ½", scca(0.25, 0.25, 0.5)),
    "3-4-5": ("10x³ − 15x⁴ + 6x⁵", powers((3, 10), (4, -15), (5, 6))),
    "4-5-6-7": ("35x⁴ − 84x⁵ + 70x⁶ − 20x⁷", powers((4, 35), (5, -84), (6, 70), (7, -20))),
    "5-6-7-8-9": ("126x⁵ − 420x⁶ + 540x⁷ − 315x⁸ + 70x⁹", powers((5, 126), (6, -420), (7, 540), (8, -315), (9, 70))),
    "polynomial-5": ("3-4-5 between dwells; otherwise the polynomial of degree 5 that joins its neighbours", None),
    "polynomial-7": ("4-5-6-7 between dwells; otherwise the polynomial of degree 7 that joins its neighbours", None),
    "berzak-d": ("12.1x³ − 25.5x⁴ + 24.9x⁵ − 14.7x⁶ + 4.2x⁷", powers((3, 12.1), (4, -25.5), (5, 24.9), (6, -14.7), (7, 4.2))),
    "gutman-1-3": ("x − (15/32π) sin 2πx − (1/96π) sin 6πx", sines((2, 15 / (32 * pi)), (6, 1 / (96 * pi)))),
    "freudenstein-1-3": ("x − (27/56π)(sin 2πx + sin(6πx)/54)", sines((2, 27 / (56 * pi)), (6, 27 / (56 * pi * 54)))),
    "freudenstein-1-3-at-rest": ("x − (27/56π)(sin 2πx + sin(6πx)/81)", sines((2, 27 / (56 * pi)), (6, 27 / (56 * pi * 81)))),
    "freudenstein-1-3-5": ("x − (α/2π)(sin 2πx + sin(6πx)/54 + sin(10πx)/1250), α = 1125/1192", sines((2, ALPHA / (2 * pi)), (6, ALPHA / (108 * pi)), (10, ALPHA / (2500 * pi)))),
    "eccentric": ("½(1 − cos πx) with a flat face; with a roller it depends on the ratio", None),
}
HEAD = """# Rise laws

![Lift, velocity, acceleration and jerk of the laws](../pictures/laws.svg)

```sh
gaitcam laws
```

The names are used in `law.segment.N.motion`. A rise by h over the angle β, with x = θ/β from 0 to 1, has

    lift s = h·f(x),  velocity ≤ Cv·h/β,  acceleration ≤ Ca·h/β²,  jerk ≤ Cj·h/β³

Derivatives in time have the additional factors ω, ω², ω³. The peak of the inertia torque is proportional to Ct = max|a·v|. A fall is the
inverted rise; for an unsymmetrical law it is also mirrored in x. In the picture every curve is scaled to its own maximum; an arrow is an infinite
jerk. The jerk is also infinite at an end if the acceleration of the neighbour is different.

| law | f(x) | Cv | Ca | Cj | Ct | joins at its start → end |
|---|---|---|---|---|---|---|
"""
TAIL = """
*Joins* lists the neighbours that cause no jump of velocity or acceleration: a dwell, a constant velocity, or a fall that
begins with the same acceleration. Next to a dwell, the acceleration of a law for an equal return jumps, and the verdict is
`not-for-high-speed`.

| requirement | law |
|---|---|
| minimum peak acceleration between dwells | `modified-trapezoid` |
| minimum peak velocity, torque and pressure angle between dwells | `modified-sine` |
| continuous jerk between dwells, little vibration at high speed | `4-5-6-7`, `5-6-7-8-9` |
| a simple law for most machines | `cycloidal`, `3-4-5` |
| rise and return without dwell | `simple-harmonic` |
| constant velocity in the middle | `semicycloidal-start`, `constant-velocity`, `semicycloidal-end` |
| a given force | no law of this table; `law.family = "spline"` computes the law |

The parameters of `scca b c d` and `eccentric ratio` follow the name. [Theory §7](../theory/cams.md#7-rise-laws) describes SCCA, residual
vibration and sources. `docs/laws.py` evaluates every formula and writes this page.
"""


def curves(function):
    """Lift and its first three derivatives at the centres of the steps, by differences."""
    rows = [[function(i / STEPS) for i in range(STEPS + 1)]]
    for _ in range(3):
        rows.append([(b - a) * STEPS for a, b in zip(rows[-1], rows[-1][1:])])
    return rows


def verify(law, rows):
    for key, row, allowed in (("cv", rows[1], 2e-3), ("ca", rows[2], 2e-2)):
        peak = max(map(abs, row))
        assert abs(peak - law[key]) <= allowed * max(1, law[key]), f"{law['name']}: {key} {law[key]}, formula {peak}"


def cell(name, rows, left, top):
    """Diagram of one law: four curves, each scaled to its peak, and an arrow where the acceleration jumps."""
    out = [f'<text x="{left + 2}" y="{top + 14}" font-weight="bold">{name}</text>']
    for row, colour in zip(rows, ("#0072b2", "#009e73", "#d55e00", "#be5f9b")):
        # Differences over a jump do not approximate the jerk. Values far beyond the others are left out.
        size = max(sorted(map(abs, row))[: max(1, len(row) - 12)])
        size = size if size > 1e-3 else 1  # zero but for rounding
        points = ((i / len(row), y / size) for i, y in enumerate(row) if i % 6 == 0 and abs(y) <= 1.15 * size)
        text = " ".join(f"{left + 2 + 176 * x:.1f},{top + 72 - 48 * y:.1f}" for x, y in points)
        out.append(f'<polyline points="{text}" fill="none" stroke="{colour}" stroke-width="1.4"/>')
    out.insert(1, f'<path d="M{left + 2} {top + 72}h176" stroke="#9ea6b1"/>')
    acceleration, last = rows[2], 0
    least = max(1e-3, 0.2 * max(map(abs, acceleration)))
    for i, (a, b) in enumerate(zip(acceleration, acceleration[1:])):
        if abs(b - a) > least and i > last + 2:
            last, x, up = i, left + 2 + 176 * (i + 1.5) / len(acceleration), 1 if b > a else -1
            out.append(f'<path d="M{x:.1f} {top + 72}v{-44 * up}m-3 {7 * up}l3 {-7 * up}l3 {7 * up}" fill="none" stroke="#be5f9b" stroke-width="1.4"/>')
    return out


def main(binary, check):
    catalogue = json.loads(subprocess.run([binary, "laws", "--json"], capture_output=True, check=True, text=True).stdout)
    assert {law["name"] for law in catalogue} == set(LAWS), "the catalogue has other laws than this script"
    lines, drawn = [], []
    for law in catalogue:
        formula, function = LAWS[law["name"]]
        numbers = " | ".join("∞" if law[k] is None else f"{law[k]:.5g}" for k in ("cv", "ca", "cj", "ct"))
        lines.append(f"| `{law['name']}` | {formula} | {numbers} | {' → '.join(dict.fromkeys(law['joins']))} |")
        if function:
            rows = curves(function)
            verify(law, rows)
            drawn += cell(law["name"], rows, 10 + 190 * (len(drawn) // 6 % 4), 24 + 130 * (len(drawn) // 24))
    height = 40 + 130 * -(-len(drawn) // 24)
    key = "".join(f'<tspan fill="{c}">{n}  </tspan>' for c, n in
                  (("#0072b2", "lift"), ("#009e73", "velocity"), ("#d55e00", "acceleration"), ("#be5f9b", "jerk")))
    picture = (f'<svg xmlns="http://www.w3.org/2000/svg" width="780" height="{height}" viewBox="0 0 780 {height}" '
               f'font-family="sans-serif" font-size="12"><rect width="780" height="{height}" fill="#fff"/>'
               f'<text x="12" y="16" xml:space="preserve">{key}</text>{"".join(drawn)}</svg>\n')
    page = HEAD + "\n".join(lines) + "\n" + TAIL
    if check and (PAGE.read_text(encoding="utf-8"), PICTURE.read_text(encoding="utf-8")) != (page, picture):
        sys.exit("docs/reference/laws.md or its picture is not up to date: run python3 docs/laws.py")
    if not check:
        PAGE.write_text(page, encoding="utf-8")
        PICTURE.write_text(picture, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(sys.argv[1], "--check" in sys.argv)
