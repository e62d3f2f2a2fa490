// SPDX-License-Identifier: Apache-2.0
// On the leaves of feline prove.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "testbench/mutation/fate.h"
#include "testbench/mutation/leaf_mutants.h"
#include "testbench/mutation/leaf_trial.h"

namespace feline::mutation {
namespace {

// Whether what differs nowhere in the leaf's domain is the same.
bool is_complete(const prove::Leaf& leaf, const std::string& instance) {
  const std::string_view in = leaf.complete_in;
  return leaf.complete || (!in.empty() && (instance == in || instance.starts_with(fmt::format("{}.", in))));
}

// On all domains of one wrapper.
void try_leaf(const StageMutants& stage, std::string_view wrapper, const std::vector<const prove::Leaf*>& leaves,
              bool quick, const Workshop& workshop, std::vector<Fate>& fates) {
  constexpr std::uint64_t kQuick = std::uint64_t{1} << 24;
  constexpr std::uint64_t kMost = std::uint64_t{1} << 32;
  const std::filesystem::path directory = workshop.directory / stage.stage() / wrapper;
  std::filesystem::create_directories(directory);
  const LeafMutants in_leaf(stage, wrapper, workshop.source, directory);
  std::vector<Fate*> open;
  std::vector<Mutant> mutants;
  for (Fate& fate : fates) {
    const auto mutant = in_leaf.in_leaf(fate.mutant);
    if (!fate.is_open() || !mutant) continue;
    open.push_back(&fate);
    mutants.push_back(*mutant);
  }
  std::optional<Aiger> logic;
  for (const prove::Leaf* const leaf : leaves) {
    if (open.empty()) return;
    const std::uint64_t limit = quick ? kQuick : leaf->complete ? leaf->domain.count : kMost;
    const std::uint64_t inputs_tried = std::min(limit, leaf->domain.count);
    const std::string key = workshop.cache.key(
        {"leaf", fmt::format("{}", inputs_tried), workshop.proofs, stage.text(), leaf->name, codes_of(open)});
    nlohmann::json inputs = nlohmann::json::parse(workshop.cache.read(key).value_or("[]"));
    if (inputs.size() != open.size()) {
      if (!logic) logic = in_leaf.logic(mutants);
      std::vector<std::uint64_t> codes;
      for (const Mutant& mutant : mutants) codes.push_back(code(mutant));
      inputs = nlohmann::json::array();
      for (const auto& input : differing_inputs(*leaf, *logic, codes, inputs_tried)) {
        inputs.push_back(input ? nlohmann::json(*input) : nlohmann::json());
      }
      workshop.cache.write(key, inputs.dump());
    }
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (!inputs[i].is_null()) {
        open[i]->tier = kExhaustive;
        open[i]->stage = leaf->name;
        open[i]->lookup = inputs[i];
      } else if (inputs_tried == leaf->domain.count && is_complete(*leaf, in_leaf.instance(mutants[i]))) {
        if (!open[i]->differs.empty()) {
          throw std::runtime_error(
              fmt::format("{}: nothing differs in {}, but SAT says: {}", open[i]->name, leaf->name, open[i]->differs));
        }
        open[i]->logic = Fate::Logic::kSame;
      }
    }
    for (std::size_t i = open.size(); i-- > 0;) {
      if (open[i]->is_open()) continue;
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
      mutants.erase(mutants.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

}  // namespace

void try_leaves(const StageMutants& stage, bool quick, const Workshop& workshop, std::vector<Fate>& fates) {
  std::map<std::string_view, std::vector<const prove::Leaf*>> by_wrapper;
  for (const prove::Leaf& leaf : prove::all_leaves()) {
    if (leaf.stage() == stage.stage()) by_wrapper[leaf.wrapper].push_back(&leaf);
  }
  for (const auto& [wrapper, leaves] : by_wrapper) try_leaf(stage, wrapper, leaves, quick, workshop, fates);
}

}  // namespace feline::mutation
