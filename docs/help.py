#!/usr/bin/env python3
"""Writes docs/reference/commands.md from the help of every command.

    python3 docs/help.py target/release/gaitcam            # --check: only compares, and fails if the page is outdated
"""

import os
import re
import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).resolve().parent / "reference" / "commands.md"
HEAD = """# Command line

This page contains the help of every command; `--lang es` prints it in Spanish. [Exit codes](../verdict.md#exit-codes) and
[output files](files-out.md) are described on separate pages. `docs/help.py` writes this page.
"""


def help_of(binary, *command):
    printed = subprocess.run([binary, "--lang", "en", *command, "--help"], check=True, text=True, stdin=subprocess.DEVNULL,
                             env={**os.environ, "COLUMNS": "100"}, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    return re.sub(rf"(?m)^Usage: {re.escape(Path(binary).name)}", "Usage: gaitcam", printed.stdout).strip()


def main(binary, check):
    first = help_of(binary)
    names = re.findall(r"(?m)^  ([a-z]+) ", re.search(r"(?ms)^Commands:\n(.*?)\n\n", first).group(1))
    parts = [HEAD, f"```text\n{first}\n```\n"]
    for name in (n for n in names if n != "help"):
        parts.append(f"## {name}\n\n```text\n{help_of(binary, name)}\n```\n")
    page = "\n".join(parts)
    if not check:
        PAGE.write_text(page, encoding="utf-8")
    elif not PAGE.exists() or PAGE.read_text(encoding="utf-8") != page:
        sys.exit(f"docs/reference/commands.md is old: run python3 docs/help.py {binary}")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(sys.argv[1], "--check" in sys.argv)
