#!/usr/bin/env python3
"""Runs the commands of README.md.

    python3 docs/commands.py target/release/gaitcam

Every line `gaitcam …` of a `sh` block is run in a copy of scenes/ and data/; a `toml` block that begins
with the comment `# NAME.toml` is written to that file first. Fails at the first exit code other than 0.
"""

import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def main(binary):
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    blocks = re.findall(r"(?ms)^```(\w+)\n(.*?)^```$", text)
    with tempfile.TemporaryDirectory() as folder:
        for name in ("scenes", "data"):
            shutil.copytree(ROOT / name, Path(folder) / name)
        subprocess.run([binary, "synth"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        for kind, block in blocks:
            named = re.match(r"# (\S+\.toml)\n", block)
            if kind == "toml" and named:
                (Path(folder) / named.group(1)).write_text(block, encoding="utf-8")
            for line in block.splitlines() if kind == "sh" else []:
                if line.startswith("gaitcam "):
                    print(line, flush=True)
                    words = shlex.split(line, comments=True)[1:]
                    subprocess.run([binary, *words], cwd=folder, check=True, stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        main(str(Path(sys.argv[1]).resolve()))
    except subprocess.CalledProcessError as error:
        sys.exit(f"exit code {error.returncode}: {shlex.join(error.cmd)}")
