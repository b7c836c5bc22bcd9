"""Sweeps on dask.distributed: ``pip install 'gaitcam[dask]'``."""

from collections.abc import Callable
from os import PathLike
from typing import Any

from gaitcam import Sweep, blocks
from gaitcam._missing import needed


def sweep(
    plan: Sweep,
    path: str | PathLike[str],
    *,
    client: Any = None,
    block_rows: int = blocks.BLOCK_ROWS,
    retries: int = 5,
    progress: Callable[[int, int], object] | None = None,
) -> int:
    """Computes the missing blocks of the folder ``path``, one task each. Returns the number of computed rows.

    ``path`` is a folder that every worker can access; ``client`` is a ``distributed.Client``, by default the current one. If
    a worker fails, its task is computed again elsewhere. A driver that is started again computes only the missing blocks.
    ``progress(done, rows)`` is called after each block.
    """
    distributed = needed("distributed", "gaitcam[dask]")
    client = client or distributed.Client.current()
    missing = plan.begin(path, block_rows)
    shared = client.scatter(plan, broadcast=True, hash=False)  # sent once to each worker, with the recordings
    tasks = [client.submit(blocks.write, shared, *block, pure=False, retries=retries) for block in missing]
    results = (task.result() for task in distributed.as_completed(tasks))
    return blocks.counted(results, missing, progress)
