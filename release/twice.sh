#!/usr/bin/env bash
# Builds this commit in two clones and compares every file of the release byte by byte, part by part: release/twice.sh [FOLDER]
#
# FOLDER has the files of release/build.sh for the same commit. If it is given, one clone is built and compared with these files.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
given=${1:+$(realpath "$1")}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

clones=(one)
other=$given
[ -n "$given" ] || { clones=(one another); other=$work/another.files; }
for name in "${clones[@]}"; do
  git clone --quiet "$root" "$work/$name"
  mkdir -p "$work/$name/target/web"
  # Tools are copied, because they are not compared.
  for tool in release-tools tools web/toolchain web/node_modules; do
    [ ! -d "target/$tool" ] || cp -a "target/$tool" "$work/$name/target/$tool"
  done
done

# The command and the page are first, because differences are most likely in them.
for part in licences command page package book; do
  for name in "${clones[@]}"; do
    "$work/$name/release/build.sh" "$work/$name.files" "$part" > "$work/$name.log" 2>&1 ||
      { tail -n 30 "$work/$name.log"; exit 1; }
  done
  (cd "$other" && sha256sum --check --quiet "$work/one.files/SHA256SUMS")
  echo "$part: $(wc -l < "$work/one.files/SHA256SUMS") files, equal bit for bit"
done
