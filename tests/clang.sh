#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every hand-written source through clang++'s warnings as errors, and through clang-tidy (.clang-tidy). Needs a build,
# for what Verilator makes. --shard I/N: only each N-th through clang-tidy, which takes five times as long, from I = 0.
# Left out is what takes the RTL with counters or mutants, which only builds of their own have.
# usage: tests/clang.sh BUILD_DIRECTORY [--shard I/N] [SOURCE...]
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:?usage: tests/clang.sh BUILD_DIRECTORY [--shard I/N] [SOURCE...]}
shift
shard=0/1
if [[ ${1:-} == --shard ]]; then
  shard=$2
  [[ $shard =~ ^[0-9]+/[1-9][0-9]*$ ]] || { echo "error: --shard: got $shard, legal is I/N, as 0/3" >&2; exit 2; }
  shift 2
fi
if [[ $# -eq 0 ]]; then
  mapfile -t sources < <(find tables model testbench tests -name '*.cpp' -not -name covered_unit.cpp -not -name mutated_unit.cpp | sort)
  set -- "${sources[@]}"
fi
tidied=()
others=()
number=0
for source in "$@"; do
  if ((number++ % ${shard#*/} == ${shard%/*})); then tidied+=("$source"); else others+=("$source"); fi
done
flags=(-std=c++20 -Wall -Wextra -Wconversion -I. -isystem /usr/share/verilator/include
  -isystem /usr/share/verilator/include/vltstd "-I$build/faulty"
  -DFELINE_SOURCE_DIR='"."' -DFELINE_PROGRAM='""' -DFELINE_BROKEN='""')
for library in fast trace faulty; do
  flags+=(-isystem "$build/CMakeFiles/feline_$library.dir/Vfeline_$library.dir")
done
for leaf in "$build"/CMakeFiles/feline_leaves.dir/V*.dir; do flags+=(-isystem "$leaf"); done
# xargs would start a command for nothing.
each() {
  local -n files=$1
  shift
  ((${#files[@]} == 0)) || printf '%s\0' "${files[@]}" | xargs -0 -P "$(nproc)" -I{} "$@"
}
each others clang++ -fsyntax-only -Werror "${flags[@]}" {}
# Findings go to standard output; standard error counts what is not shown, in headers that are not ours.
noise=$(mktemp)
trap 'rm -f "$noise"' EXIT
each tidied clang-tidy --quiet {} -- "${flags[@]}" 2>"$noise" ||
  { grep -vE '^[0-9]+ (warnings?|errors?)' "$noise" >&2; exit 1; }
echo "clang++: clean in ${#} sources; clang-tidy: clean in ${#tidied[@]}"
