#!/usr/bin/env python3
"""Writes made_log.csv: a log of a footbridge shaker that is not quite the one of its scene, made by a computer, so that its truth
is known.

    gaitcam synth footbridge --out out/bridge && python3 data/logs/made_log.py out/bridge

The moved mass is 73 kg (the scene: 71.4 kg), the guide rubs with 20 N s/m and 3 N, a bearing that runs out adds 6 N twice and
3 N five times per turn; the load cell is 1 ms late, reads 4 N too much and scatters by 2 N. 20 cycles, 250 samples a second.
"""

import csv
import math
import random
import sys
from pathlib import Path

rows = list(csv.DictReader(open(Path(sys.argv[1]) / "law.csv")))
law = [(float(r["v_m_per_rad"]), float(r["a_m_per_rad2"])) for r in rows]
speed, rate = 2 * math.pi * 1.85, 250
random.seed(36)


def force(theta):
    place = theta / (2 * math.pi) % 1 * len(law)
    (v, a), (p, q) = law[int(place)], law[(int(place) + 1) % len(law)]
    v, a = (x + place % 1 * (y - x) for x, y in ((v, p), (a, q)))
    rubs = 20 * speed * v + math.copysign(3, v)
    return 73 * (9.81 + speed**2 * a) + rubs + 6 * math.sin(2 * theta + 1) + 3 * math.cos(5 * theta)


with open(Path(__file__).parent / "made_log.csv", "w") as file:
    file.write("time_s,theta_rad,force_n\n")
    for i in range(round(20 / 1.85 * rate)):
        theta = 2 + speed * i / rate
        reading = force(theta - 0.001 * speed) + 4 + random.gauss(0, 2)
        file.write(f"{i / rate:.3f},{theta % (2 * math.pi):.4f},{reading:.2f}\n")
