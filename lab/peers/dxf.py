"""Reads profile.dxf of several designs, as arcs and as splines, with ezdxf: see dxf.sh."""

import csv
import math
import os
import subprocess
import tempfile
from pathlib import Path

import ezdxf
from ezdxf.math import BSpline

ROOT = Path(__file__).resolve().parent.parent.parent
BINARY = os.environ["GAITCAM"]
# Scene, changes, closed curves with their tables.
SCENES = [
    ("footbridge", ["cam.bore=20 mm", "cam.keyway=auto"], {"CUT_PROFILE": "profile.csv"}),
    ("heel_tester", [], {"CUT_PROFILE": "profile.csv"}),
    ("camdas_07_conjugate_roller", [], {"CUT_PROFILE": "profile.csv", "CUT_SECOND_PROFILE": "second_profile.csv"}),
    ("translating_cam", [], {}),
    ("thesis_barrel", [], {}),
]


def shoelace(points):
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))) / 2


def of_arcs(entity):
    """Area within a closed polyline of arcs: area of the polygon and of the segments between chords and arcs."""
    rows = [(v.dxf.location.x, v.dxf.location.y, v.dxf.bulge) for v in entity.vertices]
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(rows, rows[1:] + rows[:1])) / 2
    for (x, y, bulge), (u, v, _) in zip(rows, rows[1:] + rows[:1]):
        if bulge:
            angle = 4 * math.atan(bulge)
            radius = math.hypot(u - x, v - y) / (2 * math.sin(angle / 2))
            area += radius * radius * (angle - math.sin(angle)) / 2
    return abs(area)


def of_spline(entity, count=200_000):
    """Area within a closed spline, and points on it."""
    curve = BSpline([tuple(p) for p in entity.control_points], order=4, knots=list(entity.knots))
    end = curve.max_t
    points = [(p.x, p.y) for p in curve.points([end * i / count for i in range(count)])]
    return shoelace(points), points


def drawn(scene, changes, curves, folder):
    out = folder / f"{scene}_{curves}"
    sets = [part for change in changes for part in ("--set", change)]
    command = [BINARY, "synth", str(ROOT / "scenes" / f"{scene}.toml"), *sets, "--no-png", "--points", "100000", "--dxf", curves, "--out", str(out)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    document = ezdxf.readfile(out / "profile.dxf")
    audit = document.audit()
    assert not audit.errors, f"{scene}, {curves}: {audit.errors}"
    return document, out


def on(document, layer, kind):
    return [e for e in document.modelspace() if e.dxf.layer == layer and e.dxftype() == kind]


def distance(point, points, near):
    """Distance of a point from a polygon, searched near the last position."""
    n = len(points)
    best = math.inf
    for k in range(near - 40, near + 40):
        (a, b), (c, d) = points[k % n], points[(k + 1) % n]
        dx, dy = c - a, d - b
        u = max(0.0, min(1.0, ((point[0] - a) * dx + (point[1] - b) * dy) / (dx * dx + dy * dy)))
        best = min(best, math.hypot(point[0] - a - u * dx, point[1] - b - u * dy))
    return best


def main():
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        for scene, changes, edges in SCENES:
            arcs, out = drawn(scene, changes, "arcs", folder)
            splines, _ = drawn(scene, changes, "splines", folder)
            assert splines.dxfversion == "AC1015" and arcs.dxfversion == "AC1009"
            count = len([e for e in splines.modelspace() if e.dxftype() == "SPLINE"])
            assert count > 0, scene
            said = f"{count} splines"
            for layer, table in edges.items():
                with open(out / table, newline="") as file:
                    truth = [(1e3 * float(r["x_m"]), 1e3 * float(r["y_m"])) for r in csv.DictReader(file)]
                exact = shoelace(truth)
                by_arcs = of_arcs(on(arcs, layer, "POLYLINE")[0])
                by_spline, points = of_spline(on(splines, layer, "SPLINE")[0])
                # Area of a deviation of 0.1 µm along the whole curve.
                length = sum(math.dist(a, b) for a, b in zip(truth, truth[1:]))
                assert abs(by_arcs - exact) < 1e-4 * length, (scene, by_arcs, exact)
                assert abs(by_spline - exact) < 1e-4 * length, (scene, by_spline, exact)
                worst = 0.0
                for point in truth[:: len(truth) // 60]:
                    near = min(range(0, len(points), 20), key=lambda k: math.dist(points[k], point))
                    worst = max(worst, distance(point, points, near))
                assert worst < 1e-4, f"{scene}: the spline is {worst} mm away"
                said += f", {layer}: area arcs {by_arcs / exact - 1:+.1e} splines {by_spline / exact - 1:+.1e}, edge {1e3 * worst:.4f} µm"
            print(f"  {scene:28} {said}", flush=True)
    print("dxf: ezdxf agrees")


main()
