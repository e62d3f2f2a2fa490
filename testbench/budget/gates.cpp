// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/gates.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tables/emit.h"
#include "testbench/error.h"

namespace feline {

std::string unit_source(const Config& config, const std::filesystem::path& rtl) {
  const Roms roms = make_roms(config);
  const PackageParts parts = package_parts(config);
  std::string source = emit_package(config, parts, fingerprint(config, parts, roms));
  std::vector<const Rom*> in_order = roms.all();
  std::ranges::sort(in_order, {}, &Rom::name);
  for (const Rom* const rom : in_order) source += emit_rom_module(*rom);
  std::vector<std::filesystem::path> modules;
  if (std::filesystem::is_directory(rtl)) {
    for (const auto& entry : std::filesystem::directory_iterator(rtl)) {
      if (entry.path().extension() == ".sv") modules.push_back(entry.path());
    }
  }
  if (modules.empty()) bad_input(rtl.string(), "--source", "no .sv files", "a directory with rtl/*.sv");
  std::ranges::sort(modules);
  for (const std::filesystem::path& module : modules) {
    std::ifstream file(module, std::ios::binary);
    if (!file) bad_input(module.string(), "open", "no file that can be read", "a file");
    source.append(std::istreambuf_iterator<char>(file), {});
  }
  return source;
}

GateCount synthesized_gates(const Synthesis& synthesis, const std::filesystem::path& rtl) {
  return [&synthesis, rtl](const Config& config) {
    double gates = 0;
    for (const StageArea& stage : synthesis.unit(unit_source(config, rtl))) gates += stage.gates;
    return gates;
  };
}

}  // namespace feline
