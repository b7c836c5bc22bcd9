#!/usr/bin/env bash
# Reads profile.dxf with ezdxf, drawn as arcs and as splines: an audit without errors, and areas and points compared with the table of the profile.
# Requires pip. Without the packages, it ends without an error.  Usage: lab/peers/dxf.sh [path to gaitcam]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
binary=$(realpath "${1:-$root/target/release/gaitcam}")
venv="$root/target/dxf-tests"
if [ ! -x "$venv/bin/python" ]; then
  python3 -m venv "$venv"
fi
if ! "$venv/bin/python" -c "import ezdxf" 2>/dev/null; then
  "$venv/bin/pip" install --quiet ezdxf || { echo "dxf: SKIPPED, ezdxf cannot be installed"; exit 0; }
fi
GAITCAM=$binary "$venv/bin/python" "$here/dxf.py"
