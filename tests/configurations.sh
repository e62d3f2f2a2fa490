#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Other configurations: RTL and model compared in each, made by the README's recipe in a copy of the tree.
# usage: tests/configurations.sh [NAME|SEED...]   without arguments: least, most, finest, bare, front and lean; a number
#                                                 is the seed of a random configuration
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
source testbench/build.sh
source tests/packages.sh
feline_install_tests

# Every field with its legal range, from tables/config.h.
ranges() { sed -n 's/^  int \([a-z0-9_]*\) = .*; *\/\/ \([a-z0-9_]*\) \.\. \([0-9]*\)[:,].*/\1 \2 \3/p' tables/config.h; }
features() { sed -n 's/^  bool \([a-z0-9_]*\) = true;.*/\1/p' tables/config.h; }

[[ $(ranges | wc -l) -eq $(grep -cE '^  int [a-z0-9_]+ = ' tables/config.h) ]] ||
  { echo "configurations.sh: a field of tables/config.h does not state its range" >&2; exit 1; }

# NAME=VALUE of each field that differs from the default.
fields_of() {
  case $1 in
    least) ranges | awk '{ print $1 "=" ($2 == "channel_fraction_bits" ? 2 : $2) }' ;;
    # Positions have 19 bits of size and guard at most: here those of guard, below those of size.
    finest) printf '%s\n' max_size_log2=4 guard_bits=15 least_range_log2=19 ;;
    most) ranges | awk '{ print $1 "=" ($1 == "guard_bits" ? 4 : $1 == "least_range_log2" ? 0 : $3) }' ;;
    # Nothing but nearest, bilinear and trilinear; and all of the front with few bits and many probes, where a shortened
    # footprint comes nearest to vanishing.
    bare)
      printf '%s=false\n' ext simple_feline table_feline gaussian factors srgb mirrored_repeat clamp_to_border
      # Clamped coordinates saturate far beyond what positions reach.
      printf 'least_range_log2=17\n'
      ;;
    front) printf '%s\n' gaussian=false srgb=false mirrored_repeat=false clamp_to_border=false table_rows=7 \
      table_columns=6 max_probes=32 mantissa_bits=6 factor_bits=10 ;;
    # What a scene leaves: one mode, one wrap mode, one format, powers of two, few probes, levels and exponents.
    lean)
      printf '%s=false\n' nearest bilinear trilinear ext table_feline gaussian factors mirrored_repeat clamp_to_edge \
        clamp_to_border r8 rg8 srgb alpha any_size nearest_texels dvdx
      printf '%s\n' exponent_bits=3 max_size_log2=7 guard_bits=9 max_probes=5 max_levels=5
      ;;
    *[!0-9]*) echo "configurations.sh: no configuration $1: legal is least, most, finest, bare, front, lean or a seed" >&2; exit 2 ;;
    *)
      ranges | awk -v seed="$1" 'BEGIN { srand(seed) } {
        low = $2 == "channel_fraction_bits" ? channel : $2
        value = low + int(rand() * ($3 - low + 1))
        if ($1 == "table_columns") value -= value % 2
        if ($1 == "channel_fraction_bits") channel = value
        if ($1 == "max_size_log2") size = value
        if ($1 == "guard_bits") value = value % (20 - size)
        print $1 "=" value }'
      features | awk -v seed="$1" 'BEGIN { srand(seed + 1000) } {
        # Something must be left of modes, wrap modes, formats and kinds of texels.
        keeps = $1 ~ /^(trilinear|repeat|rgba8|linear_texels)$/
        print $1 "=" (!keeps && rand() < 0.5 ? "false" : "true") }'
      ;;
  esac
}

check() {
  local name=$1 copy=$root/build-configurations/$1 field fields
  fields=$(fields_of "$name")
  mkdir -p "$copy"
  rm -rf "$copy"/{model,rtl,tables,testbench,tests}
  cp -r CMakeLists.txt model rtl tables testbench tests "$copy"
  for field in $fields; do
    sed -i -E "s/^  (int|bool) ${field%=*} = [a-z0-9]+;/  \1 ${field%=*} = ${field#*=};/" "$copy/tables/config.h"
    grep -q "^  [a-z]* ${field%=*} = ${field#*=};" "$copy/tables/config.h"
  done
  printf '%s: %s\n' "$name" "$(tr '\n' ' ' <<<"$fields")"
  (
    cd "$copy"
    ./testbench/generate
    local rtl
    rtl="tables/generated/feline_pkg.sv $(echo tables/generated/feline_rom_*.sv) $(echo rtl/*.sv)"
    yosys -q -p "read_verilog -sv -noautowire $rtl; hierarchy -check -top feline_unit; proc; check -assert"
    ./testbench/run --random 200000 --stalls 0.1 --memory-latency 3 --no-wave --output . | tail -n 2 | head -n 1
    # The scenes have textures of up to 1024 texels, not all of them powers of two.
    (($(sed -n 's/^  int max_size_log2 = \([0-9]*\);.*/\1/p' tables/config.h) < 10)) && return
    grep -q 'bool any_size = false' tables/config.h && return
    ./testbench/run --scene all --mode all --kernel all --wrap all --size 24 --stalls 0.1 --memory-latency 3 --no-wave \
      --output . | grep '^RTL'
  )
}

[[ $# -gt 0 ]] || set -- least most finest bare front lean
for name in "$@"; do check "$name"; done
