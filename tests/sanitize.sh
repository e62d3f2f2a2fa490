#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The tests under the address and undefined behaviour sanitizers: those whose name matches, or every fourth one.
# usage: tests/sanitize.sh [--quarter 0|1|2|3] [CTEST_REGEX]
set -euo pipefail
cd "$(dirname "$0")/.."
source testbench/build.sh
source tests/packages.sh
chosen=()
case ${1:-}${2:-} in
  # Those left out wait for Yosys and for units that are built without sanitizers.
  '') chosen=(-E '(gates|savings|prune_program)_long') ;;
  --quarter[0123]) chosen=(-I "$((1 + $2)),,4" -E '(gates|savings|prune_program)_long') ;;
  -*) echo "usage: tests/sanitize.sh [--quarter 0|1|2|3] [CTEST_REGEX]" >&2; exit 2 ;;
  *) chosen=(-R "$1") ;;
esac
feline_install_long_tests
feline_build build-sanitize RelWithDebInfo all -DFELINE_SANITIZE=ON "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1 -DNDEBUG"
export UBSAN_OPTIONS=print_stacktrace=1 LSAN_OPTIONS=print_suppressions=0
ctest --test-dir build-sanitize --output-on-failure --no-tests=error -j 2 "${chosen[@]}"
