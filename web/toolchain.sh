# Debian's Rust compiler below target/web/toolchain, with the source of the standard library, for web/build.sh and
# release/build.sh: source web/toolchain.sh. It compiles for platforms for which the installed Rust has no library.
debian=$PWD/target/web/toolchain

no_compiler() { echo "web/toolchain.sh: $*" >&2; exit 1; }

# The package that another one depends on, its version in its name.
needed() { apt-cache depends "$1" | grep -oE "$2[0-9.]+" | head -n1; }

unpack() {
  command -v apt-get > /dev/null ||
    no_compiler "the installed Rust has no library for this platform (rustup target add), and there is no apt-get to fetch Debian's compiler"
  # Lists kept in an image of a machine may name an older compiler only.
  apt-get -qq update || true
  [ "$(apt-cache show rustc-web 2> /dev/null | grep -m1 -oP '^Version: 1\.\K[0-9]+')" -ge 91 ] 2> /dev/null ||
    no_compiler "the Debian archive set up here has no rustc-web of 1.91 or later (bookworm-security has)"
  local std llvm
  std=$(needed libstd-rust-web-dev libstd-rust-web-)
  llvm=$(needed "$std" libllvm)
  rm -rf "$debian.new" "$debian.packages"
  mkdir -p "$debian.new" "$debian.packages"
  (cd "$debian.packages" && apt-get -qq download rustc-web "$std" libstd-rust-web-dev rust-web-src "$llvm" "lld-${llvm#libllvm}" binaryen) ||
    no_compiler "apt-get cannot fetch Debian's compiler"
  for package in "$debian.packages"/*.deb; do dpkg -x "$package" "$debian.new"; done
  rm -r "$debian.packages"
  mv "$debian.new" "$debian"
}

# Makes cargo use this compiler, unpacked first where it is missing.
use_debian() {
  [ -d "$debian" ] || unpack
  export LD_LIBRARY_PATH=$debian/usr/lib/x86_64-linux-gnu:$(echo "$debian"/usr/lib/llvm-*/lib)
  export RUSTC=$debian/usr/bin/rustc RUSTC_BOOTSTRAP=1 WASM_LD=$(echo "$debian"/usr/lib/llvm-*/bin/wasm-ld)
  export PATH="$debian/usr/bin:$PATH"
  # The lint on unused crates takes those of the standard library for ours.
  export CARGO_BUILD_WARNINGS=allow
}
