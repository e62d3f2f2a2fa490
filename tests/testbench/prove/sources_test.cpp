// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/sources.h"

#include <gtest/gtest.h>

namespace feline::prove {
namespace {

using Files = std::set<std::string>;

// All that a stage's own includes, each once, but no other stage's model.
TEST(prove_sources, what_evaluates_is_what_is_included) {
  const Sources sources{{"model/group.h", "#include <array>\n#include \"tables/a.h\"\n#include \"model/shared.h\"\n"},
                        {"model/footprint.h", "#include \"model/shared.h\"\n"},
                        {"model/shared.h", "#include \"tables/a.h\"\n"},
                        {"tables/a.h", "#include \"tables/b.h\"\nint a;\n"},
                        {"tables/b.h", "#include \"tables/a.h\"\n"},
                        {"testbench/prove/exact_footprint.cpp", "#include \"testbench/prove/loop.h\"\n"},
                        {"testbench/prove/exact_tables.cpp", ""},
                        {"testbench/prove/errors.cpp", "#include \"testbench/prove/loop.h\"\n"},
                        {"testbench/prove/loop.h", ""},
                        {"testbench/prove/model_front.cpp",
                         "#include \"model/footprint.h\"\n#include \"model/group.h\"\n#include \"tables/c.h\"\n"},
                        {"tables/c.h", ""}};
  const auto text_of = [&](const std::string& file) -> const std::string& { return sources.at(file); };
  Files of_group;
  for (const auto& [file, text] : sources) of_group.insert(file);
  of_group.erase("model/footprint.h");
  EXPECT_EQ(evaluating_files("group", text_of), of_group);
  Files of_footprint = of_group;
  of_footprint.erase("model/group.h");
  of_footprint.insert("model/footprint.h");
  EXPECT_EQ(evaluating_files("footprint", text_of), of_footprint);
}

// Formats, the arithmetic of fields, and errors of a stage are what its certificate is of; another stage is not.
TEST(prove_sources, of_a_stage) {
  const auto text_of = [](const std::string& file) -> const std::string& { return built_in_sources().at(file); };
  const Files plan = evaluating_files("plan", text_of);
  for (const char* const file : {"model/plan.h", "model/features.h", "tables/format.h", "tables/rounding.h",
                                 "tables/supported.h", "testbench/prove/errors.cpp", "testbench/prove/exact_plan.cpp",
                                 "testbench/prove/lane_loop.h", "testbench/stability/real.h"}) {
    EXPECT_TRUE(plan.contains(file)) << file;
  }
  for (const char* const file :
       {"model/walk.h", "testbench/prove/exact_texels.cpp", "testbench/prove/model_back.cpp"}) {
    EXPECT_FALSE(plan.contains(file)) << file;
  }
  EXPECT_TRUE(evaluating_files("walk", text_of).contains("model/walk.h"));
}

// The program was built from the sources as they are.
TEST(prove_sources, built_in_are_those_that_are_read) {
  for (const auto& [file, text] : read_sources(FELINE_SOURCE_DIR)) {
    const auto built_in = built_in_sources().find(file);
    ASSERT_NE(built_in, built_in_sources().end()) << file;
    EXPECT_TRUE(built_in->second == text) << file;
  }
}

}  // namespace
}  // namespace feline::prove
