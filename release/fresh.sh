#!/usr/bin/env bash
# Measures the time from the files of release/build.sh to the first cam, with an empty home folder and no compiler on the path.
#
#   release/fresh.sh [FOLDER] [--source]      --source: also run the first command of the README in a new clone
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
files=$root/target/release-files
source=0
for argument in "$@"; do
  if [ "$argument" = --source ]; then source=1; else files=$(realpath "$argument"); fi
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/home"
python=$(python3 -c 'import sys; print(sys.executable)')
bare() { (cd "$work" && env -i HOME="$work/home" PATH=/usr/bin:/bin LANG=C.UTF-8 "$@"); }
timed() {
  local name=$1 most=$2 begun took
  shift 2
  begun=$(date +%s.%N)
  "$@"
  took=$(python3 -c "import time; print(f'{time.time() - $begun:.1f}')")
  echo "$name: $took s (at most $most s)"
  python3 -c "import sys; sys.exit($took > $most)" || { echo "too slow"; exit 1; }
}

command_() {
  bare tar -xzf "$files"/gaitcam-*-linux-x86_64.tar.gz
  bare "$(echo "$work"/gaitcam-*)/gaitcam" synth --out first > /dev/null
}

wheel() {
  bare "$python" -m venv package
  bare package/bin/pip install --quiet --disable-pip-version-check --only-binary :all: "$files"/gaitcam-*manylinux*x86_64.whl
  bare package/bin/python -c 'import gaitcam; assert gaitcam.synth(gaitcam.Scene.builtin("footbridge")).verdict == "acceptable"'
}

page() {
  GAITCAM_DIST=$files crates/studio/tests/browser/run.sh "$(command -v true)" test_engine.Engine.test_one_file_opens_without_any_server \
    > "$work/page.log" 2>&1 && grep -q '^OK$' "$work/page.log" || { cat "$work/page.log"; exit 1; }
}

clone() {
  git clone --quiet "$root" "$work/source"
  (cd "$work/source" && cargo run --release --quiet -- synth > /dev/null)
}

timed "the page, browser and test driver included" 10 page
timed "the wheel, from an empty environment" 30 wheel
timed "the command, from its archive" 5 command_
if [ "$source" = 1 ]; then timed "the source, from a new clone" 180 clone; fi
