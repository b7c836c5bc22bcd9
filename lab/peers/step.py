"""Reads cam.step of several designs with OCCT and gmsh: see step.sh."""

import csv
import math
import os
import subprocess
import tempfile
from pathlib import Path

from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from OCP.gp import gp_Pnt
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer

ROOT = Path(__file__).resolve().parent.parent.parent
BINARY = os.environ["GAITCAM"]
# Scene, changes, area of the hole in mm² (DIN 6885-1, computed by hand), number of solids.
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
    """Area within the profile of the table, mm², by the trapezoid rule on a smooth closed curve."""
    with open(path, newline="") as file:
        points = [(1e3 * float(r["x_m"]), 1e3 * float(r["y_m"])) for r in csv.DictReader(file)]
    twice = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))
    return abs(twice) / 2, points


def synth(scene, changes, out):
    sets = [part for change in changes for part in ("--set", change)]
    command = [BINARY, "synth", str(scene), *sets, "--solid", "--no-png", "--points", "400000", "--out", str(out)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def solids_of(path, count):
    """Valid solids of a file, and the volume of the first, mm³."""
    reader = STEPControl_Reader()
    assert reader.ReadFile(str(path)) == IFSelect_RetDone, f"{path}: not read"
    reader.TransferRoots()
    whole = reader.OneShape()
    assert BRepCheck_Analyzer(whole).IsValid(), f"{path}: not valid"
    found = list(shapes(whole, TopAbs_SOLID))
    assert len(found) == count, f"{path}: {len(found)} solids"
    properties = GProp_GProps()
    # The accuracy is stated, because the call without it uses few points and has an error of 1e-4.
    BRepGProp.VolumeProperties_s(found[0], properties, 1e-9, True, False)
    return found, properties.Mass()


def farthest(points, parts):
    """Maximum distance of points from the nearest of some edges or faces, mm."""
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
    """Area of the translating cam: the area under its table, closed by the base."""
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

def furnished(folder):
    """Area of a plate with keyway and mark. The removed area is known."""
    out = folder / "furnished"
    changes = ["cam.bore=20 mm", "cam.keyway=auto", "cam.mark=true"]
    scene = folder / "furnished.toml"
    scene.write_text(FURNISHED)
    synth(scene, changes, out)
    found, volume = solids_of(out / "cam.step", 1)
    surface, points = area(out / "profile.csv")
    exact = 10.0 * (surface - KEYED) - 0.3 * math.pi
    edges = list(shapes(found[0], TopAbs_EDGE))
    rim = [(x, y, 0.0) for x, y in points[:: len(points) // 100]]
    report("furnished", changes[3:], volume / exact - 1, farthest(rim, edges))
    return out / "cam.step"


def meshed(path):
    """Checks that gmsh reads the solid with the same volume."""
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
        for file in files[-1:]:
            meshed(file)
    print("step: OCCT and gmsh agree")


main()
