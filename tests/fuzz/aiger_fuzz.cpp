// SPDX-License-Identifier: Apache-2.0
// Yosys' AIGER: what is taken is written as it was read, and so is what is made of it.
#include "testbench/mutation/aiger.h"
#include "tests/fuzz/fuzz.h"

void feline::fuzz::run(Input input) {
  accepts<std::runtime_error>([&] {
    const mutation::Aiger aiger = mutation::read_aiger(input.rest());
    const std::string binary = mutation::to_binary(aiger);
    require(mutation::to_binary(mutation::read_aiger(binary)) == binary, "to_binary: the same again");
    const mutation::Aiger fixed = mutation::with_input(aiger, "mutant", 5);
    mutation::read_aiger(mutation::to_binary(mutation::cut_latches(fixed)));
    mutation::read_aiger(mutation::to_binary(mutation::observed_difference(aiger, fixed)));
  });
}
