"""Sweep in blocks: one Parquet file per range of rows, each complete or absent."""

import os
import uuid
from collections.abc import Callable, Iterable, Sequence
from os import PathLike

from gaitcam import Sweep
from gaitcam._missing import needed

#: Default number of rows of a block: one row group.
BLOCK_ROWS = 131_072


def write(plan: Sweep, start: int, stop: int, file: str | PathLike[str]) -> int:
    """Computes a block of ``plan`` on one core and writes the complete ``file``. Returns the number of rows."""
    pyarrow = needed("pyarrow", "gaitcam[arrow]")
    parquet = needed("pyarrow.parquet", "gaitcam[arrow]")
    table = pyarrow.table(plan.run(start, stop, jobs=1))
    folder, name = os.path.split(os.fspath(file))
    partial = os.path.join(folder, f".{name}.{uuid.uuid4().hex}.partial")  # hidden from readers of the folder
    try:
        with open(partial, "xb") as sink:
            parquet.write_table(table, sink, compression="snappy")
            sink.flush()
            os.fsync(sink.fileno())
        os.replace(partial, file)
    except BaseException:
        if os.path.exists(partial):
            os.remove(partial)
        raise
    return stop - start


def counted(
    results: Iterable[int],
    missing: Sequence[tuple[int, int, str | PathLike[str]]],
    progress: Callable[[int, int], object] | None,
) -> int:
    """Sum of the numbers of rows of completed blocks. ``progress(done, rows)`` is called after each block."""
    rows = sum(stop - start for start, stop, _ in missing)
    done = 0
    for result in results:
        done += int(result)
        if progress is not None:
            progress(done, rows)
    return done


def sweep(
    plan: Sweep,
    path: str | PathLike[str],
    *,
    block_rows: int = BLOCK_ROWS,
    progress: Callable[[int, int], object] | None = None,
) -> int:
    """Computes the missing blocks of ``path`` in this process. Returns the number of computed rows.

    ``progress(done, rows)`` is called after each block.
    """
    missing = plan.begin(path, block_rows)
    return counted((write(plan, *block) for block in missing), missing, progress)
