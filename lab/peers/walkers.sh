#!/usr/bin/env bash
# The least worst error over 200 walkers, and that of the worst tenth, under limits on stroke, acceleration and jerk, by cvxpy,
# against `gaitcam synth`. Needs pip; ends well where the packages cannot be had.  Usage: lab/peers/walkers.sh [gaitcam]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
binary=$(realpath "${1:-$root/target/release/gaitcam}")
venv="$root/target/walkers-tests"
if [ ! -x "$venv/bin/python" ]; then
  python3 -m venv "$venv"
fi
if ! "$venv/bin/python" -c "import numpy, cvxpy" 2>/dev/null; then
  "$venv/bin/pip" install --quiet numpy cvxpy || { echo "walkers: SKIPPED, cvxpy cannot be installed"; exit 0; }
fi
GAITCAM=$binary "$venv/bin/python" "$here/walkers.py"
