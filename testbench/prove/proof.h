// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "testbench/prove/leaf_synthesis.h"

namespace feline::prove {

// What is proved of all inputs at once, by Yosys and ABC: a module proofs/feline_proof_<name>.sv whose only output,
// broken_o, can never be 1.
struct Proof {
  enum class Method {
    kEquivalence,   // of a module without state: SAT sweeping (&cec)
    kReachability,  // from reset, for ever: property-directed reachability (pdr)
    kInduction,     // from reset, for ever: if it holds in a cycle, it holds in the next (bmc3, ind)
  };
  enum class Registers { kReal, kWires };  // kWires: in stream registers' place, as in the leaves
  // A bug for the same proof to find, or it shows nothing: a text that is once in a file of the RTL, and what it
  // becomes.
  using Control = LeafSynthesis::Change;

  std::string_view name;
  std::string_view claim;
  Method method;
  std::vector<Control> controls;  // each must be found
  Registers registers = Registers::kReal;
};

const std::vector<Proof>& all_proofs();

struct ProofResult {
  enum class Verdict { kHolds, kBroken, kControlNotFound, kUndecided } verdict = Verdict::kUndecided;
  std::string said;  // what ABC says, unless it holds
  double seconds = 0;
};

// "abc pdr".
std::string_view method_name(const Proof& proof);

// Throws InputError when a tool is missing or does not take the files.
ProofResult run_proof(const Proof& proof, const LeafSynthesis& synthesis);

// Of the proof, its method, its controls and all that it is made from, in hex. Throws InputError for a control that is
// not once in its file.
std::string proof_hash(const Proof& proof, const LeafSynthesis& synthesis);

}  // namespace feline::prove
