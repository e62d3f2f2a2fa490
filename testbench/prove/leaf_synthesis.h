// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "testbench/measure/cache.h"
#include "testbench/prove/leaf.h"
#include "testbench/prove/netlist.h"
#include "testbench/prove/sources.h"

namespace feline::prove {

// The RTL's text for the second engine and the proofs: modules from the files of this project, without comments, so
// that these change nothing.
class LeafSynthesis {
 public:
  // `root` is where the sources lie, for messages.
  LeafSynthesis(const Sources& sources, std::filesystem::path root);

  // "Yosys 0.23". Throws InputError, which says what to install, when there is none.
  std::string version() const;

  // A leaf's wrapper, synthesized to gates by Yosys, or as the cache has it. Throws InputError with what Yosys says.
  Netlist netlist(std::string_view wrapper, const Cache& cache) const;

  // Of the modules that a leaf is made of, with the package, and of the C++ that evaluates it; in hex.
  std::string leaf_hash(const Leaf& leaf) const;

  // The modules that a proof is made of, with the package. `file` is a path from the root; a text that is in it once
  // becomes another. Throws InputError naming the file when it is not.
  struct Change {
    std::string_view file, original, mutant;
  };
  // With `wires` the stream register is the leaves', wires.
  std::string proof_text(std::string_view proof, const Change* change, bool wires) const;

 private:
  struct Module {
    std::string name;
    std::string file;  // from the root
    std::string text;
  };

  // The package and what `top` is made of, in the order of names; `own` come before those of the RTL.
  std::string closure(const std::string& top, const std::vector<Module>& own, const Change* change) const;

  std::filesystem::path root_;
  std::string package_;
  std::vector<Module> rtl_, leaves_, proofs_;
  Sources evaluating_;  // of C++
};

}  // namespace feline::prove
