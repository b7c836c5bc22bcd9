#!/usr/bin/env python3
"""Contents of the program: a CycloneDX list of its crates, and the texts of their licences.

    python3 release/inventory.py SBOM.json LICENCES.txt
"""

import json
import subprocess
import sys
from pathlib import Path

# Delivered parts: the command, the Python package, the engine of the page.
ROOTS = {"gaitcam-cli", "gaitcam-python", "gaitcam-app"}
PLATFORMS = ("x86_64-unknown-linux-gnu", "aarch64-unknown-linux-gnu", "x86_64-pc-windows-gnu")
TEXTS = ("LICEN", "COPYING", "NOTICE")


def crates():
    """Crates that are compiled into the delivered parts, by name and version."""
    command = ["cargo", "metadata", "--locked", "--format-version", "1"]
    for platform in PLATFORMS:
        command += ["--filter-platform", platform]
    data = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    packages = {package["id"]: package for package in data["packages"]}
    nodes = {node["id"]: node for node in data["resolve"]["nodes"]}
    open_ = [key for key, package in packages.items() if package["name"] in ROOTS]
    found = set()
    while open_:
        key = open_.pop()
        if key in found:
            continue
        found.add(key)
        # Files that the build scripts read, such as the font, are included too.
        kinds = (None,) if packages[key]["source"] else (None, "build")
        open_ += [dep["pkg"] for dep in nodes[key]["deps"] if any(kind["kind"] in kinds for kind in dep["dep_kinds"])]
    return sorted((packages[key] for key in found), key=lambda package: (package["name"], package["version"]))


def component(package):
    name, version = package["name"], package["version"]
    entry = {"type": "library", "name": name, "version": version, "purl": f"pkg:cargo/{name}@{version}"}
    entry["bom-ref"] = entry["purl"]
    if package["license"]:
        entry["licenses"] = [{"expression": package["license"].replace("/", " OR ")}]
    return entry


def texts(package):
    """Licence files of a crate, including those of its bundled code."""
    folder = Path(package["manifest_path"]).parent
    named = sorted(path for path in folder.rglob("*") if path.is_file() and path.name.upper().startswith(TEXTS))
    return [path.read_text(errors="replace").strip() for path in named]


def main():
    sbom, licences = map(Path, sys.argv[1:])
    all_ = crates()
    foreign = [package for package in all_ if package["source"]]
    missing = [package["name"] for package in foreign if not package["license"] and not package["license_file"]]
    if missing:
        sys.exit(f"release/inventory.py: no licence is stated by {', '.join(missing)}")
    bom = {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1, "components": [component(p) for p in all_]}
    sbom.write_text(json.dumps(bom, indent=1) + "\n")
    # Each text is printed once, below the names of all crates with this text.
    holders = {}
    for package in foreign:
        for text in texts(package) or [f"{package['license']} (the crate carries no text)"]:
            holders.setdefault(text, []).append(f"{package['name']} {package['version']}")
    blocks = [", ".join(names) + "\n\n" + text for text, names in holders.items()]
    licences.write_text(("\n\n" + "=" * 80 + "\n\n").join(blocks) + "\n")
    print(f"{len(all_)} crates, {len(foreign)} of them from others, {len(holders)} texts")


if __name__ == "__main__":
    main()
