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
# Debian's shell without the windows of a browser needs half the processor time.
found() { command -v chromium-headless-shell || command -v chromium || command -v chromium-browser || command -v google-chrome || true; }
chromium=${CHROMIUM:-$(found)}
if [[ "$chromium" != *-shell && -z "${CHROMIUM:-}" ]] && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
  { timeout 120 apt-get -qq update && timeout 300 apt-get -qq install -y --no-install-recommends chromium-headless-shell ||
    timeout 300 apt-get -qq install -y --no-install-recommends chromium; } >/dev/null 2>&1 || true
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
# The longest modules first. Two run at a time; those that measure times run alone, afterwards.
[ $# -gt 0 ] || set -- test_model test_studio test_access test_sharing test_recordings test_layout test_values test_state test_programme \
  test_direct test_class test_dialogs test_looks test_compare test_engine test_speed
export GAITCAM=$binary CHROMIUM=$chromium GAITCAM_ROOT=$root python="$venv/bin/python"
if [ $# = 1 ]; then
  exec "$python" -m unittest -v "$1"
fi
one() {
  local began=$SECONDS code=0 log
  log=$(mktemp)
  "$python" -m unittest -v "$1" > "$log" 2>&1 || code=$?
  printf '\n-- %s: %s s, exit code %s\n%s\n' "$1" $((SECONDS - began)) "$code" "$(cat "$log")"
  rm -f "$log"
  return "$code"
}
export -f one
timed=()
beside=()
for test in "$@"; do
  case $test in test_speed*) timed+=("$test") ;; *) beside+=("$test") ;; esac
done
code=0
[ ${#beside[@]} = 0 ] || printf '%s\n' "${beside[@]}" | xargs -P 2 -I {} bash -c 'one {}' || code=1
for test in "${timed[@]}"; do
  one "$test" || code=1
done
exit "$code"
