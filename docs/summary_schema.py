#!/usr/bin/env python3
"""Checks docs/reference/summary.schema.json against the summaries of the program.

    python3 docs/summary_schema.py target/release/gaitcam

The summaries of all built-in scenes, and of scenes that fail, must be valid, and the schema must describe every key in them.
The script implements the part of JSON Schema that the file uses. If the package `jsonschema` is installed, it is used too.
"""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SCHEMA = json.loads((ROOT / "docs/reference/summary.schema.json").read_text(encoding="utf-8"))
RECORDING = ["--set", "gait.file=data/recordings/made_walk.csv"]
# Scenes for keys that the built-in scenes do not have: a recording, a force error, a conflict, an uncertified result, the time limit, no cam.
OTHERS = [
    ["scenes/measured_walk.toml", *RECORDING],
    ["footbridge", "--set", "limits.stroke=40 mm", "--set", "law.spans=16"],
    ["footbridge", "--set", "cam.base_radius=20 mm", "--set", "limits.stroke=10 mm", "--set", "limits.curvature=40 mm"],
    ["footbridge", "--set", "limits.torque=14 N m", "--set", "law.spans=16"],
    ["scenes/heel_tester_fitted.toml", "--time-limit", "0.1"],
    ["footbridge", "--set", "machine.natural_frequency=60 Hz", "--set", "law.polydyne=true"],
    ["footbridge", "--set", "machine.floor.mass=10000 kg", "--set", "machine.floor.frequency=1.85 Hz", "--set", "machine.floor.damping=0.01"],
    ["thesis_barrel", "--set", "cam.depth=200 mm"],
]
# A corrected cam from a log.
RECUT = ["recut", "footbridge", "data/logs/made_log.csv"]
TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None), "integer": int}


def is_type(value, name):
    if name == "number":
        return isinstance(value, (int, float)) and not isinstance(value, bool)
    return isinstance(value, TYPES[name]) and (name != "integer" or not isinstance(value, bool))


def faults(value, schema, path="summary"):
    """Positions at which a value violates the schema. A key without a description is a fault."""
    if "$ref" in schema:
        yield from faults(value, SCHEMA["$defs"][schema["$ref"].rsplit("/", 1)[1]], path)
    if "enum" in schema and value not in schema["enum"]:
        yield f"{path}: {value!r} is none of {schema['enum']}"
    if "anyOf" in schema:
        found = [list(faults(value, choice, path)) for choice in schema["anyOf"]]
        yield from min(found, key=len)
    names = schema.get("type", [])
    names = [names] if isinstance(names, str) else names
    if names and not any(is_type(value, name) for name in names):
        yield f"{path}: {value!r} is not of type {' or '.join(names)}"
    elif isinstance(value, dict) and "properties" in schema:
        yield from (f"{path}: {key} is missing" for key in schema.get("required", []) if key not in value)
        for key, entry in value.items():
            if key in schema["properties"]:
                yield from faults(entry, schema["properties"][key], f"{path}.{key}")
            elif "code" not in schema["properties"]:  # a reason has the data of its code
                yield f"{path}.{key}: not in the schema"
    elif isinstance(value, list) and "items" in schema:
        for entry in value:
            yield from faults(entry, schema["items"], f"{path}[]")


def main(binary):
    try:
        import jsonschema
    except ImportError:
        jsonschema = None
    scenes = sorted((ROOT / "scenes").glob("*.toml"))
    runs = [[str(s.relative_to(ROOT)), *(RECORDING if s.stem == "measured_walk" else [])] for s in scenes] + OTHERS + [RECUT]
    found = []
    for words in runs:
        done = subprocess.run([binary, *([] if words is RECUT else ["synth"]), *words, "--json"], cwd=ROOT, capture_output=True, text=True, timeout=120)
        if done.returncode not in (0, 3):
            sys.exit(f"{words}: exit code {done.returncode}: {done.stderr}")
        summary = json.loads(done.stdout)
        found += [f"{' '.join(words)}: {fault}" for fault in faults(summary, SCHEMA)]
        if jsonschema:
            jsonschema.validate(summary, SCHEMA)
    print(f"{len(runs)} summaries, by this script{' and by jsonschema' if jsonschema else ''}")
    if found:
        sys.exit("\n".join(found))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(str(Path(sys.argv[1]).resolve()))
