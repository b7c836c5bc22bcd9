"""Class 5: recordings of walkers with known mass, for the interval of the mass."""

import numpy as np

from formats import loadsol, plain
from recording import CLOCK, INSOLE, Recording, belts, case, options, walkway, with_sensor

EACH = 25
MASS = (r"mass|cross-talk|unloaded|one foot|between the feet", options("mass|force"))


def plates(trial, x):
    return plain(trial.t, x, [f"Plate {k + 1} Fz (N)" for k in range(len(x))])


@case("5 belts", EACH)
def interval_belts(rng, i):
    trial = belts(rng, rate=[100, 200, 500][i % 3], steps=int(rng.integers(10, 40)))
    return Recording({"walk.csv": plain(trial.t, with_sensor(rng, trial, noise=2, offset=8))}, trial.truth())


@case("5 insoles", EACH)
def interval_insoles(rng, i):
    trial = belts(rng, rate=100, steps=int(rng.integers(12, 40)))
    x = np.maximum(with_sensor(rng, trial, noise=1), 0)
    # Published errors of insoles compared with plates: gain errors of some percent.
    x *= 1 + rng.normal(0, 0.05, (2, 1))
    return Recording({"walk.txt": loadsol(trial.t, *x, zones=False, moving=False)}, trial.truth(), asks=[INSOLE])


@case("5 two single stances", EACH)
def interval_two_plates(rng, i):
    trial = walkway(rng, plates=2)
    return Recording({"walk.csv": plates(trial, with_sensor(rng, trial, noise=2, offset=8))}, trial.truth(), asks=[CLOCK, MASS])


@case("5 one plate, one foot", EACH)
def interval_one_plate(rng, i):
    trial = walkway(rng, plates=1, asymmetry=rng.normal(0, 0.03))
    return Recording({"walk.csv": plates(trial, with_sensor(rng, trial, noise=2, offset=8))}, trial.truth(), asks=[CLOCK, MASS])


@case("5 unequal feet", EACH)
def interval_unequal(rng, i):
    asymmetry = rng.choice([-1, 1]) * rng.uniform(0.05, 0.2)
    if i % 3 == 0:
        trial = belts(rng, asymmetry=asymmetry)
        x, counts = with_sensor(rng, trial, noise=2)[:1], trial.counts[:1]
        return Recording({"walk.csv": plain(trial.t, x, ["Fz (N)"])}, trial.truth(counts=counts), asks=[MASS])
    trial = belts(rng, asymmetry=asymmetry) if i % 3 == 1 else walkway(rng, plates=3, asymmetry=asymmetry)
    return Recording({"walk.csv": plates(trial, with_sensor(rng, trial, noise=2))}, trial.truth(), asks=[MASS])


@case("5 offsets and drift", EACH)
def interval_offsets(rng, i):
    trial = belts(rng, idle=i % 2 == 0) if i % 3 else walkway(rng, plates=3)
    x = with_sensor(rng, trial, noise=2, offset=60, drift=rng.uniform(-1, 1) if i % 4 == 0 else 0)
    return Recording({"walk.csv": plates(trial, x)}, trial.truth(), asks=[CLOCK, MASS])


@case("5 cross-talk", EACH)
def interval_crosstalk(rng, i):
    trial = belts(rng, idle=i % 2 == 0) if i % 3 else walkway(rng, plates=2 + i % 2)
    x = with_sensor(rng, trial, noise=2, cross=rng.uniform(0.01, 0.06))
    return Recording({"walk.csv": plates(trial, x)}, trial.truth(), asks=[CLOCK, MASS])


@case("5 noise and hum", EACH)
def interval_noise(rng, i):
    trial = belts(rng, rate=[200, 1000][i % 2], steps=16) if i % 3 else walkway(rng, plates=2)
    x = with_sensor(rng, trial, noise=rng.uniform(5, 15), hum=(rng.uniform(0, 12), [50.0, 60.0][i % 2]))
    return Recording({"walk.csv": plates(trial, x)}, trial.truth(), asks=[CLOCK, MASS])
