#!/usr/bin/env bash
# Builds the page with its engine inside: web/dist/ (static files for any web server) and web/dist/gaitcam.html (one file that opens with a double
# click).
#
# The engine is compiled for WebAssembly. If the installed Rust has no library for WebAssembly, the compiler of Debian is unpacked below target/web
# without installation. Debian's binaryen reduces the size of the module, and esbuild from npm joins the scripts. The build fails if a tool is not
# available.
set -euo pipefail
cd "$(dirname "$0")/.."
web=$PWD/target/web
page=$PWD/crates/studio
mkdir -p "$web"

fail() { echo "web/build.sh: $*" >&2; exit 1; }

command -v npm > /dev/null || fail "npm is needed (Debian: apt-get install nodejs npm)"

# shellcheck source=web/toolchain.sh
source web/toolchain.sh

if [ -d "$(rustc --print sysroot)/lib/rustlib/wasm32-unknown-unknown" ]; then
  standard=()
  export WASM_LD="rust-lld -flavor wasm" PATH="$PATH:$(rustc --print target-libdir)/../bin"
else
  use_debian
  # A page has nowhere to print a panic: it ends the worker, and the page says so.
  export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS="-Zunstable-options -Cpanic=immediate-abort"
  standard=(-Zbuild-std=std,panic_abort -Zbuild-std-features= -Zwarnings)
fi
export CARGO_INCREMENTAL=0 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$PWD/web/link.sh
command -v wasm-opt > /dev/null || fail "wasm-opt is needed (binaryen)"
rm -rf "$web/modules"
mkdir "$web/modules"
# The first module of the page, and the whole module for files, simulations and recordings.
for name in engine whole; do
  features=()
  [ "$name" = whole ] || features=(--no-default-features)
  cargo rustc --quiet --profile web -p gaitcam-app --lib --crate-type cdylib --target wasm32-unknown-unknown \
    --target-dir "$web/cargo" "${features[@]}" "${standard[@]}"
  wasm-opt -O3 "$web/cargo/wasm32-unknown-unknown/web/gaitcam_app.wasm" -o "$web/modules/$name.wasm"
done

[ -x "$page/node_modules/.bin/esbuild" ] || npm ci --silent --no-audit --no-fund --prefix "$page" > /dev/null ||
  fail "npm cannot install esbuild and the libraries of the page"
python3 web/page.py "$web/modules" "$page/node_modules/.bin/esbuild" web/dist ${GAITCAM_URL:+--url "$GAITCAM_URL"}
