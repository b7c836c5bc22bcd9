"""Any arguments for any exported function: a result, or an exception of an expected type."""

import inspect

import numpy as np
import pytest

import gaitcam
from gaitcam import _native

#: Values that are invalid for every argument, or unusual.
ODD = [
    None,
    True,
    -1,
    10**30,
    float("nan"),
    float("inf"),
    1e308,
    "",
    "\0",
    "\ud800",
    "1 furlong",
    b"x",
    [],
    [1.0],
    [[1.0, 2.0], [3.0]],
    ["a", 1],
    {},
    {1: 2},
    {"x": object()},
    {"limits.stroke": 10**30},
    {"limits.stroke_m": float("nan")},
    {"\ud800": "\ud800"},
    object(),
    np.zeros((2, 2)),
    np.zeros(3, dtype=complex),
    np.array(["2020-01-01"], dtype="datetime64[D]"),
    float,
]

#: Expected exceptions: KeyError if there is no such column, and Python's error for text that is not Unicode.
EXPECTED = (gaitcam.InputError, gaitcam.NoSuchCam, TypeError, KeyError, UnicodeEncodeError)


class Trap:
    """Object whose use makes the package panic: pyo3 resumes a panic that Python returns."""

    def __getattribute__(self, name):
        raise gaitcam.InternalError(name)

    def trip(self, *_):
        raise gaitcam.InternalError("trip")

    __index__ = __float__ = __len__ = __iter__ = __str__ = __fspath__ = __getitem__ = __array__ = trip


@pytest.fixture(scope="module")
def known(tmp_path_factory):
    """Valid values by the names of parameters, and an object of each class."""
    folder = tmp_path_factory.mktemp("faults")
    scene = gaitcam.Scene.builtin("footbridge").set({"law.family": "harmonic"})
    force = gaitcam.Force(np.arange(8) / 16, 700 + 100 * np.sin(np.arange(8) * np.pi / 4), period_s=0.5)
    design = gaitcam.synth(scene)
    sweep = gaitcam.sweep(scene, vary={"limits.stroke": ["40 mm", "60 mm", 2]})
    table = sweep.run()
    return {
        "scene": scene,
        "force": force,
        "design": design,
        "table": table,
        "folder": str(folder),
        "path": str(folder / "missing.csv"),
        "name": "footbridge",
        "theta": 0.5,
        "order": 1,
        "points": 32,
        "text": scene.to_toml(),
        "changes": {"limits.stroke": "50 mm"},
        "columns": {"a": [1.0, 2.0]},
        "t_s": force.time_s,
        "f_n": force.force_n,
        "segments": [("cycloidal", "20 mm", "180 deg"), ("cycloidal", "-20 mm", "180 deg")],
        gaitcam.Scene: scene,
        gaitcam.Force: force,
        gaitcam.Design: design,
        gaitcam.Sweep: sweep,
        gaitcam.Table: table,
        gaitcam.Law: design.motion,
        gaitcam.Run: gaitcam.simulate(design),
        gaitcam.Front: gaitcam.front(table),
    }


def exported(known):
    """Every function, constructor, method and operator of the package with its name."""
    for name, value in vars(_native).items():
        if inspect.isclass(value) and not issubclass(value, BaseException):
            yield name, value
            for member in vars(value):
                if member.startswith("_") and member not in ("__call__", "__getitem__", "__contains__", "__eq__"):
                    continue
                if callable(getattr(value, member)):
                    yield f"{name}.{member}", getattr(known[value], member)
        elif callable(value) and not inspect.isclass(value) and not name.startswith("_"):
            yield name, value


def calls(known, odd):
    """Calls with one argument `odd` and otherwise valid arguments."""
    for name, function in exported(known):
        try:
            parameters = list(inspect.signature(function).parameters.values())
        except ValueError:
            parameters = [inspect.Parameter("value", inspect.Parameter.POSITIONAL_ONLY)]
        positional = [p for p in parameters if p.kind in (p.POSITIONAL_OR_KEYWORD, p.POSITIONAL_ONLY)]
        needed = [p for p in positional if p.default is p.empty]
        for wrong in parameters:
            arguments = [odd if p is wrong else known.get(p.name, odd) for p in needed]
            if wrong in needed:
                keywords = {}
            elif wrong.kind == wrong.VAR_KEYWORD:
                keywords = {"rate": odd}
            else:
                keywords = {wrong.name: odd}
            yield f"{name}({wrong.name})", function, arguments, keywords


def test_odd_values_are_taken_or_refused_as_input(known, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    found = []
    for odd in ODD:
        for name, function, arguments, keywords in calls(known, odd):
            try:
                function(*arguments, **keywords)
            except EXPECTED:
                continue
            except BaseException as fault:  # noqa: BLE001
                found.append(f"{name} of {odd!a}: {fault!r}"[:300])
    assert not found, "\n".join(found)


def test_a_panic_in_whatever_is_called_is_an_internal_error(known, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    panicked = set()
    for name, function, arguments, keywords in calls(known, Trap()):
        try:
            function(*arguments, **keywords)
        except gaitcam.InternalError:
            panicked.add(name.split("(")[0])
        except EXPECTED:
            continue
    assert len(panicked) > 8, panicked
