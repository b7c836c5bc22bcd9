#!/usr/bin/env python3
"""Compares the speed of two builds of gaitcam by CPU seconds, job by job in alternation.

    python3 lab/speed.py OLD NEW [--runs 5] [--jobs sweep,files] [--check]

OLD and NEW are binaries, clones that contain target/release/gaitcam, or commits, which are built in a worktree below
--worktrees (default: target/speed). Each job runs once as a warm-up, then alternately with both builds; medians are
compared. The CPU time of the process depends less on the load of the machine than the elapsed time.
"""
import argparse
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
GRID = ["--vary", "gait.step_frequency=1.6Hz:2.4Hz:60"]
ROLLER = [
    "--set", "cam.follower=roller-translating", "--set", "cam.roller_radius=10mm",
    "--vary", "gait.step_frequency=1.6Hz:2.2Hz:12", "--vary", "limits.stroke=40mm:60mm:5",
]
HARMONIC = ["--set", "law.family=harmonic", "--set", "limits.stroke=200mm", "--vary", "gait.body_weight=500N:900N:2000"]
ONE = ["--jobs", "1", "--out"]

# Name, arguments ("{out}" is a new folder), maximum ratio NEW / OLD.
JOBS = {
    "sweep": (["sweep", "footbridge", *GRID, "--vary", "limits.stroke=20mm:45mm:50", *ONE, "{out}/t.csv"], 1.3),
    "files": (["synth", "footbridge", "--out", "{out}/design"], 1.0),
    "fitted": (["synth", "heel_tester_fitted", "--json"], 0.7),
    "rollers": (["sweep", "footbridge", *ROLLER, *ONE, "{out}/t.csv"], 0.5),
    "plain": (["sweep", "footbridge", *HARMONIC, *GRID, *ONE, "{out}/t.csv"], 1.0),
    "start": (["--version"], 1.0),
}


def built(what, worktrees):
    """Path of the binary of a path or of a commit."""
    path = pathlib.Path(what)
    if path.is_dir():
        path = path / "target/release/gaitcam"
    if path.is_file():
        return path.resolve()
    place = worktrees / what
    if not place.exists():
        subprocess.run(["git", "-C", ROOT, "worktree", "add", "--detach", place, what], check=True)
    subprocess.run(["cargo", "build", "--release", "-p", "gaitcam-cli"], cwd=place, check=True)
    return place / "target/release/gaitcam"


def cpu(binary, arguments):
    """CPU time of one run, s."""
    with tempfile.TemporaryDirectory() as out:
        command = [str(binary)] + [a.replace("{out}", out) for a in arguments]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    # A design outside its limits has a separate exit code. Only an invalid call is an error here.
    if done.returncode not in (0, 1, 3):
        sys.exit(f"{' '.join(command)}: {done.returncode}\n{done.stderr}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--jobs", default=",".join(JOBS))
    parser.add_argument("--worktrees", type=pathlib.Path, default=ROOT / "target/speed")
    parser.add_argument("--check", action="store_true", help="exit with 1 where a job is slower than wanted")
    given = parser.parse_args()
    binaries = [built(what, given.worktrees) for what in (given.old, given.new)]
    print("| job | old, CPU s | new, CPU s | new / old | wanted |\n|---|---|---|---|---|")
    slow = False
    for job in given.jobs.split(","):
        arguments, wanted = JOBS[job]
        for binary in binaries:
            cpu(binary, arguments)
        times = [[], []]
        for _ in range(given.runs):
            for binary, all_times in zip(binaries, times):
                all_times.append(cpu(binary, arguments))
        old, new = map(statistics.median, times)
        slow |= new > wanted * old
        print(f"| {job} | {old:.3f} | {new:.3f} | {new / old:.2f} | {wanted} |", flush=True)
    sys.exit(given.check and slow)


if __name__ == "__main__":
    main()
