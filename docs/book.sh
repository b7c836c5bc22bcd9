#!/usr/bin/env bash
# Builds the guide as an HTML book in target/book and checks its links: docs/book.sh
# Installs mdBook below target/tools where it is absent: about 200 CPU seconds, once.
set -euo pipefail
cd "$(dirname "$0")/.."
version=0.5.4
mdbook=target/tools/bin/mdbook
if [ "$("$mdbook" --version 2>/dev/null || true)" != "mdbook v$version" ]; then
  cargo install mdbook --version "$version" --locked --no-default-features --root target/tools \
    --target-dir target/mdbook-build
  rm -rf target/mdbook-build
fi
rm -rf target/book
"$mdbook" build docs
python3 docs/check.py --book target/book
