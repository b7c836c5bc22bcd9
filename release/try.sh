#!/usr/bin/env bash
# Runs command and wheel of each platform and compares the results: release/try.sh [FOLDER [PLATFORM ...]]
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

# Python for ARM from Debian's packages for that processor, and numpy for both processors, for the wheels.
fetch_python() {
  local folder=$1 python options platform processor
  python=$(apt-cache depends python3-minimal | grep -oE 'python3\.[0-9]+' | head -n1)
  options=(-o "Dir::State::lists=$folder/lists" -o "Dir::Cache=$folder/cache" -o APT::Architecture=arm64 -o APT::Architectures=arm64)
  mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial"
  apt-get -qq "${options[@]}" update
  (
    apt-get() { command apt-get "${options[@]}" "$@"; }
    fetch "$folder" "$python-minimal" "lib$python-minimal" "lib$python-stdlib" libc6 libexpat1 zlib1g libgcc-s1 libstdc++6 \
      libffi8 libssl3 libcrypt1
  )
  rm -r "$folder/lists" "$folder/cache"
  ln -s "$python" "$folder/usr/bin/python3"
  for processor in x86_64 aarch64; do
    platform=()
    for level in manylinux_2_28 manylinux_2_27 manylinux2014; do platform+=(--platform "${level}_$processor"); done
    python3 -m pip download --quiet --disable-pip-version-check --no-deps --only-binary :all: --python-version "${python#python}" \
      "${platform[@]}" --dest "$folder/numpy-$processor" numpy
    python3 -m zipfile -e "$folder/numpy-$processor"/numpy-*.whl "$folder/numpy-$processor"
  done
}

if [ ! -d "$tools" ]; then
  apt-get -qq update || true
  rm -rf "$tools.new"
  fetch "$tools.new" qemu-user-static libc6-arm64-cross libgcc-s1-arm64-cross \
    wine64 libwine libz-mingw-w64 libunwind8 libcapi20-3 libpcap0.8
  # Wine looks for its server beside its own files.
  ln -sf wineserver64 "$tools.new/usr/lib/wine/wineserver"
  fetch_python "$tools.new/python"
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
