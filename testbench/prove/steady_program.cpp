// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/steady_program.h"

namespace feline::prove {

const NetlistProgram& SteadyProgram::of(const Netlist& netlist, std::size_t place,
                                        std::span<const std::uint64_t> inputs, std::size_t words) {
  std::vector<std::uint64_t> mask(words, 0);
  std::vector<std::uint64_t> bits(inputs.begin(), inputs.begin() + static_cast<std::ptrdiff_t>(words));
  for (std::size_t bit = place; bit < netlist.inputs.size(); ++bit) mask[bit / 64] |= std::uint64_t{1} << (bit % 64);
  for (std::size_t i = 0; i < inputs.size(); ++i) mask[i % words] &= ~(inputs[i] ^ bits[i % words]);
  for (std::size_t k = 0; k < words; ++k) bits[k] &= mask[k];
  if (netlist_ != &netlist || mask != mask_ || bits != bits_) {
    program_.emplace(netlist.with_constants(mask, bits));
    netlist_ = &netlist;
    mask_ = mask;
    bits_ = bits;
  }
  return *program_;
}

}  // namespace feline::prove
