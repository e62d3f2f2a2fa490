// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "testbench/prove/netlist.h"

namespace feline::prove {

// A netlist's program under what is constant in a block of inputs, made again only when that changes.
class SteadyProgram {
 public:
  // Of bits from `place` on; `inputs` are lanes of so many words. The netlist is to outlive this.
  const NetlistProgram& of(const Netlist& netlist, std::size_t place, std::span<const std::uint64_t> inputs,
                           std::size_t words);

 private:
  std::optional<NetlistProgram> program_;
  const Netlist* netlist_ = nullptr;
  std::vector<std::uint64_t> mask_, bits_;
};

}  // namespace feline::prove
