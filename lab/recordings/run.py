#!/usr/bin/env python3
"""Reads generated recordings with known true values with one or more builds and counts right, asked rightly and wrong.

    lab/recordings/run.py BINARY [BINARY2] [--check] [--only WORD] [--keep FOLDER]

It prints a table class x result for each build, every wrong result with a sentence, and coverage and width of the mass interval if
stated. Silent results are wrong ones with a false number and no question. With --check, the exit code is 1 if the last build has a
wrong result. --keep writes the recordings and their true values.
"""

import argparse
import json
import sys
import tempfile
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np

import disturbed  # noqa: F401
import interval  # noqa: F401
import layouts  # noqa: F401
import others  # noqa: F401
import plain  # noqa: F401
from judge import judge
from recording import CASES, build

RESULTS = ("right", "asked", "wrong", "silent")


def one(job):
    """Generates a recording and classifies the results of all builds."""
    at, binaries, keep = job
    recording = build(*CASES[at])
    with tempfile.TemporaryDirectory() as folder:
        if keep:
            folder = Path(keep) / recording.name
            folder.mkdir(parents=True, exist_ok=True)
        for name, data in recording.files.items():
            (Path(folder) / name).write_bytes(data)
        if keep:
            truth = {"args": recording.args, **recording.truth}
            (Path(folder) / "truth.json").write_text(json.dumps(truth, indent=1, default=float) + "\n", encoding="utf-8")
        return recording.group, recording.name, [judge(b, recording, folder) for b in binaries]


def print_counts(binary, judged, k):
    counts = defaultdict(lambda: dict.fromkeys(RESULTS, 0))
    for group, _, verdicts in judged:
        counts[group][verdicts[k].result] += 1
        counts[group]["silent"] += verdicts[k].silent
    print(f"\n{binary}\n{'class':28}" + "".join(f"{r:>8}" for r in RESULTS))
    for group in sorted(counts):
        print(f"{group:28}" + "".join(f"{counts[group][r]:8d}" for r in RESULTS))
    print(f"{'all':28}" + "".join(f"{sum(c[r] for c in counts.values()):8d}" for r in RESULTS))
    for group, name, verdicts in judged:
        if verdicts[k].result == "wrong":
            print(f"  wrong  {group} / {name}: {verdicts[k].why}")


def print_intervals(judged, k):
    """Share of intervals that contain the true mass, and their median width, for each class that states any."""
    stated = defaultdict(list)
    for group, _, verdicts in judged:
        if verdicts[k].interval:
            stated[group].append(verdicts[k].interval)
            stated["5 all" if group.startswith("5") else "0 to 4 all"].append(verdicts[k].interval)
    if not stated:
        print("no interval of the mass is stated")
        return
    print(f"{'interval of the mass':28}{'n':>6}{'holds truth':>13}{'median width':>14}")
    for group in sorted(stated):
        true, low, high = np.array(stated[group]).T
        holds = 100 * np.mean((low <= true) & (true <= high))
        print(f"{group:28}{len(true):6d}{holds:11.1f} %{100 * np.median((high - low) / true):12.1f} %")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binary", nargs="+", type=lambda p: Path(p).resolve())
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--only", default="", help="classes or names that contain a word")
    parser.add_argument("--keep")
    args = parser.parse_args()
    chosen = [i for i, (group, make, _) in enumerate(CASES) if args.only in f"{group} {make.__name__.replace('_', '-')}"]
    with ProcessPoolExecutor(2) as pool:
        judged = list(pool.map(one, [(i, args.binary, args.keep) for i in chosen], chunksize=4))
    judged.sort(key=lambda j: j[:2])
    for k, binary in enumerate(args.binary):
        print_counts(binary, judged, k)
        print_intervals(judged, k)
    sys.exit(args.check and any(j[2][-1].result == "wrong" for j in judged))


if __name__ == "__main__":
    main()
