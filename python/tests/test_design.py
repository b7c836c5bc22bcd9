"""Designs: the results of synth equal those of the command."""

import json
import os
import pickle
from pathlib import Path

import numpy as np
import pytest

import gaitcam

T = np.arange(540) * 0.001
F = 700 + 250 * np.sin(2 * np.pi * T / 0.54)


def test_the_default_scene_is_acceptable_and_meets_its_accuracy(design):
    assert design.verdict == "acceptable"
    summary = design.summary
    assert summary["force"]["rms_error_percent_of_mean"] <= 0.5
    assert summary["outcome"] == "built" and all(c["pass"] for c in design.checks)
    assert design.reason("es") != design.reason()


def test_a_log_gives_the_machine_and_the_next_cam(tmp_path):
    scene = gaitcam.Scene.builtin("footbridge")
    design = gaitcam.synth(scene)
    law = design.law
    theta = 2 * np.pi * 1.85 * np.arange(6000) / 600
    mean = np.interp(theta % (2 * np.pi), law["theta_rad"], law["force_n"], period=2 * np.pi)
    scatter = np.random.default_rng(1).normal(0, 2, theta.size)

    def log(repeats):
        force = mean + repeats * np.sin(2 * theta) + scatter
        rows = np.column_stack([np.arange(6000) / 600, theta % (2 * np.pi), force])
        path = tmp_path / f"log{repeats}.csv"
        np.savetxt(path, rows, fmt="%.5f", delimiter=",", header="time_s,theta_rad,force_n", comments="")
        return path

    found = design.identify(log(9))
    mass = next(p for p in found["parameters"] if p["key"] == "drive.mass")
    assert mass["low"] <= 700 / 9.81 <= mass["high"] and found["noise_rms_n"] == pytest.approx(2, rel=0.1)
    cut = design.recut(log(9))
    assert cut.summary["recut"]["predicted_rms_n"] < 3.6 < 6 < cut.summary["recut"]["before_rms_n"]
    assert cut.verdict == "acceptable" and "recut" not in design.summary
    assert pickle.loads(pickle.dumps(cut)).summary["recut"] == cut.summary["recut"]
    with pytest.raises(gaitcam.NoSuchCam, match="noise"):
        design.recut(log(0))
    (tmp_path / "bad.csv").write_text("time_s,force_n\n0,1\n")
    with pytest.raises(gaitcam.InputError) as fault:
        design.identify(tmp_path / "bad.csv")
    assert fault.value.code == "log-few-rows"


def test_tables_are_the_law_and_the_profile(design):
    law, profile = design.law, design.profile
    assert law.column_names == [
        *("theta_rad", "s_m", "v_m_per_rad", "a_m_per_rad2", "j_m_per_rad3", "force_n", "target_n"),
        *("time_s", "speed_rad_per_s"),
    ]
    assert np.allclose(law["time_s"] * law["speed_rad_per_s"], law["theta_rad"], rtol=1e-12)
    assert len(law) == len(profile) == 1440
    s, v, a, j = design.motion(law["theta_rad"])
    for name, values in zip(law.column_names[1:5], (s, v, a, j)):
        assert np.array_equal(law[name], values)
    # Flat face: contact at (v, Rb + s), rotated by −θ into the frame of the cam.
    theta, rb = law["theta_rad"], design.summary["cam"]["base_radius_m"]
    x = np.cos(theta) * law["v_m_per_rad"] + np.sin(theta) * (rb + law["s_m"])
    y = -np.sin(theta) * law["v_m_per_rad"] + np.cos(theta) * (rb + law["s_m"])
    assert profile["x_m"] == pytest.approx(x, abs=1e-12) and profile["y_m"] == pytest.approx(y, abs=1e-12)
    # Force of a moving axis: M (g + ω² a).
    drive = design.summary["drive"]
    force = drive["mass_kg"] * (9.81 + drive["speed_rad_per_s"] ** 2 * law["a_m_per_rad2"])
    assert law["force_n"] == pytest.approx(force, rel=1e-3)
    error = np.sqrt(np.mean((law["force_n"] - law["target_n"]) ** 2))
    assert error == pytest.approx(design.summary["force"]["rms_error_n"], rel=0.02)
    fine, _ = design.tables(7200)
    assert fine["s_m"][::5] == pytest.approx(law["s_m"], abs=1e-15)


def test_saved_files_are_those_in_memory_and_can_be_loaded(design, tmp_path):
    folder = design.save(tmp_path / "out", solid=True)
    files = design.files(png=True, solid=True)
    assert set(os.listdir(folder)) == set(files)
    times = {"summary.json", "report.html", "profile.xlsx"}
    for name in set(files) - times:
        assert (folder / name).read_bytes() == files[name], name
    summary = json.loads((folder / "summary.json").read_text())
    assert summary["verdict"] == design.verdict
    again = gaitcam.Scene.load(folder / "summary.json")
    assert gaitcam.synth(again).summary["law"] == design.summary["law"]


def test_an_input_is_never_overwritten(tmp_path):
    (tmp_path / "law.csv").write_text("# cycle, period_s = 0.54\ntime_s,force_n\n" + "".join(
        f"{t},{f}\n" for t, f in zip(T, F)))
    (tmp_path / "scene.toml").write_text('[gait]\nfile = "law.csv"\n')
    design = gaitcam.synth(gaitcam.Scene.load(tmp_path / "scene.toml"))
    before = (tmp_path / "law.csv").read_bytes()
    with pytest.raises(gaitcam.InputError, match="never overwritten"):
        design.save(tmp_path)
    assert (tmp_path / "law.csv").read_bytes() == before


def test_a_force_from_arrays_takes_the_place_of_the_scene_s_own(footbridge, tmp_path):
    force = gaitcam.Force(T, F)
    design = gaitcam.synth(footbridge, force=force)
    law = design.law
    assert law["target_n"] == pytest.approx(force(law["theta_rad"]), abs=1e-9)
    assert design.summary["drive"]["speed_rad_per_s"] == pytest.approx(2 * np.pi / 0.54, rel=1e-9)
    # Law of a single sine: s = −A sin θ/(M ω²) + constant.
    amplitude = 250 / (700 / 9.81 * (2 * np.pi / 0.54) ** 2)
    assert design.summary["law"]["stroke_m"] == pytest.approx(2 * amplitude, rel=2e-3)
    # The saved folder is complete: its scene refers to the force file beside it.
    folder = design.save(tmp_path / "sine", png=False)
    again = gaitcam.synth(gaitcam.Scene.load(folder / "scene.toml"))
    assert again.summary["law"]["stroke_m"] == pytest.approx(design.summary["law"]["stroke_m"], rel=1e-9)


def test_a_scene_without_a_gait_takes_a_force():
    design = gaitcam.synth(gaitcam.Scene(), force=gaitcam.Force(T, F))
    assert design.summary["force"]["target_mean_n"] == pytest.approx(700, rel=1e-9)
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.synth(gaitcam.Scene())
    assert fault.value.key == "gait" and "force" in str(fault.value)


def test_designs_and_their_questions_are_pickled(design, footbridge):
    again = pickle.loads(pickle.dumps(design))
    strip = lambda d: {k: v for k, v in d.items() if k not in ("time", "solver")}
    assert strip(again.summary) == strip(design.summary)
    given = gaitcam.synth(footbridge, force=gaitcam.Force(T, F))
    again = pickle.loads(pickle.dumps(given))
    assert np.array_equal(again.law["s_m"], given.law["s_m"])


def test_laws_and_runs_are_pickled(design):
    theta = np.linspace(0, 6, 50)
    program = gaitcam.program([("cycloidal", "20 mm", "180 deg"), ("3-4-5", -0.02, np.pi)])
    for law in (design.motion, gaitcam.Law("scca 0.25 0.25 0.5"), gaitcam.laws()["modified-sine"], program):
        again = pickle.loads(pickle.dumps(law))
        x = theta / 6 if law.factors else theta
        assert again.name == law.name and all(np.array_equal(a, b) for a, b in zip(again(x), law(x)))
    for machine in (None, {"drive.speed": "60 rpm"}):
        run = gaitcam.simulate(design, "rigid", machine=machine)
        again = pickle.loads(pickle.dumps(run))
        assert again.summary == run.summary
        assert np.array_equal(again.table["torque_nm"], run.table["torque_nm"])


def test_tables_of_an_arm_have_its_units():
    arm = {"follower": "roller-oscillating", "roller_radius": "10 mm", "pivot_distance": "120 mm", "arm": "100 mm"}
    drive = {"kind": "fixed-axis", "spring_rate": "300 N m/rad", "lever": "80 mm"}
    design = gaitcam.synth(gaitcam.Scene({"gait": {"model": "young", "step_frequency": "1.85 Hz", "body_weight": "700 N"}, "drive": drive, "cam": arm}))
    assert design.law["force_n"] == pytest.approx(300 * design.law["s_rad"] / 0.08)
    table = gaitcam.simulate(design, "rigid").table
    assert table["contact_force_n"] == pytest.approx(300 * table["lift_rad"] / 0.08, rel=1e-6)
    assert np.mean(table["contact_force_n"]) == pytest.approx(design.summary["force"]["mean_n"], rel=1e-6)
    assert "gap_rad" in table.column_names and "lift_m" not in table.column_names
    assert "N·m" in gaitcam.simulate(design, "rigid")._repr_html_()


def test_a_scene_that_no_cam_answers_says_which_limits_conflict(footbridge):
    # A double integrator needs 49 mm for this force.
    design = gaitcam.synth(footbridge.set({"limits.stroke": "5 mm", "gait.band": "20 N", "law.spans": 8}))
    assert design.verdict == "unacceptable"
    assert design.summary["outcome"] == "infeasible"
    assert "stroke" in json.dumps(design.summary["infeasible"])
    with pytest.raises(gaitcam.NoSuchCam):
        gaitcam.simulate(design)
    with pytest.raises(gaitcam.NoSuchCam):
        design.profile
    assert "unacceptable" in design._repr_html_()
    assert "report.html" in design.files() and "profile.dxf" not in design.files()


@pytest.mark.parametrize(
    ("name", "changes", "key"),
    [
        ("camdas_01_roller", {"law.segment.1.motion": "constant-velocity"}, "law.segment"),
        ("camdas_01_roller", {"law.segment.2.lift": "-49 mm"}, "law.segment"),
        ("camdas_02_oscillating_roller", {"cam.arm": "20 mm"}, "cam"),
        ("camdas_02_oscillating_roller", {"cam.base_radius": "auto", "limits.curvature": "10 m"}, "cam.base_radius"),
        ("camdas_08_conjugate_flat", {"cam.conjugate.distance": "140 mm"}, "cam.conjugate"),
        ("thesis_barrel", {"cam.depth": "200 mm"}, "cam.depth"),
    ],
)
def test_a_scene_without_a_cam_is_a_design_that_says_why(name, changes, key, tmp_path):
    design = gaitcam.synth(gaitcam.Scene.builtin(name).set(changes))
    summary = design.summary
    assert design.verdict == summary["verdict"] == "unacceptable"
    assert summary["outcome"] == "infeasible" and summary["reasons"][0]["key"] == key
    assert design.name == name and key in design.reason() and design.reason("es") != design.reason()
    assert "unacceptable" in design._repr_html_() and "unacceptable" in repr(design)
    assert set(design.files()) == {"scene.toml", "summary.json"}
    design.save(tmp_path / "out")
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["reasons"] == summary["reasons"]
    for shown in (
        lambda: design.law,
        lambda: design.profile,
        lambda: design.motion,
        lambda: design.checks,
        lambda: design.tables(90),
        lambda: gaitcam.simulate(design),
    ):
        with pytest.raises(gaitcam.NoSuchCam):
            shown()


def test_every_result_shows_itself_in_a_notebook(design, footbridge):
    plan = gaitcam.Sweep(footbridge, vary={"gait.body_weight": ["600 N", "800 N", 25], "law.family": ["harmonic"]})
    table = plan.run()
    front = gaitcam.front(table, "stroke")
    shown = table._repr_html_()
    assert shown.count("<tr>") == 12 and "…" in shown and "<td>acceptable</td>" in shown
    assert all(f"<th>{name}</th>" in shown for name in table.column_names)
    assert front._repr_html_().count("<tr>") == 1 + len(front)
    assert f"{front.values[0][0]:.4f}"[:6] in front._repr_html_()
    assert "gait.body_weight" in plan._repr_html_() and "footbridge" in plan._repr_html_()
    small = gaitcam.Table({"a<b": [1.0, 2.0]})._repr_html_()
    assert small.count("<tr>") == 3 and "a&lt;b" in small and "…" not in small


@pytest.mark.parametrize("wrong", ["footbridge", {"name": "x"}, 3, b"x", ["footbridge"]])
def test_what_is_no_object_of_the_package_is_refused_with_how_one_is_made(design, footbridge, wrong):
    calls = {
        "scene": [lambda: gaitcam.synth(wrong), lambda: gaitcam.Sweep(wrong)],
        "force": [lambda: gaitcam.synth(footbridge, force=wrong), lambda: gaitcam.Sweep(footbridge, force=wrong)],
        "design": [lambda: gaitcam.simulate(wrong)],
    }
    for name, all_of_it in calls.items():
        for call in all_of_it:
            with pytest.raises(TypeError, match=rf"^{name}: a {name.capitalize()}, not .*; .*make"):
                call()


def test_a_notebook_shows_verdict_and_pictures(design):
    html = design._repr_html_()
    assert "acceptable" in html and html.count("<svg") == 3 and "<script" not in html


def test_the_emitted_cam_runs_and_presses_as_its_law(design):
    run = gaitcam.simulate(design, model="rigid")
    assert run.model == "rigid" and not run.contact_lost and run.verdict == "acceptable"
    force = design.summary["force"]
    assert run.summary["force"]["max"] == pytest.approx(force["max_n"], rel=1e-3)
    assert len(run.table["theta_rad"]) == len(run.table) > 0
    assert "<pre>" in run._repr_html_()


def test_another_machine_runs_the_same_cam(design):
    slow = design.summary["drive"]["speed_rad_per_s"]
    lift_off = gaitcam.simulate(design).summary["liftoff_speed_rad_per_s"]
    assert lift_off > slow
    fast = gaitcam.simulate(design, machine={"drive.speed": f"{1.2 * lift_off} rad/s"})
    assert fast.contact_lost and fast.verdict == "unacceptable"
    heavy = gaitcam.simulate(design, model="rigid", machine={"drive.mass": "142 kg"})
    plain = gaitcam.simulate(design, model="rigid")
    mass = design.summary["drive"]["mass_kg"]
    assert heavy.summary["force"]["max"] == pytest.approx(plain.summary["force"]["max"] * 142 / mass, rel=1e-6)
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.simulate(design, machine={"limits.stroke": "3 mm"})
    assert fault.value.key == "limits.stroke"
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.simulate(design, model="rigit")
    assert fault.value.key == "model"


def test_the_path_of_a_wire_and_splines_come_as_the_command_writes_them(design, tmp_path: Path):
    usual, asked = design.files(), design.files(wire="0.14 mm", dxf="splines", cut_only=True)
    assert asked.keys() - usual.keys() == {"wire.nc"}
    assert asked["wire.nc"] == design.files(wire=0.14e-3)["wire.nc"] != design.files(wire="0.2 mm")["wire.nc"]
    assert b"SPLINE" in asked["profile.dxf"] and b"AC1015" in asked["profile.dxf"]
    assert b"SPLINE" not in usual["profile.dxf"]
    def layers(dxf: bytes) -> set[bytes]:
        lines = [line.strip() for line in dxf.split(b"\n")]
        entities = lines[lines.index(b"ENTITIES"):]
        return {name for code, name in zip(entities[1::2], entities[2::2]) if code == b"8"}
    assert any(name.startswith(b"REF_") for name in layers(usual["profile.dxf"]))
    assert all(name.startswith(b"CUT_") for name in layers(asked["profile.dxf"]))
    folder = design.save(tmp_path, png=False, wire="0.14 mm", dxf="splines", cut_only=True)
    for name in ("wire.nc", "profile.dxf"):
        assert Path(folder, name).read_bytes() == asked[name]


@pytest.mark.parametrize("call", [
    lambda d, s: gaitcam.synth("footbridge"),
    lambda d, s: gaitcam.synth(s, force=F),
    lambda d, s: gaitcam.synth(s, time_limit="long"),
    lambda d, s: gaitcam.synth(s, force=gaitcam.Force(T, F), forces=[gaitcam.Force(T, F)]),
    lambda d, s: gaitcam.synth(s, forces=[F]),
    lambda d, s: gaitcam.simulate(s),
    lambda d, s: d.save(3),
    lambda d, s: d.files(points="many"),
])
def test_arguments_of_the_wrong_type_are_type_errors(design, footbridge, call):
    with pytest.raises(TypeError):
        call(design, footbridge)


@pytest.mark.parametrize("call, key", [
    (lambda d, s: gaitcam.synth(s, time_limit=0), "time_limit"),
    (lambda d, s: gaitcam.synth(s, time_limit=float("nan")), "time_limit"),
    (lambda d, s: d.files(points=3), "points"),
    (lambda d, s: d.files(lang="fr"), "lang"),
    (lambda d, s: d.files(tool="3 kg"), "tool"),
    (lambda d, s: d.files(wire="3 kg"), "wire"),
    (lambda d, s: d.files(dxf="circles"), "dxf"),
    (lambda d, s: d.tables(2), "points"),
])
def test_arguments_of_the_wrong_value_are_named(design, footbridge, call, key):
    with pytest.raises(gaitcam.InputError) as fault:
        call(design, footbridge)
    assert fault.value.key == key


def test_no_file_is_left_where_a_folder_cannot_be_written(design, tmp_path: Path):
    place = tmp_path / "file"
    place.write_text("mine")
    with pytest.raises(gaitcam.InputError):
        design.save(place)
    assert place.read_text() == "mine"


@pytest.mark.parametrize("dialect", ["codesys", "twincat", "segments", "rockwell", "csv"])
def test_an_electronic_cam_is_the_file_of_the_command_with_its_error(design, dialect):
    cam = design.ecam(dialect)
    assert cam["dialect"] == dialect and cam["file"].startswith(f"ecam_{dialect}.")
    assert cam["text"] and cam["points"] >= 4
    # The controller adds little to the error of the law.
    own = design.summary["force"]["rms_error_n"]
    assert cam["rms_error_n"] == pytest.approx(own, abs=cam["added_rms_n"] + 1e-9)
    assert cam["added_percent"] < 0.5


def test_an_electronic_cam_that_cannot_be_is_refused_with_a_sufficient_one(design):
    for arguments, key in [(("siemens",), "dialect"), (("csv", 2), "points"), (("csv", 8), "points")]:
        with pytest.raises(gaitcam.InputError) as fault:
            design.ecam(*arguments)
        assert fault.value.key == key
    assert design.ecam("csv", 360)["points"] == 360
