#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every hand-written source through clang++ with warnings as errors. Needs a build, for what Verilator makes.
# usage: tests/clang.sh BUILD_DIRECTORY
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:?usage: tests/clang.sh BUILD_DIRECTORY}
includes=(-I. -isystem /usr/share/verilator/include -isystem /usr/share/verilator/include/vltstd -isystem "$build/faulty")
for library in fast trace faulty; do
  includes+=(-isystem "$build/CMakeFiles/feline_$library.dir/Vfeline_$library.dir")
done
find tables model testbench tests -name '*.cpp' -print0 |
  xargs -0 -n 4 -P 2 clang++ -fsyntax-only -std=c++20 -Wall -Wextra -Wconversion -Werror "${includes[@]}" \
    -DFELINE_SOURCE_DIR='""' -DFELINE_PROGRAM='""' -DFELINE_BROKEN='""'
echo "clang++: clean"
