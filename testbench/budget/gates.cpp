// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/gates.h"

#include <algorithm>

#include "tables/emit.h"

namespace feline {

std::string unit_source(const Config& config, const std::filesystem::path& rtl) {
  const Roms roms = make_roms(config);
  const PackageParts parts = package_parts(config);
  std::string source = emit_package(config, parts, fingerprint(config, parts, roms));
  std::vector<const Rom*> in_order = roms.all();
  std::ranges::sort(in_order, {}, &Rom::name);
  for (const Rom* const rom : in_order) source += emit_rom_module(*rom);
  return source + modules_text(rtl);
}

GateCount synthesized_gates(const Synthesis& synthesis, const std::filesystem::path& rtl) {
  return [&synthesis, rtl](const Config& config) {
    double gates = 0;
    for (const StageArea& stage : synthesis.unit(unit_source(config, rtl))) gates += stage.gates;
    return gates;
  };
}

}  // namespace feline
