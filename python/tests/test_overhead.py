"""Overhead of the package over the library in processor time."""

import json
import os
import subprocess
import time

import pytest

import gaitcam

pytestmark = pytest.mark.overhead
# The example `overhead` of the library measures the same calls without Python.
BARE = os.environ.get("GAITCAM_OVERHEAD")


@pytest.fixture(scope="module")
def bare():
    if not BARE:
        pytest.fail("GAITCAM_OVERHEAD names the program target/release/examples/overhead")
    return json.loads(subprocess.run([BARE], capture_output=True, check=True, text=True).stdout)


def mean(call, rounds):
    """Mean processor time of a call, s. The load of the machine has no influence on it."""
    call()
    begun = time.process_time()
    for _ in range(rounds):
        call()
    return (time.process_time() - begun) / rounds


def told(capsys, text):
    with capsys.disabled():
        print(f"\n{text}")


def test_synth_costs_at_most_a_fifth_over_the_library(bare, capsys):
    scene = gaitcam.Scene.builtin("footbridge")
    mine = mean(lambda: gaitcam.synth(scene), 2000)
    told(capsys, f"synth: {1e3 * mine:.3f} ms, library {1e3 * bare['synth_s']:.3f} ms: {mine / bare['synth_s'] - 1:+.1%}")
    assert mine <= 1.2 * bare["synth_s"]


def test_a_sweep_costs_at_most_a_tenth_over_the_kernel(bare, capsys):
    scene = gaitcam.Scene.builtin("footbridge").set({"law.family": "harmonic"})
    plan = gaitcam.Sweep(scene, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz"], "gait.body_weight": ["500 N", "900 N"]},
                         sample=100_000)
    mine = mean(lambda: plan.run(jobs=1), 5)
    told(capsys, f"100 000 rows: {mine:.3f} s, kernel {bare['sweep_s']:.3f} s: {mine / bare['sweep_s'] - 1:+.1%}")
    assert mine <= 1.1 * bare["sweep_s"]


def test_a_million_rows_become_a_data_frame_in_a_fifth_of_a_second(capsys):
    pd = pytest.importorskip("pandas")
    scene = gaitcam.Scene.builtin("footbridge").set({"law.family": "harmonic"})
    plan = gaitcam.Sweep(scene, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz"], "gait.body_weight": ["500 N", "900 N"]},
                         sample=1_000_000)
    table = plan.run()
    seconds = mean(lambda: pd.DataFrame.from_arrow(table), 5)
    frame = pd.DataFrame.from_arrow(table)
    told(capsys, f"1 000 000 rows × {frame.shape[1]} columns to pandas: {seconds:.3f} s")
    assert len(frame) == 1_000_000 and seconds <= 0.2
