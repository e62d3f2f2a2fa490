// SPDX-License-Identifier: Apache-2.0
// In the registers of a pipeline, and in the unit's own.
#include <map>

#include "testbench/mutation/fate.h"
#include "testbench/mutation/same_sites.h"
#include "testbench/mutation/sat.h"
#include "testbench/parallel.h"
#include "testbench/progress.h"

namespace feline::mutation {
namespace {

// The register with these mutants of its own.
Aiger register_logic(const Elaboration& elaboration, const std::string& module, const std::vector<Mutant>& mutants,
                     const Workshop& workshop, const std::filesystem::path& directory) {
  const std::vector<std::uint32_t> only = site_numbers(mutants);
  const auto site = workshop.source / "testbench" / "mutation" / "feline_mutation_site.sv";
  const auto netlist = instrument(elaboration.netlist, module, &only, true).netlist;
  return read_aiger(to_gates(netlist, module, read_command({std::filesystem::absolute(site)}), directory));
}

void prove_register(const StageMutants& stage, const std::string& module, const std::vector<std::string>& paths,
                    const Workshop& workshop, std::vector<Fate>& fates) {
  const std::filesystem::path directory = workshop.directory / stage.stage();
  const Elaboration elaboration = elaborate_module(module, "feline_" + stage.stage(), directory);
  const std::vector<Site> own = instrument(elaboration.netlist, module, nullptr, true).sites;
  std::map<std::uint32_t, std::uint32_t> sites;
  for (const std::string& path : paths) sites.merge(same_sites(stage.sites(), path, own, ""));
  std::vector<Fate*> open;
  std::vector<Mutant> mutants;
  for (Fate& fate : fates) {
    const auto site = sites.find(fate.mutant.site);
    if (!fate.is_open() || fate.mutant.kind == Kind::kRomBit || site == sites.end()) continue;
    open.push_back(&fate);
    mutants.push_back(fate.mutant);
    mutants.back().site = site->second;
  }
  if (open.empty()) return;
  const std::string key = workshop.cache.key({"register", workshop.proofs, stage.text(), module, codes_of(open)});
  std::string proved = workshop.cache.read(key).value_or("");
  if (proved.size() != open.size()) {
    const Aiger logic = register_logic(elaboration, module, mutants, workshop, directory);
    const Aiger right = with_input(logic, "mutant", 0);
    proved.assign(open.size(), '0');
    for_each_index(0, static_cast<std::int64_t>(open.size()), [&](std::int64_t i) {
      const auto place = static_cast<std::size_t>(i);
      if (unobserved(right, with_input(logic, "mutant", code(mutants[place])))) proved[place] = '1';
    });
    workshop.cache.write(key, proved);
  }
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (proved[i] == '1') open[i]->logic = Fate::Logic::kUnobserved;
  }
}

}  // namespace

void prove_registers(const StageMutants& stage, const Workshop& workshop, std::vector<Fate>& fates) {
  if (!is_pipeline(stage) && stage.stage() != kUnitName) return;
  std::map<std::string, std::vector<std::string>> paths;  // by module
  for (const auto& [path, module] : stage.elaboration().instances) {
    const bool is_register = module.find("feline_stream_register") != std::string::npos ||
                             module.find("feline_spill_register") != std::string::npos;
    if (is_register) paths[module].push_back(path);
  }
  Progress progress(stage.stage() + ": registers", paths.size());
  for (const auto& [module, of_module] : paths) {
    prove_register(stage, module, of_module, workshop, fates);
    progress.advance(1);
  }
}

}  // namespace feline::mutation
