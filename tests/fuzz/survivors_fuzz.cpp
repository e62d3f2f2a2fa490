// SPDX-License-Identifier: Apache-2.0
// survivors.json of feline mutate: every mutant that is taken has a reason.
#include "testbench/mutation/mutation_report.h"
#include "tests/fuzz/fuzz.h"

void feline::fuzz::run(Input input) {
  const auto path = file_with("survivors.json", input.rest());
  accepts([&] {
    for (const auto& [stage, mutants] : mutation::read_known_survivors(path)) {
      for (const auto& [mutant, reason] : mutants)
        require(reason.size() > reason.find(": ") + 2, "read_known_survivors: reasons");
    }
  });
}
