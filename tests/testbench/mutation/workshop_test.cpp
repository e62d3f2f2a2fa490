// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/workshop.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "testbench/error.h"
#include "tests/testbench/temp_dir.h"

namespace feline::mutation {
namespace {

TEST(workshop, other_sources_are_refused) {
  const TempDir directory;
  const std::string message = input_error([&] { check_source(directory / "."); });
  EXPECT_NE(message.find("--source"), std::string::npos) << message;
  EXPECT_NO_THROW(check_source(FELINE_SOURCE_DIR));
}

TEST(workshop_long, results_follow_from_what_tries_and_what_proves) {
  const TempDir directory;
  const std::filesystem::path copy = directory / "copy";
  for (const char* const room :
       {"rtl", "model", "tables", "testbench", "tests/model", "tests/support", "tests/tables"}) {
    std::filesystem::create_directories(copy / room);
    std::filesystem::copy(std::filesystem::path(FELINE_SOURCE_DIR) / room, copy / room,
                          std::filesystem::copy_options::recursive);
  }
  const auto touched = [&](const std::string& file) {
    const auto hashes = [&] {
      const Workshop workshop(copy, directory / "work");
      return std::pair(workshop.trials, workshop.proofs);
    };
    const auto before = hashes();
    std::ofstream(copy / file, std::ios::app) << "\n";
    const auto after = hashes();
    return std::pair(before.first != after.first, before.second != after.second);
  };
  EXPECT_EQ(touched("rtl/feline_walk.sv"), std::pair(true, true));
  EXPECT_EQ(touched("model/sampler.h"), std::pair(true, true));
  EXPECT_EQ(touched("testbench/random.h"), std::pair(true, true));
  EXPECT_EQ(touched("model/reference/lookup.h"), std::pair(true, false));
  EXPECT_EQ(touched("testbench/cosim/scoreboard.cpp"), std::pair(true, false));
  EXPECT_EQ(touched("tests/model/plan_test.cpp"), std::pair(true, false));
  EXPECT_EQ(touched("tests/tables/rounding_test.cpp"), std::pair(true, false));
  EXPECT_EQ(touched("testbench/mutation/trial.cpp"), std::pair(true, true));
  EXPECT_EQ(touched("testbench/mutation/rules/feline_rules_plan.sv"), std::pair(false, true));
  EXPECT_EQ(touched("testbench/mutation/survivors.json"), std::pair(false, false));
  EXPECT_EQ(touched("testbench/program/command_mutate.cpp"), std::pair(false, false));
}

TEST(workshop_long, one_run_at_a_time) {
  const TempDir directory;
  const Workshop workshop(FELINE_SOURCE_DIR, directory / "work");
  const std::string message = input_error([&] { const Workshop other(FELINE_SOURCE_DIR, directory / "work"); });
  EXPECT_NE(message.find("a run that is still going on"), std::string::npos) << message;
}

TEST(workshop, a_program_that_fails_is_told) {
  EXPECT_EQ(run_program({"cat"}, "text"), "text");
  EXPECT_THROW(run_program({"false"}), std::runtime_error);
}

TEST(workshop, what_is_wrong_without_a_mutant_is_no_failure_of_the_program) {
  EXPECT_EQ(run_trials({"cat"}, "text"), "text");
  EXPECT_THROW(run_trials({"sh", "-c", "exit 1"}), WitnessMismatch);
  EXPECT_THROW(
      try {
        run_trials({"sh", "-c", "exit 2"});
      } catch (const WitnessMismatch&) { FAIL() << "taken for a mismatch"; },
      std::runtime_error);
}

}  // namespace
}  // namespace feline::mutation
