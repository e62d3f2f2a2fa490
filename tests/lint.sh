#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Layout, formatting, and the RTL in both front ends. Prints the command that mends what it finds.
set -euo pipefail
cd "$(dirname "$0")/.."
source testbench/build.sh

fail() {
  echo "lint: $1" >&2
  exit 1
}

# The top level, exactly; every hand-written file within 400 lines.
extra=$(find . -mindepth 1 -maxdepth 1 -not -name '.*' -not -name 'build*' -printf '%f\n' |
  grep -vxE 'CMakeLists.txt|README.md|model|rtl|tables|testbench|tests' || true)
[[ -z $extra ]] || fail "the top level has entries that the layout does not name: $extra"
sources=$(find model rtl tables testbench tests -not -path 'tables/generated/*' \( -name '*.cpp' -o -name '*.h' \))
long=$(find CMakeLists.txt README.md model rtl tables testbench tests -type f -not -path 'tables/generated/*' -not -name '*.png' -not -name certificate.json -not -path 'tests/fuzz/corpus/*' \
  -exec awk 'END { if (NR > 400) print FILENAME ": " NR }' {} \;)
[[ -z $long ]] || fail "files over 400 lines: $long"
# clang-format leaves strings whole.
wide=$(awk 'length > 120 { print FILENAME ":" FNR }' $sources)
[[ -z $wide ]] || fail "lines over 120 columns: $wide"

# Data flows one way: tables -> model -> testbench -> tests; OpenImageIO in the testbench only.
flows() {
  local room=$1 allowed=$2 bad
  bad=$(grep -rnE '#include "(tables|model|rtl|testbench|tests)/' "$room" --include='*.h' --include='*.cpp' |
    grep -vE "#include \"($allowed)/" || true)
  [[ -z $bad ]] || fail "$room may include $allowed only:
$bad"
}
flows tables tables
flows model 'tables|model'
flows testbench 'tables|model|testbench'
outside=$(grep -rln 'OpenImageIO' tables model rtl || true)
[[ -z $outside ]] || fail "OpenImageIO is for the testbench only: $outside"
if [[ -d model/reference ]]; then
  shared=$(grep -rnE '#include "model/[a-z_]+\.h"' model/reference || true)
  [[ -z $shared ]] || fail "model/reference shares no arithmetic with the stages: $shared"
fi

# The stages are templates: the linker keeps one copy of each, which must not be one that is compiled without optimization.
light=$(grep -lE '#include "model/(unit|group|footprint|plan|walk|address|fetch|filter|accumulate|shortcuts)\.h"' \
  testbench/program/*.cpp testbench/page/*.cpp testbench/cosim/mismatch.cpp \
  testbench/prune/{pruned_main,profile,prune}.cpp testbench/{gbuffer,image,image_io}.cpp |
  grep -vxE 'testbench/program/(command_vectors|explanation)\.cpp' || true)
[[ -z $light ]] || fail "the stages in what CMakeLists.txt compiles with -O0: $light"

# shellcheck disable=SC2086
clang-format --dry-run -Werror $sources || fail "formatting; mend it with: clang-format -i \$(git ls-files '*.cpp' '*.h' ':!tables/generated')"

rtl="tables/generated/feline_pkg.sv $(echo tables/generated/feline_rom_*.sv) $(echo rtl/*.sv)"
# shellcheck disable=SC2086
verilator --lint-only -Wall --no-timing --top-module feline_unit $rtl || fail "verilator -Wall"
leaves="${rtl/rtl\/feline_stream_register.sv/testbench/prove/rtl_leaves/feline_stream_register.sv}"
for leaf in testbench/prove/rtl_leaves/feline_leaf_*.sv; do
  # shellcheck disable=SC2086
  verilator --lint-only -Wall --no-timing --top-module "$(basename "$leaf" .sv)" $leaves "$leaf" || fail "verilator -Wall of $leaf"
done
# Also that no wire leads from the last ready to the first; the second selection shows that the search finds wires.
# shellcheck disable=SC2086
yosys -q -p "read_verilog -sv -noautowire $rtl; hierarchy -check -top feline_unit; proc; check -assert; flatten; opt_clean
             select -assert-none i:accumulate_ready_i %coe* o:request_ready_o %i
             select -assert-any i:accumulate_ready_i %coe* o:taken_o %i" ||
  fail "yosys does not take the RTL, or accumulate_ready_i reaches request_ready_o within a cycle"
echo "lint: clean"
