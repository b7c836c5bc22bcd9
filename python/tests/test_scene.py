"""Scenes: written scenes can be read again, and faults are named."""

import pickle
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import gaitcam

BUILT_IN = gaitcam.Scene.builtins()

CHANGES = st.fixed_dictionaries(
    {},
    optional={
        "limits.stroke": st.floats(1, 500).map(lambda x: f"{x} mm"),
        "limits.curvature": st.floats(0.1, 50).map(lambda x: f"{x} mm"),
        "accuracy.rms": st.floats(0.01, 20).map(lambda x: f"{x} %"),
        "cam.thickness": st.floats(1, 100).map(lambda x: f"{x} mm"),
        "machine.friction": st.floats(0, 1),
        "machine.restitution": st.floats(0, 1),
        "name": st.text("abcdefghijk_é", min_size=1),
    },
)


@given(st.sampled_from(BUILT_IN), CHANGES)
@settings(max_examples=150, deadline=None)
def test_a_scene_comes_back_from_its_dictionary_its_text_and_its_pickle(name, changes):
    assume("limits.stroke" not in changes or "oscillating" not in gaitcam.Scene.builtin(name).to_toml())
    scene = gaitcam.Scene.builtin(name).set(changes)
    assert gaitcam.Scene(scene.to_dict()) == scene
    assert gaitcam.Scene.from_toml(scene.to_toml()) == scene
    assert pickle.loads(pickle.dumps(scene)) == scene


def test_set_gives_a_new_scene_and_leaves_the_old_one(footbridge):
    changed = footbridge.set({"limits.stroke": "31 mm", "law.degree": 7})
    assert changed != footbridge and footbridge == gaitcam.Scene.builtin("footbridge")
    assert changed.to_dict()["limits"]["stroke"] == "31 mm"
    assert changed.to_dict()["law"]["degree"] == 7


@pytest.mark.parametrize("key, unit, column", [
    ("limits.stroke", "m", "limits.stroke_m"),
    ("limits.jerk", "m/s^3", "limits.jerk_m_per_s3"),
    ("limits.pressure_angle", "rad", "limits.pressure_angle_rad"),
    ("drive.speed", "rad/s", "drive.speed_rad_per_s"),
    ("gait.step_frequency", "Hz", "gait.step_frequency_hz"),
    ("machine.stiffness", "N/m", "machine.stiffness_n_per_m"),
])
@pytest.mark.parametrize("number", [0.75, np.float64(0.75), 1, 1e-5])
def test_a_number_under_a_key_with_its_unit_is_the_text_with_that_unit(key, unit, column, number, footbridge):
    assert footbridge.set({column: number}) == footbridge.set({key: f"{number:.5f} {unit}"})


def test_numbers_with_units_in_their_keys_stand_wherever_keys_stand(footbridge):
    scene = gaitcam.Scene({"limits": {"stroke_m": 0.05}, "drive": {"mass_kg": 2, "speed": "60 rpm"}})
    assert scene.to_dict()["limits"] == {"stroke": "0.05 m"} and scene.to_dict()["drive"]["mass"] == "2 kg"
    design = gaitcam.synth(footbridge)
    runs = [gaitcam.simulate(design, machine=m).summary for m in ({"drive.mass_kg": 71.5}, {"drive.mass": "71.5 kg"})]
    assert runs[0] == runs[1]
    with pytest.raises(gaitcam.InputError, match="limits.stroke"):
        footbridge.set({"limits.stroke_m": "50 mm"})


def test_lists_and_tables_are_values_too():
    segments = [
        {"motion": "cycloidal", "lift": "10 mm", "angle": "180 deg"},
        {"motion": "cycloidal", "lift": "-10 mm", "angle": "180 deg"},
    ]
    scene = gaitcam.Scene({"name": "two", "drive": {"speed": "60 rpm", "mass": "1 kg"}, "law": {"family": "program", "segment": segments}})
    assert gaitcam.synth(scene).summary["law"]["stroke_m"] == pytest.approx(0.01, rel=1e-9)
    assert scene.set({"law.segment.2.lift": "-5 mm"}) != scene


def test_a_file_and_its_relative_recording_are_found_from_anywhere(tmp_path: Path, monkeypatch):
    (tmp_path / "walk.csv").write_text("# cycle, period_s = 0.5\ntime_s,force_n\n" + "".join(
        f"{0.001 * i},{700 + (i % 50)}\n" for i in range(500)))
    (tmp_path / "walk.toml").write_text('[gait]\nfile = "walk.csv"\nscale = "to-mass"\n')
    scene = gaitcam.Scene.load(tmp_path / "walk.toml")
    monkeypatch.chdir("/")
    assert Path(scene.recording) == tmp_path / "walk.csv"
    again = pickle.loads(pickle.dumps(scene))
    assert again == scene and Path(again.recording).exists()
    assert Path(gaitcam.Scene(scene.to_dict()).recording).exists()


@pytest.mark.parametrize(
    "changes, key, helped",
    [
        ({"limits.strok": "40 mm"}, "limits.strok", "stroke"),
        ({"limits.stroke": 40}, "limits.stroke", "mm"),
        ({"limits.stroke": "40 kg"}, "limits.stroke", ""),
        ({"limits.stroke": float("nan")}, "limits.stroke", ""),
        ({"law.family": "splin"}, "law.family", "spline"),
        ({"gait.accept": "nothing"}, "gait.accept", ""),
        ({"law.segment.3.lift": "1 mm"}, "law.segment.3.lift", ""),
    ],
)
def test_wrong_keys_and_values_are_named_with_what_would_be_right(footbridge, changes, key, helped):
    with pytest.raises(gaitcam.InputError) as fault:
        footbridge.set(changes)
    assert fault.value.key == key
    assert helped in str(fault.value.help) or helped in str(fault.value)
    assert fault.value.code and isinstance(fault.value, ValueError)
    again = pickle.loads(pickle.dumps(fault.value))
    assert (again.key, again.help) == (fault.value.key, fault.value.help)


@pytest.mark.parametrize("value", [None, object(), b"40 mm", {"a": None}, [1, object()]])
def test_values_of_the_wrong_type_are_type_errors_with_the_key(footbridge, value):
    with pytest.raises(TypeError, match="limits.stroke"):
        footbridge.set({"limits.stroke": value})


def test_arguments_of_the_wrong_type_are_type_errors(footbridge):
    for wrong in (lambda: gaitcam.Scene(3), lambda: footbridge.set("limits.stroke=40 mm"),
                  lambda: footbridge.set({3: "40 mm"}), lambda: gaitcam.Scene({3: {}})):
        with pytest.raises(TypeError):
            wrong()


def test_missing_files_and_broken_text_name_the_file_and_the_line(tmp_path: Path):
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.Scene.load(tmp_path / "none.toml")
    assert "none.toml" in fault.value.place and fault.value.key is None
    broken = tmp_path / "broken.toml"
    broken.write_text("[gait]\nfile = \n")
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.Scene.load(broken)
    assert fault.value.place.endswith("broken.toml line 2")
    broken.write_text('[limits]\nstrok = "4 mm"\n')
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.Scene.load(broken)
    assert fault.value.key == "limits.strok" and "broken.toml" in fault.value.place
    with pytest.raises(gaitcam.InputError, match="footbridge"):
        gaitcam.Scene.builtin("footbrige")


def test_the_key_table_is_that_of_the_command():
    stroke = next(k for k in gaitcam.keys() if k["key"] == "limits.stroke")
    assert stroke["section"] == "limits" and stroke["doc"]["es"]


def test_a_motion_is_read_from_a_file_and_goes_with_the_scene(tmp_path: Path, monkeypatch):
    rows = ["angle_deg,lift_mm"] + [f"{5 * i},{10 * (x := i / 24) ** 3 * (10 - 15 * x + 6 * x * x)}" for i in range(25)]
    (tmp_path / "lift.csv").write_text("\n".join(rows))
    (tmp_path / "scene.toml").write_text(
        """
        drive = {kind = "fixed-axis", speed = "60 rpm"}
        cam = {follower = "flat-translating", base_radius = "60 mm"}
        [law]
        family = "program"
        segment = [{motion = "table lift.csv"}, {motion = "3-4-5", lift = "-10 mm", angle = "240 deg"}]
        """
    )
    scene = gaitcam.Scene.load(tmp_path / "scene.toml")
    monkeypatch.chdir(tmp_path.parent)
    pickled = pickle.dumps(scene)
    exact = scene.set({"law.segment.1.motion": "3-4-5", "law.segment.1.lift": "10 mm", "law.segment.1.angle": "120 deg"})
    stroke = [gaitcam.synth(s).summary["cam"]["rho_min_m"] for s in (scene, exact)]
    assert stroke[0] == pytest.approx(stroke[1], abs=1e-9)
    # Neither the pickle nor the text depends on the file.
    (tmp_path / "lift.csv").unlink()
    assert pickle.loads(pickled) == scene
    assert gaitcam.Scene.from_toml(scene.to_toml()) == scene
    with pytest.raises(gaitcam.InputError, match="lift.csv"):
        gaitcam.Scene.load(tmp_path / "scene.toml")
