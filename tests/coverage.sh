#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What the tests reach: lines, branches and bits of the RTL, lines and branches of the model, functional bins. Writes
# build/coverage/coverage.html and coverage.json; fails where less is reached than testbench/coverage/ratchet.json says.
# --update writes that file anew. Five minutes from cold, two where compiler outputs are cached.
# usage: tests/coverage.sh [--update]
set -euo pipefail
cd "$(dirname "$0")/.."
source testbench/build.sh
source tests/packages.sh
case ${1:-} in
  '' | --update) ;;
  *) echo "usage: tests/coverage.sh [--update]" >&2; exit 2 ;;
esac
feline_install_coverage
output=build/coverage
mkdir -p $output

feline_build build-coverage Release feline_coverage -DFELINE_COVERAGE=RTL
feline_build build-coverage-model Release model_coverage -DFELINE_COVERAGE=MODEL -DCMAKE_CXX_COMPILER=clang++

build-coverage/feline_coverage run --output $output &
suite=$!
trap 'kill "$suite" 2>/dev/null || true' EXIT
# The million draws of each invariant reach nothing that the tests of the stages do not.
LLVM_PROFILE_FILE=$output/model.profraw build-coverage-model/model_coverage --gtest_brief=1 \
  --gtest_filter='-*_long.*:invariants.*' >$output/model.log || { cat $output/model.log >&2; exit 1; }
llvm-profdata merge -o $output/model.profdata $output/model.profraw
llvm-cov show build-coverage-model/model_coverage -instr-profile=$output/model.profdata -show-branches=count \
  -show-instantiations=false model/*.h model/*.cpp >$output/model.txt
rm $output/model.profraw $output/model.profdata $output/model.log
wait "$suite"

build-coverage/feline_coverage judge --output $output --model $output/model.txt "$@"
