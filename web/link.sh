#!/usr/bin/env bash
# Linker of the engine for WebAssembly. It exports only the functions that the page calls. The browser bindings in some libraries would export
# thousands of other functions, which are not used here.
arguments=()
while [ $# -gt 0 ]; do
  case "$1 ${2:-}" in
    "--export ask" | "--export keep" | "--export free" | "--export room") arguments+=("$1" "$2"); shift 2 ;;
    "--export "*) shift 2 ;;
    "-flavor "*) shift 2 ;;
    *) arguments+=("$1"); shift ;;
  esac
done
# shellcheck disable=SC2086
exec ${WASM_LD:?} "${arguments[@]}"
