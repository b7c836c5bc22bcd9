#!/usr/bin/env bash
# Builds the wheel, installs it in a fresh environment and runs the tests of the Python package.
#
#   python/run.sh            everything but the measurements; Ray and Dask where GAITCAM_ENGINES=1
#   python/run.sh engines    Ray and Dask alone, on clusters of this machine
#   python/run.sh overhead   times against the library
#
# The release build of the workspace is used as far as it goes, so that the library is compiled once.
set -euo pipefail
cd "$(dirname "$0")/.."
part=${1:-tests}
with_engines=${GAITCAM_ENGINES:-0}
[ "$part" = engines ] && with_engines=1
target=${CARGO_TARGET_DIR:-$PWD/target}
environment=$target/python-$part
python=${PYTHON:-python3}

rm -rf "$environment"
"$python" -m venv "$environment"
pip() { "$environment/bin/python" -m pip --disable-pip-version-check --quiet "$@"; }
pip install 'maturin>=1.9.4,<2' pytest hypothesis numpy pyarrow pandas
case $part in
  tests) pip install polars mypy matplotlib scipy nbformat nbclient ipykernel ;;
  engines | overhead) ;;
  *) echo "python/run.sh [tests|engines|overhead]" >&2; exit 2 ;;
esac
if [ "$with_engines" = 1 ]; then pip install 'ray[data]' distributed; fi

(cd python && CARGO_TARGET_DIR=$target "$environment/bin/maturin" build --release --quiet --interpreter "$environment/bin/python" \
  --out "$environment/wheels")
pip install --no-index --find-links "$environment/wheels" --no-deps gaitcam

# Not from the source folder: what is tested is the wheel.
cd "$environment"
tests=(-m pytest "$OLDPWD/python/tests" -c "$OLDPWD/python/pyproject.toml" -p no:cacheprovider --durations=5)
case $part in
  tests) bin/python "${tests[@]}" ;;
  engines) ;;
  overhead)
    (cd "$OLDPWD" && cargo build --release --quiet --example overhead)
    GAITCAM_OVERHEAD=$target/release/examples/overhead bin/python "${tests[@]}" -m overhead ;;
esac
engines() { timeout 600 bin/python "${tests[@]}" -m engines -s; }
# A machine that is busy for a while lets a cluster miss its heartbeats: one more run decides.
if [ "$with_engines" = 1 ]; then engines || { echo "The engines once more:"; engines; }; fi
