"""Class 1: known layouts with disturbed or incomplete readings."""

import numpy as np

from c3d import c3d
from formats import cells, cut_rows, loadsol, opensim, plain, table, visual3d, with_bad_cell, without
from recording import CLOCK, INSOLE, Recording, belts, case, options, walkway, with_sensor

CROSS = (r"cross-talk|unloaded", options("mass|force|file"))
FEET = (r"one foot|other foot|feet (may |that )?differ|between the feet|single stance", options("mass|force"))


@case("1 unloaded blank", 8)
def blank_csv(rng, i):
    token = ["", "NaN", "NA", "-"][i % 4]
    trial = belts(rng, rate=[1000, 200][i // 4], idle=i % 2 == 0)
    x = with_sensor(rng, trial, noise=1)
    columns = [cells(trial.t, 3), *without([cells(f) for f in x], x, token)]
    data = table(["time (s)", "Left Fz (N)", "Right Fz (N)"], columns)
    return Recording({"walk.csv": data}, trial.truth(level=0.0))


@case("1 unloaded blank", 4)
def blank_opensim(rng, i):
    trial = belts(rng, rate=[200, 1000][i % 2], idle=i >= 2, first=1)
    x = with_sensor(rng, trial, noise=1)[::-1]
    truth = trial.truth(counts=trial.counts[::-1], level=0.0)
    return Recording({"walk.mot": opensim(trial.t, x, ["NaN", "nan"][i % 2])}, truth)


@case("1 unloaded blank", 4)
def blank_visual3d(rng, i):
    trial = belts(rng, rate=200, idle=i % 2 == 0)
    x = with_sensor(rng, trial, noise=1)
    data = visual3d(x, ["", "", "NaN", "-"][i])
    return Recording({"walk.txt": data}, trial.truth(level=0.0), ["--rate", "200 Hz"])


@case("1 unloaded blank", 3)
def blank_walkway(rng, i):
    trial = walkway(rng, plates=2)
    x = with_sensor(rng, trial, noise=1)
    columns = [cells(trial.t, 3), *without([cells(f) for f in x], x, ["", "NaN", "NA"][i])]
    data = table(["time (s)", "Plate 1 Fz (N)", "Plate 2 Fz (N)"], columns)
    return Recording({"walk.csv": data}, trial.truth(level=0.0))


@case("1 c3d > 255 channels", 6)
def c3d_wide(rng, i):
    trial = belts(rng, rate=1000, steps=14)
    x = with_sensor(rng, trial, noise=2, offset=8)
    kind, storage = [2, 1, 2, 3, 4, 2][i], ["float", "int"][i % 2]
    data = c3d(x, 1000, kind, storage, before=[263, 250, 255, 252, 300, 520][i], other=3, scale_pick=0.5)
    return Recording({"walk.c3d": data}, trial.truth())


@case("1 loadsol", 6)
def loadsol_zones(rng, i):
    trial = belts(rng, rate=[100, 200][i % 2], idle=i % 3 == 0)
    x = np.maximum(with_sensor(rng, trial, noise=0.5), 0)
    return Recording({"walk.txt": loadsol(trial.t, *x, moving=i < 3)}, trial.truth(), asks=[INSOLE])


@case("1 loadsol", 2)
def loadsol_damaged(rng, i):
    trial = belts(rng, rate=100, steps=20)
    x = np.maximum(with_sensor(rng, trial, noise=0.5), 0)
    data, n = loadsol(trial.t, *x), len(trial.t)
    if i:
        data = with_bad_cell(data, n, n // 2, 4, "\t", "x")
        return Recording({"walk.txt": data}, trial.truth(), asks=[INSOLE], slack=1)
    end = trial.walk.middle(12) - trial.start
    data = cut_rows(data, n, int(end * 100), 11)
    return Recording({"walk.txt": data}, trial.until(end), asks=[INSOLE])


@case("1 cross-talk", 10)
def crosstalk(rng, i):
    share = 0.03 + 0.05 * (i % 5) / 4
    if i < 5:
        trial = belts(rng, rate=200, idle=i % 2 == 0)
    else:
        trial = walkway(rng, plates=2 + i % 2)
    x = with_sensor(rng, trial, noise=1, cross=share)
    names = [f"Plate {k + 1} Fz (N)" for k in range(len(x))]
    return Recording({"walk.csv": plain(trial.t, x, names)}, trial.truth(level=0.0), asks=[CROSS])


@case("1 hum", 8)
def hum(rng, i):
    trial = belts(rng, rate=[200, 1000][i % 2], idle=i < 4)
    x = with_sensor(rng, trial, noise=1, hum=(rng.uniform(10, 20), [50.0, 60.0][i // 2 % 2]))
    return Recording({"walk.csv": plain(trial.t, x)}, trial.truth(level=0.0))


@case("1 spikes", 8)
def spikes(rng, i):
    trial = belts(rng, rate=1000, steps=16) if i < 6 else belts(rng, rate=200, steps=20)
    x = with_sensor(rng, trial, noise=2)
    # Several single samples, or one sequence of samples.
    count, width = [(1, 1), (3, 1), (6, 1), (2, 2), (1, 4), (1, 6), (3, 1), (6, 1)][i]
    for at in rng.choice(len(trial.t) - 20, count, replace=False):
        x[rng.integers(2), at : at + width] += rng.uniform(2000, 5000) * rng.choice([1, 1, -1])
    asks = [(r"spike|outlier|single sample|peak", options("mass|force|file"))]
    return Recording({"walk.csv": plain(trial.t, x)}, trial.truth(), asks=asks, slack=2 * count)


@case("1 unequal feet", 5)
def unequal_one_belt(rng, i):
    trial = belts(rng, asymmetry=[-1, 1][i % 2] * rng.uniform(0.05, 0.2))
    x = with_sensor(rng, trial, noise=2)[:1]
    data = plain(trial.t, x, ["Fz (N)"])
    return Recording({"walk.csv": data}, trial.truth(counts=trial.counts[:1]), asks=[FEET])


@case("1 unequal feet", 5)
def unequal_few(rng, i):
    plates = [2, 3, 3, 4, 5][i]
    trial = walkway(rng, plates=plates, asymmetry=[-1, 1][i % 2] * rng.uniform(0.05, 0.2))
    x = with_sensor(rng, trial, noise=2, offset=5)
    return Recording({"walk.c3d": c3d(x, 1000, 2, "float")}, trial.truth(), asks=[FEET])


@case("1 unequal feet", 4)
def unequal_one_plate(rng, i):
    trial = walkway(rng, plates=1, asymmetry=[-1, 1][i % 2] * rng.uniform(0.05, 0.2))
    x = with_sensor(rng, trial, noise=2)
    return Recording({"walk.csv": plain(trial.t, x, ["Fz (N)"])}, trial.truth(), asks=[CLOCK, FEET])


@case("1 unequal feet", 3)
def unequal_both_belts(rng, i):
    trial = belts(rng, asymmetry=[-1, 1, 1][i] * rng.uniform(0.05, 0.2))
    x = with_sensor(rng, trial, noise=2)
    return Recording({"walk.csv": plain(trial.t, x)}, trial.truth(), asks=[FEET])
