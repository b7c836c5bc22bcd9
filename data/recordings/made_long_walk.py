#!/usr/bin/env python3
"""Writes made_long_walk.csv: 52 s on two force plates that a computer made, with step times that vary as those of a person do.

    python3 data/recordings/made_long_walk.py

The walker of made_walk.py (700 N) makes 1.9 steps per second on average. The step times are an autoregressive sequence of first order with a
coefficient of variation of 2.5 % and a correlation of 0.3 from step to step. Each stance lasts in proportion to its step, and its force has 2 % of
scatter. The plates add noise of 2 N.
"""

import math
import random
from pathlib import Path

from made_walk import STANCE_S, STEPS_PER_S, WEIGHT_N, stance

RATE_HZ, STEPS = 100.0, 98
VARIATION, CORRELATION, SCATTER = 0.025, 0.3, 0.02


def main():
    chance = random.Random(7)
    deviation, strikes, scales = 0.0, [0.3], []
    for _ in range(STEPS):
        deviation = CORRELATION * deviation + math.sqrt(1 - CORRELATION**2) * VARIATION * chance.gauss(0, 1)
        strikes.append(strikes[-1] + (1 + deviation) / STEPS_PER_S)
        scales.append(chance.gauss(1, SCATTER))
    rows = ["# made by made_long_walk.py, not measured; forces in N", "time (s),Left Fz,Right Fz"]
    for i in range(round(RATE_HZ * (strikes[-1] + 0.3))):
        feet = [chance.gauss(0, 2), chance.gauss(0, 2)]
        for k, (start, end) in enumerate(zip(strikes, strikes[1:])):
            since = (i / RATE_HZ - start) / (end - start) / STEPS_PER_S
            if 0 <= since < STANCE_S:
                feet[k % 2] += WEIGHT_N * scales[k] * stance(since)
        rows.append(f"{i / RATE_HZ:.2f},{feet[0]:.0f},{feet[1]:.0f}")
    Path(__file__).with_suffix(".csv").write_text("\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
