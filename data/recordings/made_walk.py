#!/usr/bin/env python3
"""Writes made_walk.csv: a generated recording of two force plates, so that the true values are known.

    python3 data/recordings/made_walk.py

A walker of 700 N (71.36 kg) makes 1.9 steps per second on a treadmill with one plate under each foot. Every stance
has the shape of Li et al. (2010), see data/gait_curves/SOURCES.md, with a variation of 3 % from step to step. The plates
add noise of 2 N and offsets of +4 N and -6 N.
"""

import math
import random
from pathlib import Path

WEIGHT_N, STEPS_PER_S, RATE_HZ, DURATION_S = 700.0, 1.9, 100.0, 10.5
STANCE_S = 1 / (0.76 * STEPS_PER_S)
A = [-0.0698 * STEPS_PER_S + 1.211, 0.1052 * STEPS_PER_S - 0.1284, 0.3002 * STEPS_PER_S - 0.1534,
     0.0416 * STEPS_PER_S - 0.0288, -0.0275 * STEPS_PER_S + 0.0608]
# Mean of both feet over a stride, relative to the weight (only odd terms have a mean).
MEAN = 2 * sum(a * 2 / (n * math.pi) for n, a in enumerate(A, 1) if n % 2) * STANCE_S * STEPS_PER_S / 2


def stance(time_s):
    """Force relative to the weight, `time_s` after heel strike."""
    return sum(a * math.sin(n * math.pi * time_s / STANCE_S) for n, a in enumerate(A, 1)) / MEAN


def foot(time_s, first_strike_s, scatter):
    stride_s = 2 / STEPS_PER_S
    number = math.floor((time_s - first_strike_s) / stride_s)
    since = time_s - first_strike_s - number * stride_s
    return WEIGHT_N * scatter[number] * stance(since) if since < STANCE_S else 0.0


def main():
    chance = random.Random(19)
    feet = [[chance.gauss(1, 0.03) for _ in range(16)] for _ in range(2)]
    rows = ["# made by made_walk.py, not measured; forces in N", "time (s),Left Fz,Right Fz"]
    for i in range(round(RATE_HZ * DURATION_S)):
        t = i / RATE_HZ
        left = foot(t, 0.3, feet[0]) + 4 + chance.gauss(0, 2)
        right = foot(t, 0.3 + 1 / STEPS_PER_S, feet[1]) - 6 + chance.gauss(0, 2)
        rows.append(f"{t:.2f},{left:.1f},{right:.1f}")
    Path(__file__).with_suffix(".csv").write_text("\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
