#!/usr/bin/env bash
# The linker of the engine for WebAssembly: exports what the page calls. The bindings to browsers that libraries bring along
# would export some thousands of functions for a generator that is not used here.
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
