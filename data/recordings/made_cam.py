#!/usr/bin/env python3
"""Writes made_cam.csv: 240 generated points of a cam in the format of a measuring machine, so that the true values are known.

    gaitcam synth footbridge --out out/bridge && python3 data/recordings/made_cam.py out/bridge

The cam is turned by 30° and shifted by (5, -2) mm; its profile has five waves of 20 µm along the normal.
"""

import csv
import math
import sys
from pathlib import Path

rows = list(csv.DictReader(open(Path(sys.argv[1]) / "profile.csv")))[::6]
place = [(1e3 * float(r["x_m"]), 1e3 * float(r["y_m"])) for r in rows]
count = len(place)
cos, sin = math.cos(math.radians(30)), math.sin(math.radians(30))
with open(Path(__file__).parent / "made_cam.csv", "w") as file:
    file.write("x_mm,y_mm\n")
    for i, (x, y) in enumerate(place):
        (u, v), (p, q) = place[(i + 1) % count], place[i - 1]
        length = math.hypot(u - p, v - q)
        # The profile runs clockwise, so that its left side is outside.
        wave = 0.02 * math.cos(10 * math.pi * i / count) / length
        x, y = x - wave * (v - q), y + wave * (u - p)
        file.write(f"{cos * x - sin * y + 5:.4f},{sin * x + cos * y - 2:.4f}\n")
