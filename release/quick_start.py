#!/usr/bin/env python3
"""The texts that lie beside the command in its archive, in both languages: README.md, LEEME.md and, for Windows, a file
that starts the page by a double click.

    python3 release/quick_start.py PLATFORM FOLDER

They come from release/quick_start/. In them, `$gaitcam` is the command as typed in the folder of the archive, `$version` the
version and `$scene` the example of the README. A paragraph that begins with `windows:` or `linux:` is for this system only.
release/try.sh runs all commands of both files.
"""

import re
import string
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# Both shells of Windows accept the backslash; PowerShell needs it.
COMMAND = {"linux": "./gaitcam", "windows": r".\gaitcam"}
START = """@echo off\r
rem Starts the page of gaitcam in the browser. The page ends when this window is closed.\r
cd /d "%~dp0"\r
"%~dp0gaitcam.exe" studio\r
if errorlevel 1 pause\r
"""


def main():
    platform, folder = sys.argv[1], Path(sys.argv[2])
    system = platform.split("-")[0]
    version = re.search(r'(?m)^version = "(.*)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8")).group(1)
    scene = re.search(r"(?ms)^```toml\n(# walker\.toml\n.*?)^```", (ROOT / "README.md").read_text(encoding="utf-8")).group(1)
    for source in sorted((ROOT / "release" / "quick_start").glob("*.md")):
        kept = []
        for paragraph in source.read_text(encoding="utf-8").split("\n\n"):
            only = re.match(r"(linux|windows): ", paragraph)
            if not only or only.group(1) == system:
                kept.append(paragraph[only.end():] if only else paragraph)
        text = string.Template("\n\n".join(kept)).substitute(gaitcam=COMMAND[system], version=version, scene=scene.rstrip())
        (folder / source.name).write_text(text, encoding="utf-8", newline="\n")
    if system == "windows":
        (folder / "gaitcam studio.cmd").write_bytes(START.encode("ascii"))


if __name__ == "__main__":
    main()
