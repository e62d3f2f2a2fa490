#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Every parser under libFuzzer with the address and undefined behaviour sanitizers: first the inputs of its corpus,
# tests/fuzz/corpus/PARSER, and those of former runs, build-fuzz/corpus/PARSER, then new ones, of which those that reach
# new code are kept in the latter.
# Not here, for want of a parser: vectors, which are only written, for $readmemh; configurations, which are C++ but for
# those in profiles; waveforms, which GTKWave's reader takes from the file that was just written.
# usage: tests/fuzz.sh [--seconds N] [--seed N] [PARSER...]
#   --seconds N  of new inputs for each parser: 15 by default, 3600 for the long run, 0 for the corpus alone
#   --seed N     of chance, another one each time by default; each run tells its own
#   PARSER       tests/fuzz/PARSER_fuzz.cpp; all of them by default
# A finding is whatever is neither taken nor refused as the parser's contract says, or takes more than 10 seconds or
# 2 GB: its input is kept in build-fuzz/findings, and the exit code is 1. To make the corpus as small as it can be:
#   build-fuzz/PARSER_fuzz -merge=1 EMPTY_DIRECTORY tests/fuzz/corpus/PARSER build-fuzz/corpus/PARSER
set -euo pipefail
cd "$(dirname "$0")/.."
source testbench/build.sh
source tests/packages.sh

usage() { sed -n '/^# usage/,/PARSER  /s/^# //p' "$0"; }

seconds=15
seed=$((RANDOM * 32768 + RANDOM + 1))
parsers=()
while (($# > 0)); do
  case $1 in
    --seconds | --seed)
      [[ ${2:-} =~ ^[0-9]+$ ]] || { echo "error: $1: got ${2:-nothing}, legal is a whole number" >&2; exit 2; }
      # Not octal, however many zeros it begins with.
      if [[ $1 == --seed ]]; then seed=$((10#$2)); else seconds=$((10#$2)); fi
      # 0 is a seed of libFuzzer's own choice.
      ((seed > 0)) || { echo "error: --seed: got 0, legal is 1 or more" >&2; exit 2; }
      shift
      ;;
    -h | --help) usage; exit 0 ;;
    -*) usage >&2; exit 2 ;;
    *)
      [[ -f tests/fuzz/$1_fuzz.cpp ]] || { echo "error: no parser $1: no tests/fuzz/$1_fuzz.cpp" >&2; exit 2; }
      parsers+=("$1")
      ;;
  esac
  shift
done
if ((${#parsers[@]} == 0)); then
  for source in tests/fuzz/*_fuzz.cpp; do parsers+=("$(basename "$source" _fuzz.cpp)"); done
fi

feline_install_long_tests
CC=clang CXX=clang++ feline_build build-fuzz RelWithDebInfo all -DFELINE_FUZZ=ON \
  "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1 -DNDEBUG"

# Targets write the files that they read, thousands a second: in memory, if there is such a directory.
memory=/dev/shm
[[ -w $memory ]] || memory=${TMPDIR:-/tmp}
TMPDIR=$(mktemp -d "$memory/feline-fuzz-XXXXXX")
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
export UBSAN_OPTIONS=print_stacktrace=1 LSAN_OPTIONS=print_suppressions=0
# OpenImageIO takes 64 MB at a time: of memory that is given back this much is watched.
export ASAN_OPTIONS=quarantine_size_mb=64
mkdir -p build-fuzz/findings
# To libFuzzer no seconds are no limit.
limit=(-max_total_time="$seconds")
((seconds > 0)) || limit=(-runs=0)

findings=0
echo "seed $seed, $seconds s each"
for parser in "${parsers[@]}"; do
  log=build-fuzz/$parser.log
  kept=build-fuzz/corpus/$parser
  mkdir -p "$kept"
  command=(build-fuzz/"${parser}"_fuzz -timeout=10 -rss_limit_mb=2048)
  result=clean
  "${command[@]}" "${limit[@]}" -dict=tests/fuzz/words.dict -seed="$seed" -print_final_stats=1 \
    -artifact_prefix=build-fuzz/findings/"$parser"- "$kept" tests/fuzz/corpus/"$parser" >"$log" 2>&1 || result=FINDING
  told() { sed -n "s/^stat::$1: *//p" "$log"; }
  printf '%-14s %9s inputs, %6s a second, coverage %5s, %4s new: %s\n' "$parser" "$(told number_of_executed_units)" \
    "$(told average_exec_per_sec)" "$(grep -oE 'cov: [0-9]+' "$log" | tail -n 1 | cut -c 6-)" "$(told new_units_added)" \
    "$result"
  if [[ $result == FINDING ]]; then
    ((++findings))
    input=$(sed -n 's/.*Test unit written to //p' "$log" | tail -n 1)
    tail -n 40 "$log" >&2
    echo "replay: ${command[*]} ${input:-: see $log}" >&2
  fi
done
((findings == 0)) || exit 1
