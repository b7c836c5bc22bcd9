"""Sweeps on real engines: a Ray cluster and Dask processes on this machine, with workers and drivers killed during the sweep."""

import os
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import pytest

import gaitcam

pytestmark = pytest.mark.engines
ROWS, BLOCK = 4_000, 100

PLAN = textwrap.dedent(f"""
    import gaitcam
    plan = gaitcam.Sweep(
        gaitcam.Scene.builtin("footbridge"),
        vary={{"gait.step_frequency": ["1.5 Hz", "2.4 Hz"], "gait.body_weight": ["500 N", "900 N"],
              "limits.stroke": ["45 mm", "120 mm"], "law.family": ["harmonic", "spline"]}},
        sample={ROWS}, seed=11)
""")


def plan() -> gaitcam.Sweep:
    names: dict[str, gaitcam.Sweep] = {}
    exec(PLAN, names)
    return names["plan"]


@pytest.fixture(scope="module")
def whole():
    """Sweep in one process."""
    begun = time.monotonic()
    table = plan().run(jobs=1)
    print(f"\none process, one core: {ROWS / (time.monotonic() - begun):.0f} designs/s")
    return table


def agree(folder: Path, whole: gaitcam.Table) -> None:
    """The blocks together equal the table of one process bit by bit, and each block exists once."""
    import pyarrow.parquet as pq

    union = pq.read_table(folder)
    assert union.num_rows == ROWS == len(whole) and union.column_names == whole.column_names
    for name in whole.column_names:
        column = union.column(name)
        if isinstance(whole[name], list):
            assert column.to_pylist() == whole[name], name
        else:
            assert column.to_numpy().tobytes() == whole[name].tobytes(), name
    assert len(list(folder.glob("*.parquet"))) == ROWS // BLOCK


def blocks(folder: Path) -> int:
    return len(list(folder.glob("rows-*.parquet")))


def wait_for(folder: Path, count: int, process: subprocess.Popen | None = None) -> None:
    end = time.monotonic() + 120
    while blocks(folder) < count:
        assert time.monotonic() < end, "the sweep does not begin"
        assert process is None or process.poll() is None, "the driver ended"
        time.sleep(0.05)


@pytest.fixture
def ray_cluster():
    ray = pytest.importorskip("ray")
    from ray.cluster_utils import Cluster

    os.environ["RAY_DATA_DISABLE_PROGRESS_BARS"] = "1"
    cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 0})
    workers = [cluster.add_node(num_cpus=1) for _ in range(2)]
    cluster.wait_for_nodes()
    yield ray, cluster, workers
    if ray.is_initialized():
        ray.shutdown()
    cluster.shutdown()


def test_ray_loses_nothing_when_a_node_dies(ray_cluster, whole, tmp_path):
    import threading

    import gaitcam.ray

    ray, cluster, workers = ray_cluster
    ray.init(address=cluster.address, log_to_driver=False)

    def kill() -> None:
        wait_for(tmp_path, 4)
        cluster.remove_node(workers[1], allow_graceful=False)

    killer = threading.Thread(target=kill)
    killer.start()
    begun = time.monotonic()
    seen = []
    assert gaitcam.ray.sweep(plan(), tmp_path, block_rows=BLOCK, progress=lambda *rows: seen.append(rows)) == ROWS
    assert seen == [(done, ROWS) for done in range(BLOCK, ROWS + 1, BLOCK)]
    killer.join()
    print(f"\nRay, two workers, one killed: {ROWS / (time.monotonic() - begun):.0f} designs/s")
    agree(tmp_path, whole)
    assert gaitcam.ray.sweep(plan(), tmp_path, block_rows=BLOCK) == 0


def test_ray_goes_on_where_a_killed_driver_stopped(ray_cluster, whole, tmp_path):
    ray, cluster, _ = ray_cluster
    out = tmp_path / "out"
    driver = PLAN + textwrap.dedent(f"""
        import ray, gaitcam.ray
        ray.init(address={cluster.address!r}, log_to_driver=False)
        gaitcam.ray.sweep(plan, {str(out)!r}, block_rows={BLOCK})
    """)
    process = subprocess.Popen([sys.executable, "-c", driver], stderr=subprocess.DEVNULL)
    out.mkdir()
    wait_for(out, 4, process)
    process.kill()
    process.wait()
    done = blocks(out)
    assert 0 < done < ROWS // BLOCK
    times = {p.name: p.stat().st_mtime_ns for p in out.glob("rows-*.parquet")}
    import gaitcam.ray

    ray.init(address=cluster.address, log_to_driver=False)
    computed = gaitcam.ray.sweep(plan(), out, block_rows=BLOCK)
    assert 0 < computed < ROWS
    agree(out, whole)
    kept = {p.name: p.stat().st_mtime_ns for p in out.glob("rows-*.parquet") if p.name in times}
    assert kept == times


@pytest.fixture
def dask_cluster(tmp_path):
    distributed = pytest.importorskip("distributed")
    cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None,
                                       local_directory=str(tmp_path / "scratch"))
    yield distributed, cluster
    cluster.close()


def test_dask_loses_nothing_when_a_worker_dies(dask_cluster, whole, tmp_path):
    import threading

    import gaitcam.dask

    distributed, cluster = dask_cluster
    out = tmp_path / "out"
    out.mkdir()
    with distributed.Client(cluster) as client:
        pids = list(client.run(os.getpid).values())

        def kill() -> None:
            wait_for(out, 4)
            os.kill(pids[1], signal.SIGKILL)

        killer = threading.Thread(target=kill)
        killer.start()
        begun = time.monotonic()
        seen = []
        progress = lambda *rows: seen.append(rows)  # noqa: E731
        assert gaitcam.dask.sweep(plan(), out, client=client, block_rows=BLOCK, progress=progress) == ROWS
        assert seen == [(done, ROWS) for done in range(BLOCK, ROWS + 1, BLOCK)]
        killer.join()
        print(f"\nDask, two workers, one killed and restarted: {ROWS / (time.monotonic() - begun):.0f} designs/s")
        agree(out, whole)
        assert gaitcam.dask.sweep(plan(), out, client=client, block_rows=BLOCK) == 0


def test_dask_goes_on_where_a_killed_driver_stopped(dask_cluster, whole, tmp_path):
    import gaitcam.dask

    distributed, cluster = dask_cluster
    out = tmp_path / "out"
    out.mkdir()
    driver = PLAN + textwrap.dedent(f"""
        import distributed, gaitcam.dask
        client = distributed.Client({cluster.scheduler_address!r})
        gaitcam.dask.sweep(plan, {str(out)!r}, client=client, block_rows={BLOCK})
    """)
    process = subprocess.Popen([sys.executable, "-c", driver], stderr=subprocess.DEVNULL)
    wait_for(out, 4, process)
    process.kill()
    process.wait()
    assert 0 < blocks(out) < ROWS // BLOCK
    with distributed.Client(cluster) as client:
        assert 0 < gaitcam.dask.sweep(plan(), out, client=client, block_rows=BLOCK) < ROWS
    agree(out, whole)
