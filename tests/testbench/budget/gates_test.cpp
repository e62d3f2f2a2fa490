// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/gates.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/testbench/budget/hardware_for.h"
#include "tests/testbench/measure/surfaces.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

const std::filesystem::path kRoot = FELINE_SOURCE_DIR;

// Comments, which tell errors of ROMs, are none of the unit's.
std::string without_comments(const std::string& source) {
  std::istringstream lines(source);
  std::string code;
  for (std::string line; std::getline(lines, line);) {
    const std::string kept = line.substr(0, line.find("//"));
    if (kept.find_first_not_of(' ') != std::string::npos) code += kept + "\n";
  }
  return code;
}

TEST(budget_gates, the_default_unit_is_the_generated_one) {
  const std::string made = without_comments(unit_source(kDefaultConfig, kRoot / "rtl"));
  EXPECT_TRUE(made == without_comments(unit_source(kRoot / "rtl", kRoot / "tables" / "generated")));
  EXPECT_GT(made.size(), 10000U);
  const TempDir dir;
  const std::string message = input_error([&] { unit_source(kDefaultConfig, dir / "rtl"); });
  EXPECT_NE(message.find("--source"), std::string::npos) << message;
}

// What the search assumes: a unit that needs no more than another one has no more gates.
TEST(budget_gates_long, rise_with_every_need) {
  const Exhibit exhibit = plan_exhibit(small_scene("bricks"), 16, 16).build();
  const auto hardware = [&](const Candidate& candidate) { return hardware_for(exhibit, candidate); };
  // Each needs what the one before it does, and more.
  const std::vector<Candidate> rising{{{6, 8, 5, 5, 6}, Mode::kTrilinear, Kernel::kBilinear, ParameterSet::kExact, 1},
                                      {{8, 8, 5, 5, 6}, Mode::kTrilinear, Kernel::kBilinear, ParameterSet::kExact, 1},
                                      {{8, 8, 8, 8, 6}, Mode::kTrilinear, Kernel::kBilinear, ParameterSet::kExact, 1},
                                      {{8, 8, 8, 8, 6}, Mode::kTrilinear, Kernel::kGaussian, ParameterSet::kExact, 1}};
  const Synthesis synthesis(kCellLibrary, nullptr);
  const GateCount count = synthesized_gates(synthesis, kRoot / "rtl");
  double before = 0;
  for (std::size_t i = 0; i < rising.size(); ++i) {
    const Config unit = hardware(rising[i]);
    EXPECT_TRUE(i == 0 || needs_no_more(hardware(rising[i - 1]), unit)) << i;
    const double gates = count(unit);
    EXPECT_GT(gates, before) << sampler_name(rising[i]) << "; " << widths_name(rising[i]);
    before = gates;
  }
}

}  // namespace
}  // namespace feline
