// SPDX-License-Identifier: Apache-2.0
// Netlists of gates: what is taken evaluates, and to the same when its inputs are constants.
#include "testbench/prove/netlist.h"
#include "tests/fuzz/fuzz.h"

namespace feline::prove {
namespace {

using Words = std::vector<std::uint64_t>;

std::size_t words(std::size_t bits) { return std::max<std::size_t>(1, (bits + 63) / 64); }

Words evaluate(const Netlist& netlist, const Words& inputs) {
  Words outputs(words(netlist.outputs.size()));
  Words scratch;
  NetlistProgram(netlist).evaluate(inputs.data(), inputs.size(), outputs.data(), outputs.size(), 1, scratch);
  return outputs;
}

void check(const Netlist& netlist) {
  const Words everything(words(netlist.inputs.size()), ~std::uint64_t{0});
  for (const std::uint64_t pattern : {0x0ULL, 0xffffffffffffffffULL, 0x5a5a5a5ac3c3c3c3ULL}) {
    const Words inputs(everything.size(), pattern);
    fuzz::require(evaluate(netlist, inputs) == evaluate(netlist.with_constants(everything, inputs), inputs),
                  "with_constants: the same outputs");
  }
}

}  // namespace
}  // namespace feline::prove

void feline::fuzz::run(Input input) {
  accepts<std::runtime_error>([&] { prove::check(prove::Netlist(input.rest(), "m")); });
}
