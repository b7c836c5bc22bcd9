#!/usr/bin/env python3
"""Compares gaitcam with other programs for the same tasks on this machine.

    cargo build --release && python3 lab/peers/speed/run.py [--out reports]

Each peer is installed by name into a temporary virtual environment. A peer that cannot be installed is reported as "skipped".
gaitcam is measured before and after the peers by lab/examples/peers.rs, which prints one line of JSON per task; the slower one
of its two medians is used. All times are processor times of all threads. The tables are written as the section "Peers" of
speed_accuracy.md, which `gaitcam-lab chart` keeps, and the chart of whole processes as whole_process.svg.
"""

import argparse
import csv
import json
import math
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import venv

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PEERS = [
    ("cvxpy + Clarabel", ["cvxpy", "clarabel"], "fit_cvxpy.py"),
    ("scipy spline least squares", ["scipy"], "fit_scipy.py"),
    ("", ["numpy", "scipy", "daqp", "piqp", "clarabel"], "fit_qp.py"),
    ("mechanism (PyPI)", ["mechanism"], "cam_mechanism.py"),
]
# Minimum speed ratios.
MINIMUM = {"fit_cvxpy.py": 50, "fit_scipy.py": 5, "fit_qp.py": 2, "cam_mechanism.py": 10}
# The kernel of gaitcam does the same work as the peer; the public call does the complete work for a user.
PUBLIC = {
    "jerk limit, quintic 32 spans": "jerk limit, quintic 32 spans, public call",
    "no limits, quintic 32 spans": "no limits, quintic, public call",
    "acceleration and jerk at 95 %, quintic 32 spans": "acceleration and jerk at 95 %, quintic 32 spans, assembled too",
}
# Whole processes: name, command, whether it is a peer's.
RUNS = 15
SECTION = "\n## Peers\n"


def ours():
    """Mapping task name -> {seconds, error} from the Rust benchmark."""
    run = subprocess.run(
        ["cargo", "run", "--quiet", "--release", "-p", "gaitcam-lab", "--example", "peers"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    )
    lines = [l for l in run.stdout.splitlines() if l.startswith("{")]
    return {row["task"]: row for row in map(json.loads, lines)}


def integrators():
    """Rows of the crate ode_solvers for the follower of chart (d1), or the reason why it was skipped."""
    run = subprocess.run(
        ["cargo", "run", "--quiet", "--release", "--manifest-path", str(ROOT / "lab/peers/ode/Cargo.toml")],
        capture_output=True, text=True,
    )
    if run.returncode:
        words = run.stderr.strip().splitlines() or ["no word"]
        return [], f"skipped: {words[-1][:120]}"
    return [json.loads(l) for l in run.stdout.splitlines() if l.startswith("{")], ""


def closed_form(out):
    """Time and error of gaitcam's method in chart (d1), from the last run of the chart."""
    table = out / "speed_accuracy.csv"
    rows = csv.DictReader(table.open()) if table.exists() else []
    own = [r for r in rows if r["chart"].endswith("_d1") and r["method"] == "closed form"]
    return own[0] if own else None


def slower(one, two):
    """The slower one of two runs of gaitcam, for each task."""
    return {task: max(row, two[task], key=lambda r: r["seconds"]) for task, row in one.items()}


def peer(python, names, script):
    """Rows of the peer, or the reason why it was skipped."""
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


def whole(command):
    """Median processor time of a whole process, s."""
    times = []
    for _ in range(RUNS):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return statistics.median(times)


def processes(pythons, folder):
    """Times of whole processes of gaitcam and of the two scripts with the same fit, measured alternately."""
    gaitcam = str(ROOT / "target" / "release" / "gaitcam")
    out = str(pathlib.Path(folder) / "footbridge")
    rows = [
        ("gaitcam synth --json, no files", [gaitcam, "synth", "--json"]),
        ("gaitcam synth --no-png", [gaitcam, "synth", "--no-png", "--out", out]),
        ("gaitcam synth, all files", [gaitcam, "synth", "--out", out]),
    ]
    for name, script in [("scipy script", "fit_scipy.py"), ("cvxpy script", "fit_cvxpy.py")]:
        if script in pythons:
            rows.append((name, [pythons[script], str(HERE / script), "once"]))
    return [(name, whole(command)) for name, command in rows]


def chart(rows):
    """Picture with dots at the process times on a logarithmic scale."""
    low, high = 1e-3, 10.0
    width, row, left = 560, 26, 240
    place = lambda s: left + width * math.log(s / low) / math.log(high / low)
    height = 70 + row * len(rows)
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {left + width + 90} {height}" '
        'font-family="DejaVu Sans, sans-serif" font-size="13">',
        f'<rect width="{left + width + 90}" height="{height}" fill="#fff"/>',
        f'<text x="{left}" y="20" font-weight="bold">The footbridge law as one process, time of the processor</text>',
    ]
    for power in range(-3, 2):
        x = place(10.0**power)
        name = f"{10**power:g} s" if power >= 0 else f"{10 ** (power + 3):g} ms"
        out.append(f'<path d="M{x:.1f} 32V{height - 28}" stroke="#ccc"/>')
        out.append(f'<text x="{x:.1f}" y="{height - 10}" text-anchor="middle" fill="#555">{name}</text>')
    for i, (name, seconds) in enumerate(rows):
        y = 38 + row * i
        colour = "#0072b2" if name.startswith("gaitcam") else "#999"
        x = place(seconds)
        out.append(f'<path d="M{left} {y + 9}H{left + width}" stroke="#eee"/>')
        out.append(f'<circle cx="{x:.1f}" cy="{y + 9}" r="5" fill="{colour}"/>')
        out.append(f'<text x="{left - 8}" y="{y + 13}" text-anchor="end">{name}</text>')
        time = f"{seconds:.3g} s" if seconds >= 1 else f"{1e3 * seconds:.3g} ms"
        out.append(f'<text x="{x + 10:.1f}" y="{y + 13}">{time}</text>')
    return "\n".join(out + ["</svg>\n"])


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--out", type=pathlib.Path, default=ROOT / "reports")
    out = arguments.parse_args().out
    mine = ours()
    found, pythons = [], {}
    with tempfile.TemporaryDirectory() as folder:
        for name, packages, script in PEERS:
            home = pathlib.Path(folder) / script.split(".")[0]
            venv.create(home, with_pip=True)
            python = str(home / "bin" / "python")
            rows, why = peer(python, packages, script)
            found.append((name, script, rows, why))
            if not why:
                pythons[script] = python
        mine = slower(mine, ours())
        runs = processes(pythons, folder)
    lines = [
        "Written by `python3 lab/peers/speed/run.py` in one run, with the same tasks one after the other on one machine. Times are medians of processor times inside one process after a warm-up. gaitcam was measured before and after the other programs; the slower median is given.",
        "",
        "*kernel*: gaitcam solves the task of the other program with the same input: the number of spans, and for DAQP, PIQP and Clarabel also all matrices. *more*: the complete result of `synthesise`, with the search for spans, the size of the cam, all checks on the continuous law and the certificate. For DAQP, PIQP and Clarabel it is the kernel including the assembly of its matrices.",
        "",
        "| task | peer | its time | its error | kernel | its error | faster by | more | faster by | minimum for the kernel |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for name, script, rows, why in found:
        if why:
            print(f"{name or script}: {why}")
            lines.append(f"| — | {name or script} | {why} | | | | | | | {MINIMUM[script]} |")
        for row in rows:
            own = mine[row["task"]]
            more = mine.get(PUBLIC.get(row["task"]))
            ratio = row["seconds"] / own["seconds"]
            whole_ratio = f"{row['seconds'] / more['seconds']:.1f}" if more else ""
            more_time = f"{1e3 * more['seconds']:.4f} ms" if more else ""
            peer_name = f"{name} {row['version']}".strip()
            print(f"{peer_name}: {row['task']}: kernel {ratio:.1f} times, more {whole_ratio or '-'}")
            minimum = MINIMUM[script] if "DAQP" in peer_name or script != "fit_qp.py" else ""
            lines.append(
                f"| {row['task']} | {peer_name} | {1e3 * row['seconds']:.3f} ms | {row['error']} "
                f"| {1e3 * own['seconds']:.4f} ms | {own['error']} | {ratio:.1f} | {more_time} | {whole_ratio} | {minimum} |"
            )
    all_files = dict(runs)["gaitcam synth, all files"]
    lines += [
        "",
        "Times of whole processes are medians of "
        f"{RUNS} runs. The scripts import their packages, fit once, and write nothing.",
        "",
        "![whole processes](whole_process.svg)",
        "",
        "| process | time of the processor | over gaitcam with all files |",
        "|---|---|---|",
    ]
    lines += [f"| {name} | {1e3 * seconds:.1f} ms | {seconds / all_files:.2f} |" for name, seconds in runs]
    out.mkdir(parents=True, exist_ok=True)
    (out / "whole_process.svg").write_text(chart(runs))
    lines += [
        "",
        "Adaptive integrators of the crate `ode_solvers` (lab/peers/ode) were run on the follower of chart (d1). The table gives the error of the state after one turn:",
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
    page.write_text(before + SECTION + "\n" + "\n".join(lines) + "\n")


if __name__ == "__main__":
    sys.exit(main())
