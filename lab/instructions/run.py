#!/usr/bin/env python3
"""Counts the instructions of ten kernels under callgrind and compares them with counts.json beside this file.

    lab/instructions/run.py            fails if a kernel needs 10 % more than the stored count
    lab/instructions/run.py --store    measures and stores

Counts depend on the compiler, the C library and the processor's instruction set, although less than times. All three are
stored with the counts, and a difference is reported. Without valgrind nothing is counted, which is reported; with
GAITCAM_COUNT=must this is an error. CI installs valgrind where possible.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
STORED = HERE / "counts.json"
ALLOWED = 0.10


def built():
    """Path of the program with the kernels."""
    build = ["cargo", "build", "--quiet", "--release", "-p", "gaitcam-lab", "--example", "instructions"]
    plain = subprocess.run(
        build + ["--message-format=json"], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True
    ).stdout
    artifacts = [json.loads(line) for line in plain.splitlines()]
    paths = [a["executable"] for a in artifacts if a.get("executable")]
    return paths[-1]


def count(program, kernel):
    """Number of instructions of one kernel."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", "--collect-atstart=no",
             "--toggle-collect=*instructions::counted*", program, kernel],
            capture_output=True, text=True,
        )
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode or not found or int(found[1]) == 0:
        raise SystemExit(f"{kernel} was not counted:\n{run.stderr}")
    return int(found[1])


def surroundings():
    """Versions on which the counts depend, other than the source."""
    compiler = subprocess.run(["rustc", "--version"], cwd=ROOT, check=True, capture_output=True, text=True)
    return {"compiler": compiler.stdout.strip(), "libc": " ".join(platform.libc_ver()), "machine": platform.machine()}


def skipped():
    """Reports that valgrind is missing; returns 1 if GAITCAM_COUNT=must."""
    print("NOT COUNTED: valgrind is not installed, so no kernel's instructions were held against what is stored.\n"
          "             Install it (apt-get install valgrind) and run lab/instructions/run.py again.", file=sys.stderr)
    return 1 if os.environ.get("GAITCAM_COUNT") == "must" else 0


def judged(counts, stored):
    """Prints every kernel with its stored count. Returns the names of those that exceed it too far."""
    grown = []
    for kernel, found in counts.items():
        before = stored["kernels"].get(kernel)
        if before is None:
            print(f"{kernel}: {found / 1e6:.3f} million, not stored yet")
            grown.append(f"{kernel} is not stored: run lab/instructions/run.py --store")
            continue
        change = found / before - 1.0
        print(f"{kernel}: {found / 1e6:.3f} million instructions, {change:+.1%} of the stored {before / 1e6:.3f}")
        if change > ALLOWED:
            grown.append(f"{kernel} needs {change:.1%} more instructions than are stored ({found} instead of {before})")
        elif change < -ALLOWED:
            print("    store this gain: lab/instructions/run.py --store")
    return grown


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--store", action="store_true", help="store what is measured")
    store = arguments.parse_args().store
    if shutil.which("valgrind") is None:
        return skipped()
    program = built()
    kernels = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = dict(zip(kernels, pool.map(lambda kernel: count(program, kernel), kernels)))
    here = surroundings()
    if store:
        STORED.write_text(json.dumps({**here, "kernels": counts}, indent=2) + "\n")
        print(f"stored {len(counts)} kernels in {STORED.relative_to(ROOT)}")
        return 0
    stored = json.loads(STORED.read_text())
    others = [f"{name} is {here[name]}, the counts were stored with {stored[name]}"
              for name in here if here[name] != stored[name]]
    for other in others:
        print(f"note: {other}")
    grown = judged(counts, stored)
    for line in grown:
        print(line, file=sys.stderr)
    if grown and others:
        print("The change may come from what the notes above say: compare with a build of the commit before.", file=sys.stderr)
    return 1 if grown else 0


if __name__ == "__main__":
    sys.exit(main())
