#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prunes a unit for each scene, builds it, and compares its RTL with its model and its pixels with the full unit's.
# usage: tests/prune.sh [--shard I/N]   the I-th of N parts of the scenes, I from 0; otherwise all
set -euo pipefail
cd "$(dirname "$0")/.."
part=0 parts=1
if [[ ${1:-} == --shard ]]; then
  shard=${2:-nothing}
  [[ $shard =~ ^[0-9]+/[1-9][0-9]*$ ]] || { echo "error: --shard: got $shard, legal is I/N, as 0/5" >&2; exit 2; }
  part=${shard%/*} parts=${shard#*/}
fi
mapfile -t scenes < <(build/feline scene --list | awk '{ print $1 }')
((${#scenes[@]} > 1)) || { echo "prune.sh: feline scene --list names no scenes" >&2; exit 1; }
for ((i = part; i < ${#scenes[@]}; i += parts)); do
  printf '%s: ' "${scenes[i]}"
  said=$(build/feline prune --scene "${scenes[i]}" --mode simple,table --size 64 --output "build/units/${scenes[i]}") ||
    { printf '\n%s\n' "$said"; exit 1; }
  grep '^check' <<<"$said"
done
