"""Threads, memory and Ctrl-C."""

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy as np
import pytest

import gaitcam


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(sys.platform != "linux", reason="memory is read from /proc")
def test_a_hundred_thousand_designs_leave_memory_flat(spectral):
    plan = gaitcam.Sweep(spectral, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz"]}, sample=100_000)
    pa = pytest.importorskip("pyarrow")

    def round_(start):
        table = plan.run(start, start + 5000)
        pa.table(table).column("stroke_m").to_numpy()
        assert table["row"][0] == start

    for start in range(0, 20_000, 5000):
        round_(start)
    before = resident()
    for start in range(0, 100_000, 5000):
        round_(start)
    # A leak of one table of 5000 rows per round would be 27 MB.
    assert resident() - before < 12e6


@pytest.mark.skipif(sys.platform != "linux", reason="memory is read from /proc")
def test_designs_errors_and_laws_leave_memory_flat(spectral):
    def some():
        for _ in range(100):
            design = gaitcam.synth(spectral)
            design.law["s_m"], design.summary, design.motion(0.3)
            with pytest.raises(gaitcam.InputError):
                spectral.set({"limits.strok": "3 mm"})

    some()
    before = resident()
    for _ in range(4):
        some()
    assert resident() - before < 8e6


def test_eight_threads_give_what_one_gives(footbridge):
    strokes = [f"{s} mm" for s in range(46, 62, 2)]
    alone = [gaitcam.synth(footbridge.set({"limits.stroke": s})).law["s_m"] for s in strokes]
    found = [None] * 8

    def work(i):
        found[i] = gaitcam.synth(footbridge.set({"limits.stroke": strokes[i]})).law["s_m"]

    threads = [threading.Thread(target=work, args=(i,)) for i in range(8)]
    [t.start() for t in threads]
    [t.join() for t in threads]
    assert all(np.array_equal(a, b) for a, b in zip(alone, found))


def test_other_threads_run_while_a_sweep_computes(spectral):
    plan = gaitcam.Sweep(spectral, vary={"gait.step_frequency": ["1.5 Hz", "2.4 Hz"]}, sample=100_000)
    done = threading.Event()
    worker = threading.Thread(target=lambda: (plan.run(jobs=1), done.set()))
    worker.start()
    ticks = 0
    while not done.is_set():
        time.sleep(0.001)
        ticks += 1
    worker.join()
    assert ticks > 5


LONG = {
    "sweep": "gaitcam.Sweep(s, vary={'gait.step_frequency': ['1.5 Hz', '2.4 Hz']}, sample=200_000_000).run(jobs=JOBS)",
    "rows": "gaitcam.Sweep(vary={'gait.step_frequency': ['1.5 Hz', '2.4 Hz'], 'limits.stroke': ['5 mm', '40 mm'], "
            "'limits.jerk': ['20 m/s^3', '200 m/s^3']}, sample=1_000_000).run(jobs=JOBS)",
}


@pytest.mark.parametrize("call", LONG)
@pytest.mark.parametrize("jobs", [1, 2])
def test_ctrl_c_ends_a_long_call_at_once(call, jobs):
    program = textwrap.dedent(f"""
        import gaitcam, time
        s = gaitcam.Scene.builtin("footbridge").set({{"law.family": "harmonic"}})
        print("ready", flush=True)
        try:
            {LONG[call].replace("JOBS", str(jobs))}
        except KeyboardInterrupt:
            print("interrupted", flush=True)
    """)
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "ready\n"
    time.sleep(1.5)
    assert child.poll() is None, "the call was not long"
    begun = time.monotonic()
    child.send_signal(signal.SIGINT)
    assert child.stdout.readline() == "interrupted\n"
    assert time.monotonic() - begun < 8
    assert child.wait(timeout=20) == 0


def test_an_internal_error_is_an_exception_that_programs_catch():
    from gaitcam import _native

    with pytest.raises(Exception, match="internal error") as caught:  # noqa: B017, PT011
        _native._panic()
    assert type(caught.value) is gaitcam.InternalError
    assert gaitcam.synth().verdict == "acceptable"
