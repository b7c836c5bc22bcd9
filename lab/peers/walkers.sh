#!/usr/bin/env bash
# Minimum of the maximum error over 200 walkers, and of the mean error of the worst tenth, with limits on stroke, acceleration and jerk. Compares
# cvxpy with `gaitcam synth`. Requires pip. Without the packages, it ends without an error.  Usage: lab/peers/walkers.sh [gaitcam]
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
