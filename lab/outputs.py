#!/usr/bin/env python3
"""Compares the files that two builds of gaitcam write for the built-in scenes and several commands.

    lab/outputs.py OLD NEW [--quick] [--tolerance 1e-9]

Both builds write all files of every scene, two sweeps, simulations and catalogues, which are then compared. Numbers in texts may
differ by the tolerance; times are left out. The exit code is 1 if there is a difference.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
SPACE = "(?:&nbsp;|\u00a0|\u202f| )".encode()
TIMES = re.compile(
    rb'"(?:solve_s|total_s|passed_over_s)": *[-+.\deE]+'
    + rb"|[\d.,]+" + SPACE + "(?:µs|ms|s)".encode() + rb"\b"
    + rb"|[\d.,]+ " + "(?:designs per second|diseños por segundo|designs/s|diseños/s)".encode())
BINARY = {".png", ".xlsx", ".3mf"}


def jobs(binary, quick):
    """Names and arguments of all commands; `{out}` is a separate folder for each."""
    listed = subprocess.run([binary, "scenes", "--json"], capture_output=True, check=True).stdout
    for name in (scene["name"] for scene in json.loads(listed)):
        yield f"synth {name}", ["synth", name, "--out", "{out}", *(["--no-png"] if quick else [])]
        if not quick:
            yield f"synth {name} es", ["synth", name, "--out", "{out}", "--no-png", "--lang", "es"]
            yield f"simulate {name}", ["simulate", name, "--json"]
    sweep = ["sweep", "footbridge", "--out", "{out}/t.csv", "--vary"]
    yield "sweep closed form", [*sweep, "gait.step_frequency=1.5 Hz:2.4 Hz:20", "--vary", "cam.base_radius=20 mm:60 mm:5"]
    yield "sweep programs", [*sweep, "gait.step_frequency=1.5 Hz:2.4 Hz:6", "--vary", "limits.stroke=30 mm:80 mm:6"]
    yield "keys", ["keys", "--json"]
    yield "laws", ["laws", "--json"]


def run(binary, arguments, folder):
    """Runs a command in a folder and stores its printed output beside its files."""
    out = folder / "o"
    out.mkdir(parents=True)
    words = [word.replace("{out}", str(out)) for word in arguments]
    done = subprocess.run([binary, *words], cwd=folder, capture_output=True)
    (folder / "stdout").write_bytes(done.stdout.replace(str(folder).encode(), b"OUT"))
    (folder / "stderr").write_bytes(done.stderr.replace(str(folder).encode(), b"OUT"))
    (folder / "exit").write_text(str(done.returncode))


def without_times(text):
    """Text without numbers that differ from run to run."""
    lines = text.split(b"\n")
    names = lines[0].split(b",")
    if names[0] == b"row" and b"time_s" in names:
        at = names.index(b"time_s")
        rows = [line.split(b",") for line in lines]
        lines = [b",".join(row[:at] + row[at + 1:]) for row in rows]
    return TIMES.sub(b"", b"\n".join(lines))


def difference(a, b, tolerance):
    """Sentence on the difference of two files; empty if they are equal."""
    if a == b:
        return ""
    a, b = without_times(a), without_times(b)
    if NUMBER.sub(b"#", a) != NUMBER.sub(b"#", b):
        la, lb = a.splitlines(), b.splitlines()
        for x, y in zip(la, lb):
            if NUMBER.sub(b"#", x) != NUMBER.sub(b"#", y):
                return f"text: {x[:110]!r} -> {y[:110]!r}"
        return f"{len(la)} -> {len(lb)} lines"
    worst, shown = 0.0, ""
    for x, y in zip(NUMBER.findall(a), NUMBER.findall(b)):
        change = abs(float(x) - float(y)) / max(abs(float(x)), abs(float(y)), 1e-6)
        if change > worst:
            worst, shown = change, f"{x.decode()} -> {y.decode()}"
    return f"numbers: {worst:.1e} ({shown})" if worst > tolerance else ""


def compare(old, new, job, tolerance):
    """Differences between the two builds for one command."""
    name, arguments = job
    found = []
    with tempfile.TemporaryDirectory() as folder:
        sides = [Path(folder) / side for side in "ab"]
        for binary, side in zip((old, new), sides):
            run(binary, arguments, side)
        files = {path.relative_to(side) for side in sides for path in side.rglob("*") if path.is_file()}
        for file in sorted(files):
            a, b = (side / file for side in sides)
            if not a.exists() or not b.exists():
                found.append(f"{name}: {file}: only in {'old' if a.exists() else 'new'}")
                continue
            a, b = a.read_bytes(), b.read_bytes()
            if file.suffix in BINARY:
                text = "bytes differ" if a != b else ""
            else:
                text = difference(a, b, tolerance)
            if text:
                found.append(f"{name}: {file}: {text}")
    return found


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("old")
    arguments.add_argument("new")
    arguments.add_argument("--quick", action="store_true", help="without pictures, Spanish and simulations")
    arguments.add_argument("--tolerance", type=float, default=1e-9)
    given = arguments.parse_args()
    old, new = (str(Path(binary).resolve()) for binary in (given.old, given.new))
    with ThreadPoolExecutor(2) as pool:
        found = pool.map(lambda job: compare(old, new, job, given.tolerance), list(jobs(old, given.quick)))
        lines = [line for differences in found for line in differences]
    print("\n".join(lines) or "equal")
    sys.exit(bool(lines))


if __name__ == "__main__":
    main()
