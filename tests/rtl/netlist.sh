#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Yosys writes the unit as Verilog, Icarus runs it on golden vectors: a second front end and a second simulator.
# usage: tests/rtl/netlist.sh WORK_DIRECTORY [LOOKUPS] [MODES]
set -euo pipefail
cd "$(dirname "$0")/../.."
work=${1:?usage: tests/rtl/netlist.sh WORK_DIRECTORY [LOOKUPS] [MODES]}
lookups=${2:-40}
modes=${3:-nearest bilinear trilinear ext simple table}
mkdir -p "$work"
rtl="tables/generated/feline_pkg.sv $(echo tables/generated/feline_rom_*.sv) $(echo rtl/*.sv)"
yosys -q -p "read_verilog -sv -noautowire $rtl; hierarchy -check -top feline_unit; proc; flatten; opt_clean;
             write_verilog -noattr $work/feline_unit.v"
seed=0
for mode in $modes; do
  seed=$((seed + 1))
  build/feline vectors --random "$lookups" --mode "$mode" --seed "$seed" --output "$work" >/dev/null
  count() { grep -vc '^//' "$work/$1.hex"; }
  width() { sed -n '1s/.* beats, \([0-9]*\) bits.*/\1/p' "$work/$1.hex"; }
  line_width=$(sed -n 's/.* LineWidth = \([0-9]*\);.*/\1/p' tables/generated/feline_pkg.sv)
  iverilog -g2012 -o "$work/netlist" -s netlist_tb \
    -P "netlist_tb.Requests=$(count request)" -P "netlist_tb.Lines=$(count memory)" \
    -P "netlist_tb.SamplerWidth=$(width sampler)" -P "netlist_tb.RequestWidth=$(width request)" \
    -P "netlist_tb.PixelWidth=$(width accumulate)" -P "netlist_tb.LineWidth=$line_width" \
    "$work/feline_unit.v" tests/rtl/netlist_tb.v
  (cd "$work" && vvp -n netlist) | tee "$work/netlist.log"
  grep -q "^PASS: $(count accumulate) pixels" "$work/netlist.log"
done
