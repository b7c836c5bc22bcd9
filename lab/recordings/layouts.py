"""Class 2: other movements, lost samples, and layouts with more than the vertical forces."""

import numpy as np

from c3d import c3d
from formats import cells, plain, stances, table, visual3d
from recording import Recording, belts, case, options, with_sensor


def landing_force(rng, t, mass, hop):
    """Landing of one leg from a box. The person then stands or hops off at once; a hop gives a second peak, as in walking."""
    length = rng.uniform(0.5, 0.7) if hop else rng.uniform(0.7, 1.3)
    s = np.clip((t - 0.8) / length, 0, 1)
    if hop:
        nodes = [0, rng.uniform(0.10, 0.14), 0.2, 0.5, 0.72, 0.9, 1]
        levels = [0, rng.uniform(1.7, 2.1), 1.6, 1.5, rng.uniform(1.7, 1.9), 0.9, 0]
        rough = np.interp(s, nodes, levels)
        width = int(0.03 * len(t) / t[-1])
        return np.convolve(rough, np.ones(width) / width, mode="same") * mass * 9.81
    peak, at = rng.uniform(2.4, 4.0), rng.uniform(0.06, 0.12)
    rise = peak * np.sin(np.clip(s / at, 0, 2) * np.pi / 2) ** 2
    rest = (1.15 + 0.25 * np.sin(2 * np.pi * (s - at) * 2)) * np.clip((s - at) / at, 0, 1) * np.clip((1 - s) / 0.15, 0, 1) ** 0.7
    return np.where((s > 0) & (s < 1), rise + rest, 0) * mass * 9.81


@case("2 landing", 6)
def landing_one_leg(rng, i):
    t = np.arange(3000) / 1000
    mass = rng.uniform(50, 90)
    f = landing_force(rng, t, mass, i >= 3) + rng.normal(0, 1, len(t))
    asks = [(r"jump|land|leave the ground", options("kind|period"))]
    return Recording({"trial.csv": plain(t, [f], ["Fz (N)"])}, {"mass": mass, "kind": "jumping"}, asks=asks, only_asks=True)


@case("2 drop-outs", 8)
def drop_outs(rng, i):
    rate = [200, 100][i % 2]
    trial = belts(rng, rate=rate, steps=50, idle=i < 4)
    x = with_sensor(rng, trial, noise=0)
    gap = int(0.055 * rate + 0.5)
    hit = set()
    w = trial.walk
    for _ in range([3, 8, 15, 25][i // 2 % 4]):
        k, at = rng.integers(2), rng.integers(10, len(trial.t) - gap - 10)
        x[k, at : at + gap] = 0
        a, b = trial.start + trial.t[at], trial.start + trial.t[at + gap]
        hit |= {j for j, s in enumerate(w.stances) if s.foot == k and s.start < b and s.end > a}
    # The median of fewer strides is less accurate.
    truth = trial.truth(period_error=0.005 + 2 * w.cv_time / np.sqrt(sum(trial.counts) - len(hit)))
    asks = [(r"lost|zero|missing|drop", options("file|mass|force") + "|give (a|another) recording")]
    return Recording({"walk.csv": plain(trial.t, x)}, truth, asks=asks, says=r"lost|drop|missing|zero", slack=len(hit))


def smooth(x, width):
    return np.array([np.convolve(f, np.ones(width) / width, mode="same") for f in x])


@case("2 columns twice", 8)
def columns_twice(rng, i):
    trial = belts(rng, rate=[200, 1000][i % 2], idle=i < 4)
    x = with_sensor(rng, trial, noise=3)
    y = [x, smooth(x, 3), smooth(x, 5 if i % 2 == 0 else 15), 0.5 * (x + smooth(x, 5))][i // 2]
    names = [["Fz1 (N)", "Fz2 (N)", "Fz1 filtered (N)", "Fz2 filtered (N)"], ["Left Fz", "Right Fz", "Left Fz filt", "Right Fz filt"],
             ["FP1_Fz", "FP2_Fz", "FP1_Fz_lp", "FP2_Fz_lp"], ["Fz1 raw", "Fz2 raw", "Fz1", "Fz2"]][(i + i // 4) % 4]
    return Recording({"walk.csv": plain(trial.t, [*x, *y], names)}, trial.truth())


@case("2 components", 6)
def component_rows(rng, i):
    trial = belts(rng, rate=1000, steps=16)
    rows = [s.force(np.arange(s.start, s.end, 0.001)) for s in trial.walk.stances[2:14:2]]
    name = ["F_AP_RAW", "F_ML_RAW", "COP_AP_RAW", "COP_ML_RAW", "F_AP_PRO", "COP_AP_PRO"][i]
    data = stances([r * [0.15, 0.06, 0.0002, 0.0001, 0.15, 0.0002][i] * np.cos(np.linspace(0, 3, len(r))) for r in rows], name)
    asks = [(r"vertical|component|AP|ML|COP", options("force") + "|F_V")]
    return Recording({f"GRF_{name}_left.csv": data}, {"mass": trial.walk.mass, "kind": "walking"}, ["--rate", "1000 Hz"], asks,
                     only_asks=True)


@case("2 components", 3)
def component_columns(rng, i):
    trial = belts(rng)
    x = with_sensor(rng, trial, noise=1)
    names, columns = ["time"], [cells(trial.t, 3)]
    for side, f in zip("LR", x):
        for part, scale in [("ml", 0.05), ("ap", 0.18), ("v", 1.0), ("copx", 0.2), ("copy", 0.1)]:
            g = f * scale if part == "v" else f * scale * np.sin(9 * trial.t)
            names.append([f"{side}_{part}GRF", f"GRF_{part.upper()}_{side}", f"{side}GRF_{part}"][i])
            columns.append(cells(g, 3))
    return Recording({"walk.csv": table(names, columns)}, trial.truth())


@case("2 counters and names", 3)
def numeric_names(rng, i):
    trial = belts(rng)
    x = with_sensor(rng, trial, noise=1)
    names = [["time[secs]", "1", "2"], ["time", "0", "1"], ["t (s)", "101", "102"]][i]
    data = table(names, [cells(trial.t, 3), *(cells(f) for f in x)], "\t")
    args = ["--force", "2", "--force", "3"] if i == 0 else []
    return Recording({"walk.txt": data}, trial.truth(), args, asks=[(r"columns? (are|is)|name", options("force"))])


@case("2 counters and names", 6)
def counters(rng, i):
    trial = belts(rng, rate=200, idle=i % 2 == 0)
    x = with_sensor(rng, trial, noise=1)
    n = len(trial.t)
    count = [str(k + 1) for k in range(n)]
    sub = [str(k % 10) for k in range(n)]
    if i == 4:
        return Recording({"walk.txt": visual3d(x, "")}, trial.truth(), ["--rate", "200 Hz"])
    first = [["Frame"], ["Frame", "Sub Frame"], ["Sample #"], ["ITEM"], [], ["No."]][i]
    columns = [count, sub][: len(first)]
    data = table([*first, "Fz1 (N)", "Fz2 (N)"], [*columns, *(cells(f) for f in x)])
    return Recording({"walk.csv": data}, trial.truth(), ["--rate", "200 Hz"])


@case("2 thousands", 8)
def thousands(rng, i):
    trial = belts(rng, rate=200, idle=True, mass=rng.uniform(98, 120))
    x = with_sensor(rng, trial, noise=1)
    separator, mark, group, quote = [
        (",", ".", ",", '"'), ("\t", ".", ",", ""), (";", ",", ".", ""), ("\t", ",", ".", ""),
        (";", ".", "'", ""), (",", ".", "'", ""), (";", ".", "\u2019", ""), (";", ",", "\u202f", "")][i]
    columns = [cells(trial.t, 3, mark), *([quote + c + quote for c in cells(f, 2, mark, group)] for f in x)]
    return Recording({"walk.csv": table(["time (s)", "Left Fz (N)", "Right Fz (N)"], columns, separator)}, trial.truth())


@case("2 minus signs", 4)
def unicode_minus(rng, i):
    trial = belts(rng, rate=200, idle=i % 2 == 0)
    x = with_sensor(rng, trial, noise=1, sign=-1.0)
    mark, separator = [(".", ","), (",", ";")][i // 2]
    columns = [cells(trial.t, 3, mark), *(cells(f, 2, mark, minus="\u2212") for f in x)]
    return Recording({"walk.csv": table(["time (s)", "Left Fz (N)", "Right Fz (N)"], columns, separator)}, trial.truth())


@case("2 N/kg under N", 4)
def per_mass(rng, i):
    trial = belts(rng, rate=200)
    x = with_sensor(rng, trial, noise=1) / trial.walk.mass
    data = table(["time [s]", "Left Fz [N]", "Right Fz [N]"], [cells(trial.t, 3), *(cells(f, 4) for f in x)])
    asks = [(r"N/kg", options("unit"))]
    if i < 2:
        return Recording({"walk.csv": data}, trial.truth(), asks=asks, only_asks=True)
    args = ["--unit", "N/kg", "--mass", f"{trial.walk.mass:.3f} kg"]
    return Recording({"walk.csv": data}, trial.truth(), args if i == 2 else args[:2], asks=[(r"N/kg|mass", options("mass"))])


@case("2 type 4 without matrix", 3)
def type4_uncalibrated(rng, i):
    trial = belts(rng, rate=1000, steps=12)
    data = c3d(with_sensor(rng, trial, noise=2), 1000, 4, ["float", "int", "float"][i], calibrated=False)
    args = ["--mass", f"{trial.walk.mass:.1f} kg"] if i == 2 else []
    asks = [(r"CAL_MATRIX|calibration", "export|" + options("force"))]
    return Recording({"walk.c3d": data}, trial.truth(), args, asks, only_asks=True)


@case("2 pressures", 4)
def pedar_pressures(rng, i):
    trial = belts(rng, rate=50, steps=16)
    x = with_sensor(rng, trial, noise=0)
    shares = rng.dirichlet(np.ones(99), 2)
    columns = [cells(trial.t, 3)]
    for share, f in zip(shares, x):
        columns += [cells(f * p / 0.15, 1) for p in share]
    head = ["file name: walk01.sol\tdate/time: 01.01.24 10:00", "sensor type: pedar-x insoles\tinsole: X",
            "total time [secs]: 10.06\ttime per sample [secs]: 0.0200\tscanning rate [Hz]: 50.00", "", "pressure values in kPa"]
    data = table(["time[secs]", *(str(k + 1) for k in range(198))], columns, "\t", head if i < 3 else ())
    args = ["--force", "40"] if i == 1 else []
    asks = [(r"pressure|sensor|kPa", "export|" + options("force"))]
    if i >= 2:
        asks.append((r"columns|names", options("force")))
    return Recording({"walk.asc": data}, trial.truth(), args, asks, only_asks=True)


@case("2 insole beside plate", 5)
def insole_and_plate(rng, i):
    trial = belts(rng, rate=200, idle=i % 2 == 0)
    x = with_sensor(rng, trial, noise=2, offset=6)
    y = np.maximum(trial.forces * rng.uniform(1.08, 1.25), 0) + 0.0
    plate, insole = [(["Plate 1 Fz (N)", "Plate 2 Fz (N)"], ["Insole left (N)", "Insole right (N)"]),
                     (["FP1 Fz", "FP2 Fz"], ["left insole force [N]", "right insole force [N]"]),
                     (["Fz1 (N)", "Fz2 (N)"], ["pedar left force (N)", "pedar right force (N)"]),
                     (["Fz plate left (N)", "Fz plate right (N)"], ["Fz insole left (N)", "Fz insole right (N)"]),
                     (["Force plate 1 Fz (N)", "Force plate 2 Fz (N)"], ["L total force[N]", "R total force[N]"])][i]
    names, columns = ([*plate, *insole], [*x, *y]) if i % 2 == 0 else ([*insole, *plate], [*y, *x])
    data = plain(trial.t, columns, names)
    asks = [(r"insole|pedar|total", options("force|mass"))]
    return Recording({"walk.csv": data}, trial.truth(), asks=asks, says=r"(?i)insole|pedar|total force")


@case("2 late clock", 6)
def late_clock(rng, i):
    trial = belts(rng, rate=[200, 100][i % 2])
    x = with_sensor(rng, trial, noise=1)
    start = [1700000000.0, 534.13, 1.7e12, 86399.5, 1.7e9, 45000.25][i]
    if i == 2:
        return Recording({"walk.csv": table(["time (ms)", "Left Fz (N)", "Right Fz (N)"],
                          [cells(start + 1000 * trial.t, 0), *(cells(f) for f in x)])}, trial.truth())
    places = [3, 4, 0, 3, 6, 3][i]
    names = ["time (s)", "timestamp", "", "time", "unix time [s]", "Time"]
    data = table([names[i], "Left Fz (N)", "Right Fz (N)"], [cells(start + trial.t, places), *(cells(f) for f in x)])
    return Recording({"walk.csv": data}, trial.truth())
