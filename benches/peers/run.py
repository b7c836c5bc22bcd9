#!/usr/bin/env python3
"""Holds gaitcam against other programs on the same tasks, on this machine.

    cargo build --release && python3 benches/peers/run.py [--out reports]

A temporary virtual environment is made for each peer and the peer is installed into it by name; what cannot
be installed is reported as "skipped". gaitcam is measured by `cargo bench --bench peers`, which prints one
line of JSON per task, before and after the peers; the slower of its two medians counts. The table becomes the
section "Peers" of speed_accuracy.md, which `gaitcam chart` keeps.
"""

import argparse
import csv
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
# What was asked: faster by at least.
ASKED = {"fit_cvxpy.py": 50, "fit_scipy.py": 5, "cam_mechanism.py": 10}
SECTION = "\n## Peers\n"


def ours():
    """Task name -> {seconds, error} from the Rust benchmark."""
    run = subprocess.run(
        ["cargo", "bench", "--quiet", "--bench", "peers"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    )
    lines = [l for l in run.stdout.splitlines() if l.startswith("{")]
    return {row["task"]: row for row in map(json.loads, lines)}


def integrators():
    """Rows of the crate ode_solvers on chart (d1)'s follower, or why it was skipped."""
    run = subprocess.run(
        ["cargo", "run", "--quiet", "--release", "--manifest-path", str(ROOT / "benches/ode/Cargo.toml")],
        capture_output=True, text=True,
    )
    if run.returncode:
        words = run.stderr.strip().splitlines() or ["no word"]
        return [], f"skipped: {words[-1][:120]}"
    return [json.loads(l) for l in run.stdout.splitlines() if l.startswith("{")], ""


def closed_form(out):
    """Time and error of gaitcam's own way on chart (d1), from the chart's last run."""
    table = out / "speed_accuracy.csv"
    rows = csv.DictReader(table.open()) if table.exists() else []
    own = [r for r in rows if r["chart"].endswith("_d1") and r["method"] == "closed form"]
    return own[0] if own else None


def slower(one, two):
    """Of two runs of ours, task by task, the slower."""
    return {task: max(row, two[task], key=lambda r: r["seconds"]) for task, row in one.items()}


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
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for name, packages, script in PEERS:
            home = pathlib.Path(folder) / script.split(".")[0]
            venv.create(home, with_pip=True)
            found.append((name, script, *peer(str(home / "bin" / "python"), packages, script)))
    mine = slower(mine, ours())
    lines = [
        "Written by `python3 benches/peers/run.py` in one run: the same tasks, one after the other on one machine; "
        "medians of repeated runs inside one process after a warm-up. gaitcam was measured before and after its "
        "peers; the slower median stands here.",
        "",
        "| task | peer | its time | its error | gaitcam | its error | faster by | asked |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for name, script, rows, why in found:
        if why:
            print(f"{name}: {why}")
            lines.append(f"| — | {name} | {why} | | | | | {ASKED[script]} |")
        for row in rows:
            own = mine[row["task"]]
            ratio = row["seconds"] / own["seconds"]
            print(f"{name}: {row['task']}: {ratio:.1f} times")
            lines.append(
                f"| {row['task']} | {name} {row['version']} | {1e3 * row['seconds']:.3f} ms | {row['error']} "
                f"| {1e3 * own['seconds']:.4f} ms | {own['error']} | {ratio:.1f} | {ASKED[script]} |"
            )
    lines += [
        "",
        "Adaptive integrators of the crate `ode_solvers` (benches/ode) on the follower of chart (d1), error of the "
        "state after one turn:",
        "",
        "| method | its time | its error |",
        "|---|---|---|",
    ]
    own = closed_form(out)
    if own:
        lines.append(f"| gaitcam, closed form (chart d1) | {1e6 * float(own['median_s']):.1f} µs | {float(own['error']):.1e} |")
    rows, why = integrators()
    if why:
        print(f"ode_solvers: {why}")
        lines.append(f"| ode_solvers | {why} | |")
    for row in rows:
        lines.append(f"| {row['method']} | {1e6 * row['seconds']:.1f} µs | {row['error']:.1e} |")
    page = out / "speed_accuracy.md"
    before = page.read_text().split(SECTION)[0].rstrip("\n") + "\n" if page.exists() else ""
    out.mkdir(parents=True, exist_ok=True)
    page.write_text(before + SECTION + "\n" + "\n".join(lines) + "\n")


if __name__ == "__main__":
    sys.exit(main())
