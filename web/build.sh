#!/usr/bin/env bash
# Builds the page with its engine inside: web/dist/ (static files for any web server) and web/dist/gaitcam.html (one file
# that opens by a double click).
# The engine is compiled for WebAssembly. Where the installed Rust has no library for it, Debian's compiler is unpacked
# below target/web; nothing is installed. esbuild comes from npm.
set -euo pipefail
cd "$(dirname "$0")/.."
web=$PWD/target/web
tools=$web/toolchain
mkdir -p "$web"
rm -rf web/dist

missing() { echo "the page with its engine: SKIPPED, $1"; exit 0; }
command -v node > /dev/null && command -v npm > /dev/null || missing "no Node.js (install nodejs and npm)"

PACKAGES="rustc-web libstd-rust-web-1.96 libstd-rust-web-dev rust-web-src libllvm22 llvm-22-linker-tools lld-22"

unpack() {
  command -v apt-get > /dev/null || missing "no library of Rust for WebAssembly (rustup target add wasm32-unknown-unknown)"
  mkdir -p "$tools.new" "$web/packages"
  # shellcheck disable=SC2086
  (cd "$web/packages" && { apt-get download $PACKAGES || { apt-get -qq update && apt-get download $PACKAGES; }; }) > /dev/null 2>&1 ||
    missing "Debian's compiler for the web cannot be had"
  for package in "$web"/packages/*.deb; do dpkg -x "$package" "$tools.new"; done
  rm -r "$web/packages"
  mv "$tools.new" "$tools"
}

if [ -d "$(rustc --print sysroot)/lib/rustlib/wasm32-unknown-unknown" ]; then
  standard=()
  CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$PWD/web/link.sh
  export WASM_LD="rust-lld -flavor wasm" PATH="$PATH:$(rustc --print target-libdir)/../bin"
else
  [ -d "$tools" ] || unpack
  export LD_LIBRARY_PATH=$tools/usr/lib/x86_64-linux-gnu:$tools/usr/lib/llvm-22/lib
  export RUSTC=$tools/usr/bin/rustc RUSTC_BOOTSTRAP=1 WASM_LD=$tools/usr/lib/llvm-22/bin/wasm-ld
  standard=(-Zbuild-std=std,panic_abort)
fi
export CARGO_INCREMENTAL=0 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$PWD/web/link.sh
cargo rustc --quiet --profile web -p gaitcam-engine --lib --crate-type cdylib --target wasm32-unknown-unknown \
  --target-dir "$web/cargo" "${standard[@]}"

[ -x "$web/node_modules/.bin/esbuild" ] || npm install --silent --no-audit --no-fund --prefix "$web" esbuild@0.28.2 > /dev/null ||
  missing "esbuild cannot be installed"
python3 web/page.py "$web/cargo/wasm32-unknown-unknown/web/gaitcam_engine.wasm" "$web/node_modules/.bin/esbuild" web/dist
