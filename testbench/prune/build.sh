#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the check of a pruned unit, DIRECTORY/build/feline_pruned, from what `feline prune` wrote to DIRECTORY; or what
# counts its toggles, feline_activity.
# usage: testbench/prune/build.sh DIRECTORY [feline_pruned | feline_activity]
set -euo pipefail
unit=$(realpath "${1:?usage: testbench/prune/build.sh DIRECTORY [TARGET]}")
target=${2:-feline_pruned}
cd "$(dirname "$0")/../.."
source testbench/build.sh
feline_install
# A waveform costs the check's build nothing.
options=("-DFELINE_UNIT=$unit")
[[ $target != feline_activity ]] || options+=(-DFELINE_ACTIVITY=ON)
feline_build "$unit/build" Release "$target" "${options[@]}"
