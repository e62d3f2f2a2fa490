#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds what tries the mutants that `feline mutate` wrote to DIRECTORY: DIRECTORY/build/feline_mutated_STAGE.
# usage: testbench/mutation/build.sh DIRECTORY STAGE
set -euo pipefail
mutants=$(realpath "${1:?usage: testbench/mutation/build.sh DIRECTORY STAGE}")
stage=${2:?usage: testbench/mutation/build.sh DIRECTORY STAGE}
cd "$(dirname "$0")/../.."
source testbench/build.sh
feline_install
feline_build "$mutants/build" Release "feline_mutated_$stage" "-DFELINE_MUTANTS=$mutants"
