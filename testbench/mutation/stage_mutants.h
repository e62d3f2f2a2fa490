// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "testbench/mutation/elaboration.h"
#include "testbench/mutation/mutant.h"

namespace feline::mutation {

// The name of what is between the stages.
inline constexpr std::string_view kUnitName = "unit";

// One stage and its mutants, or what is between the stages, "unit"; prepared in `directory`: the stage with a site at
// every port as feline_STAGE.v, which testbench/mutation/build.sh builds into the unit, and its ROMs with any bit
// wrong.
class StageMutants {
 public:
  // Runs Yosys. Throws InputError when it is not there.
  StageMutants(std::string stage, const std::filesystem::path& source, const std::filesystem::path& directory);

  const std::string& stage() const { return stage_; }
  const std::vector<Site>& sites() const { return sites_; }
  // Of the stage's own ports: what is wrong in the unit that it is in, for logic() alone.
  const std::vector<Site>& ports() const { return ports_; }
  const std::vector<Rom>& roms() const { return roms_; }
  const Elaboration& elaboration() const { return elaboration_; }
  // What a result follows from.
  const std::string& text() const { return text_; }

  // "$add at rtl/feline_walk.sv:53.19-53.60, port B, bit 2 of 10: invert", "$mux in u_length at ...", "ROM weight, word
  // 17, bit 3". No two mutants of a stage are described alike.
  std::string describe(const Mutant& mutant) const;

  // Whether a mutant is described so.
  bool has(std::string_view description) const;

  // Whether it may touch valid or ready, or when a register takes what it holds: not in a module of the stage's
  // arithmetic, nor a port of data.
  bool in_stream(const Mutant& mutant) const;

  // The stage's logic with its registers as binary AIGER with the mutant as inputs mutant[0] to mutant[63]; memories
  // are registers, or cut (cut_memories); sites other than those of `mutants` left out. Of a ROM's bit the whole word
  // is what an input any says. With rules/feline_rules_STAGE.sv, if there is one: legal_o says that what comes in is
  // what can come. Of the unit with all that is in its stages. Throws std::runtime_error.
  std::string logic(const std::vector<Mutant>& mutants, bool without_memories = false) const;

 private:
  void write_roms(const std::vector<std::string>& names);
  std::string rom_file(const std::string& name) const;

  std::string stage_;
  std::filesystem::path source_, directory_;
  Elaboration elaboration_;
  std::vector<Site> sites_;
  std::vector<Site> ports_;
  std::vector<std::string> labels_;  // of the sites
  std::vector<Rom> roms_;
  std::string text_;
};

// Whether it is a pipeline of stream registers alone, whose proofs of streams (feline prove) leave only what a beat
// makes of another one.
bool is_pipeline(const StageMutants& stage);

}  // namespace feline::mutation
