#!/usr/bin/env bash
# Builds all files of a release into a folder: release/build.sh [FOLDER [PART ...]]     (target/release-files by default)
#
# Parts are licences, command, package, page and book, in any order; all by default. The command contains the licences.
#
#   gaitcam-VERSION-linux-x86_64.tar.gz   the command; requires only glibc 2.28 (2018)
#   gaitcam-VERSION-*.whl                 the Python package for 3.10 and later
#   gaitcam.html, gaitcam-page.tar.gz     the page as one file and as a folder
#   gaitcam-book.tar.gz                   the guide in both languages
#   sbom.cdx.json, licences.txt           list of the crates, and their licences
#   SHA256SUMS
#
# The same commit gives the same bytes in any folder. Tools are downloaded from package registries into target/.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
out=$(realpath -m "${1:-target/release-files}")
parts=("${@:2}")
tools=$root/target/release-tools
build=$root/target/release-build
glibc=2.28
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n1)
export SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export CARGO_INCREMENTAL=0 CARGO_TARGET_DIR=$build
if [ ${#parts[@]} = 0 ]; then
  rm -rf "$out"
  parts=(licences command package page book)
fi
mkdir -p "$out"

[ -x "$tools/bin/cargo-zigbuild" ] || {
  python3 -m venv "$tools"
  "$tools/bin/pip" install --quiet --disable-pip-version-check cargo-zigbuild==0.24.1 ziglang==0.17.1 maturin==1.16.0
}
export PATH=$tools/bin:$PATH

# Creates a tar file of FOLDER/NAME that depends only on its contents.
pack() {
  tar --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --mode=u+rwX,go+rX,go-w \
    -C "$1" -cf - "$2" | gzip -9n > "$out/$3"
}

licences() {
  python3 release/inventory.py "$out/sbom.cdx.json" "$out/licences.txt"
}

crates=${CARGO_HOME:-$HOME/.cargo}
native="--remap-path-prefix=$root=gaitcam --remap-path-prefix=$crates=crates"

command_() {
  RUSTFLAGS=$native cargo zigbuild --release --locked --quiet -p gaitcam-cli --features parquet --target "x86_64-unknown-linux-gnu.$glibc"
  local folder=$build/files/gaitcam-$version
  rm -rf "$build/files"
  mkdir -p "$folder"
  cp "$build/x86_64-unknown-linux-gnu/release/gaitcam" README.md LICENSE-* "$out/licences.txt" "$folder/"
  pack "$build/files" "gaitcam-$version" "gaitcam-$version-linux-x86_64.tar.gz"
}

package() {
  (cd python && RUSTFLAGS=$native maturin build --release --locked --quiet --zig \
    --target x86_64-unknown-linux-gnu --compatibility "manylinux_${glibc/./_}" --out "$out")
}

page() {
  (unset CARGO_TARGET_DIR && web/build.sh)
  cp web/dist/gaitcam.html "$out/"
  rm -rf "$build/files"
  mkdir -p "$build/files"
  cp -r web/dist "$build/files/gaitcam-page"
  rm "$build/files/gaitcam-page/gaitcam.html"
  pack "$build/files" gaitcam-page gaitcam-page.tar.gz
}

book() {
  (unset CARGO_TARGET_DIR && docs/book.sh)
  rm -rf "$build/files"
  mkdir -p "$build/files"
  cp -r target/book "$build/files/gaitcam-book"
  pack "$build/files" gaitcam-book gaitcam-book.tar.gz
}

for part in "${parts[@]}"; do
  echo "== $part"
  case $part in
    command) command_ ;;
    licences | package | page | book) "$part" ;;
    *) echo "release/build.sh: no part $part: licences, command, package, page or book" >&2; exit 2 ;;
  esac
done

(cd "$out" && rm -f SHA256SUMS && sha256sum -- * > SHA256SUMS && cat SHA256SUMS)
