"""Several cams for a population."""

import pickle

import numpy as np
import pytest
from test_walkers import walk

import gaitcam

SLOW = [walk(f, 0.25, f"slow {f}") for f in (1.45, 1.5, 1.55)]
QUICK = [walk(f, 0.5, f"quick, {f}") for f in (2.25, 2.3, 2.35)]


@pytest.fixture(scope="module")
def scene():
    return gaitcam.Scene({"drive": {"kind": "moving-axis"}, "law": {"family": "harmonic", "harmonics": 2, "robust": "worst"}})


@pytest.fixture(scope="module")
def found(scene):
    return gaitcam.cover(scene, forces=SLOW + QUICK, cams=3)


def test_two_kinds_of_walkers_get_a_cam_each(found):
    assert list(found.cams["cams"]) == [1, 2, 3]
    worst, bound = found.cams["worst_percent"], found.cams["bound_percent"]
    assert (bound <= worst * (1 + 1e-6)).all() and worst[2] < worst[1] < 0.5 * worst[0]
    rows = [(w, cam) for k, w, cam in zip(*(found.assignment[c] for c in ("cams", "walker", "cam"))) if k == 2]
    groups = {cam: {w for w, c in rows if c == cam} for cam in (1.0, 2.0)}
    assert sorted(groups.values(), key=min) == [{f.name for f in QUICK}, {f.name for f in SLOW}]
    assert set(found.folds["cams"]) <= {1, 2, 3} and (found.folds["out_mean_percent"] > 0).all()


def test_the_cams_of_a_cover_are_designs_for_those_whom_they_serve(scene, found):
    assert [len(cams) for cams in found.designs] == [1, 2, 3]
    for k, cams in enumerate(found.designs, start=1):
        errors = {}
        for design in cams:
            errors |= dict(zip(design.walkers["walker"], design.walkers["rms_error_percent"]))
        stated = [(w, e) for n, w, e in zip(*(found.assignment[c] for c in ("cams", "walker", "rms_error_percent"))) if n == k]
        assert {w for w, _ in stated} == {f.name for f in SLOW + QUICK}
        assert all(errors.get(w, e) == pytest.approx(e, rel=1e-6, abs=1e-9) for w, e in stated)
    cam = found.designs[1][0]
    again = pickle.loads(pickle.dumps(cam))
    assert again.walkers["walker"] == cam.walkers["walker"]
    assert again.summary["law"]["stroke_m"] == pytest.approx(cam.summary["law"]["stroke_m"], rel=1e-6)
    assert cam.files()["law.csv"]


def test_walkers_come_from_the_scene_too_and_some_may_be_left_out(scene):
    frequencies = scene.set({"gait.model": "young", "gait.step_frequency": "1.6 Hz:2.2 Hz:4"})
    assert len(set(gaitcam.cover(frequencies, cams=1).assignment["walker"])) == 4
    rest = gaitcam.cover(scene.set({"gait.leave_out": [QUICK[0].name]}), forces=SLOW + QUICK, cams=1)
    assert set(rest.assignment["walker"]) == {f.name for f in SLOW + QUICK[1:]}


def test_what_is_no_population_is_refused(scene):
    for arguments, key in [({"forces": SLOW[:1]}, "gait.file"), ({"forces": SLOW, "cams": 0}, "cams"), ({"forces": SLOW, "cams": 10**6}, "cams")]:
        with pytest.raises(gaitcam.InputError) as fault:
            gaitcam.cover(scene, **arguments)
        assert fault.value.key == key
    with pytest.raises(gaitcam.InputError):
        gaitcam.cover(scene)
