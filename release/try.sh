#!/usr/bin/env bash
# Runs the command of each platform from its archive and compares the results: release/try.sh [FOLDER [PLATFORM ...]]
#
# FOLDER has the files of release/build.sh (target/release-files by default). Linux on ARM runs under qemu, Windows under wine;
# both are unpacked from Debian's packages into target/try-tools, nothing is installed. release/try.py has the list of checks.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
files=$(realpath "${1:-target/release-files}")
tools=$root/target/try-tools
mingw=$root/target/release-tools/mingw/usr/bin

# Debian's packages, unpacked: fetch FOLDER PACKAGE ...
fetch() {
  local folder=$1 package
  shift
  mkdir -p "$folder/packages"
  (cd "$folder/packages" && apt-get -qq download "$@")
  for package in "$folder"/packages/*.deb; do dpkg -x "$package" "$folder"; done
  rm -r "$folder/packages"
}

if [ ! -d "$tools" ]; then
  apt-get -qq update || true
  rm -rf "$tools.new"
  fetch "$tools.new" qemu-user-static libc6-arm64-cross libgcc-s1-arm64-cross \
    wine64 libwine libz-mingw-w64 libunwind8 libcapi20-3 libpcap0.8
  # Wine looks for its server and for this library beside its own files.
  ln -sf wineserver64 "$tools.new/usr/lib/wine/wineserver"
  cp "$tools.new/usr/x86_64-w64-mingw32/lib/zlib1.dll" "$tools.new/usr/lib/x86_64-linux-gnu/wine/x86_64-windows/"
  mv "$tools.new" "$tools"
fi

# Rust's random numbers need ProcessPrng, which Windows has and wine 8 has not. For the test only.
if [ ! -f "$tools/bcryptprimitives.dll" ] && [ -d "$mingw" ]; then
  cat > "$tools/prng.c" <<'C'
#include <windows.h>
BOOLEAN NTAPI SystemFunction036(PVOID, ULONG);
__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE data, SIZE_T size) { return SystemFunction036(data, (ULONG)size); }
C
  PATH=$mingw:$PATH x86_64-w64-mingw32-gcc-win32 -shared -s -O2 -o "$tools/bcryptprimitives.dll" "$tools/prng.c" -ladvapi32
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
words=(/usr/bin/python3 release/try.py "$files" "$tools" "$work" "${@:2}")
if [ "$(id -u)" = 0 ]; then
  # Write permissions do not bind root.
  chown 65534:65534 "$work"
  setpriv --reuid=65534 --regid=65534 --clear-groups "${words[@]}"
else
  "${words[@]}"
fi
