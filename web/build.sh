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
tools=$web/toolchain
mkdir -p "$web"

fail() { echo "web/build.sh: $*" >&2; exit 1; }

command -v npm > /dev/null || fail "npm is needed (Debian: apt-get install nodejs npm)"

# Name of the package, with its version, on which another package depends.
needed() { apt-cache depends "$1" | grep -oE "$2[0-9.]+" | head -n1; }

unpack() {
  command -v apt-get > /dev/null || fail "no library of Rust for WebAssembly (rustup target add wasm32-unknown-unknown) and no apt-get to fetch Debian's"
  # The package lists of a machine image may contain only an older compiler.
  apt-get -qq update || true
  [ "$(apt-cache show rustc-web 2> /dev/null | grep -m1 -oP '^Version: 1\.\K[0-9]+')" -ge 91 ] 2> /dev/null ||
    fail "the Debian archive set up here has no rustc-web of 1.91 or later (bookworm-security has)"
  local std llvm
  std=$(needed libstd-rust-web-dev libstd-rust-web-)
  llvm=$(needed "$std" libllvm)
  rm -rf "$tools.new" "$web/packages"
  mkdir -p "$tools.new" "$web/packages"
  (cd "$web/packages" && apt-get -qq download rustc-web "$std" libstd-rust-web-dev rust-web-src "$llvm" "lld-${llvm#libllvm}" binaryen) ||
    fail "apt-get cannot fetch Debian's compiler"
  for package in "$web"/packages/*.deb; do dpkg -x "$package" "$tools.new"; done
  rm -r "$web/packages"
  mv "$tools.new" "$tools"
}

if [ -d "$(rustc --print sysroot)/lib/rustlib/wasm32-unknown-unknown" ]; then
  standard=()
  export WASM_LD="rust-lld -flavor wasm" PATH="$PATH:$(rustc --print target-libdir)/../bin"
else
  [ -d "$tools" ] || unpack
  export LD_LIBRARY_PATH=$tools/usr/lib/x86_64-linux-gnu:$(echo "$tools"/usr/lib/llvm-*/lib)
  export RUSTC=$tools/usr/bin/rustc RUSTC_BOOTSTRAP=1 WASM_LD=$(echo "$tools"/usr/lib/llvm-*/bin/wasm-ld)
  export PATH="$tools/usr/bin:$PATH"
  # A page cannot print a panic. A panic ends the worker, and the page reports it.
  export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS="-Zunstable-options -Cpanic=immediate-abort"
  standard=(-Zbuild-std=std,panic_abort -Zbuild-std-features= -Zwarnings)
  # The lint on unused crates also reports crates of the standard library.
  export CARGO_BUILD_WARNINGS=allow
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
