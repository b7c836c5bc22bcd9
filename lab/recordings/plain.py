"""Class 0: clean recordings in many formats, and damaged copies of their files."""

import numpy as np

from c3d import c3d
from formats import cells, cut_rows, loadsol, opensim, plain, stances, table, visual3d, with_bad_cell
from recording import CLOCK, INSOLE, Recording, belts, case, walkway, with_sensor

DIALECTS = [
    dict(separator=","), dict(separator="\t"), dict(separator="|"), dict(separator=";", end="\r\n"),
    dict(separator=",", head=["# subject: 7", "# device: A"]), dict(separator=",", encoding="utf-16"),
]


@case("0 plain", 6)
def csv_dialects(rng, i):
    trial = belts(rng, rate=[100, 200, 500][i % 3])
    return Recording({"walk.csv": plain(trial.t, with_sensor(rng, trial, noise=2, offset=15), **DIALECTS[i])}, trial.truth())


@case("0 plain", 3)
def decimal_comma(rng, i):
    trial = belts(rng)
    names = [["Zeit [s]", "Links Fz [N]", "Rechts Fz [N]"], ["Temps (s)", "Gauche Fz (N)", "Droite Fz (N)"],
             ["Tiempo (s)", "Izquierda Fz (N)", "Derecha Fz (N)"]][i]
    x = with_sensor(rng, trial, noise=2)
    columns = [cells(trial.t, 3, ","), *(cells(f, 2, ",") for f in x)]
    return Recording({"walk.csv": table(names, columns, ";", encoding="latin-1")}, trial.truth())


@case("0 plain", 4)
def opensim_motion(rng, i):
    trial = belts(rng, rate=[200, 1000][i % 2], idle=i >= 2, first=1)
    right_left = with_sensor(rng, trial, noise=1)[::-1]
    return Recording({"walk.mot": opensim(trial.t, right_left)}, trial.truth(counts=trial.counts[::-1]))


@case("0 plain", 8)
def c3d_types(rng, i):
    kind, storage = 1 + i % 4, "float" if i < 4 else "int"
    trial = belts(rng, rate=1000)
    x = with_sensor(rng, trial, noise=3, offset=12)
    return Recording({"walk.c3d": c3d(x, 1000, kind, storage, before=i % 3)}, trial.truth())


@case("0 plain", 2)
def c3d_walkway(rng, i):
    trial = walkway(rng, plates=2 + i)
    x = with_sensor(rng, trial, noise=2, offset=10)
    return Recording({"walk.c3d": c3d(x, 1000, 2, ("float", "int")[i])}, trial.truth())


@case("0 plain", 2)
def visual3d_text(rng, i):
    trial = belts(rng, idle=True)
    x = -with_sensor(rng, trial, noise=1) if i else with_sensor(rng, trial, noise=1)
    return Recording({"walk.txt": visual3d(x, None)}, trial.truth(), ["--rate", "200 Hz"])


@case("0 plain", 2)
def loadsol_totals(rng, i):
    trial = belts(rng, rate=[100, 200][i], idle=True)
    x = np.maximum(with_sensor(rng, trial, noise=1), 0)
    return Recording({"walk.txt": loadsol(trial.t, *x, zones=False)}, trial.truth(), asks=[INSOLE])


@case("0 plain", 2)
def stance_rows(rng, i):
    trial = belts(rng, rate=1000, steps=24)
    w = trial.walk
    rows = [s.force(np.arange(s.start, s.end, 0.001)) for s in w.stances[2:22:2]]
    files = {"GRF_F_V_RAW_left.csv": stances(rows)}
    if i:
        files["GRF_metadata.csv"] = f"SUBJECT_ID,SESSION_ID,BODY_WEIGHT\n12,34,{9.81 * w.mass:.1f}\n".encode()
    truth = trial.truth(counts=[len(rows)])
    return Recording(files, truth, ["--rate", "1000 Hz"], asks=[CLOCK])


@case("0 damaged", 4)
def truncated_text(rng, i):
    trial = belts(rng, rate=[200, 1000][i % 2], first=1)
    keep = int(len(trial.t) * 0.6)
    w = trial.walk
    k = next(k for k in range(len(w.stances)) if w.middle(k) - trial.start > trial.t[keep])
    keep = int((w.middle(k) - trial.start) * (len(trial.t) / trial.t[-1]))
    x = with_sensor(rng, trial, noise=1, offset=5)
    truth = trial.until(trial.t[keep])
    if i < 2:
        return Recording({"walk.csv": cut_rows(plain(trial.t, x), len(trial.t), keep)}, truth)
    truth["counts"] = truth["counts"][::-1]
    data = cut_rows(opensim(trial.t, x[::-1]), len(trial.t), keep)
    return Recording({"walk.mot": data}, truth, says=r"rows|truncat|announce")


@case("0 damaged", 8)
def bad_cell(rng, i):
    trial = belts(rng)
    x = with_sensor(rng, trial, noise=1)
    text = ["#REF!", "abc", "1.2.3", "1e30", "--", "99999999", "12:30", "-1e9"][i]
    row = len(trial.t) // 2
    names = dict(names=("Fz left (N)", "Fz right (N)"))
    data = with_bad_cell(plain(trial.t, x, **names), len(trial.t), row, 1 + i % 2, ",", text)
    return Recording({"walk.csv": data}, trial.truth(), asks=[(r"line \d+|row", r"number|cell|column")], slack=1)


@case("0 damaged", 3)
def bad_time(rng, i):
    trial = belts(rng)
    x = with_sensor(rng, trial, noise=1)
    text = ["abc", "", "0.000"][i]
    data = with_bad_cell(plain(trial.t, x), len(trial.t), len(trial.t) // 2, 0, ",", text)
    return Recording({"walk.csv": data}, trial.truth(), asks=[(r"line \d+", r"time|clock")], slack=2)


@case("0 damaged", 3)
def wrong_count(rng, i):
    trial = belts(rng, first=1)
    x = with_sensor(rng, trial, noise=1)[::-1]
    data = opensim(trial.t, x, rows=len(trial.t) + [37, -80, 100000][i])
    return Recording({"walk.mot": data}, trial.truth(counts=trial.counts[::-1]), says=r"rows")


@case("0 damaged", 4)
def truncated_c3d(rng, i):
    trial = belts(rng, rate=1000)
    frames = len(trial.t) // 10
    w = trial.walk
    end = w.middle(13) - trial.start
    x = with_sensor(rng, trial, noise=1)
    data = c3d(x, 1000, 2, ("float", "int")[i % 2])
    head = data[16] + 256 * data[17]
    size = (len(data) - 512 * (head - 1)) // frames
    data = data[: 512 * (head - 1) + size * int(end * 100) + (7 if i >= 2 else 0)]
    return Recording({"walk.c3d": data}, trial.until(end), asks=[(r"frames|truncat", r"export|complete|file")], says=r"frames")


@case("0 damaged", 2)
def wrong_frames(rng, i):
    trial = belts(rng, rate=1000)
    frames = len(trial.t) // 10
    data = c3d(with_sensor(rng, trial, noise=1), 1000, 2, ("float", "int")[i], frames_said=frames + 400)
    return Recording({"walk.c3d": data}, trial.truth(), asks=[(r"frames|truncat", r"export|complete|file")], says=r"frames")
