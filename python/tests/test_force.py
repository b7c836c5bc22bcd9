"""Forces from arrays and recordings."""

import inspect
import pickle

import numpy as np
import pytest
from conftest import CURVES, WALK
from hypothesis import given, settings
from hypothesis import strategies as st

import gaitcam

PERIOD = 0.5


def walk(t):
    return 700 + 250 * np.sin(2 * np.pi * t / PERIOD) + 40 * np.cos(6 * np.pi * t / PERIOD)


T = np.arange(500) * 0.001


def test_equal_steps_are_taken_as_they_stand():
    force = gaitcam.Force(T, walk(T), mass_kg=71.0, name="mine")
    assert np.array_equal(force.force_n, walk(T))
    assert force.period_s == pytest.approx(PERIOD, rel=1e-12)
    assert (force.mass_kg, force.name, len(force)) == (71.0, "mine", 500)
    assert force.mean_n == pytest.approx(700, rel=1e-12)
    assert force.time_s == pytest.approx(T, abs=1e-12)


def test_a_force_is_a_function_of_the_cam_angle():
    force = gaitcam.Force(T, walk(T))
    theta = np.linspace(-9, 9, 40).reshape(5, 8)
    # Cubic interpolation of 500 samples: the error is of third order at the maxima.
    assert force(theta) == pytest.approx(walk(PERIOD * theta / (2 * np.pi)), abs=0.02)
    assert force(theta).shape == (5, 8) and isinstance(force(0.3), float)


@given(st.integers(40, 400), st.floats(0.2, 3), st.booleans())
@settings(max_examples=60, deadline=None)
def test_times_may_be_uneven_and_the_first_sample_repeated(n, period, closed):
    t = period * np.arange(n + closed) / n
    t = t + 0.2 * period / n * np.sin(2 * np.pi * np.arange(n + closed) / n)
    f = 700 + 200 * np.sin(2 * np.pi * t / period)
    force = gaitcam.Force(t, f, period_s=period)
    assert force.period_s == period
    assert np.abs(force.force_n - (700 + 200 * np.sin(2 * np.pi * (force.time_s + t[0]) / period))).max() < 3000 / n**1.5 + 1


@pytest.mark.parametrize("give", [list, tuple, np.float32, np.asarray])
def test_anything_like_an_array_is_taken(give):
    f = np.round(walk(T))
    assert np.array_equal(gaitcam.Force(T, give(f)).force_n, f)


def test_columns_of_pandas_polars_and_pyarrow_are_taken():
    pandas, polars, pyarrow = (pytest.importorskip(m) for m in ("pandas", "polars", "pyarrow"))
    for column in (pandas.Series, polars.Series, pyarrow.array):
        assert np.array_equal(gaitcam.Force(column(T), column(walk(T))).force_n, walk(T))


@pytest.mark.parametrize(
    "t, f, key",
    [
        (T, walk(T)[:-1], "f_n"),
        ([], [], "t_s"),
        (T[:3], walk(T)[:3], "t_s"),
        (T, np.where(T == T[7], np.nan, walk(T)), "f_n"),
        (T, np.where(T == T[7], np.inf, walk(T)), "f_n"),
        (np.where(T == T[7], np.nan, T), walk(T), "t_s"),
        (T[::-1], walk(T), "t_s"),
        (np.zeros(500), walk(T), "t_s"),
        (T, walk(T).reshape(50, 10), "f_n"),
        (T, 3.0, "f_n"),
    ],
)
def test_arrays_that_are_no_cycle_are_refused_by_name(t, f, key):
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.Force(t, f)
    assert fault.value.key == key


@pytest.mark.parametrize("period", [0.0, -1.0, float("nan"), float("inf"), 0.3])
def test_a_period_that_cannot_be_is_refused(period):
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.Force(T, walk(T), period_s=period)
    assert fault.value.key in ("period_s", "t_s")


@pytest.mark.parametrize("wrong", ["text", ["a", "b"], None, object(), [True, False], {"a": 1}, 1j * T])
def test_what_holds_no_numbers_is_a_type_error(wrong):
    with pytest.raises(TypeError, match="t_s"):
        gaitcam.Force(wrong, walk(T))


def test_a_recording_reads_as_the_command_reads_it_and_travels_by_content(tmp_path):
    path = next(iter(sorted(CURVES.glob("*.csv"))))
    copy = tmp_path / path.name
    copy.write_bytes(path.read_bytes())
    force = gaitcam.read_gait(copy)
    bytes_ = pickle.dumps(force)
    copy.unlink()
    again = pickle.loads(bytes_)
    assert np.array_equal(again.force_n, force.force_n) and again.name == force.name


def test_options_of_a_recording_are_keys_of_the_scene(tmp_path):
    path = tmp_path / "press.csv"
    path.write_text("time_s,force\n" + "".join(f"{0.001 * i},{0.7 + 0.001 * (i % 9)}\n" for i in range(500)))
    force = gaitcam.read_gait(path, period="0.25 s", unit="kN")
    assert force.period_s == 0.25 and 700 <= force.mean_n <= 709
    assert gaitcam.read_gait(path, period_s=0.25, unit="kN").period_s == 0.25
    for options, key in [({"period": 0.25}, "gait.period"), ({"kind": "dancing"}, "gait.kind"),
                         ({"period": "0.25 s", "unit": "pt"}, "gait.unit"), ({"feet": "three"}, "gait.feet")]:
        with pytest.raises(gaitcam.InputError) as fault:
            gaitcam.read_gait(path, **options)
        assert fault.value.key == key
    with pytest.raises(gaitcam.InputError, match="none.csv"):
        gaitcam.read_gait(tmp_path / "none.csv")


def test_an_unknown_option_is_a_type_error_with_the_names_that_there_are():
    for read in (gaitcam.read_gait, lambda path, **o: gaitcam.Force.from_recording(T, walk(T), **o)):
        with pytest.raises(TypeError, match=r"perod.*did you mean 'period'.*feet, .*mass"):
            read(WALK, perod="0.25 s")
        with pytest.raises(TypeError, match="mass: one value"):
            read(WALK, mass="70 kg", mass_kg=70.0)
    with pytest.raises(TypeError, match="rate"):
        gaitcam.Force.from_recording(T, walk(T), rate="100 Hz")
    shown = inspect.signature(gaitcam.read_gait).parameters
    assert {"feet", "mass", "mass_kg", "kind"} <= set(shown)
    assert not any(p.kind is inspect.Parameter.VAR_KEYWORD for p in shown.values())


def test_a_force_is_called_as_its_file_or_as_given(tmp_path):
    copy = tmp_path / "S06, left.csv"
    copy.write_bytes(WALK.read_bytes())
    force = gaitcam.read_gait(copy)
    assert force.name == "S06, left" and "S06, left" in repr(force)
    named = gaitcam.read_gait(copy, " Ana ")
    assert named.name == "Ana" == pickle.loads(pickle.dumps(named)).name
    assert gaitcam.Force.from_recording(*plates()).name == "recording"
    assert gaitcam.Force(T, walk(T)).name == "force"
    for wrong in ("", "  ", "a\nb"):
        for give in (lambda n: gaitcam.Force(T, walk(T), name=n), lambda n: gaitcam.read_gait(copy, name=n)):
            with pytest.raises(gaitcam.InputError) as fault:
                give(wrong)
            assert fault.value.key == "name"


def test_kind_and_open_questions_are_words():
    force = gaitcam.read_gait(WALK)
    assert (force.kind, force.open) == ("walking", [])
    heavy = gaitcam.read_gait(WALK, mass_kg=110.0)
    assert heavy.open == ["mass"] == pickle.loads(pickle.dumps(heavy)).open
    assert gaitcam.read_gait(WALK, mass_kg=110.0, accept="mass").open == []
    plain = gaitcam.Force(T, walk(T))
    assert (plain.kind, plain.open, len(plain.stances), len(plain.strides)) == (None, [], 0, 0)


def test_stances_and_strides_are_those_of_the_recording():
    """In the generated recording, a foot strikes every 1/1.9 s, and the mean force of a stride is the weight of 700 N."""
    force = gaitcam.read_gait(WALK)
    stances, strides = force.stances, force.strides
    assert stances.column_names == ["column", "foot", "start_s", "end_s", "p1_n", "valley_n", "p2_n", "impulse", "used", "why"]
    used = stances["used"] == 1.0
    assert (len(stances), used.sum(), stances["why"][0]) == (21, 19, "cut-at-start")
    assert all((why is None) == bool(u) for why, u in zip(stances["why"], used))
    left = used & (np.array(stances["foot"]) == "left")
    assert np.diff(stances["start_s"][left]) == pytest.approx(2 / 1.9, abs=0.02)
    assert (stances["valley_n"][used] < stances["p1_n"][used]).all() and np.isnan(stances["p1_n"][0])
    durations = strides["end_s"] - strides["start_s"]
    assert strides["impulse"].sum() / durations.sum() == pytest.approx(700.0, rel=0.01)


def test_scenes_that_come_with_the_package_find_their_recordings_anywhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert gaitcam.synth(gaitcam.Scene.builtin("heel_tester")).verdict == "acceptable"


def plates():
    # Six steps of half a second on two plates with an overlap of a tenth of a second.
    rate, step, stance = 1000, 0.55, 0.65
    t = np.arange(int(8 * step * rate)) / rate
    plates = np.zeros((len(t), 2))
    for k in range(6):
        u = (t - 0.3 - k * step) / stance
        on = (u > 0) & (u < 1)
        shape = np.sin(np.pi * u) * (1.25 - 0.35 * np.sin(np.pi * u) ** 2)
        plates[on, k % 2] += 850 * shape[on]
    return t, plates


def test_a_whole_recording_may_come_from_arrays():
    t, two = plates()
    force = gaitcam.Force.from_recording(t, two, "Ana", mass="71 kg")
    assert force.period_s == pytest.approx(2 * 0.55, rel=0.02) and force.name == "Ana"
    assert len(force.stances) == 6
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.Force.from_recording(t[:-1], two)
    assert fault.value.key == "f_n"


def plate_file(path, plate, mass_kg=70.0, stride_s=1.1):
    """One step on one of two plates of a trial, in the format of Qualisys."""
    rate, stance = 1000.0, 0.62 * stride_s
    t = np.arange(int(rate * (0.8 + 1.5 * stride_s))) / rate
    x = (t - 0.4 - 0.5 * stride_s * plate) / stance
    # The mean of the two sines over a stance is 2/π (1 + 0.25/3).
    level = mass_kg * 9.81 / (2.0 * 0.62) / (2.0 / np.pi * (1.0 + 0.25 / 3.0))
    force = np.where((x >= 0.0) & (x < 1.0), level * (np.sin(np.pi * x) + 0.25 * np.sin(3.0 * np.pi * x)), 0.0)
    head = f"NO_OF_SAMPLES\t{len(t)}\nFREQUENCY\t{rate}\nTIME_STAMP\t2020-01-01\nFIRST_SAMPLE\t1\n"
    head += f"DESCRIPTION\tForce data\nFORCE_PLATE_NAME\tForce-plate {plate + 1}\n"
    head += "Force_X\tForce_Y\tForce_Z\tMoment_X\tMoment_Y\tMoment_Z\tCOP_X\tCOP_Y\tCOP_Z\n"
    rows = (f"1.0\t-2.0\t{f:.3f}\t50.0\t60.0\t1.0\t300.0\t200.0\t0.0\n" for f in force)
    path.write_text(head + "".join(rows))
    return path


def test_plates_in_a_file_each_are_one_recording(tmp_path):
    files = [plate_file(tmp_path / f"walk_f_{k + 1}.tsv", k) for k in range(2)]
    force = gaitcam.read_gait(files)
    assert force.mass_kg == pytest.approx(70.0, rel=0.02)
    typed = gaitcam.read_gait(" + ".join(map(str, files)))
    np.testing.assert_array_equal(typed.force_n, force.force_n)
    again = pickle.loads(pickle.dumps(force))
    np.testing.assert_array_equal(again.force_n, force.force_n)
    scene = gaitcam.Scene({"cam": {"follower": "flat-translating"}, "drive": {"kind": "moving-axis"}})
    gaitcam.synth(scene, force=force).save(tmp_path / "out")
    assert (tmp_path / "out" / "law.csv").exists()
    with pytest.raises(gaitcam.InputError):
        gaitcam.read_gait([])
