#!/usr/bin/env bash
# Reads the Parquet file of a sweep with another reader (pyarrow) and compares it with the CSV of the same sweep. Optional: requires gaitcam with
# --features parquet, python3 with venv, and a package index. If one of them is missing, it prints this and ends without an error.  Usage:
# lab/peers/parquet.sh [path to gaitcam]
set -euo pipefail
here="$(cd "$(dirname "$0")/../.." && pwd)"
gaitcam="${1:-$here/target/release/gaitcam}"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
skip() { echo "skipped: $*"; exit 0; }

[ -x "$gaitcam" ] || skip "no gaitcam at $gaitcam"
sweep() { "$gaitcam" sweep --vary 'limits.stroke=40 mm:60 mm:5' --vary law.family=spline,harmonic,program --out "$1"; }
sweep "$work/t.parquet" >/dev/null 2>"$work/why" || { grep -q 'feature "parquet"' "$work/why" && skip "gaitcam was built without Parquet"; cat "$work/why"; exit 1; }
sweep "$work/t.csv" >/dev/null
command -v python3 >/dev/null || skip "no python3"
python3 -m venv "$work/venv" 2>/dev/null || skip "python3 has no venv"
"$work/venv/bin/pip" install --quiet pyarrow >/dev/null 2>&1 || skip "pyarrow cannot be installed"
"$work/venv/bin/python" - "$work" <<'PYTHON'
import csv, sys
import pyarrow.parquet as pq

work = sys.argv[1]
table = pq.read_table(f"{work}/t.parquet")
rows = list(csv.DictReader(open(f"{work}/t.csv")))
assert table.num_rows == len(rows) == 15, table.num_rows
assert table.column_names == list(rows[0]), "columns differ"
units = {f.name: (f.metadata or {}).get(b"unit") for f in table.schema}
assert units["limits.stroke_m"] == b"m" and units["jerk_max_m_per_s3"] == b"m/s^3", units
for name in table.column_names[:-1]:  # the last column is the time
    for value, row in zip(table.column(name).to_pylist(), rows):
        text = row[name]
        if value is None:
            assert text == "", (name, text)
        elif isinstance(value, str):
            assert value == text, (name, value, text)
        else:
            assert value == float(text), (name, value, text)
print(f"pyarrow reads {table.num_rows} rows x {table.num_columns} columns, equal to the CSV, units in the metadata")
PYTHON
