"""Checks from outside: measured cams, scenes and recordings."""

import numpy as np
import pytest
from conftest import WALK

import gaitcam


@pytest.fixture(scope="module")
def heel():
    return gaitcam.synth(gaitcam.Scene.builtin("heel_tester"))


def turned(design, angle_deg=40.0, centre=(0.012, -0.007), every=4):
    """Points of a profile in the coordinates of a measuring machine: rotated about another centre, in reverse order."""
    a = np.radians(angle_deg)
    xy = np.stack([design.profile["x_m"], design.profile["y_m"]])[:, ::-every]
    return (np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]) @ xy).T + centre


def test_a_cam_as_designed_is_found_where_it_lies(heel, tmp_path):
    xy = turned(heel)
    found = gaitcam.inspect(heel, xy)
    assert found.summary["points"] == len(xy) == len(found.table)
    assert np.degrees(found.summary["turn_rad"]) == pytest.approx(40.0, abs=1e-6)
    assert found.summary["centre_m"] == pytest.approx([0.012, -0.007], abs=1e-9)
    assert np.abs(found.table["deviation_m"]).max() < 1e-8
    made, designed = found.summary["made"], found.summary["designed"]
    assert made["force_rms_error_n"] == pytest.approx(designed["force_rms_error_n"], rel=1e-6)
    path = tmp_path / "measured.csv"
    np.savetxt(path, 1e3 * xy, delimiter=",", header="x_mm,y_mm", comments="", fmt="%.17g")
    of_file = gaitcam.inspect(heel, path).summary
    assert of_file["turn_rad"] == pytest.approx(found.summary["turn_rad"], abs=1e-9)


def test_a_probing_ball_and_a_bump_are_seen(heel):
    xy = turned(heel, 0.0, (0.0, 0.0))
    out = xy / np.linalg.norm(xy, axis=1)[:, None]
    bumped = xy + 30e-6 * out * np.exp(-((np.arange(len(xy)) - 90) / 12.0)[:, None] ** 2)
    assert 15e-6 < gaitcam.inspect(heel, bumped).table["deviation_m"].max() < 31e-6
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.inspect(heel, xy, ball=-1.0)
    assert fault.value.key == "ball"
    shift = gaitcam.inspect(heel, xy, ball="0.1 mm").summary["deviation"]["rms_m"]
    assert shift == pytest.approx(1e-4, rel=0.05)


@pytest.mark.parametrize("points", [np.zeros((9, 3)), np.zeros(9), np.full((9, 2), np.nan), np.zeros((0, 2)), np.zeros((9, 2))])
def test_arrays_that_are_no_cam_are_refused(heel, points):
    with pytest.raises(gaitcam.InputError):
        gaitcam.inspect(heel, points)


def test_a_file_without_points_is_refused(heel, tmp_path):
    path = tmp_path / "measured.csv"
    for text, help_ in [("a,b\n1,2\n", "x_mm,y_mm"), ("x_mm,y_mm\n1,two\n", "numbers")]:
        path.write_text(text)
        with pytest.raises(gaitcam.InputError, match="measured.csv") as fault:
            gaitcam.inspect(heel, path)
        assert help_ in fault.value.help
    for wrong in ([["a", "b"]], 3, None, np.ones((9, 2)) * 1j):
        with pytest.raises(gaitcam.InputError) as fault:
            gaitcam.inspect(heel, wrong)
        assert fault.value.key == "points"


SCENE = """
[drive]
kind = "fixed-axis"
sped = "60 rpm"
speed = 5
[law]
family = "program"
[[law.segment]]
motion = "cycloidle"
lift = "10 mm"
angle = "180 deg"
[[law.segment]]
motion = "cycloidal"
lift = "-10 mm"
angle = "180 deg"
[limits]
stroke = "10 kg"
"""


def test_every_fault_of_a_scene_is_named_at_once(tmp_path):
    path = tmp_path / "a.toml"
    path.write_text(SCENE)
    found = gaitcam.doctor(path)
    assert len(found) == 4 and {f["mark"] for f in found} == {"bad"}
    assert {"drive.sped", "drive.speed", "limits.stroke"} <= {f["key"] for f in found}
    assert all(f["code"] and f["sentence"] for f in found) and any(f["help"] for f in found)
    spanish = gaitcam.doctor(path, lang="es")
    assert [f["code"] for f in spanish] == [f["code"] for f in found] and spanish != found


def test_a_sound_scene_has_its_verdict_and_a_recording_its_open_questions(footbridge, design, tmp_path):
    for given in (footbridge, "footbridge"):
        verdict = gaitcam.doctor(given)[-1]
        assert (verdict["mark"], verdict["code"], verdict["sentence"]) == ("good", "acceptable", design.reason())
    impossible = gaitcam.doctor(footbridge.set({"limits.stroke": "1 mm"}))[-1]
    assert (impossible["mark"], impossible["code"]) == ("bad", "unacceptable")
    assert not [f for f in gaitcam.doctor(WALK) if f["mark"] == "bad"]
    heavy = gaitcam.Scene({**footbridge.to_dict(), "gait": {"file": str(WALK), "mass": "110 kg"}})
    assert "mass" in [f["code"] for f in gaitcam.doctor(heavy) if f["mark"] == "bad"]
    (tmp_path / "c.csv").write_text("time,Fz\n0,1\n0.1,x\n")
    assert [f["mark"] for f in gaitcam.doctor(tmp_path / "c.csv")] == ["bad"]
    with pytest.raises(gaitcam.InputError):
        gaitcam.doctor(tmp_path / "none.toml")
    with pytest.raises(TypeError):
        gaitcam.doctor(3)
