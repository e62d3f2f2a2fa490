// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/model_mutants.h"

#include <gtest/gtest.h>

#include "testbench/mutation/mutation_report.h"

namespace feline::mutation {
namespace {

TEST(mutation_model_mutants, reasons_are_of_mutants_that_there_are) {
  const std::filesystem::path source = FELINE_SOURCE_DIR;
  const auto names = model_mutant_names(source);
  EXPECT_GT(names.at("model/plan.h").size(), 300U);
  for (const auto& [file, mutants] : read_known_survivors(source / "testbench/mutation/model_survivors.json")) {
    ASSERT_TRUE(names.contains(file)) << file;
    for (const auto& [mutant, reason] : mutants) EXPECT_TRUE(names.at(file).contains(mutant)) << mutant;
  }
}

}  // namespace
}  // namespace feline::mutation
