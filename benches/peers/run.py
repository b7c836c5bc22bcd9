#!/usr/bin/env python3
"""Holds gaitcam against other programs on the same tasks, on this machine.

    cargo build --release && python3 benches/peers/run.py [--out reports]

A temporary virtual environment is made and the peers are installed into it by name; what cannot be
installed is reported as "skipped". gaitcam is measured by `gaitcam chart`'s own benchmark
(`cargo bench --bench peers`), which prints one line of JSON per task.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import venv

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PEERS = [
    ("cvxpy + Clarabel", ["cvxpy", "clarabel"], "fit_cvxpy.py"),
    ("scipy spline least squares", ["scipy"], "fit_scipy.py"),
    ("mechanism (PyPI)", ["mechanism"], "cam_mechanism.py"),
]


def ours():
    """Task name -> {seconds, error} from the Rust benchmark."""
    run = subprocess.run(
        ["cargo", "bench", "--quiet", "--bench", "peers"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    )
    lines = [l for l in run.stdout.splitlines() if l.startswith("{")]
    return {row["task"]: row for row in map(json.loads, lines)}


def peer(python, names, script):
    """The peer's rows, or why it was skipped."""
    install = subprocess.run(
        [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *names],
        capture_output=True, text=True,
    )
    if install.returncode:
        words = install.stderr.strip().splitlines() or ["pip failed"]
        return [], f"skipped: {words[-1][:120]}"
    run = subprocess.run([python, HERE / script], capture_output=True, text=True)
    if run.returncode:
        words = run.stderr.strip().splitlines() or ["no word"]
        return [], f"skipped: {words[-1][:120]}"
    rows = [json.loads(l) for l in run.stdout.splitlines() if l.startswith("{")]
    return rows, ""


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--out", type=pathlib.Path, default=ROOT / "reports")
    out = arguments.parse_args().out
    mine = ours()
    lines = [
        "# gaitcam and its peers",
        "",
        "Written by `python3 benches/peers/run.py`: the same tasks, one after the other on one machine; "
        "medians of repeated runs inside one process after a warm-up.",
        "",
        "| task | peer | its time | its error | gaitcam | its error | faster by |",
        "|---|---|---|---|---|---|---|",
    ]
    with tempfile.TemporaryDirectory() as folder:
        for name, packages, script in PEERS:
            home = pathlib.Path(folder) / script.split(".")[0]
            venv.create(home, with_pip=True)
            rows, why = peer(str(home / "bin" / "python"), packages, script)
            if why:
                print(f"{name}: {why}")
                lines.append(f"| — | {name} | {why} | | | | |")
            for row in rows:
                own = mine[row["task"]]
                ratio = row["seconds"] / own["seconds"]
                print(f"{name}: {row['task']}: {ratio:.1f} times")
                lines.append(
                    f"| {row['task']} | {name} {row['version']} | {1e3 * row['seconds']:.3f} ms | {row['error']} "
                    f"| {1e3 * own['seconds']:.4f} ms | {own['error']} | {ratio:.0f} |"
                )
    out.mkdir(parents=True, exist_ok=True)
    (out / "peers.md").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    sys.exit(main())
