"""cam.step of several designs, read back by OCCT and by gmsh: see step.sh."""

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


def read(scene, changes, hole, solids, folder):
    out = folder / scene
    sets = [part for change in changes for part in ("--set", change)]
    command = [BINARY, "synth", str(ROOT / "scenes" / f"{scene}.toml"), *sets, "--solid", "--no-png", "--points", "400000", "--out", str(out)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    reader = STEPControl_Reader()
    assert reader.ReadFile(str(out / "cam.step")) == IFSelect_RetDone, f"{scene}: not read"
    reader.TransferRoots()
    whole = reader.OneShape()
    assert BRepCheck_Analyzer(whole).IsValid(), f"{scene}: not valid"
    found = list(shapes(whole, TopAbs_SOLID))
    assert len(found) == solids, f"{scene}: {len(found)} solids"
    surface, points = area(out / "profile.csv")
    thickness = 10.0
    exact = thickness * (surface - hole)
    properties = GProp_GProps()
    # To the accuracy that is asked for: the plain call integrates with few points and is off by 1e-4.
    BRepGProp.VolumeProperties_s(found[0], properties, 1e-9, True, False)
    error = properties.Mass() / exact - 1
    edges = list(shapes(found[0], TopAbs_EDGE))
    worst = 0.0
    for x, y in points[:: len(points) // 100]:
        vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, 0.0)).Vertex()
        worst = max(worst, min(BRepExtrema_DistShapeShape(vertex, edge).Value() for edge in edges))
    print(f"  {scene:28} {' '.join(changes):36} volume {error:+.1e}  edge {1e3 * worst:.4f} µm")
    assert abs(error) < 1e-6, f"{scene}: volume differs by {error}"
    assert worst < 1e-4, f"{scene}: the edge is {worst} mm away"
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
        files = [read(*scene, Path(folder)) for scene in SCENES]
        meshed(files[-1])
    print("step: OCCT and gmsh agree")


main()
