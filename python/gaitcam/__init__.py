"""Design cams that reproduce a given force: law of motion, profile, checks, sweeps.

A scene states target and limits. A force may be read from arrays or a recording. :func:`synth` designs the cam::

    scene = gaitcam.Scene.builtin("footbridge").set({"limits.stroke": "60 mm"})
    design = gaitcam.synth(scene)
    design.verdict, design.law["s_m"], design.save("out/footbridge")

All values are in SI units, which are part of the names of columns and keys. Long calls release the interpreter's lock and
end on Ctrl-C. Invalid input raises :class:`InputError` with ``.key`` and ``.help``.
"""

from typing import Any as _Any
from typing import NamedTuple as _NamedTuple

from gaitcam._native import (
    Design,
    Force,
    Front,
    InputError,
    InternalError,
    Law,
    NoSuchCam,
    Run,
    Scene,
    Sweep,
    Table,
    __version__,
    cover,
    doctor,
    front,
    identify,
    inspect,
    keys,
    laws,
    program,
    read_gait,
    recut,
    simulate,
    synth,
)


class Svaj(_NamedTuple):
    """Lift and its derivatives by the cam angle in m, m/rad, m/rad², m/rad³ (for an oscillating follower in rad)."""

    s: _Any
    v: _Any
    a: _Any
    j: _Any


class Cover(_NamedTuple):
    """Cams for a population; see :func:`cover`. Errors are in percent of a walker's mean force, or in N with ``law.error``."""

    cams: Table
    assignment: Table
    folds: Table
    designs: list[list[Design]]


class Inspection(_NamedTuple):
    """A measured cam; see :func:`inspect`."""

    summary: dict[str, _Any]
    table: Table


#: ``gaitcam.sweep(scene, vary=...).run()`` is the table of a whole sweep; see :class:`Sweep`.
sweep = Sweep

# These imports are last, since they need the names above. The engines themselves are imported when they are used.
from gaitcam import blocks, dask, ray  # noqa: E402

__all__ = [
    "Cover",
    "Design",
    "Force",
    "Front",
    "InputError",
    "Inspection",
    "InternalError",
    "Law",
    "NoSuchCam",
    "Run",
    "Scene",
    "Svaj",
    "Sweep",
    "Table",
    "__version__",
    "blocks",
    "cover",
    "dask",
    "doctor",
    "front",
    "identify",
    "inspect",
    "keys",
    "laws",
    "program",
    "ray",
    "read_gait",
    "recut",
    "simulate",
    "sweep",
    "synth",
]
