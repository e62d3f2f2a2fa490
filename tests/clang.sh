#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every hand-written source through clang-tidy (.clang-tidy), with clang++'s own warnings as errors among its checks.
# Needs a build, for what Verilator makes.
# usage: tests/clang.sh BUILD_DIRECTORY [SOURCE...]
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:?usage: tests/clang.sh BUILD_DIRECTORY [SOURCE...]}
shift
if [[ $# -eq 0 ]]; then
  mapfile -t sources < <(find tables model testbench tests -name '*.cpp' | sort)
  set -- "${sources[@]}"
fi
includes=(-I. -isystem /usr/share/verilator/include -isystem /usr/share/verilator/include/vltstd "-I$build/faulty")
for library in fast trace faulty; do
  includes+=(-isystem "$build/CMakeFiles/feline_$library.dir/Vfeline_$library.dir")
done
# Findings go to standard output; standard error counts what is not shown, in headers that are not ours.
noise=$(mktemp)
trap 'rm -f "$noise"' EXIT
printf '%s\0' "$@" |
  xargs -0 -P "$(nproc)" -I{} clang-tidy --quiet {} -- -std=c++20 -Wall -Wextra -Wconversion "${includes[@]}" \
    -DFELINE_SOURCE_DIR='""' -DFELINE_PROGRAM='""' -DFELINE_BROKEN='""' 2>"$noise" ||
  { grep -vE '^[0-9]+ (warnings?|errors?)' "$noise" >&2; exit 1; }
echo "clang-tidy and clang++: clean"
