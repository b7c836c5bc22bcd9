"""Generated recordings of walking: small, long, binary, doubtful."""

import importlib.util
import math
import random

from studio import ROOT

SPEC = importlib.util.spec_from_file_location("made_walk", ROOT / "data" / "recordings" / "made_walk.py")
MADE = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(MADE)
HEAD = "# forces in N\ntime (s),Left Fz,Right Fz\n"


def walk(rate=100.0, seconds=8.5, seed=1, times=1.0, head=HEAD, digits=1):
    """Recording of two plates with a walker of 700 N."""
    chance = random.Random(seed)
    feet = [[chance.gauss(1, 0.03) for _ in range(24)] for _ in range(2)]
    rows = []
    for i in range(round(rate * seconds)):
        at = i / rate
        left = MADE.foot(at, 0.3, feet[0]) + chance.gauss(0, 2)
        right = MADE.foot(at, 0.3 + 1 / MADE.STEPS_PER_S, feet[1]) + chance.gauss(0, 2)
        rows.append(f"{at:.4f},{times * left:.{digits}f},{times * right:.{digits}f}\n")
    return (head + "".join(rows)).encode()


def one_stance(rate=500, weight=700, more=""):
    """Recording of one stance without its stride, so that the reader asks for the clock."""
    rows = []
    for k in range(int(0.66 * rate)):
        u = k / rate / 0.65
        force = weight * (math.sin(math.pi * u) + 0.35 * math.sin(3 * math.pi * u)) if u < 1 else 0
        rows.append(f"{k / rate:.5f},{force:.4f}{more}\n")
    return ("time (s),Fz (N)\n" + "".join(rows)).encode()


SMALL = ("small walk.csv", walk())
LONG = ("long_walk.csv", walk(rate=1000.0))
# A character that is not UTF-8, so that a link treats the file as binary.
BINARY = ("binary.csv", b"# force plate \xb5\n" + walk(seed=3))
ASKS_CLOCK = ("one_stance.csv", one_stance())
LONG_ASKS_CLOCK = ("long_stance.csv", one_stance(rate=8000))
# The unit is missing. In newtons, the walker would have a mass of 14 kg.
ASKS_MASS = ("light.csv", walk(seed=5, times=0.2, head="time (s),Left Fz,Right Fz\n", digits=3))
