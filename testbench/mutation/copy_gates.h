// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "testbench/mutation/aiger.h"

namespace feline::mutation {

// Gives each variable's literal in another circuit, whose gates `add` makes. What `from` has for variables up to its
// last latch is given.
template <typename Add>
std::vector<std::uint32_t> copy_gates(const Aiger& from, std::vector<std::uint32_t> variables, Add&& add) {
  const auto moved = [&](std::uint32_t literal) { return variables[literal / 2] ^ (literal & 1); };
  for (const Aiger::Gate& gate : from.gates) variables.push_back(add(moved(gate.left), moved(gate.right)));
  return variables;
}

// Makes gates of a circuit, equal ones once (structural hashing).
class HashedGates {
 public:
  explicit HashedGates(Aiger& aiger) : aiger_(aiger) {}
  std::uint32_t operator()(std::uint32_t left, std::uint32_t right) {
    const auto [place, is_new] = known_.emplace(std::uint64_t{std::max(left, right)} << 32 | std::min(left, right), 0);
    if (is_new) place->second = aiger_.add_gate(left, right);
    return place->second;
  }
  std::uint32_t different(std::uint32_t a, std::uint32_t b) { return either((*this)(a, b ^ 1), (*this)(a ^ 1, b)); }
  std::uint32_t either(std::uint32_t a, std::uint32_t b) { return (*this)(a ^ 1, b ^ 1) ^ 1; }

 private:
  Aiger& aiger_;
  std::unordered_map<std::uint64_t, std::uint32_t> known_;
};

}  // namespace feline::mutation
