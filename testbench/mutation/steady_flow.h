// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "testbench/mutation/copy_gates.h"

// Pipelines that the same beat goes through in every cycle, all of it valid and ready, without a reset. What comes out
// says all of a pipeline that has no state but its streams', and whose beats move by themselves.
namespace feline::mutation {

// Whether what moves a pipeline's beats, all X_valid_o and X_ready_o, follows from nothing but X_valid_i, X_ready_i and
// rst_i, now and before: no beat's data has a part in it.
bool moves_by_itself(const Aiger& aiger);

// One pipeline, whose gates in all cycles are made in another circuit of the same inputs.
class SteadyRun {
 public:
  explicit SteadyRun(const Aiger& aiger);
  void step(HashedGates& gates);
  // In the last cycle.
  std::uint32_t output(std::size_t i) const { return moved(aiger_.outputs[i].literal); }
  // Output legal_o, or 1.
  std::uint32_t legal() const;
  // What the latches hold after it.
  std::vector<std::uint32_t>& state() { return state_; }
  // Whether every output X_valid_o is 1 in the last cycle, whatever the beat, if it is legal: the pipeline is not
  // longer.
  bool comes_out() const;

 private:
  std::uint32_t moved(std::uint32_t literal) const { return variables_[literal / 2] ^ (literal & 1); }

  const Aiger& aiger_;
  std::vector<std::uint32_t> given_, state_, variables_;
};

// A pipeline and one with a mutant side by side, of the same inputs, latches and outputs.
class SteadyPair {
 public:
  SteadyPair(const Aiger& right, const Aiger& wrong);
  SteadyPair(const SteadyPair&) = delete;
  SteadyPair& operator=(const SteadyPair&) = delete;
  void step();
  // A circuit whose output is 1 when what a latch holds now differs, or an output in the last cycle, of a beat that was
  // legal.
  Aiger registers_differ();
  Aiger outputs_differ();
  // A circuit whose output is 1 for a beat that was legal so far.
  Aiger legal() { return with_output(1); }
  // From now on the latches of the one with the mutant hold what the others do.
  void make_same() { wrong_.state() = right_.state(); }
  const SteadyRun& right() const { return right_; }

 private:
  // 1 when this literal is, of a beat that was legal so far.
  Aiger with_output(std::uint32_t literal);

  Aiger both_;
  HashedGates gates_;
  SteadyRun right_, wrong_;
  std::size_t outputs_;
  std::uint32_t legal_ = 1;
};

}  // namespace feline::mutation
