"""Small writer of C3D files: Intel numbers, integer or float storage, force plates of types 1 to 4."""

import struct

import numpy as np

CAL = np.diag([4.0, 4.0, 11.0, 2.6, 1.9, 1.3]) + 0.004


def parameter(group, name, values, kind, dims):
    """One parameter. The kind is -1 for text, 2 for integer, 4 for float."""
    if kind == -1:
        data = b"".join(v.ljust(dims[0])[: dims[0]].encode("latin-1") for v in values)
    else:
        data = np.asarray(values).ravel(order="F").astype("<i2" if kind == 2 else "<f4").tobytes()
    body = struct.pack("<bB", kind, len(dims)) + bytes(dims) + data + b"\0"
    return struct.pack("<bb", len(name), group) + name.encode() + struct.pack("<H", len(body) + 2) + body


def group(number, name):
    return struct.pack("<bb", len(name), -number) + name.encode() + struct.pack("<H", 3) + b"\0"


def split(base, values, kind, width=None):
    """List parameter in parts of 255. The later parts have a number in their name: LABELS, LABELS2."""
    for part in range(0, max(len(values), 1), 255):
        some = values[part : part + 255]
        name = base + (str(part // 255 + 1) if part else "")
        dims = [width, len(some)] if kind == -1 else [len(some)]
        yield parameter(2, name, some, kind, dims)


def plate_channels(kind, fz):
    """Raw channels of a plate for the upward force fz on the foot, in the axes of the plate (z downwards)."""
    zero = np.zeros_like(fz)
    fx, fy = 0.05 * fz, -0.12 * fz
    if kind == 3:
        parts = (0.28, 0.22, 0.27, 0.23)
        return [fx * 0.5, fx * 0.5, fy * 0.5, fy * 0.5] + [-p * fz for p in parts], 8
    rest = [zero + 12.0, zero - 8.0, 0.004 * fz] if kind == 1 else [-30 * fz, 20 * fz, 4 * fz]
    six = np.array([fx, fy, -fz] + rest)
    if kind == 4:
        six = np.linalg.solve(CAL, six)
    return list(six), 6


def c3d(forces, rate, kind=2, storage="float", ratio=10, before=0, calibrated=True, frames_said=None, scale_pick=None,
        first=1, other=0):
    """Bytes of a trial with one plate per row of forces (N), `before` unused analog channels in front and `other` behind."""
    columns, plates = [], []
    rng = np.random.default_rng(5)
    for i in range(before):
        columns.append((f"EMG{i + 1}", 0.2 * rng.normal(size=forces.shape[1])))
    for p, fz in enumerate(forces):
        raw, count = plate_channels(kind, fz)
        plates.append([len(columns) + k + 1 for k in range(count)])
        names = "Fx Fy Fz Mx My Mz".split() if count == 6 else "Fx12 Fx34 Fy14 Fy23 Fz1 Fz2 Fz3 Fz4".split()
        columns += [(f"{n}{p + 1}" if count == 6 else f"F{p + 1}{n[1:]}", r) for n, r in zip(names, raw)]
    for i in range(other):
        columns.append((f"AUX{i + 1}", 0.1 * rng.normal(size=forces.shape[1])))
    names = [c[0] for c in columns]
    values = np.array([c[1] for c in columns])
    frames = values.shape[1] // ratio
    values = values[:, : frames * ratio]
    top = np.abs(values).max(axis=1) + 1e-9
    gen = 1.0 if storage == "float" else 0.5
    scale = top / 30000 / gen if storage != "float" else np.full(len(names), scale_pick or 1.0)
    offset = np.zeros(len(names)) if storage == "float" else np.full(len(names), 200.0)
    scale, offset = np.float32(scale).astype(float), offset
    stored = values / (scale * gen)[:, None] + offset[:, None]
    points = 1
    n = len(plates)
    rows = len(plates[0])
    block = [group(1, "POINT"), group(2, "ANALOG"), group(3, "FORCE_PLATFORM")]
    block += [parameter(1, "USED", [points], 2, []), parameter(1, "SCALE", [-0.1 if storage == "float" else 0.1], 4, []),
              parameter(1, "RATE", [rate / ratio], 4, []), parameter(1, "DATA_START", [0], 2, []),
              parameter(1, "FRAMES", [min(frames_said or frames, 32767)], 2, []),
              parameter(1, "LABELS", ["SACR"], -1, [4, 1]), parameter(1, "UNITS", ["mm"], -1, [2])]
    units = ["V" if m.startswith(("EMG", "AUX")) or kind == 4 else "N" for m in names]
    block += [parameter(2, "USED", [len(names)], 2, []), parameter(2, "GEN_SCALE", [gen], 4, []),
              parameter(2, "RATE", [rate], 4, []), *split("LABELS", names, -1, 8), *split("SCALE", list(scale), 4),
              *split("OFFSET", list(offset.astype(int)), 2), *split("UNITS", units, -1, 2)]
    corners = np.zeros((3, 4, n))
    for p in range(n):
        corners[:, :, p] = np.array([[464, 0, 0, 464], [508, 508, 0, 0], [0, 0, 0, 0]]) + np.array([[0], [520 * p], [0]])
    block += [parameter(3, "USED", [n], 2, []), parameter(3, "TYPE", [kind] * n, 2, [n]),
              parameter(3, "ZERO", [1, 0], 2, [2]), parameter(3, "CORNERS", corners, 4, [3, 4, n]),
              parameter(3, "ORIGIN", np.tile([[0.0], [0.0], [-40.0]], (1, n)), 4, [3, n]),
              parameter(3, "CHANNEL", np.array(plates).T, 2, [rows, n])]
    if kind == 4 and calibrated:
        block.append(parameter(3, "CAL_MATRIX", np.repeat(CAL[:, :, None], n, axis=2), 4, [6, 6, n]))
    body = b"".join(block) + b"\0\0"
    blocks = -(-(len(body) + 4) // 512)
    section = (struct.pack("<BBBB", 1, 80, blocks, 84) + body).ljust(512 * blocks, b"\0")
    start = 2 + blocks
    section = section.replace(b"DATA_START" + struct.pack("<HbBh", 7, 2, 0, 0), b"DATA_START" + struct.pack("<HbBh", 7, 2, 0, start))
    head = struct.pack("<BBHHHHHfHHf", 2, 80, points, len(names) * ratio, first, first - 1 + (frames_said or frames), 0,
                       -0.1 if storage == "float" else 0.1, start, ratio, rate / ratio).ljust(512, b"\0")
    cells = stored.reshape(len(names), frames, ratio).transpose(1, 2, 0).reshape(frames, -1)
    if storage == "float":
        marker = np.tile([100.0, 200.0, 900.0, 0.0], (frames, 1))
        data = np.hstack([marker, cells]).astype("<f4")
    else:
        marker = np.tile([1000, 2000, 9000, 0], (frames, 1))
        data = np.hstack([marker, np.round(cells)]).astype("<i2")
    return head + section + data.tobytes()
