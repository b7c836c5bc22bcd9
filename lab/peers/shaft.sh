#!/usr/bin/env bash
# Integrates the shaft with a motor by scipy (DOP853) for every follower and drive, and compares force and period with `gaitcam simulate`. Requires
# pip. Without the packages, it ends without an error.  Usage: lab/peers/shaft.sh [path to gaitcam]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
binary=$(realpath "${1:-$root/target/release/gaitcam}")
venv="$root/target/shaft-tests"
if [ ! -x "$venv/bin/python" ]; then
  python3 -m venv "$venv"
fi
if ! "$venv/bin/python" -c "import numpy, scipy" 2>/dev/null; then
  "$venv/bin/pip" install --quiet numpy scipy || { echo "shaft: SKIPPED, scipy cannot be installed"; exit 0; }
fi
GAITCAM=$binary "$venv/bin/python" "$here/shaft.py"
