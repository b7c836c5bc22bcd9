"""Logs of a running machine, as files and as arrays, one and several."""

import numpy as np
import pytest
from conftest import ROOT

import gaitcam

LOGS = ROOT / "data" / "logs"


def arrays(path):
    names = path.read_text().split("\n", 1)[0].split(",")
    return dict(zip(names, np.loadtxt(path, delimiter=",", skiprows=1, unpack=True)))


def nameless(found):
    """Identified parameters, without the names of the logs."""
    logs = [{k: v for k, v in log.items() if k != "name"} for log in found["logs"]]
    return {**found, "logs": logs}


def value(found, key):
    return next(p for p in found["parameters"] if p["key"] == key)


@pytest.mark.parametrize("name", ["made_log.csv", "made_time.csv", "made_torque.csv"])
def test_arrays_are_read_as_their_file(design, name):
    of_file = gaitcam.identify(design, LOGS / name)
    of_arrays = gaitcam.identify(design, arrays(LOGS / name))
    assert nameless(of_arrays) == nameless(of_file) and of_arrays["logs"][0]["name"] == "log 1"
    assert design.identify([LOGS / name]) == of_file and of_file["cycles"] >= 19


def test_columns_of_pandas_are_a_log(design):
    pandas = pytest.importorskip("pandas")
    frame = pandas.read_csv(LOGS / "made_log.csv")
    assert nameless(gaitcam.identify(design, frame)) == nameless(gaitcam.identify(design, LOGS / "made_log.csv"))


def test_a_known_mass_is_found_and_runs_at_two_speeds_tell_more(design):
    """m (g + ω² s″) with 1.05 of the mass at two speeds. The interval of the mass from both logs is narrower than from one."""
    rng = np.random.default_rng(3)
    own = design.summary["drive"]

    def run(speed):
        time = 0.002 * np.arange(8000)
        theta = speed * time
        force = 1.05 * own["mass_kg"] * (9.81 + speed**2 * design.motion(theta).a) + rng.normal(0, 2, len(time))
        return {"time_s": time, "theta_rad": theta, "force_n": force}

    logs = [run(own["speed_rad_per_s"]), run(0.8 * own["speed_rad_per_s"])]
    one, two = (value(gaitcam.identify(design, given), "drive.mass") for given in (logs[0], logs))
    for mass in (one, two):
        assert mass["low"] <= 1.05 * own["mass_kg"] <= mass["high"]
    assert two["high"] - two["low"] < one["high"] - one["low"]


def test_the_next_cam_is_the_same_from_arrays(design, tmp_path):
    of_file = gaitcam.recut(design, LOGS / "made_log.csv")
    of_arrays = design.recut(arrays(LOGS / "made_log.csv"))
    assert of_arrays.summary["recut"] == of_file.summary["recut"]
    assert of_arrays.summary["law"]["coefficients"] == of_file.summary["law"]["coefficients"]
    log = tmp_path / "law.csv"
    log.write_bytes((LOGS / "made_log.csv").read_bytes())
    with pytest.raises(gaitcam.InputError, match="law.csv"):
        gaitcam.recut(design, [log, LOGS / "made_log.csv"]).save(tmp_path)


def test_columns_of_files_have_names_and_units(design, tmp_path):
    log = arrays(LOGS / "made_log.csv")
    path = tmp_path / "plc.csv"
    rows = np.stack([1e3 * log["time_s"], np.degrees(log["theta_rad"]), 1e-3 * log["force_n"], np.zeros(len(log["time_s"]))], axis=1)
    np.savetxt(path, rows, delimiter=",", header="t [ms],phi [deg],cell A [kN],cell B [kN]", comments="", fmt="%.9g")
    found = gaitcam.identify(design, path, force="cell A [kN]")
    assert value(found, "drive.mass")["value"] == pytest.approx(value(gaitcam.identify(design, log), "drive.mass")["value"], rel=1e-4)
    with pytest.raises(TypeError, match="forse.*force"):
        gaitcam.identify(design, path, forse="cell A [kN]")
    with pytest.raises(TypeError, match="arrays"):
        gaitcam.identify(design, log, force="force_n")


@pytest.mark.parametrize(
    "change, key",
    [
        (lambda log: log.pop("force_n"), "logs"),
        (lambda log: log.update(load=log["force_n"]), "logs"),
        (lambda log: log.update(force_n=log["force_n"][:-1]), None),
        (lambda log: log.update(force_n=np.full(len(log["force_n"]), np.nan)), None),
        (lambda log: log.update(time_s=log["time_s"][::-1]), None),
        (lambda log: [log.pop("time_s"), log.pop("theta_rad")], None),
    ],
)
def test_arrays_that_are_no_log_are_refused(design, change, key):
    log = arrays(LOGS / "made_log.csv")
    change(log)
    for call in (gaitcam.identify, gaitcam.recut):
        with pytest.raises(gaitcam.InputError) as fault:
            call(design, log)
        assert fault.value.key == key
        assert key or "log 1" in fault.value.place
    with pytest.raises(gaitcam.InputError):
        gaitcam.identify(design, [])
    with pytest.raises(TypeError):
        gaitcam.identify(design, 3)
