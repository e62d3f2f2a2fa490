#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The tests under the address and undefined behaviour sanitizers. The argument chooses tests by name.
set -euo pipefail
cd "$(dirname "$0")/.."
source testbench/build.sh
feline_build build-sanitize RelWithDebInfo all -DFELINE_SANITIZE=ON
ctest --test-dir build-sanitize --output-on-failure --no-tests=error -j 2 -R "${1:-.}"
