"""The stubs contain all names of the package and are valid under mypy --strict."""

import inspect
import subprocess
import sys
from pathlib import Path

import pytest

import gaitcam

USE = '''
import numpy as np
import gaitcam
import gaitcam.blocks

scene: gaitcam.Scene = gaitcam.Scene.load("heel.toml").set({"limits.stroke": "40 mm"})
force: gaitcam.Force = gaitcam.Force(np.zeros(4), np.zeros(4), period_s=0.5)
design: gaitcam.Design = gaitcam.synth(scene, force=force)
verdict: str = design.verdict
number: float = force(0.5)
run: gaitcam.Run = gaitcam.simulate(design, model="auto")
plan: gaitcam.Sweep = gaitcam.sweep(scene, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz", 10]})
table: gaitcam.Table = plan.run(0, len(plan))
best: int | None = gaitcam.front(table).best
rows: int = gaitcam.blocks.sweep(plan, "out")
walker: gaitcam.Force = gaitcam.read_gait("walk.c3d", "S01", feet="left", kind="walking", mass_kg=70.0)
stances: gaitcam.Table = walker.stances
open_: bool = "mass" in walker.open
cover: gaitcam.Cover = gaitcam.cover(scene, forces=[walker, force], cams=2)
second: gaitcam.Design = cover.designs[1][0]
found: dict[str, object] = gaitcam.inspect(design, np.zeros((9, 2)), ball="1 mm").summary
sentences: list[str] = [finding["sentence"] for finding in gaitcam.doctor(scene)]
log = {"time_s": np.zeros(9), "force_n": np.zeros(9)}
found = gaitcam.identify(design, ["run1.csv", log], torque="M [N m]")
next_: gaitcam.Design = gaitcam.recut(design, log)
text: str = design.ecam("codesys")["text"]
other: gaitcam.Run = gaitcam.simulate(design, force=walker)
'''


def test_mypy_strict_is_clean(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "use.py").write_text(USE)
    command = [sys.executable, "-m", "mypy", "--strict", "use.py", "-p", "gaitcam"]
    for arguments in (command[:-2], command[:-3] + command[-2:]):
        found = subprocess.run(arguments, capture_output=True, text=True, cwd=tmp_path)
        assert found.returncode == 0, found.stdout


WRONG = """
import gaitcam

gaitcam.read_gait("walk.c3d", feet="three")
gaitcam.read_gait("walk.c3d", weight="700 N")
gaitcam.read_gait("walk.c3d").open == ["mass"]
"""


def test_mypy_rejects_unknown_options_and_words(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "wrong.py").write_text(WRONG)
    found = subprocess.run([sys.executable, "-m", "mypy", "--strict", "wrong.py"], capture_output=True, text=True, cwd=tmp_path)
    assert found.stdout.count("error:") == 2 and "weight" in found.stdout and "three" in found.stdout, found.stdout


def test_the_stubs_name_what_the_package_has():
    text = (Path(gaitcam.__file__).parent / "_native.pyi").read_text()
    for name in gaitcam.__all__:
        value = getattr(gaitcam, name)
        if name in ("Cover", "Inspection", "Svaj", "sweep", "__version__", "blocks", "dask", "ray"):
            continue
        assert f"class {name}" in text or f"def {name}(" in text, name
        if not inspect.isclass(value):
            continue
        body = text.split(f"class {name}", 1)[1].split("\nclass ", 1)[0]
        for member in vars(value):
            if not member.startswith("_") and not issubclass(value, Exception):
                assert f"def {member}(" in body, f"{name}.{member}"


def test_the_package_shows_no_names_but_its_own():
    shown = {name for name in dir(gaitcam) if not name.startswith("_")}
    assert shown == set(gaitcam.__all__) - {"__version__"}


def test_everything_public_is_documented():
    for name in gaitcam.__all__:
        value = getattr(gaitcam, name)
        if name != "__version__":
            assert value.__doc__, name
        if inspect.isbuiltin(value):
            assert "..." not in str(inspect.signature(value)), name
        if inspect.isclass(value) and value.__module__ == "gaitcam" and not issubclass(value, (Exception, tuple)):
            for member, attribute in vars(value).items():
                if not member.startswith("_"):
                    assert attribute.__doc__, f"{name}.{member}"
