// SPDX-License-Identifier: Apache-2.0
// Where the unit's wires enter and leave a stage.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tables/stages.h"
#include "testbench/mutation/fate.h"

namespace feline::mutation {
namespace {

// The stage's own mutant that is the same.
Mutant at_port(const Mutant& mutant, const Site& in_unit, const StageMutants& stage) {
  const auto port = std::ranges::find(stage.ports(), in_unit.port, &Site::port);
  if (port == stage.ports().end() || port->width != in_unit.width) {
    throw std::runtime_error(stage.stage() + " has no port " + in_unit.port);
  }
  Mutant same = mutant;
  same.site = port->number;
  return same;
}

}  // namespace

void prove_ports(const StageMutants& unit, const Workshop& workshop, std::vector<Fate>& fates) {
  for (const std::string_view name : kStageNames) {
    const std::string module = fmt::format("feline_{}", name);
    std::vector<Fate*> open;
    for (Fate& fate : fates) {
      if (!fate.is_open() || fate.mutant.kind == Kind::kRomBit) continue;
      if (unit.sites()[fate.mutant.site - 1].type == module) open.push_back(&fate);
    }
    if (open.empty()) continue;
    const std::filesystem::path directory = workshop.directory / unit.stage() / name;
    std::filesystem::create_directories(directory);
    const StageMutants stage(std::string(name), workshop.source, directory);
    std::vector<Fate> at_ports;
    for (const Fate* const fate : open) {
      at_ports.push_back({at_port(fate->mutant, unit.sites()[fate->mutant.site - 1], stage), fate->name});
    }
    compare_logic(stage, Fate::Logic::kUnobserved, workshop, at_ports);
    for (std::size_t i = 0; i < open.size(); ++i) {
      open[i]->logic = at_ports[i].logic;
      open[i]->differs = at_ports[i].differs;
    }
  }
}

}  // namespace feline::mutation
