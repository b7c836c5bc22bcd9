#!/usr/bin/env bash
# Builds all files of a release into a folder: release/build.sh [FOLDER [PART ...]]     (target/release-files by default)
#
# Parts are licences, command, package, page and book, in any order; all by default. The command contains the licences.
# The parts command and package build for all platforms, or for those in GAITCAM_PLATFORMS.
#
#   gaitcam-VERSION-linux-x86_64.tar.gz   the command; requires only glibc 2.28 (2018)
#   gaitcam-VERSION-linux-aarch64.tar.gz  the same for 64-bit ARM
#   gaitcam-VERSION-windows-x86_64.zip    the command for Windows 10 and later
#   gaitcam-VERSION-*.whl                 the Python package for 3.10 and later, one file for each platform
#   gaitcam.html, gaitcam-page.tar.gz     the page as one file and as a folder
#   gaitcam-book.tar.gz                   the guide in both languages
#   sbom.cdx.json, licences.txt           list of the crates, and their licences
#   SHA256SUMS
#
# The same commit gives the same bytes in any folder. Tools are downloaded from package registries into target/.
# Where the installed Rust has no library for a platform, Debian's compiler builds it (release/toolchain.sh).
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
out=$(realpath -m "${1:-target/release-files}")
parts=("${@:2}")
read -ra platforms <<< "${GAITCAM_PLATFORMS:-linux-x86_64 linux-aarch64 windows-x86_64}"
tools=$root/target/release-tools
build=$root/target/release-build
glibc=2.28
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n1)
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH CARGO_INCREMENTAL=0
# What `time` prints.
TIMEFORMAT="%U s + %S s of the processor"
unset CARGO_TARGET_DIR
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
# shellcheck source=release/toolchain.sh
source release/toolchain.sh

# Creates an archive of FOLDER/NAME that depends only on its contents: pack FOLDER NAME FILE
pack() {
  case $3 in
    *.zip) python3 release/zip.py "$1" "$2" "$out/$3" "$SOURCE_DATE_EPOCH" ;;
    *) tar --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --mode=u+rwX,go+rX,go-w \
      -C "$1" -cf - "$2" | gzip -9n > "$out/$3" ;;
  esac
}

# The folder of the command for a platform: fill FOLDER PLATFORM PROGRAM
fill() {
  local folder=$1 platform=$2 program=$3
  rm -rf "$folder"
  mkdir -p "$folder"
  cp "$program" LICENSE-* "$out/licences.txt" "$folder/"
  cp -r scenes data "$folder/"
  # Parts of the runtime library of mingw-w64 are in the programs for Windows.
  case $platform in windows-*) cp "$tools/mingw/usr/share/doc/mingw-w64-x86-64-dev/copyright" "$folder/licences-mingw-w64.txt" ;; esac
  python3 release/quick_start.py "$platform" "$folder"
}

licences() {
  python3 release/inventory.py "$out/sbom.cdx.json" "$out/licences.txt"
}

command_() {
  local platform folder=$build/files/gaitcam-$version
  for platform in "${platforms[@]}"; do
    echo "== command for $platform"
    time (
      use "$platform"
      cargo_for "$platform" --release --locked --quiet -p gaitcam-cli --features parquet
    )
    case $platform in
      linux-*) fill "$folder" "$platform" "$(built "$platform")/gaitcam"
        pack "$build/files" "gaitcam-$version" "gaitcam-$version-$platform.tar.gz" ;;
      windows-*) fill "$folder" "$platform" "$(built "$platform")/gaitcam.exe"
        pack "$build/files" "gaitcam-$version" "gaitcam-$version-$platform.zip" ;;
    esac
  done
}

package() {
  local platform
  for platform in "${platforms[@]}"; do
    echo "== package for $platform"
    time (
      use "$platform"
      cd python
      case $platform in
        linux-*) maturin build --release --locked --quiet --zig --target "$(triple "$platform")" \
          --compatibility "manylinux_${glibc/./_}" "${standard[@]}" --out "$out" ;;
        windows-*) maturin build --release --locked --quiet --target "$(triple "$platform")" "${standard[@]}" --out "$out" ;;
      esac
    )
  done
}

page() {
  web/build.sh
  cp web/dist/gaitcam.html "$out/"
  rm -rf "$build/files"
  mkdir -p "$build/files"
  cp -r web/dist "$build/files/gaitcam-page"
  rm "$build/files/gaitcam-page/gaitcam.html"
  pack "$build/files" gaitcam-page gaitcam-page.tar.gz
}

book() {
  docs/book.sh
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
