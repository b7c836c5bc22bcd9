"""Writes reports/distributed.md, which docs/distributed.md cites: target/python-tests/bin/python lab/clusters.py

The environment is that of `python/run.sh engines`. Nothing else should run on the machine.
"""

import sys
import tempfile
import time
from pathlib import Path

import distributed
import gaitcam
import gaitcam.dask

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "python" / "tests"))
from test_engines import PLAN, ROWS  # noqa: E402

ROWS_HERE, BLOCK = 64_000, 1_000
ROW = "| {} | {:.0f} /s | {} | {:.2g} € |\n"


def closed(frequencies, rows):
    """Sweep of `rows` closed-form designs for the force of the footbridge with the given step frequencies."""
    weights = [f"{500 + 400 * i / (rows // len(frequencies))} N" for i in range(rows // len(frequencies))]
    scene = gaitcam.Scene.builtin("footbridge").set({"law.family": "harmonic"})
    return gaitcam.Sweep(scene, vary={"gait.step_frequency": frequencies, "gait.body_weight": weights})


def roller(rows):
    """Sweep of splines for a roller with limits of pressure angle, radius of curvature and stroke."""
    scene = gaitcam.Scene.builtin("footbridge").set({
        "cam.follower": "roller-translating", "cam.roller_radius": "10 mm", "limits.pressure_angle": "30 deg", "limits.curvature": "12 mm"})
    return gaitcam.Sweep(scene, vary={"limits.stroke": f"40 mm:60 mm:{rows}"})


def mixed():
    """The sweep of the engine tests with more rows."""
    names = {}
    exec(PLAN.replace(f"sample={ROWS}", f"sample={ROWS_HERE}"), names)
    return names["plan"]


def rate(sweep, rows):
    begun = time.perf_counter()
    sweep.run(jobs=1)
    return rows / (time.perf_counter() - begun)


def on_dask(workers, folder):
    with distributed.LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None,
                                  local_directory=str(folder / "scratch")) as cluster:
        with distributed.Client(cluster) as client:
            begun = time.perf_counter()
            gaitcam.dask.sweep(mixed(), folder / f"of-{workers}", client=client, block_rows=BLOCK)
            return ROWS_HERE / (time.perf_counter() - begun)


def model(name, designs):
    """Duration of 10⁹ designs on 100 machines of 16 cores, and their cost at 0.02 € per core hour."""
    seconds = 1e9 / (1600 * designs)
    took = f"{seconds:.1f} s" if seconds < 100 else f"{seconds / 60:.1f} min"
    return ROW.format(name, designs, took, 1e9 / designs / 3600 * 0.02)


def main():
    page = ("# Sweeps on many machines: what was measured\n\n"
            "Written by `lab/clusters.py` on two cores of an AMD EPYC, without other programs. The table gives the designs per second of one core, the time of 10⁹ designs on 100 machines of 16 cores, and their cost at 0.02 € per core hour.\n\n"
            "| designs | of one core | 10⁹ of them | cost |\n|---|---|---|---|\n")
    many = 131_072
    own = [f"{1.5 + 0.9 * i / many} Hz" for i in range(many)]
    page += model("closed form, every row with a step frequency of its own", rate(closed(own, many), many))
    page += model("closed form, eight step frequencies", rate(closed(own[:: many // 8], many), many))
    page += model("the sweep of the engine tests, half splines under a stroke limit", rate(mixed(), ROWS_HERE))
    page += model("splines for a roller with limits of pressure angle, radius of curvature and stroke", rate(roller(8192), 8192))
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        begun = time.perf_counter()
        gaitcam.blocks.sweep(closed(own, many), folder / "block", block_rows=many)
        took = time.perf_counter() - begun
        size = sum(f.stat().st_size for f in (folder / "block").glob("*.parquet"))
        page += f"\nA block of 131 072 closed forms: {took:.2f} s of a core, {size / 1e6:.1f} MB, {size / many:.0f} bytes a row in Parquet.\n"
        one, two = on_dask(1, folder), on_dask(2, folder)
        page += (f"\nThat sweep, {ROWS_HERE} rows, with Dask on one machine: {one:.0f} designs a second with one worker process, "
                 f"{two:.0f} with two, {two / one:.2f} times as many.\n")
    (ROOT / "reports" / "distributed.md").write_text(page, encoding="utf-8")
    print(page)


if __name__ == "__main__":
    main()
