#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What --all adds to the tests. The argument chooses tests by name: then only these, and under the sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."
source testbench/build.sh
source tests/packages.sh
regex=${1:-.}

step() { printf '\n== %s (%d s)\n' "$1" "$SECONDS"; }

step "packages of the long tests"
feline_install_long_tests

step "long tests"
ctest --test-dir build --output-on-failure --no-tests=ignore -j 2 -L long -R "$regex"
if [[ $regex != . ]]; then
  tests/sanitize.sh "$regex"
  exit
fi

day=$(($(date +%s) / 86400))
# Every mantissa every time; of all other leaves, and of the proofs by SAT, a thirtieth. All of it: feline prove.
step "footprint of every combination of mantissas: feline prove --leaf footprint.simple,footprint.table"
certificate=testbench/prove/certificate.json
rm -rf build/prove
build/feline prove --leaf footprint.simple,footprint.table --against $certificate --output build/prove
step "a thirtieth of all leaves and proofs: feline prove --shard $((day % 30))/30"
build/feline prove --shard "$((day % 30))/30" --against $certificate --output build/prove

step "every scene, mode, kernel and wrap at 192 x 192"
build/feline cosim --scene all --mode all --kernel all --wrap all --size 192 --stalls 0.1 --memory-latency 10 \
  --no-wave | tail -n 1

# All the days another ten million. A hundred times as many in one run: --random 1000000000 --vary.
step "10 million random and directed lookups: feline cosim --random 10000000 --vary --seed $day"
build/feline cosim --random 10000000 --vary --seed "$day" --no-wave | tail -n 1

step "the netlist in Icarus"
tests/rtl/netlist.sh build/netlist

step "coverage: tests/coverage.sh"
tests/coverage.sh

# By turns: all of it would be more than an hour.
turn=$((day / 3))
case $((day % 3)) in
  0)
    # A quarter of the tests each time; all of them: tests/sanitize.sh.
    step "sanitizers, a quarter of the tests: tests/sanitize.sh --quarter $((turn % 4))"
    tests/sanitize.sh --quarter $((turn % 4))
    ;;
  1)
    # All of them: tests/configurations.sh.
    configurations=(least most lean bare front finest)
    step "the netlist of gates in Icarus: tests/rtl/netlist.sh --gates"
    tests/rtl/netlist.sh --gates build/gates
    step "another configuration: tests/configurations.sh ${configurations[turn % 6]}"
    tests/configurations.sh "${configurations[turn % 6]}"
    # clang-tidy alone would take twenty minutes.
    step "clang++, and clang-tidy for a sixth: tests/clang.sh build --shard $((turn % 6))/6"
    tests/clang.sh build --shard "$((turn % 6))/6"
    ;;
  2)
    # An hour each: tests/fuzz.sh --seconds 3600.
    step "every parser under libFuzzer: tests/fuzz.sh"
    tests/fuzz.sh
    stages=(walk group filter)
    step "mutants of a stage of which none is left: feline mutate --stage ${stages[turn % 3]}"
    build/feline mutate --stage "${stages[turn % 3]}" --output build/mutants
    # All of them: tests/prune.sh, a quarter of an hour.
    step "pruned units of an eighth of the scenes: tests/prune.sh --shard $((turn % 8))/8"
    tests/prune.sh --shard "$((turn % 8))/8"
    ;;
esac

printf '\nall: %d s\n' "$SECONDS"
