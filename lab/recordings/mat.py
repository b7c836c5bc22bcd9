"""Small writer of MATLAB files of version 5: real arrays, texts and structs, plain or compressed."""

import struct
import zlib

import numpy as np

DOUBLE, SINGLE, INT8, INT32, UINT32, UINT16, MATRIX, COMPRESSED = 9, 7, 1, 5, 6, 4, 14, 15


def element(kind, data):
    return struct.pack("<II", kind, len(data)) + data + b"\0" * (-len(data) % 8)


def array(name, value):
    """Array for a value: dict is a struct, str a text, all others are doubles or singles."""
    if isinstance(value, dict):
        code, dims = 2, (1, 1)
        width = max(len(k) for k in value) + 1
        body = struct.pack("<HHI", INT32, 4, width)
        body += element(INT8, b"".join(k.encode().ljust(width, b"\0") for k in value))
        body += b"".join(array("", v) for v in value.values())
    elif isinstance(value, str):
        code, dims = 4, (1, len(value))
        body = element(UINT16, value.encode("utf-16-le"))
    else:
        a = np.atleast_1d(np.asarray(value))
        a = a[:, None] if a.ndim == 1 else a
        single = a.dtype == np.float32
        code, dims = (7 if single else 6), a.shape
        body = element(SINGLE if single else DOUBLE, a.astype("<f4" if single else "<f8").tobytes(order="F"))
    head = element(UINT32, struct.pack("<II", code, 0)) + element(INT32, struct.pack(f"<{len(dims)}i", *dims))
    return element(MATRIX, head + element(INT8, name.encode()) + body)


def mat(variables, compressed=False):
    """Bytes of a file with some variables."""
    text = b"MATLAB 5.0 MAT-file, Platform: GLNXA64, Created on: Mon Jan 01 10:00:00 2024"
    out = text.ljust(116) + b"\0" * 8 + struct.pack("<H", 0x0100) + b"IM"
    for name, value in variables.items():
        data = array(name, value)
        if compressed:
            packed = zlib.compress(data)
            data = struct.pack("<II", COMPRESSED, len(packed)) + packed
        out += data
    return out
