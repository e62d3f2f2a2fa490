#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# clang-tidy over every hand-written source that the build directory compiles; warnings are errors.
set -euo pipefail
cd "$(dirname "$0")/.."
directory=${1:?usage: tests/tidy.sh BUILD_DIRECTORY}
find tables model testbench -name '*.cpp' -print0 |
  xargs -0 -n 1 -P 2 clang-tidy -p "$directory" --quiet --warnings-as-errors='*'
echo "clang-tidy: clean"
