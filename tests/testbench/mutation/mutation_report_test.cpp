// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/mutation_report.h"

#include <gtest/gtest.h>

#include <fstream>

#include "testbench/error.h"
#include "tests/testbench/temp_dir.h"

namespace feline::mutation {
namespace {

KnownSurvivors read(const std::string& text) {
  const TempDir directory;
  const auto file = directory / "survivors.json";
  std::ofstream(file) << text;
  return read_known_survivors(file);
}

TEST(mutation_report, survivors_have_reasons) {
  const KnownSurvivors known = read(R"({"walk": [{"reason": "equivalent: r", "mutants": ["a", "b"]}], "plan": []})");
  EXPECT_EQ(known.at("walk").at("b"), "equivalent: r");
  EXPECT_THROW(read("[1]"), InputError);
  EXPECT_THROW(read("{"), InputError);
  EXPECT_THROW(read(R"({"walk": [{"reason": "", "mutants": ["a"]}]})"), InputError);
  EXPECT_THROW(read(R"({"walk": [{"reason": "the same", "mutants": ["a"]}]})"), InputError);
  EXPECT_THROW(read(R"({"walk": [{"reason": "equivalent: ", "mutants": ["a"]}]})"), InputError);
  EXPECT_THROW(read(R"({"walk": [{"mutants": ["a"]}]})"), InputError);
  EXPECT_THROW(read(R"({"walk": [{"reason": "equivalent: r", "mutants": ["a", "a"]}]})"), InputError);
  EXPECT_THROW(read(R"({"walk": [{"reason": "equivalent: r", "mutants": [1]}]})"), InputError);
  EXPECT_THROW(read_known_survivors("/nowhere/survivors.json"), InputError);
}

TEST(mutation_report, those_of_the_sources_can_be_read) {
  const std::filesystem::path directory = std::filesystem::path(FELINE_SOURCE_DIR) / "testbench/mutation";
  EXPECT_NO_THROW(read_known_survivors(directory / "survivors.json"));
  EXPECT_NO_THROW(read_known_survivors(directory / "model_survivors.json"));
}

TEST(mutation_report, tells_what_nothing_is_known_of) {
  StageResult result;
  result.stage = "walk";
  result.fates.resize(10);
  result.killed = {{"smoke", 6}, {"suite", 1}};
  result.same = 2;
  result.open = {"$add at rtl/feline_walk.sv:1"};
  EXPECT_EQ(result.kills(), 7U);
  const std::string text = to_text({result}, {"smoke", "pace", "suite"});
  EXPECT_NE(text.find("| walk | 10 | 6 | 0 | 1 | 2 | 0 | 0 | 1 | 87.50 % |"), std::string::npos) << text;
  EXPECT_NE(text.find("OPEN: walk: $add at rtl/feline_walk.sv:1\n"), std::string::npos);
  const auto json = to_json({result}, 5);
  EXPECT_EQ(json["seed"], 5);
  EXPECT_EQ(json["stages"]["walk"]["open"][0], "$add at rtl/feline_walk.sv:1");
}

TEST(mutation_report, a_reason_of_what_is_killed_or_proved_is_stale) {
  std::vector<Fate> fates(6);
  for (std::size_t i = 0; i < fates.size(); ++i) fates[i].name = std::string(1, static_cast<char>('a' + i));
  fates[0].tier = "smoke";
  fates[1].logic = Fate::Logic::kUnobserved;
  fates[3].differs = "x_i 0x1";
  fates[4].differs = "x_i 0x1";
  fates[5].differs = "x_i 0x1";
  const KnownSurvivors known = read(
      R"({"walk": [{"reason": "equivalent: r", "mutants": ["a", "b", "c", "e"]},
                   {"reason": "nothing can be seen: r", "mutants": ["f"]}]})");
  const StageResult result = judge("walk", 4, fates, known);
  EXPECT_EQ(result.stale, (std::vector<std::string>{"a", "b", "e"}));
  EXPECT_EQ(result.known,
            (std::map<std::string, std::string>{{"c", "equivalent: r"}, {"f", "nothing can be seen: r"}}));
  EXPECT_EQ(result.open, (std::vector<std::string>{"d (differs: x_i 0x1)", "e (differs: x_i 0x1)"}));
  EXPECT_NE(to_text({result}, {"smoke"}).find("STALE REASON: walk: b\n"), std::string::npos);
}

TEST(mutation_report, only_all_of_them_are_a_hundred_percent) {
  StageResult result;
  result.fates.resize(100000);
  result.killed = {{"smoke", 99999}};
  EXPECT_NE(to_text({result}, {"smoke"}).find("| 99.99 % |"), std::string::npos);
  result.killed = {{"smoke", 100000}};
  EXPECT_NE(to_text({result}, {"smoke"}).find("| 100.00 % |"), std::string::npos);
}

}  // namespace
}  // namespace feline::mutation
