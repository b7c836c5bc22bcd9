"""Classes 3 and 4: MATLAB files, long tables, vectors, percent of the gait cycle, and a single stance with idle time."""

import numpy as np

from formats import cells, cut_rows, plain, table, vec3, with_bad_cell
from mat import mat
from recording import CLOCK, Recording, belts, case, options, walkway, with_sensor

MATLAB = (r"MATLAB|\.mat", "export|" + options("force|rate|time"))


@case("3 MATLAB", 10)
def matlab(rng, i):
    trial = belts(rng, rate=[200.0, 1000.0][i % 2], steps=16)
    t, (left, right) = trial.t, with_sensor(rng, trial, noise=1, offset=4)
    rate = 1 / t[1]
    zero = 0 * left
    content = [
        {"time": t, "Fz_left": left, "Fz_right": right},
        {"t": t, "Fz1": left, "Fz2": right},
        {"fs": rate, "Fz": np.stack([left, right], axis=1)},
        {"data": {"time": t, "Fz_left": left, "Fz_right": right}},
        {"data": {"rate": rate, "Fz1": left, "Fz2": right, "unit": "N"}},
        {"trial": {"info": {"mass": trial.walk.mass}, "force": {"rate": rate, "left": np.stack([zero, -0.1 * left, left], axis=1),
                                                                "right": np.stack([zero, -0.1 * right, right], axis=1)}}},
        {"time": t.astype(np.float32), "Fz_left": left.astype(np.float32), "Fz_right": right.astype(np.float32)},
        {"time": t[None, :], "GRF_left": left[None, :], "GRF_right": right[None, :]},
        {"subject": "S01", "rate": rate, "FP1": np.stack([zero, zero, left], axis=1), "FP2": np.stack([zero, zero, right], axis=1)},
        {"time": t, "Fz_left": left, "Fz_right": right, "note": "walk", "marker": np.zeros((4, 3))},
    ][i]
    return Recording({"walk.mat": mat(content, compressed=i % 2 == 1)}, trial.truth(), asks=[MATLAB])


@case("3 MATLAB", 4)
def matlab_damaged(rng, i):
    trial = belts(rng, rate=200, steps=16)
    left, right = with_sensor(rng, trial, noise=1)
    data = mat({"time": trial.t, "Fz_left": left, "Fz_right": right}, compressed=i == 1)
    if i < 2:
        return Recording({"walk.mat": data[: int(0.8 * len(data))]}, trial.truth(), asks=[MATLAB, (r"truncat|ends|cut", r"file|export")],
                         only_asks=i == 0)
    if i == 2:
        left[len(left) // 2] = np.nan
        data = mat({"time": trial.t, "Fz_left": left, "Fz_right": right})
        return Recording({"walk.mat": data}, trial.truth(), asks=[MATLAB], slack=1)
    data = mat({"time": trial.t[:-50], "Fz_left": left, "Fz_right": right})
    return Recording({"walk.mat": data}, trial.truth(), asks=[MATLAB], only_asks=True)


def cycle_of(rng, count=101, feet=1, **of_walk):
    """Cycles of one foot or both of steady walking, in percent of the stride: shape (cycles, feet, count); stride time and walk."""
    trial = belts(rng, steps=20, cv_time=0.0, **of_walk)
    w = trial.walk
    period = 2 * w.step_s
    cycles = []
    for k in range(2, 14, 2):
        t = w.stances[k].start + np.arange(count) / (count - 1) * period
        both = w.feet(t)
        foot = w.stances[k].foot
        cycles.append([both[foot], both[1 - foot]][:feet])
    return np.array(cycles), period, w


def mean_of(cycle, period):
    """True values of a cycle whose last value repeats the first."""
    return {"mean": float(0.5 * (cycle[:-1] + cycle[1:]).mean()), "period": (period, period)}


@case("3 percent of cycle", 8)
def percent_of_cycle(rng, i):
    feet = 2 if i >= 5 else 1
    cycles, period, _ = cycle_of(rng, feet=feet)
    mean = cycles.mean(axis=0)
    phase = [cells(np.arange(101), 0), cells(np.linspace(0, 100, 101), 2), cells(np.linspace(0, 1, 101), 2)][1 if i == 2 else 0]
    first = ["% of gait cycle", "% gait cycle", "Gait cycle (%)", "percent", "gait_cycle_percent", "% of gait cycle", "Percent Gait Cycle",
             "GC [%]"][i]
    names = ["Fz (N)"] if feet == 1 else ["Left Fz (N)", "Right Fz (N)"]
    data = table([first, *names], [phase, *(cells(f) for f in mean)])
    truth = mean_of(mean.sum(axis=0), period)
    asks = [(r"two|both|Left|columns", options("force|feet"))] if feet == 2 else []
    return Recording({"cycle.csv": data}, truth, ["--period", f"{period:.5f} s"], asks)


@case("3 percent of cycle", 2)
def percent_without_period(rng, i):
    cycles, period, _ = cycle_of(rng)
    data = table(["% of gait cycle", "Fz (N)"], [cells(np.arange(101), 0), cells(cycles.mean(axis=0)[0])])
    return Recording({"cycle.csv": data}, mean_of(cycles.mean(axis=0)[0], period), [], [(r"cycle|percent|%", options("period"))], only_asks=True)


@case("3 long table", 8)
def long_table(rng, i):
    cycles, period, w = cycle_of(rng, mass=rng.uniform(55, 90))
    percent = i % 2 == 1
    steps = range(len(cycles))
    subjects = ["AB01"] if i < 6 else ["AB01", "AB02"]
    scale = 1 / (w.mass * 9.81) if i in (2, 3) else 1.0
    name = "grf_vertical_BW" if i in (2, 3) else ["grf_vertical", "grf_vertical_N"][i % 2]
    lines = ["subject,task,step,phase," + name]
    for s in subjects:
        for k in steps:
            for p, f in zip(np.linspace(0, 100 if percent else 1, 101), cycles[k][0]):
                lines.append(f"{s},level,{k + 1},{p:.2f},{f * scale:.5f}")
    truth = mean_of(cycles.mean(axis=0)[0], period)
    args = ["--period", f"{period:.5f} s"] + (["--mass", f"{w.mass:.3f} kg"] if i in (2, 3) else [])
    data = ("\n".join(lines) + "\n").encode()
    if i == 4:
        data = cut_rows(data, len(lines) - 1, len(lines) - 31, 6)
        truth["mean_error"] = 0.03
        return Recording({"long.csv": data}, truth, args, asks=[(r"rows|cycle|step", r"complete|line \d+")], says=r"step|rows|cycle")
    if i == 5:
        data = with_bad_cell(data, len(lines) - 1, 130, 4, ",", "abc")
        return Recording({"long.csv": data}, truth, args, asks=[(r"line \d+", r"number|abc")])
    return Recording({"long.csv": data}, truth, args)


@case("3 long table", 3)
def long_table_questions(rng, i):
    cycles, period, w = cycle_of(rng)
    lines = ["subject,task,step,phase,grf_vertical"]
    for task in ["level", "incline"][: 1 + (i == 0)]:
        for k in range(len(cycles)):
            lines += [f"AB01,{task},{k + 1},{p:.2f},{f:.3f}" for p, f in zip(np.linspace(0, 1, 101), cycles[k][0])]
    args = ["--period", f"{period:.5f} s"] if i != 1 else []
    truth = mean_of(cycles.mean(axis=0)[0], period)
    if i == 2:
        lines[0] = "subject,task,step,phase,grf_ap"
    asks = [[(r"incline", r"task")], [(r"cycle", options("period"))], [(r"vertical|force", options("force"))]][i]
    return Recording({"long.csv": ("\n".join(lines) + "\n").encode()}, truth, args, asks, only_asks=True)


@case("3 vectors", 6)
def sto_vectors(rng, i):
    trial = belts(rng, rate=[100, 500][i % 2], steps=16, first=1)
    x = with_sensor(rng, trial, noise=1)[::-1]
    truth = trial.truth(counts=trial.counts[::-1])
    asks = [(r"Vec3|vector", "export|" + options("force"))]
    if i < 4:
        return Recording({"walk.sto": vec3(trial.t, x)}, truth, asks=asks)
    if i == 4:
        return Recording({"walk.sto": vec3(trial.t, x, rows=len(trial.t) + 55)}, truth, asks=asks, says=r"rows")
    end = trial.walk.middle(11) - trial.start
    truth = trial.until(end)
    truth["counts"] = truth["counts"][::-1]
    return Recording({"walk.sto": cut_rows(vec3(trial.t, x), len(trial.t), int(end * 500), 14)}, truth, asks=asks)


@case("4 one stance", 8)
def one_stance_span(rng, i):
    rate = [1000, 200][i % 2]
    trial = walkway(rng, rate=rate, plates=1)
    idle = np.zeros(int(rate * rng.uniform(0, 2)))
    force = np.concatenate([idle, trial.forces[0]])
    x = force + rng.normal(0, rng.uniform(2, 15), len(force)) + (rng.uniform(-20, 20) if i >= 4 else 0)
    s = trial.walk.stances[0]
    period = 2 * trial.walk.step_s
    span = 360 * (s.end - s.start) / period
    data = plain(np.arange(len(x)) / rate, [x], ["Fz (N)"])
    mean = float(trial.forces[0].sum() / rate / period)
    truth = {"mean": mean, "mean_error": 0.015, "period": (period * 0.985, period * 1.015)}
    args = ["--span", f"{span:.3f} deg"] + (["--period", f"{period:.5f} s"] if i % 4 >= 2 else [])
    return Recording({"stance.csv": data}, truth, args, asks=[(r"stance|unloaded|contact", options("span|period"))])


@case("4 one stance", 8)
def one_stance(rng, i):
    rate = [1000, 200][i % 2]
    trial = walkway(rng, rate=rate, plates=1)
    x = trial.forces + rng.normal(0, rng.uniform(2, 15), len(trial.t)) + (rng.uniform(-20, 20) if i >= 4 else 0)
    data = plain(trial.t, x, ["Fz (N)"])
    truth = trial.truth()
    args = ["--mass", f"{trial.walk.mass:.2f} kg"] if i % 4 >= 2 else []
    if args:
        own = 2 * trial.walk.step_s
        truth["period"] = (own * (1 - 3 * trial.walk.cv_impulse - 0.01), own * (1 + 3 * trial.walk.cv_impulse + 0.01))
    return Recording({"stance.csv": data}, truth, args, asks=[CLOCK])
