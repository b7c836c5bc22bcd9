"""Functions that need further packages, and their errors without these packages."""

import subprocess
import sys

import numpy as np
import pytest

import gaitcam

WITHOUT = """
import sys
for name in {hidden!r}:
    sys.modules[name] = None
import gaitcam
design = gaitcam.synth(gaitcam.Scene.builtin("footbridge"))
table = design.law
{statement}
"""


def without(statement, *hidden):
    code = WITHOUT.format(hidden=hidden, statement=statement)
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)


@pytest.mark.parametrize(
    "statement, install",
    [
        ("table.__arrow_c_stream__()", "gaitcam[arrow]"),
        ("gaitcam.blocks.sweep(gaitcam.Sweep(design.scene, vary={'limits.stroke': ['40 mm', '50 mm', 2]}), 'out')", "gaitcam[arrow]"),
        ("gaitcam.ray.sweep(gaitcam.Sweep(design.scene, vary={'limits.stroke': ['40 mm', '50 mm', 2]}), 'out')", "gaitcam[ray]"),
        ("gaitcam.dask.sweep(gaitcam.Sweep(design.scene, vary={'limits.stroke': ['40 mm', '50 mm', 2]}), 'out')", "gaitcam[dask]"),
        ("table.to_pandas()", "pandas"),
        ("design.plot()", "matplotlib"),
    ],
)
def test_a_missing_package_is_named_with_the_command_that_installs_it(statement, install, tmp_path):
    statement = statement.replace("'out'", repr(str(tmp_path / "out")))
    done = without(statement, "pyarrow", "pandas", "matplotlib", "ray", "distributed")
    assert "ModuleNotFoundError: " in done.stderr and f"pip install '{install}'" in done.stderr


def test_numpy_alone_is_enough_for_designs_tables_and_fronts():
    statement = """
run = gaitcam.simulate(design)
plan = gaitcam.Sweep(design.scene, vary={"limits.stroke": ["40 mm", "50 mm", 3]})
rows = plan.run()
assert len(gaitcam.front(rows)) and len(dict(rows)["stroke_m"]) == 3 and design._repr_html_()
loaded = {name.split(".")[0] for name in sys.modules if sys.modules[name] is not None}
assert not loaded & {"pyarrow", "pandas", "matplotlib", "polars", "ray", "distributed"}, loaded
"""
    done = without(statement, "pyarrow", "pandas", "matplotlib")
    assert done.returncode == 0, done.stderr


def test_pandas_reads_a_table_without_pyarrow():
    pytest.importorskip("pandas")
    statement = """
import pandas
words = gaitcam.Table({"foot": ["left", None, "left"], "p1_n": [1.0, 2.0, float("nan")]}).to_pandas()
assert words["foot"].astype(object).where(words["foot"].notna(), None).tolist() == ["left", None, "left"]
assert words["p1_n"].isna().tolist() == [False, False, True]
assert list(table.to_pandas().columns) == table.column_names
"""
    done = without(statement, "pyarrow")
    assert done.returncode == 0, done.stderr


def test_diagrams_have_the_numbers_of_the_tables(design):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("agg")
    ax = pyplot.subplots()[1]
    assert design.plot(ax) is ax
    target, cam = ax.get_lines()
    assert np.array_equal(cam.get_ydata(), design.law["force_n"]) and target.get_label() == "target"
    assert np.array_equal(target.get_ydata(), design.law["target_n"])
    assert np.array_equal(cam.get_xdata(), np.degrees(design.law["theta_rad"]))
    lift = design.plot(what="law").get_lines()[0].get_ydata()
    assert np.ptp(lift) == pytest.approx(1e3 * design.summary["law"]["stroke_m"], rel=1e-5)
    x, y = design.plot(what="profile").get_lines()[0].get_data()
    assert (x[0], y[0]) == (x[-1], y[-1]) and len(x) == len(design.profile) + 1
    arm = gaitcam.synth(gaitcam.Scene.builtin("heel_tester"))
    assert arm.plot(what="law").get_ylabel()
    with pytest.raises(gaitcam.InputError) as fault:
        design.plot(what="torque")
    assert fault.value.key == "what"
    pyplot.close("all")
