"""cam.step of several designs, read back by OCCT and by gmsh: see step.sh."""

import csv
import math
import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from OCP.gp import gp_Pnt
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer

ROOT = Path(__file__).resolve().parent.parent.parent
BINARY = os.environ["GAITCAM"]
# Scene, changes, area of the hole in mm² (DIN 6885-1 by hand), number of solids.
ROUND = math.pi * 36
KEYED = 100 * math.pi + 6 * (12.8 - math.sqrt(91)) - (100 * math.asin(0.3) - 3 * math.sqrt(91))
SCENES = [
    ("footbridge", [], ROUND, 1),
    ("footbridge", ["cam.bore=20 mm", "cam.keyway=auto"], KEYED, 1),
    ("heel_tester", [], 0, 1),
    ("thesis_iteration_3", [], 0, 1),
    ("camdas_01_roller", ["cam.bore=20 mm", "cam.keyway=6 mm"], KEYED, 1),
    ("camdas_07_conjugate_roller", [], 0, 2),
]


def shapes(whole, kind):
    explorer = TopExp_Explorer(whole, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def area(path):
    """Within the profile's table, mm²: the trapezoid rule on a smooth closed curve."""
    with open(path, newline="") as file:
        points = [(1e3 * float(r["x_m"]), 1e3 * float(r["y_m"])) for r in csv.DictReader(file)]
    twice = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))
    return abs(twice) / 2, points


def synth(scene, changes, out):
    sets = [part for change in changes for part in ("--set", change)]
    command = [BINARY, "synth", str(scene), *sets, "--solid", "--no-png", "--points", "400000", "--out", str(out)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def solids_of(path, count):
    """The valid solids of a file, and the volume of the first, mm³."""
    reader = STEPControl_Reader()
    assert reader.ReadFile(str(path)) == IFSelect_RetDone, f"{path}: not read"
    reader.TransferRoots()
    whole = reader.OneShape()
    assert BRepCheck_Analyzer(whole).IsValid(), f"{path}: not valid"
    found = list(shapes(whole, TopAbs_SOLID))
    assert len(found) == count, f"{path}: {len(found)} solids"
    properties = GProp_GProps()
    # To the accuracy that is asked for: the plain call integrates with few points and is off by 1e-4.
    BRepGProp.VolumeProperties_s(found[0], properties, 1e-9, True, False)
    return found, properties.Mass()


def farthest(points, parts):
    """Largest distance of points from the nearest of some edges or faces, mm."""
    worst = 0.0
    for p in points:
        vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*map(float, p))).Vertex()
        worst = max(worst, min(BRepExtrema_DistShapeShape(vertex, part).Value() for part in parts))
    return worst


def report(name, changes, error, edge):
    print(f"  {name:28} {' '.join(changes):36} volume {error:+.1e}  edge {1e3 * edge:.4f} µm", flush=True)
    assert abs(error) < 1e-6, f"{name}: volume differs by {error}"
    assert edge < 1e-4, f"{name}: the edge is {edge} mm away"


def read(scene, changes, hole, solids, folder):
    out = folder / scene
    synth(ROOT / "scenes" / f"{scene}.toml", changes, out)
    found, volume = solids_of(out / "cam.step", solids)
    surface, points = area(out / "profile.csv")
    exact = 10.0 * (surface - hole)
    edges = list(shapes(found[0], TopAbs_EDGE))
    rim = [(x, y, 0.0) for x, y in points[:: len(points) // 100]]
    report(scene, changes, volume / exact - 1, farthest(rim, edges))
    return out / "cam.step"


def slide(folder):
    """The translating cam: the area under its table, closed by the foot."""
    out = folder / "slide"
    synth(ROOT / "scenes" / "translating_cam.toml", [], out)
    found, volume = solids_of(out / "cam.step", 1)
    with open(out / "profile.csv", newline="") as file:
        points = [(1e3 * float(r["x_m"]), 1e3 * float(r["y_m"])) for r in csv.DictReader(file)]
    ring = [(points[0][0], 0.0), *points, (points[-1][0], 0.0)]
    twice = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1]))
    edges = list(shapes(found[0], TopAbs_EDGE))
    rim = [(x, y, 10.0) for x, y in points[:: len(points) // 100]]
    report("translating_cam", [], volume / (10.0 * abs(twice) / 2) - 1, farthest(rim, edges))


def walls(law, distance, roller, offset):
    """Angle and height of both walls at a distance from the axis, mm: the roller's axis meets the barrel's, the contact
    is the point of its circle at r along the axis that faces the wall, r found by halving."""
    theta, s, v = law
    low, high = np.zeros_like(theta), np.full_like(theta, distance)
    for _ in range(60):
        r = 0.5 * (low + high)
        aside = roller * v / np.hypot(r, v)
        near = r * r + aside * aside < distance * distance
        low, high = np.where(near, r, low), np.where(near, high, r)
    out = []
    for side in (-1.0, 1.0):
        aside = -side * roller * v / np.hypot(r, v)
        out.append((theta + np.arctan2(aside, r), s + side * (offset + roller * r / np.hypot(r, v))))
    return out


def opened(law, turns, distance, roller, offset, count=100_000):
    """Height of the groove's opening at equal angles, mm, with its walls: union over the turns."""
    angles = np.arange(count) * 2 * math.pi / count
    bounds = []
    for angle, z in walls(law, distance, roller, offset):
        whole = 2 * math.pi * turns
        order = np.argsort(angle % whole)
        x, y = (angle % whole)[order], z[order]
        bounds.append([np.interp(angles + 2 * math.pi * k, x, y, period=whole) for k in range(turns)])
    lows, highs = np.array(bounds[0]), np.array(bounds[1])
    order = np.argsort(lows, axis=0)
    lows, highs = np.take_along_axis(lows, order, 0), np.take_along_axis(highs, order, 0)
    total, reached = np.zeros(count), np.full(count, -np.inf)
    for low, high in zip(lows, highs):
        total += np.maximum(0.0, high - np.maximum(low, reached))
        reached = np.maximum(reached, high)
    return angles, lows, highs, total


def barrel(name, scene, turns, floor, surface, roller, offset, hole, engraved, folder):
    """A barrel: its volume by integration over the law's table, its edges and walls by points of the roller's envelope."""
    out = folder / name
    synth(scene, [], out)
    found, volume = solids_of(out / "cam.step", 1)
    with open(out / "law.csv", newline="") as file:
        rows = [(float(r["theta_rad"]), 1e3 * float(r["s_m"]), 1e3 * float(r["v_m_per_rad"])) for r in csv.DictReader(file)]
    law = np.array(rows).T
    nodes, weights = np.polynomial.legendre.leggauss(8)
    removed = 0.0
    for node, weight in zip(nodes, weights):
        distance = 0.5 * (floor + surface) + 0.5 * (surface - floor) * node
        total = opened(law, turns, distance, roller, offset)[3]
        removed += 0.5 * (surface - floor) * weight * distance * 2 * math.pi * total.mean()
    # The barrel ends a roller's radius beyond the groove.
    length = law[1].max() - law[1].min() + 2 * offset + 4 * roller
    exact = length * (math.pi * surface**2 - hole) - removed - engraved
    parts = [list(shapes(found[0], kind)) for kind in (TopAbs_EDGE, TopAbs_FACE)]
    worst = 0.0
    for distance, of in ((floor, parts[0]), (surface, parts[0]), (0.5 * (floor + surface), parts[1])):
        angles, lows, highs, _ = opened(law, turns, distance, roller, offset)
        for i in range(0, len(angles), len(angles) // 40):
            for turn in range(turns):
                others = [k for k in range(turns) if k != turn]
                for z in (lows[turn][i], highs[turn][i]):
                    if any(lows[k][i] < z < highs[k][i] for k in others):
                        continue
                    point = (distance * math.cos(angles[i]), -distance * math.sin(angles[i]), z)
                    worst = max(worst, farthest([point], of))
    report(name, [], volume / exact - 1, worst)
    return out / "cam.step"


FURNISHED = """
name = "furnished"
[drive]
kind = "fixed-axis"
speed = "100 rpm"
[law]
family = "program"
[[law.segment]]
motion = "cycloidal"
lift = "3 mm"
angle = "180 deg"
[[law.segment]]
motion = "cycloidal"
lift = "-3 mm"
angle = "180 deg"
[cam]
follower = "roller-translating"
roller_radius = "10 mm"
prime_radius = "65 mm"
"""

ONE_TURN = """
name = "one_turn"
[drive]
kind = "fixed-axis"
speed = "100 rpm"
[law]
family = "program"
[[law.segment]]
motion = "cycloidal"
lift = "30 mm"
angle = "150 deg"
[[law.segment]]
motion = "dwell"
angle = "40 deg"
[[law.segment]]
motion = "3-4-5"
lift = "-30 mm"
angle = "120 deg"
[[law.segment]]
motion = "dwell"
angle = "50 deg"
[cam]
follower = "barrel"
base_radius = "45 mm"
depth = "10 mm"
roller_radius = "7 mm"
bore = "20 mm"
keyway = "6 mm"
mark = true
[limits]
pressure_angle = "none"
"""


def furnished(folder):
    """A plate with keyway, mark, hub and balance hole: what is added and taken away is known but for the hole, whose
    circle the DXF has."""
    out = folder / "furnished"
    changes = ["cam.bore=20 mm", "cam.keyway=auto", "cam.mark=true", "cam.balance=true", "cam.hub.diameter=34 mm", "cam.hub.length=12 mm"]
    scene = folder / "furnished.toml"
    scene.write_text(FURNISHED)
    synth(scene, changes, out)
    found, volume = solids_of(out / "cam.step", 1)
    surface, points = area(out / "profile.csv")
    lines = [line.strip() for line in (out / "profile.dxf").read_text().splitlines()]
    radii = [float(lines[k + 10]) for k in range(len(lines)) if lines[k] == "CIRCLE" and lines[k + 2] == "CUT_BALANCE_HOLE"]
    assert len(radii) == 1, "no balance hole"
    balance = math.pi * radii[0] ** 2
    exact = 10.0 * (surface - KEYED - balance) + 12.0 * (math.pi * 17.0**2 - KEYED) - 0.3 * math.pi
    edges = list(shapes(found[0], TopAbs_EDGE))
    rim = [(x, y, 0.0) for x, y in points[:: len(points) // 100]]
    report("furnished", changes[3:], volume / exact - 1, farthest(rim, edges))
    return out / "cam.step"


def meshed(path):
    """gmsh reads the solid and sees its volume too."""
    import gmsh

    gmsh.initialize(interruptible=False)
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.occ.importShapes(str(path))
    gmsh.model.occ.synchronize()
    volumes = [gmsh.model.occ.getMass(3, tag) for _, tag in gmsh.model.getEntities(3)]
    gmsh.finalize()
    assert volumes and all(v > 0 for v in volumes), volumes
    print(f"  gmsh: {len(volumes)} volume(s) in {path.parent.name}")


def main():
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        files = [read(*scene, folder) for scene in SCENES]
        files.append(furnished(folder))
        slide(folder)
        one = folder / "one_turn.toml"
        one.write_text(ONE_TURN)
        # The mark is 1 mm wide and 0.3 mm deep.
        files.append(barrel("one_turn", one, 1, 35.0, 45.0, 7.0, 0.0, KEYED, 0.3 * math.pi, folder))
        crossed = ROOT / "scenes" / "thesis_barrel.toml"
        files.append(barrel("thesis_barrel", crossed, 2, 21.0, 30.0, 5.25, 0.25, 0.0, 0.0, folder))
        for file in files[-3:]:
            meshed(file)
    print("step: OCCT and gmsh agree")


main()
