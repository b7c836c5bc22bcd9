#!/usr/bin/env bash
# Drives the studio in a real Chromium: crates/studio/tests/browser/run.sh target/release/gaitcam [TEST …]
# Makes a virtual environment with Playwright below target/ and, as root on Debian, installs Chromium. Where one of
# the two cannot be had the tests are skipped, and the last line says so.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../../.." && pwd)
binary=$(realpath "${1:-$root/target/release/gaitcam}")
shift || true
venv="$root/target/browser-tests"
found() { command -v chromium || command -v chromium-browser || command -v google-chrome || true; }
chromium=${CHROMIUM:-$(found)}
if [ -z "$chromium" ] && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
  { timeout 120 apt-get -qq update && timeout 300 apt-get -qq install -y --no-install-recommends chromium; } \
    >/dev/null 2>&1 || true
  chromium=$(found)
fi
if [ -z "$chromium" ]; then
  echo "studio in the browser: SKIPPED, no Chromium (install it, or set CHROMIUM)"
  exit 0
fi
if [ ! -x "$venv/bin/python" ]; then
  python3 -m venv "$venv" || { echo "studio in the browser: SKIPPED, no virtual environment"; exit 0; }
fi
if ! "$venv/bin/python" -c "import playwright, axe_playwright_python" 2>/dev/null; then
  "$venv/bin/pip" install --quiet playwright axe-playwright-python ||
    { echo "studio in the browser: SKIPPED, Playwright cannot be installed"; exit 0; }
fi
cd "$here"
[ $# -gt 0 ] || set -- test_studio test_access test_looks test_speed test_state test_direct test_class test_values test_engine test_model test_programme test_dialogs test_layout test_compare test_sharing test_recordings
GAITCAM=$binary CHROMIUM=$chromium GAITCAM_ROOT=$root "$venv/bin/python" -m unittest -v "$@"
