#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the check of a pruned unit, DIRECTORY/build/feline_pruned, from what `feline prune` wrote to DIRECTORY.
# usage: testbench/prune/build.sh DIRECTORY
set -euo pipefail
unit=$(realpath "${1:?usage: testbench/prune/build.sh DIRECTORY}")
cd "$(dirname "$0")/../.."
source testbench/build.sh
feline_install
feline_build "$unit/build" Release feline_pruned "-DFELINE_UNIT=$unit"
