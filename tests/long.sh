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

step "every scene, mode, kernel and wrap at 192 x 192"
build/feline cosim --scene all --mode all --kernel all --wrap all --size 192 --stalls 0.1 --memory-latency 10 \
  --no-wave | tail -n 1

step "10 million random and directed lookups"
for seed in 1 2; do
  build/feline cosim --random 5000000 --seed "$seed" --stalls 0.1 --memory-latency 3 --no-wave | tail -n 1 &
  pids+=($!)
done
for pid in "${pids[@]}"; do wait "$pid"; done

step "the netlist in Icarus"
tests/rtl/netlist.sh build/netlist

# All of them: tests/prune.sh, a quarter of an hour.
eighth=$(($(date +%s) / 86400 % 8))/8
step "pruned units of an eighth of the scenes: tests/prune.sh --shard $eighth"
tests/prune.sh --shard "$eighth"

# All of them: tests/configurations.sh.
other=$( (($(date +%s) / 86400 % 2)) && echo bare || echo front)
step "other configurations: tests/configurations.sh least most lean $other"
tests/configurations.sh least most lean "$other"

# In four days all of them: clang-tidy alone would take twenty minutes.
shard=$(($(date +%s) / 86400 % 4))/4
step "clang++, and clang-tidy for a quarter: tests/clang.sh build --shard $shard"
tests/clang.sh build --shard "$shard"

step "sanitizers"
tests/sanitize.sh

printf '\nall: %d s\n' "$SECONDS"
