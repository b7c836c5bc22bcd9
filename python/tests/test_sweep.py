"""Sweeps: row i depends only on the plan and on i."""

import os
import pickle
from pathlib import Path

import numpy as np
import pytest
from conftest import CURVES
from hypothesis import given, settings
from hypothesis import strategies as st

import gaitcam
import gaitcam.blocks


def same(a, b):
    """Asserts that tables agree bit by bit."""
    assert a.column_names == b.column_names
    for name in a.column_names:
        x, y = a[name], b[name]
        assert x == y if isinstance(x, list) else x.tobytes() == y.tobytes(), name


def part(table, rows):
    return {n: [table[n][i] for i in rows] if isinstance(table[n], list) else table[n][rows] for n in table.column_names}


PLANS = {
    "grid": lambda: gaitcam.Sweep(vary={"law.family": ["spline", "harmonic"], "limits.stroke": ["45 mm", "60 mm", 4],
                                        "gait.step_frequency": "1.6 Hz:2 Hz:3"}),
    "latin": lambda: gaitcam.Sweep(vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz"], "law.degree": ["5", "7"],
                                         "accuracy.rms": ["0.2 %", "3 %"]}, sample=24, seed=3),
    "sobol": lambda: gaitcam.Sweep(vary={"gait.body_weight": ["500 N", "900 N"]}, sample=16, method="sobol"),
    "list": lambda: gaitcam.Sweep(rows={"limits.stroke": ["50 mm", "5 mm", "70 mm"], "law.degree": [5, 7, 5]}),
    "scenes": lambda: gaitcam.Sweep([gaitcam.Scene.builtin("footbridge"), gaitcam.Scene.builtin("thesis_iteration_1")],
                                    vary={"limits.curvature": ["1 mm", "5 mm", 2]}),
    "recordings": lambda: gaitcam.Sweep(gaitcam.Scene.builtin("measured_walk"),
                                        recordings=sorted(CURVES.glob("*.csv"))[:3]),
    "tolerances": lambda: gaitcam.Sweep(tolerance={"profile": "0.02 mm", "mass": "1 %"}, sample=40),
}


@pytest.mark.parametrize("name", PLANS)
def test_every_part_of_every_kind_of_plan_is_that_of_the_whole(name):
    plan = PLANS[name]()
    whole = plan.run()
    n = len(plan)
    assert len(whole) == n and whole.column_names[0] == "row" and list(whole["row"]) == list(range(n))
    same(plan.run(jobs=1), whole)
    travelled = pickle.loads(pickle.dumps(plan))
    assert travelled.fingerprint == plan.fingerprint == whole.metadata["gaitcam.fingerprint"]
    for start, stop in [(0, 1), (n // 3, n // 3 + 1), (n // 2, n), (n - 1, n), (n, n)]:
        some = travelled.run(start, stop, jobs=1)
        expected = part(whole, range(start, stop))
        for column in some.column_names:
            x, y = some[column], expected[column]
            assert x == y if isinstance(x, list) else x.tobytes() == y.tobytes(), column


def test_a_row_is_the_design_of_its_scene(footbridge):
    plan = gaitcam.Sweep(footbridge, vary={"limits.stroke": ["48 mm", "60 mm", 3]})
    table = plan.run()
    assert table["limits.stroke_m"] == pytest.approx([0.048, 0.054, 0.06])
    for i, stroke in enumerate(table["limits.stroke_m"]):
        design = gaitcam.synth(footbridge.set({"limits.stroke": f"{stroke} m"}))
        assert table["force_rms_error_n"][i] == pytest.approx(design.summary["force"]["rms_error_n"], rel=1e-9)
        assert table["verdict"][i] == design.verdict


def test_numbers_in_si_are_the_values_of_an_axis_or_the_ends_of_a_sampled_range(footbridge):
    strokes = np.linspace(0.048, 0.06, 4)
    table = gaitcam.Sweep(footbridge, vary={"limits.stroke_m": strokes}).run()
    assert table["limits.stroke_m"].tobytes() == strokes.tobytes()
    some, text = (gaitcam.Sweep(footbridge, vary=v, sample=20).run() for v in (
        {"limits.stroke_m": [0.048, 0.06]}, {"limits.stroke": ["0.048 m", "0.06 m"]}))
    same(some, text)


@pytest.mark.parametrize("make", [
    lambda: gaitcam.Force(np.arange(100) / 200, 700 + 250 * np.sin(np.arange(100) * np.pi / 25), period_s=0.5, mass_kg=71),
    lambda: gaitcam.read_gait(sorted(CURVES.glob("*.csv"))[0]),
], ids=["arrays", "recording"])
def test_a_force_stands_in_for_that_of_every_scene_and_travels(make, footbridge):
    force = make()
    scenes = [footbridge, footbridge.set({"law.degree": 7})]
    plan = gaitcam.Sweep(scenes, force=force, vary={"limits.stroke": ["48 mm", "60 mm", 2]})
    table = plan.run()
    for i, (scene, stroke) in enumerate((s, x) for s in scenes for x in ("48 mm", "60 mm")):
        design = gaitcam.synth(scene.set({"limits.stroke": stroke}), force=force)
        assert table["force_rms_error_n"][i] == pytest.approx(design.summary["force"]["rms_error_n"], rel=1e-9)
    same(pickle.loads(pickle.dumps(plan)).run(), table)


@pytest.mark.parametrize("jobs", [1, 2])
def test_progress_counts_up_to_the_rows_and_its_exception_ends_the_sweep(spectral, jobs):
    plan = gaitcam.Sweep(spectral, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz"]}, sample=40_000)
    seen = []
    plan.run(jobs=jobs, progress=lambda begun, rows: seen.append((begun, rows)))
    counts = [begun for begun, _ in seen]
    assert len(seen) > 2 and counts == sorted(counts) and seen[-1] == (40_000, 40_000)
    with pytest.raises(ZeroDivisionError):
        plan.run(jobs=jobs, progress=lambda begun, rows: 1 / 0)


def test_one_objective_may_be_a_plain_name(spectral):
    table = gaitcam.Sweep(spectral, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz", 9]}).run()
    both = [gaitcam.front(table, minimise=m) for m in ("stroke", ["stroke"])]
    assert both[0].positions.tolist() == both[1].positions.tolist() and len(both[0]) == 1


@given(st.integers(1, 2000), st.data())
@settings(max_examples=15, deadline=None)
def test_cuts_do_not_matter(n, data):
    plan = gaitcam.Sweep(gaitcam.Scene.builtin("footbridge").set({"law.family": "harmonic"}),
                         vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz"], "gait.body_weight": ["500 N", "900 N"]},
                         sample=n)
    cuts = sorted({0, n, *data.draw(st.lists(st.integers(0, n), max_size=4))})
    parts = [plan.run(a, b, jobs=1)["force_rms_error_n"] for a, b in zip(cuts, cuts[1:])]
    assert np.concatenate(parts).tobytes() == plan.run()["force_rms_error_n"].tobytes()


def test_rows_may_be_columns_of_an_earlier_table(spectral):
    plan = gaitcam.Sweep(spectral, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz", 9]})
    table = plan.run()
    again = gaitcam.Sweep(spectral, rows={"gait.step_frequency_hz": table["gait.step_frequency_hz"]}).run()
    assert again["force_rms_error_n"].tobytes() == table["force_rms_error_n"].tobytes()


def test_recordings_travel_by_content_and_each_once(tmp_path):
    original = sorted(CURVES.glob("*.csv"))[0].read_bytes() + b"\n" * 100_000
    for name in ("a.csv", "b.csv", "c.csv"):
        (tmp_path / name).write_bytes(original)
    paths = sorted(tmp_path.glob("*.csv"))
    plan = gaitcam.Sweep(gaitcam.Scene.builtin("measured_walk"), recordings=paths)
    sent = pickle.dumps(plan)
    assert len(sent) < 1.2 * len(original) + 20_000
    expected = plan.run()
    for path in paths:
        path.unlink()
    same(pickle.loads(sent).run(), expected)
    assert expected["outcome"] == ["built"] * 3


def test_the_front_is_found_in_every_kind_of_table(spectral):
    plan = gaitcam.Sweep(spectral, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz"], "gait.body_weight": ["500 N", "900 N"]},
                         sample=400)
    table = plan.run()
    pa, pd, pl = (pytest.importorskip(m) for m in ("pyarrow", "pandas", "polars"))
    front = gaitcam.front(table, minimise=["stroke", "torque_max"], low_speed=True)
    x, y = table["stroke_m"], table["torque_max_n_m"]
    good = [v in ("acceptable", "not-for-high-speed") for v in table["verdict"]]
    kept = [i for i in range(400) if good[i] and not any(
        good[k] and x[k] <= x[i] * (1 - 1e-9) and y[k] <= y[i] * (1 - 1e-9) for k in range(400))]
    assert set(front.positions) <= set(kept) and front.best in front.positions and len(front) > 1
    assert front.values[:, 0].tolist() == x[front.positions].tolist()
    again = pickle.loads(pickle.dumps(front))
    assert (again.best, again.objectives, again.left_out) == (front.best, front.objectives, front.left_out)
    assert np.array_equal(again.values, front.values) and np.array_equal(again.positions, front.positions)
    for other in (pa.table(table), pl.DataFrame(table), pa.table(table).to_pandas(), {n: table[n] for n in table.keys()}):
        again = gaitcam.front(other, minimise=["stroke", "torque_max"], low_speed=True)
        assert again.positions.tolist() == front.positions.tolist()
    with pytest.raises(gaitcam.InputError, match="jerk"):
        gaitcam.front(table, minimise=["jrk"])


@pytest.mark.parametrize("arguments, key", [
    ({"vary": {"limits.strok": ["1 mm", "2 mm", 3]}}, "limits.strok"),
    ({"vary": {"limits.stroke": ["1", "2", 3]}}, "limits.stroke"),
    ({"vary": {"limits.stroke": []}}, "limits.stroke"),
    ({"vary": {"limits.stroke": ["1 mm", "2 mm", 0]}}, "limits.stroke"),
    ({"vary": {"law.family": ["splin"]}}, "law.family"),
    ({"rows": {"limits.stroke": ["50 mm", "60 mm"], "law.degree": [5]}}, None),
    ({"vary": {"law.degree": [5]}, "method": "monte-carlo"}, "method"),
    ({"tolerance": {"profile": "1 kg"}}, "profile"),
    ({"tolerance": {"mass": "1 %"}, "vary": {"law.degree": [5, 7]}}, "tolerance"),
    ({"recordings": []}, "recordings"),
    ({"recordings": ["none.csv"]}, None),
    ({"vary": {"law.degree": [5]}, "time_limit": -1}, "time_limit"),
    ({"scene": []}, "scene"),
    ({"sample": -1}, None),
])
def test_plans_that_cannot_run_are_refused_before_they_start(arguments, key):
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.Sweep(**arguments)
    assert fault.value.key == key


@pytest.mark.parametrize("arguments", [
    {"vary": [("law.degree", 5)]}, {"vary": {"law.degree": 5}}, {"vary": {"law.degree": [None]}}, {"rows": 3},
    {"scene": "footbridge"}, {"scene": [3]}, {"sample": "many", "vary": {"law.degree": [5]}},
])
def test_arguments_of_the_wrong_type_are_refused(arguments):
    with pytest.raises((TypeError, OverflowError, AttributeError)):
        gaitcam.Sweep(**arguments)


def test_rows_outside_the_plan_are_refused():
    plan = gaitcam.Sweep(vary={"law.degree": [5, 7]})
    for start, stop in [(0, 3), (2, 1), (5, 6)]:
        with pytest.raises(gaitcam.InputError, match="rows"):
            plan.run(start, stop)


def folder_of(path):
    return {p.name: p.read_bytes() for p in Path(path).iterdir()}


def test_blocks_hold_the_rows_of_one_run_and_a_second_start_does_only_what_is_missing(spectral, tmp_path):
    pq = pytest.importorskip("pyarrow.parquet")
    plan = gaitcam.Sweep(spectral, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz", 100]})
    out = tmp_path / "blocks"
    seen = []
    assert gaitcam.blocks.sweep(plan, out, block_rows=30, progress=lambda *rows: seen.append(rows)) == 100
    assert seen == [(30, 100), (60, 100), (90, 100), (100, 100)]
    blocks = sorted(out.glob("*.parquet"))
    assert [b.name for b in blocks] == [f"rows-{a:012}-{min(a + 30, 100):012}.parquet" for a in (0, 30, 60, 90)]
    union = pq.read_table(out)
    assert sorted(p.name for p in out.iterdir()) == ["_plan.json", *(b.name for b in blocks)]
    whole = plan.run()
    assert union.column_names == whole.column_names
    for name in whole.column_names:
        column = union.column(name)
        if isinstance(whole[name], list):
            assert column.to_pylist() == whole[name]
        else:
            assert column.to_numpy().tobytes() == whole[name].tobytes(), name
    assert union.schema.field("stroke_m").metadata[b"unit"] == b"m"
    assert pq.read_schema(blocks[1]).metadata[b"gaitcam.fingerprint"].decode() == plan.fingerprint
    before = folder_of(out)
    assert gaitcam.blocks.sweep(plan, out, block_rows=30) == 0
    blocks[2].unlink()
    assert gaitcam.blocks.sweep(plan, out, block_rows=30) == 30
    assert folder_of(out) == before


def test_a_plan_that_changed_since_the_folder_was_begun_is_refused_with_the_difference(spectral, tmp_path):
    vary = {"gait.step_frequency": ["1.5 Hz", "2.4 Hz", 10]}
    out = tmp_path / "blocks"
    gaitcam.blocks.sweep(gaitcam.Sweep(spectral, vary=vary), out, block_rows=5)
    before = folder_of(out)
    changed = spectral.set({"limits.stroke": "80 mm"})
    for plan, rows, named in [
        (gaitcam.Sweep(changed, vary=vary), 5, "80 mm"),
        (gaitcam.Sweep(spectral, vary={"gait.step_frequency": ["1.5 Hz", "2.3 Hz", 10]}), 5, "gait.step_frequency"),
        (gaitcam.Sweep(spectral, vary=vary), 4, "block_rows"),
    ]:
        with pytest.raises(gaitcam.InputError, match=named):
            plan.begin(out, rows)
    assert folder_of(out) == before


def test_a_recording_that_changed_is_another_plan(tmp_path):
    path = tmp_path / "walk.csv"
    path.write_bytes(sorted(CURVES.glob("*.csv"))[0].read_bytes())
    make = lambda: gaitcam.Sweep(gaitcam.Scene.builtin("measured_walk"), recordings=[path])
    first = make()
    first.begin(tmp_path / "out")
    path.write_bytes(path.read_bytes() + b"\n")
    with pytest.raises(gaitcam.InputError, match="checksum"):
        make().begin(tmp_path / "out")


def test_blocks_of_nobody_are_left_alone(spectral, tmp_path):
    (tmp_path / "rows-000000000000-000000000010.parquet").write_bytes(b"mine")
    plan = gaitcam.Sweep(spectral, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz", 10]})
    with pytest.raises(gaitcam.InputError, match="rows-000000000000"):
        plan.begin(tmp_path)
    assert os.listdir(tmp_path) == ["rows-000000000000-000000000010.parquet"]
    with pytest.raises(gaitcam.InputError) as fault:
        plan.begin(tmp_path / "new", 0)
    assert fault.value.key == "block_rows"
