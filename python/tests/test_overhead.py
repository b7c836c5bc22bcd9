"""What the package costs over the library: measured, with a wide margin for a busy machine."""

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


def best(call, rounds):
    """Shortest time of a call, s."""
    times = []
    for _ in range(rounds):
        begun = time.perf_counter()
        call()
        times.append(time.perf_counter() - begun)
    return min(times)


def told(capsys, text):
    with capsys.disabled():
        print(f"\n{text}")


def test_synth_costs_at_most_a_fifth_over_the_library(bare, capsys):
    scene = gaitcam.Scene.builtin("footbridge")
    mine = best(lambda: gaitcam.synth(scene), 200)
    told(capsys, f"synth: {1e3 * mine:.3f} ms, library {1e3 * bare['synth_s']:.3f} ms: {mine / bare['synth_s'] - 1:+.1%}")
    assert mine <= 1.2 * bare["synth_s"]


def test_a_sweep_costs_at_most_a_tenth_over_the_kernel(bare, capsys):
    scene = gaitcam.Scene.builtin("footbridge").set({"law.family": "harmonic"})
    plan = gaitcam.Sweep(scene, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz"], "gait.body_weight": ["500 N", "900 N"]},
                         sample=100_000)
    mine = best(lambda: plan.run(jobs=1), 7)
    told(capsys, f"100 000 rows: {mine:.3f} s, kernel {bare['sweep_s']:.3f} s: {mine / bare['sweep_s'] - 1:+.1%}")
    assert mine <= 1.1 * bare["sweep_s"]


def test_a_million_rows_become_a_data_frame_in_a_fifth_of_a_second(capsys):
    pd = pytest.importorskip("pandas")
    scene = gaitcam.Scene.builtin("footbridge").set({"law.family": "harmonic"})
    plan = gaitcam.Sweep(scene, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz"], "gait.body_weight": ["500 N", "900 N"]},
                         sample=1_000_000)
    table = plan.run()
    seconds = best(lambda: pd.DataFrame.from_arrow(table), 5)
    frame = pd.DataFrame.from_arrow(table)
    told(capsys, f"1 000 000 rows × {frame.shape[1]} columns to pandas: {seconds:.3f} s")
    assert len(frame) == 1_000_000 and seconds <= 0.2
