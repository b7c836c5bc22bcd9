#!/usr/bin/env python3
"""Whether version, authors and licence are the same wherever they are written.

    python3 release/consistent.py FOLDER       also the names of the files of release/build.sh in FOLDER
    python3 release/consistent.py --order      the published crates, each after those that it depends on
"""

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def packages():
    """Members of the workspace, by name."""
    command = ["cargo", "metadata", "--locked", "--no-deps", "--format-version", "1"]
    done = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
    return {package["name"]: package for package in json.loads(done.stdout)["packages"]}


def published(all_):
    """Crates without `publish = false`, in an order in which they can be published."""
    left = {name: {dep["name"] for dep in package["dependencies"] if dep.get("path") and dep["kind"] != "dev"}
            for name, package in all_.items() if package["publish"] is None}
    order = []
    while left:
        ready = sorted(name for name, needed in left.items() if needed <= set(order))
        if not ready:
            sys.exit(f"release/consistent.py: not publishable, with what they need: {left}")
        order += ready
        left = {name: needed for name, needed in left.items() if name not in ready}
    return order


def faults(all_, files):
    root = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))
    shared = root["workspace"]["package"]
    version, authors, licence = shared["version"], shared["authors"], shared["license"]
    python = tomllib.loads((ROOT / "python/pyproject.toml").read_text(encoding="utf-8"))["project"]
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    for name, package in all_.items():
        if package["version"] != version:
            yield f"{name}: version {package['version']}, not {version}"
        if package["publish"] is None and (package["authors"] != authors or package["license"] != licence):
            yield f"{name}: authors {package['authors']}, licence {package['license']}"
    for name, dependency in root["workspace"]["dependencies"].items():
        if isinstance(dependency, dict) and "path" in dependency and dependency.get("version", version) != version:
            yield f"Cargo.toml: the workspace needs {name} {dependency['version']}, not {version}"
    if re.search(r"(?m)^version: (.*)$", citation).group(1) != version:
        yield f"CITATION.cff: not version {version}"
    if re.findall(r"(?m)^  - name: (.*)$", citation) != authors:
        yield f"CITATION.cff: not the authors {authors}"
    if set(re.search(r"(?m)^license: \[(.*)\]$", citation).group(1).split(", ")) != set(licence.split(" OR ")):
        yield f"CITATION.cff: not the licence {licence}"
    if [author["name"] for author in python["authors"]] != authors:
        yield f"python/pyproject.toml: not the authors {authors}"
    if python["license"] != licence or "version" not in python["dynamic"]:
        yield f"python/pyproject.toml: not the licence {licence} with the version of Cargo.toml"
    if not re.search(rf"(?m)^## \[?{re.escape(version)}\b", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")):
        yield f"CHANGELOG.md: no section {version}"
    for path in sorted(files.glob("gaitcam-*")):
        given = re.match(r"gaitcam-(\d[^-]*)-", path.name)
        if given and given.group(1) != version:
            yield f"{path.name}: not version {version}"


def notes(python):
    """Steps of a maintainer before the first publication. They are not errors of a build."""
    if "repository" not in tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]:
        yield "Cargo.toml names no repository: add `repository` when the project has a public address"
    if re.search(r"(?mi)^## .*\b(Unreleased|not yet released)\b", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")):
        yield "CHANGELOG.md has a section without a date: give it version and date"
    if "urls" not in python:
        yield "python/pyproject.toml has no [project.urls]: add it when the project has a public address"


def main():
    all_ = packages()
    if sys.argv[1:] == ["--order"]:
        return print("\n".join(published(all_)))
    if found := list(faults(all_, Path(sys.argv[1]))):
        sys.exit("\n".join(found))
    print(f"version, authors and licence of {len(all_)} packages are consistent")
    for note in notes(tomllib.loads((ROOT / "python/pyproject.toml").read_text(encoding="utf-8"))["project"]):
        print(f"note: {note}")


if __name__ == "__main__":
    main()
