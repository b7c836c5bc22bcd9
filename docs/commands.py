#!/usr/bin/env python3
"""Runs or checks every code block of README.md, of the guide in both languages, of the theory and of the reference.

    python3 docs/commands.py target/release/gaitcam [--python INTERPRETER] [PAGE.md …]

Each page has a temporary folder with copies of scenes/ and data/, in which its blocks are run in order:

- `sh`: every line `gaitcam …` is run; an exit code other than 0 is stated behind it as `# exit code 3`;
- `text` after `sh`: each of its lines must occur in the output of these commands; a line that ends in ` …` is the
  beginning of a printed line, and a line `…` replaces omitted lines;
- `bash`, a job for Slurm (`#SBATCH --array=FIRST-LAST`): every task is run with the variables of Slurm, and the
  first once more, as for an array that is submitted again;
- after `<!-- printed -->`, every number of the paragraph with a decimal point, or with two digits or more before a unit,
  occurs, up to rounding, in the commands above or in their output (except times). `<!-- printed by`, hidden commands, `-->` runs
  these commands for the paragraph: gaitcam, `column FILE.csv NAME FACTOR`, which prints a column, and `value EXPRESSION`, which
  is computed from a JSON object d;
- `csv` is written to the file `NAME.csv` that the preceding line states in backquotes;
- `toml` that begins with the comment `# NAME.toml` is written to this file. The keys of any other block are set in the scene
  written last (else in the built-in footbridge), which must then be designed with exit code 0 or 3;
- `rust` occurs in a file of examples/ or in docs/guide/rust.md, which the tests run;
- `python`: the blocks of a page are one program. It is run by INTERPRETER, in which the package of python/ is installed;
  without --python it is only compiled. Pages below docs/guia/ are run in Spanish.
"""

import argparse
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"(?ms)(?:`(\S+)`:\n\n)?^```(\w+)\n(.*?)^```$|^<!-- printed(?: by\n(.*?)\n)? ?-->\n(?=(.*?)(?:\n\n|\Z))")
NUMBER = re.compile(r"\d+(?:[.,]\d+)?")
# Numbers in prose: with decimals, or with two digits or more before a unit.
FIGURE = re.compile(r"\d+[.,]\d+|(?<![\w.,·^/…-])\d{2,}(?= (?:mm|N|W|kg|MPa|%|N·m)\b)|(?<![\w.,])\d{2,}(?=°)")
SHELL = """
column() { python3 -c 'import csv, sys
for row in csv.DictReader(open(sys.argv[1])): print(float(row[sys.argv[2]]) * float(sys.argv[3]))' "$@"; }
value() { python3 -c 'import json, sys; from math import *
d = json.load(sys.stdin); print(eval(sys.argv[1]))' "$@"; }
"""
PAGES = ("README.md", "docs/start.md", "docs/comparison.md", "docs/verdict.md", "docs/theory/*.md", "docs/guide/*.md",
         "docs/guia/*.md", "docs/reference/*.md")


class Page:
    """A page and the folder in which its blocks are run."""

    def __init__(self, path, binary, folder, python=None):
        self.path, self.binary, self.folder = path, binary, Path(folder)
        self.interpreter = python and Path(shutil.which(python)).absolute()
        self.scene, self.printed, self.above, self.program = "footbridge", "", "", ""
        self.language = "es" if path.parent.name == "guia" else "en"
        for name in ("scenes", "data"):
            shutil.copytree(ROOT / name, self.folder / name)

    def run(self):
        before = None
        for found in re.finditer(BLOCK, self.path.read_text(encoding="utf-8")):
            self.named, kind, block, hidden, prose = found.groups()
            kind, block = ("prose", prose) if prose else (kind, block)
            if fault := hidden and self.unseen(hidden):
                sys.exit(f"{self.path.relative_to(ROOT)}: {fault}")
            if kind == "text" and before != "sh":
                continue  # a formula or a picture in characters
            check = getattr(self, kind, lambda _: f"nothing checks blocks of kind {kind}")
            if fault := check(block):
                line = self.path.read_text(encoding="utf-8").count("\n", 0, found.start()) + 1
                sys.exit(f"{self.path.relative_to(ROOT)}:{line}: {fault}")
            before = before if prose else kind
        if self.program:
            self.run_python()

    def sh(self, block):
        self.printed, self.above = "", self.above + block
        for line in block.replace("\\\n", " ").splitlines():
            if line.startswith("gaitcam studio"):
                self.printed += self.first_line(line)
                if not self.printed.endswith("\n"):
                    return f"it does not serve: {line}"
            elif line.startswith("gaitcam "):
                expected = re.search(r"# exit code (\d+)", line)
                code, printed = self.shell(line)
                self.printed += printed
                self.above += printed
                if code != int(expected.group(1) if expected else 0):
                    return f"exit code {code}: {line}\n{printed}"

    def bash(self, block):
        first, last = map(int, re.search(r"(?m)^#SBATCH --array=(\d+)-(\d+)$", block).groups())
        processors = re.search(r"(?m)^#SBATCH --cpus-per-task=(\d+)$", block).group(1)
        for task in [*range(first, last + 1), first]:
            given = {"ARRAY_TASK_ID": task, "ARRAY_TASK_MIN": first, "ARRAY_TASK_MAX": last,
                     "ARRAY_TASK_COUNT": last - first + 1, "CPUS_PER_TASK": processors, "SUBMIT_DIR": '"$PWD"'}
            code, printed = self.shell("".join(f"export SLURM_{k}={v}\n" for k, v in given.items()) + block)
            if code:
                return f"exit code {code} of task {task}:\n{printed}"

    def unseen(self, commands):
        code, printed = self.shell(SHELL + "set -e\n" + commands)
        self.above += f"{commands}\n{printed}"
        return f"exit code {code}: {commands}\n{printed}" if code else None

    def prose(self, paragraph):
        printed = [float(number.replace(",", ".")) for number in NUMBER.findall(re.sub(r"[\d.,]+ ms\b", "", self.above))]
        for number in FIGURE.findall(paragraph):
            digits = len(re.split("[.,]", f"{number}.")[1])
            if not any(abs(p - float(number.replace(",", "."))) <= 0.5001 * 10**-digits for p in printed):
                return f"the commands above do not print {number}"

    def shell(self, line):
        command = f'gaitcam() {{ {shlex.quote(self.binary)} --lang {self.language} "$@"; }}; set -o pipefail; {line}'
        done = subprocess.run(["bash", "-c", command], cwd=self.folder, timeout=120,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return done.returncode, done.stdout

    def first_line(self, line):
        """Output of the studio after its start. It is then stopped."""
        words = [self.binary, "--lang", self.language, *shlex.split(line, comments=True)[1:], "--no-open"]
        served = subprocess.Popen(words, cwd=self.folder, stdout=subprocess.PIPE, text=True)
        first = served.stdout.readline()
        served.send_signal(signal.SIGINT)
        served.wait(timeout=20)
        return first

    def text(self, block):
        printed = [" ".join(line.split()) for line in self.printed.splitlines()]
        for line in filter(None, (" ".join(line.split()) for line in block.splitlines())):
            begun = line.endswith(" …") and any(p.startswith(line[:-2]) for p in printed)
            if line not in printed and line != "…" and not begun:
                return f"not printed by the commands above: {line}\nprinted:\n{self.printed}"

    def toml(self, block):
        if named := re.match(r"# (\S+\.toml)\n", block):
            self.scene = named.group(1)
            (self.folder / self.scene).write_text(block, encoding="utf-8")
            return None
        values = " ".join(f"--set {shlex.quote(f'{key}={value}')}" for key, value in leaves(tomllib.loads(block)))
        code, printed = self.shell(f"gaitcam synth {self.scene} {values} --json")
        return None if code in (0, 3) else f"exit code {code} with {values}\n{printed}"

    def csv(self, block):
        (self.folder / self.named).write_text(block, encoding="utf-8")

    def rust(self, block):
        same = any(block.strip() in example.read_text(encoding="utf-8") for example in (ROOT / "examples").glob("*.rs"))
        return None if same or self.path.name == "rust.md" else "not in any file of examples/"

    def python(self, block):
        self.program += block

    def run_python(self):
        compile(self.program, str(self.path), "exec")
        if not self.interpreter:
            return print(f"{self.path.relative_to(ROOT)}: python blocks compiled, not run (no --python)")
        path = f"{Path(self.binary).parent}{os.pathsep}{os.environ['PATH']}"
        done = subprocess.run([self.interpreter, "-c", self.program], cwd=self.folder, env={**os.environ, "PATH": path})
        return done.returncode and sys.exit(f"{self.path.relative_to(ROOT)}: the python blocks fail")


def leaves(value, key=""):
    """Key and value of every entry in the form of --set. Entries of a list are counted from 1."""
    if isinstance(value, list):
        value = {str(number): entry for number, entry in enumerate(value, 1)}
    if not isinstance(value, dict):
        yield key, str(value).lower() if isinstance(value, bool) else value
    else:
        for name, entry in value.items():
            yield from leaves(entry, f"{key}.{name}" if key else name)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("binary")
    arguments.add_argument("--python", metavar="INTERPRETER")
    arguments.add_argument("pages", nargs="*", metavar="PAGE.md")
    given = arguments.parse_intermixed_args()
    every = (page for pattern in PAGES for page in sorted(ROOT.glob(pattern)))
    for path in [Path(page).resolve() for page in given.pages] or every:
        with tempfile.TemporaryDirectory() as folder:
            print(path.relative_to(ROOT), flush=True)
            Page(path, str(Path(given.binary).resolve()), folder, given.python).run()


if __name__ == "__main__":
    main()
