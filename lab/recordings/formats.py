"""Writers of text formats. Each returns bytes; forces are in N with one row per channel, unless stated otherwise."""

import numpy as np


def cells(values, decimals=2, mark=".", group="", minus="-"):
    """Numbers as text with the given decimal mark, thousands separator and minus sign."""
    if mark == "." and not group and minus == "-":
        return [f"{x:.{decimals}f}" for x in values]
    out = []
    for x in values:
        text = f"{x:,.{decimals}f}" if group else f"{x:.{decimals}f}"
        text = text.replace(",", "\0").replace(".", mark).replace("\0", group)
        out.append(text.replace("-", minus))
    return out


def table(names, columns, separator=",", head=(), units=None, end="\n", encoding="utf-8"):
    """Table with head lines, names, optional units, and one row per sample."""
    lines = [*head, *([separator.join(names)] if names else []), *([separator.join(units)] if units else [])]
    lines += [separator.join(row) for row in zip(*columns)]
    return (end.join(lines) + end).encode(encoding)


def plain(t, forces, names=("Left Fz (N)", "Right Fz (N)"), time="time (s)", **how):
    """Table of time and forces with a header."""
    places = 3 if len(t) < 2 or t[1] - t[0] >= 0.001 else 4
    return table([time, *names], [cells(t, places), *(cells(f) for f in forces)], **how)


def without(columns, forces, token, level=20.0):
    """Table in which cells below a level are replaced by a token for a missing value."""
    return [[token if f < level else c for c, f in zip(col, row)] for col, row in zip(columns, forces)]


def opensim(t, forces, token=None, rows=None, feet=("r", "l")):
    """OpenSim storage with the components and points of each foot; forces right then left."""
    names, columns = ["time"], [cells(t, 4)]
    zero = ["0.000000"] * len(t)
    for foot, f in zip(feet, forces):
        names += [f"ground_force_{foot}_{c}" for c in ("vx", "vy", "vz", "px", "py", "pz")]
        shear, vertical = cells(-0.05 * f, 6), cells(f, 6)
        if token is not None:
            shear, vertical = without([shear, vertical], [f, f], token)
        columns += [shear, vertical, zero, cells(0.1 + 0 * f, 6), zero, zero]
    count = len(t) if rows is None else rows
    head = ["walk", "version=1", f"nRows={count}", f"nColumns={len(names)}", "inDegrees=yes", "endheader"]
    return table(names, columns, "\t", head)


def vec3(t, forces, rows=None):
    """OpenSim storage of vectors: three components in one field."""
    columns = [cells(t, 4)]
    for f in forces:
        columns.append([f"{-0.05 * x:.4f},{x:.4f},{0.02 * x:.4f}" for x in f])
        columns.append(["0.1,0,0.2"] * len(t))
    names = ["time", "ground_force_r", "ground_point_r", "ground_force_l", "ground_point_l"]
    head = ["walk", "DataRate=" + f"{1 / (t[1] - t[0]):.6f}", "DataType=Vec3", "version=3", "OpenSimVersion=4.5", "endheader"]
    if rows is not None:
        head.insert(1, f"nRows={rows}")
    return table(names, columns, "\t", head)


def visual3d(forces, token="", level=20.0):
    """Visual3D export with five header rows and a counter. Cells without load are empty."""
    n = len(forces)
    row = lambda word: "\t" + "\t".join([word] * (3 * n))
    head = [row("C:\\data\\walk01.c3d"), "\t" + "\t".join(f"FP{k + 1}" for k in range(n) for _ in range(3)), row("FORCE"),
            row("PROCESSED"), "ITEM\t" + "\t".join(["X", "Y", "Z"] * n)]
    columns = [[str(i + 1) for i in range(len(forces[0]))]]
    for f in forces:
        three = [cells(0.03 * f, 5), cells(-0.1 * f, 5), cells(f, 5)]
        columns += three if token is None else without(three, [f] * 3, token, level)
    return table([], columns, "\t", head)


def loadsol(t, left, right, zones=True, moving=True):
    """Export of the loadsol app: two header rows, zones beside totals, a separate time for each insole."""
    names, units, columns = [], [], []
    for name, force in (("AB1-L", left), ("AB1-R", right)):
        share = 0.5 + 0.4 * np.cos(np.linspace(0, 3, len(t)))
        parts = {"heel": 0.6 * share, "medial": 1 - share, "lateral": 0.4 * share} if zones else {}
        if not names:
            names.append("")
            units.append("Time[secs]")
            columns.append(cells(t, 3))
        else:
            names.append("")
            units.append("Time[secs]")
            columns.append(cells(t, 3))
        names += [f"{name}::{zone}" for zone in parts] + [name]
        units += ["Force[N]"] * (len(parts) + 1)
        columns += [cells(p * force, 3) for p in parts.values()] + [cells(force, 3)]
        if moving:
            names += ["", *(f"{name}::{axis}" for axis in ("xAcc", "yAcc", "zAcc"))]
            units += ["Time[secs]", "[g]", "[g]", "[g]"]
            columns += [cells(t, 3), *(cells(np.sin((k + 3) * t), 3) for k in range(3))]
    head = ["loadapp_2024_01_01_10_00_00_000.loadflux", "comment trial"]
    return table(names, columns, "\t", head, units=units)


def stances(rows, component="F_V_RAW", scale=1.0):
    """One stance per row, ragged, with numbered columns."""
    most = max(len(r) for r in rows)
    lines = ["SUBJECT_ID,SESSION_ID,TRIAL_ID," + ",".join(f"{component}_{k + 1}" for k in range(most))]
    for k, r in enumerate(rows):
        lines.append(f"12,34,{k + 1}," + ",".join(cells(scale * r, 4) + [""] * (most - len(r))))
    return ("\n".join(lines) + "\n").encode()


def cut_rows(data, rows, keep, extra=4):
    """The file truncated at a random row of its last `rows`, with some bytes of the next row."""
    at = len(data)
    for _ in range(rows - keep + 1):
        at = data.rfind(b"\n", 0, at)
    return data[: at + 1 + extra]


def with_bad_cell(data, rows, row, column, separator, text):
    """The file with one cell of the last `rows` replaced."""
    lines = data.split(b"\n")
    at = len(lines) - 1 - rows + row
    fields = lines[at].split(separator.encode())
    fields[column] = text.encode()
    lines[at] = separator.encode().join(fields)
    return b"\n".join(lines)
