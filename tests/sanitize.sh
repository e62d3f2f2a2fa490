#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The tests under the address and undefined behaviour sanitizers. The argument chooses tests by name.
set -euo pipefail
cd "$(dirname "$0")/.."
source testbench/build.sh
source tests/packages.sh
feline_install_long_tests
feline_build build-sanitize RelWithDebInfo all -DFELINE_SANITIZE=ON "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1 -DNDEBUG"
export UBSAN_OPTIONS=print_stacktrace=1 LSAN_OPTIONS=print_suppressions=0
# Those wait for Yosys and for units that are built without sanitizers.
left_out=()
[[ $# -gt 0 ]] || left_out=(-E '(gates|savings|prune_program)_long')
ctest --test-dir build-sanitize --output-on-failure --no-tests=error -j 2 -R "${1:-.}" "${left_out[@]}"
