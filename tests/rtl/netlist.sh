#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Yosys writes the unit as Verilog, Icarus runs it on golden vectors: a second front end and a second simulator.
# --gates: not the operators as they were read, but what synthesis makes of them, gates of two inputs; four minutes.
# usage: tests/rtl/netlist.sh [--gates] WORK_DIRECTORY [LOOKUPS] [MODES]
set -euo pipefail
cd "$(dirname "$0")/../.."
usage="usage: tests/rtl/netlist.sh [--gates] WORK_DIRECTORY [LOOKUPS] [MODES]"
# Icarus takes gates module by module in two minutes; in one module they would take it far longer.
passes="flatten; opt_clean"
if [[ ${1:-} == --gates ]]; then
  passes="synth -top feline_unit -noabc; abc -fast -g AND,NAND,OR,NOR,XOR,XNOR,MUX; opt_clean"
  shift
fi
(($# > 0)) || { echo "$usage" >&2; exit 2; }
work=$1
lookups=${2:-40}
modes=${3:-nearest bilinear trilinear ext simple table}
rtl="tables/generated/feline_pkg.sv $(echo tables/generated/feline_rom_*.sv) $(echo rtl/*.sv)"
mkdir -p "$work"
yosys -q -p "read_verilog -sv -noautowire $rtl; hierarchy -check -top feline_unit; proc; $passes;
             write_verilog -noattr $work/feline_unit.v"

# The vectors of each mode, their memories as long as the longest, for one netlist to read them all.
count() { grep -vc '^//' "$1"; }
seed=0
lines=0
for mode in $modes; do
  seed=$((seed + 1))
  mkdir -p "$work/$mode"
  build/feline vectors --random "$lookups" --mode "$mode" --seed "$seed" --output "$work/$mode" >/dev/null
  lines=$((lines > $(count "$work/$mode/memory.hex") ? lines : $(count "$work/$mode/memory.hex")))
done
for mode in $modes; do
  for ((line = $(count "$work/$mode/memory.hex"); line < lines; ++line)); do echo 0; done >>"$work/$mode/memory.hex"
done
width() { sed -n '1s/.* beats, \([0-9]*\) bits.*/\1/p' "$work/$mode/$1.hex"; }
line_width=$(sed -n 's/.* LineWidth = \([0-9]*\);.*/\1/p' tables/generated/feline_pkg.sv)
iverilog -g2012 -o "$work/netlist" -s netlist_tb \
  -P "netlist_tb.Requests=$lookups" -P "netlist_tb.Lines=$lines" \
  -P "netlist_tb.SamplerWidth=$(width sampler)" -P "netlist_tb.RequestWidth=$(width request)" \
  -P "netlist_tb.PixelWidth=$(width accumulate)" -P "netlist_tb.LineWidth=$line_width" \
  "$work/feline_unit.v" tests/rtl/netlist_tb.v
for mode in $modes; do
  (cd "$work/$mode" && vvp -n ../netlist) | tee "$work/netlist.log"
  grep -q "^PASS: $lookups pixels" "$work/netlist.log"
done
