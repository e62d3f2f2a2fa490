// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "testbench/prove/leaf.h"
#include "testbench/prove/netlist.h"
#include "testbench/prove/rtl_leaf.h"
#include "testbench/prove/steady_program.h"

namespace feline::prove {

// Who is compared with exact arithmetic.
inline constexpr std::array<std::string_view, 3> kWitnesses{"model", "rtl", "netlist"};

// The input of a domain at which an error is largest, as Leaf::quantities counts it.
struct Worst {
  double value = -1;
  std::uint64_t input = 0;
  // The worse of both; of equal ones the first, in whatever order they come.
  void keep_worse(const Worst& other);
  bool operator==(const Worst&) const = default;
};

// A witness that disagrees with exact arithmetic, with what went in and came out.
struct Disagreement {
  std::string_view witness;
  std::uint64_t input = 0;
  std::vector<std::uint64_t> inputs, exact, got;
};

struct ChunkResult {
  std::string digest;  // of inputs and exact outputs, 128 bits in hex
  std::array<std::uint64_t, kWitnesses.size()> mismatches{};
  std::optional<Disagreement> first{};
  std::vector<Worst> worst{};  // of each quantity
};

// One thread's means of proving chunks.
class ChunkProver {
 public:
  // Every witness over the inputs of one chunk.
  ChunkResult prove(const Leaf& leaf, std::uint64_t chunk, const Netlist& netlist);

 private:
  RtlLeaf& rtl_of(std::string_view wrapper);
  std::map<std::string_view, std::unique_ptr<RtlLeaf>> rtl_;
  SteadyProgram program_;
  std::vector<std::uint64_t> inputs_, exact_, got_;
  std::vector<double> errors_;
  std::vector<std::uint64_t> scratch_;
};

}  // namespace feline::prove
