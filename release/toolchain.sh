# Compilers for the platforms of a release, for release/build.sh: source release/toolchain.sh
#
# Rust's own library for a platform is used where it is installed (`rustup target add`). Otherwise Debian's compiler, which
# web/toolchain.sh unpacks below target/web, compiles the standard library from its source. The linker is zig for Linux and
# the one of mingw-w64 for Windows. Nothing is installed. Needs: root, tools, build, glibc.

# The name that Rust has for a platform.
triple() {
  case $1 in
    linux-x86_64) echo x86_64-unknown-linux-gnu ;;
    linux-aarch64) echo aarch64-unknown-linux-gnu ;;
    windows-x86_64) echo x86_64-pc-windows-gnu ;;
    *) echo "release/build.sh: no platform $1: linux-x86_64, linux-aarch64 or windows-x86_64" >&2; exit 2 ;;
  esac
}

# Whether the installed Rust has a library for a platform.
installed() {
  [ -d "$(rustc --print sysroot)/lib/rustlib/$(triple "$1")/lib" ]
}

# Folder of the compiled program for a platform.
built() {
  echo "$build/$1/$(triple "$1")/release"
}

# Unpacks gcc and binutils for Windows, in the variant with the threads of Windows, which needs no further library.
unpack_mingw() {
  local package packages=$tools/packages
  rm -rf "$packages" "$tools/mingw.new"
  mkdir -p "$packages" "$tools/mingw.new"
  apt-get -qq update || true
  (cd "$packages" && apt-get -qq download binutils-mingw-w64-x86-64 gcc-mingw-w64-base mingw-w64-common \
    mingw-w64-x86-64-dev gcc-mingw-w64-x86-64-win32 gcc-mingw-w64-x86-64-win32-runtime) ||
    { echo "release/build.sh: apt-get cannot fetch mingw-w64" >&2; exit 1; }
  for package in "$packages"/*.deb; do dpkg -x "$package" "$tools/mingw.new"; done
  rm -r "$packages"
  mv "$tools/mingw.new" "$tools/mingw"
}

# Sets the environment of cargo and maturin for a platform, and `standard`: their options for the standard library.
use() {
  local platform=$1 crates=${CARGO_HOME:-$HOME/.cargo}
  standard=()
  export CARGO_TARGET_DIR=$build/$platform
  export RUSTFLAGS="--remap-path-prefix=$root=gaitcam --remap-path-prefix=$crates=crates"
  if ! installed "$platform"; then
    # shellcheck source=web/toolchain.sh
    source web/toolchain.sh
    use_debian
    standard=(-Zbuild-std=std,panic_abort -Zwarnings)
  fi
  if [ "$platform" = windows-x86_64 ]; then
    [ -d "$tools/mingw" ] || unpack_mingw
    export PATH=$tools/mingw/usr/bin:$PATH
    export CARGO_TARGET_X86_64_PC_WINDOWS_GNU_LINKER=x86_64-w64-mingw32-gcc-win32
  fi
}

# Compiles a crate for a platform, in the environment of `use`: cargo_for PLATFORM OPTION ...
cargo_for() {
  local platform=$1
  shift
  case $platform in
    linux-*) cargo zigbuild "$@" --target "$(triple "$platform").$glibc" "${standard[@]}" ;;
    windows-*) cargo build "$@" --target "$(triple "$platform")" "${standard[@]}" ;;
  esac
}
