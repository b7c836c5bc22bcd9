#!/usr/bin/env bash
# Reads cam.step with two other programs: OCCT (valid closed solids, volume, edge points compared with the table of the profile) and gmsh. Requires
# pip. Without the packages, it ends without an error.  Usage: lab/peers/step.sh [path to gaitcam]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
binary=$(realpath "${1:-$root/target/release/gaitcam}")
venv="$root/target/step-tests"
if [ ! -x "$venv/bin/python" ]; then
  python3 -m venv "$venv"
fi
if ! "$venv/bin/python" -c "import OCP, gmsh, numpy" 2>/dev/null; then
  "$venv/bin/pip" install --quiet cadquery-ocp gmsh numpy || { echo "step: SKIPPED, OCCT cannot be installed"; exit 0; }
fi
GAITCAM=$binary "$venv/bin/python" "$here/step.py"
