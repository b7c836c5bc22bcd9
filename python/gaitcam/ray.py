"""Sweeps on Ray Data: ``pip install 'gaitcam[ray]'``."""

import sys
from collections.abc import Callable
from os import PathLike
from typing import Any

from gaitcam import Sweep, blocks
from gaitcam._missing import needed


def sweep(
    plan: Sweep,
    path: str | PathLike[str],
    *,
    block_rows: int = blocks.BLOCK_ROWS,
    progress: Callable[[int, int], object] | None = None,
    **options: Any,
) -> int:
    """Computes the missing blocks of the folder ``path``, one core each. Returns the number of computed rows.

    ``path`` is a folder that every node can access. If a node fails, its task is computed again elsewhere. A driver that is
    started again computes only the missing blocks. ``progress(done, rows)`` is called after each block; ``options`` are
    passed to ``map_batches``.
    """
    ray = needed("ray", "gaitcam[ray]")
    missing = plan.begin(path, block_rows)
    if not missing:
        return 0
    shared = ray.put(plan)  # stored once on each node, with the recordings

    def compute(batch: dict[str, Any]) -> dict[str, list[int]]:
        return {"rows": [blocks.write(ray.get(shared), *missing[i]) for i in batch["id"]]}

    data = needed("ray.data", "gaitcam[ray]")
    context = data.DataContext.get_current()
    shown = context.enable_progress_bars
    # In a log, the progress bars of Ray would fill a page every ten seconds.
    context.enable_progress_bars = shown and sys.stdout.isatty()
    try:
        numbers = data.range(len(missing), override_num_blocks=len(missing))
        results = numbers.map_batches(compute, batch_size=1, **options).iter_rows()
        return blocks.counted((row["rows"] for row in results), missing, progress)
    finally:
        context.enable_progress_bars = shown
