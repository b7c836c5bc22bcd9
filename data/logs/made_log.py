#!/usr/bin/env python3
"""Writes generated logs of a footbridge shaker whose parameters differ from its scene, so that the true values are known.

    gaitcam synth footbridge --out out/bridge && python3 data/logs/made_log.py out/bridge

The moved mass is 73 kg (scene: 71.4 kg), the guide friction is 20 N s/m and 3 N, and the runout of a bearing adds 6 N twice and
3 N five times per turn. The load cell has a delay of 1 ms, an offset of 4 N and noise of 2 N. There are 20 cycles with 250 samples
per second.

- made_log.csv: time, angle and force at constant speed;
- made_time.csv: time and force only;
- made_torque.csv: with speed and torque at the camshaft. The speed varies by 2 % once per turn. The shaft has an inertia of
  0.05 kg m² and a friction torque of 0.5 N m.
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


def write(name, header, rows):
    with open(Path(__file__).parent / name, "w") as file:
        file.write("\n".join([header, *rows]) + "\n")


samples = range(round(20 / 1.85 * rate))
log = []
for i in samples:
    theta = 2 + speed * i / rate
    reading = force(theta - 0.001 * speed) + 4 + random.gauss(0, 2)
    log.append((f"{i / rate:.3f}", f"{theta % (2 * math.pi):.4f}", f"{reading:.2f}"))
write("made_log.csv", "time_s,theta_rad,force_n", map(",".join, log))
write("made_time.csv", "time_s,force_n", (f"{time},{reading}" for time, _, reading in log))

theta, steps, log = 2.0, 40, []
for i in samples:
    turning = speed * (1 + 0.02 * math.sin(theta))
    pressed = force(theta)
    place = theta / (2 * math.pi) % 1 * len(law)
    v, w = law[int(place)][0], law[(int(place) + 1) % len(law)][0]
    torque = pressed * (v + place % 1 * (w - v)) + 0.05 * turning * 0.02 * speed * math.cos(theta) + 0.5
    reading, torque = pressed + 4 + random.gauss(0, 2), torque + random.gauss(0, 0.05)
    log.append(f"{i / rate:.3f},{theta % (2 * math.pi):.4f},{reading:.2f},{turning:.4f},{torque:.3f}")
    for _ in range(steps):
        theta += speed * (1 + 0.02 * math.sin(theta)) / rate / steps
write("made_torque.csv", "time_s,theta_rad,force_n,speed_rad_per_s,torque_n_m", log)
