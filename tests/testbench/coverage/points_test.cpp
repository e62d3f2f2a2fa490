// SPDX-License-Identifier: Apache-2.0
// Readers of counts: what Verilator writes of the RTL, and what llvm-cov prints of the model.
#include <gtest/gtest.h>

#include <algorithm>

#include "testbench/coverage/model_points.h"
#include "testbench/coverage/rtl_points.h"
#include "tests/testbench/temp_dir.h"

namespace feline::coverage {
namespace {

// One line of Verilator's file.
std::string rtl_line(const std::filesystem::path& source, int line, const std::string& page, const std::string& what,
                     const std::string& instance, const std::string& count) {
  return "C '\1f\2" + source.string() + "\1l\2" + std::to_string(line) + "\1n\0023\1page\2" + page + "/module\1o\2" +
         what + "\1h\2TOP.feline_bench.u_unit" + instance + "' " + count + "\n";
}

constexpr const char* kHead = "# SystemC::Coverage-3\n";

class Points : public testing::Test {
 protected:
  Points() {
    write_bytes(source_, "always_comb begin\n  if (a) begin\n    b = 1;\n  end else begin\n  if (a) begin\nend\n");
  }

  std::vector<Point> rtl(const std::string& text) {
    write_bytes(file_, text);
    SourceText sources(directory_ / "");
    return read_rtl_points(file_, sources);
  }
  std::vector<Point> model(const std::string& text) {
    write_bytes(file_, text);
    SourceText sources(directory_ / "");
    return read_model_points(file_, sources);
  }

  TempDir directory_;
  std::filesystem::path source_ = directory_ / "feline_x.sv";
  std::filesystem::path file_ = directory_ / "counts";
};
using rtl_points = Points;
using model_points = Points;

TEST_F(rtl_points, kinds_names_places_and_counts) {
  const auto points = rtl(kHead + rtl_line(source_, 2, "v_branch", "if", ".u_group.u_products", "12") +
                          rtl_line(source_, 4, "v_line", "elsif", ".u_group", "0") +
                          rtl_line(source_, 3, "v_toggle", "b[3]", ".u_group", "18446744073709551615") +
                          rtl_line(source_, 3, "v_toggle", "busy_o", "", "1"));
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[0].kind, Kind::kRtlBranch);
  EXPECT_EQ(points[0].name, "u_group.u_products/if: if (a) begin");
  EXPECT_EQ(points[0].file, "feline_x.sv");
  EXPECT_EQ(points[0].line, 2);
  EXPECT_EQ(points[0].count, 12U);
  EXPECT_EQ(points[1].kind, Kind::kRtlLine);
  EXPECT_EQ(points[1].count, 0U);
  EXPECT_EQ(points[2].name, "u_group.b[3]");
  EXPECT_EQ(points[2].count, ~std::uint64_t{0});
  EXPECT_EQ(points[3].name, "busy_o");
}

TEST_F(rtl_points, blocks_without_a_condition_are_none) {
  EXPECT_TRUE(rtl(kHead + rtl_line(source_, 1, "v_line", "block", ".u_group", "0")).empty());
}

TEST_F(rtl_points, equal_names_are_numbered) {
  const auto points = rtl(kHead + rtl_line(source_, 2, "v_branch", "if", ".u_a", "1") +
                          rtl_line(source_, 5, "v_branch", "if", ".u_a", "0"));
  EXPECT_EQ(points[0].name, "u_a/if: if (a) begin");
  EXPECT_EQ(points[1].name, "u_a/if: if (a) begin #2");
}

TEST_F(rtl_points, refuses_what_is_none_of_verilators) {
  const std::string good = rtl_line(source_, 2, "v_line", "if", ".u_a", "1");
  EXPECT_NE(input_error([&] { rtl(good); }).find("line 1"), std::string::npos);
  struct Bad {
    std::string line;
    std::string field;
  };
  const std::vector<Bad> all{{good.substr(0, good.size() - 3) + "\n", "point"},
                             {good.substr(0, good.size() - 2) + "x\n", "point"},
                             {rtl_line(source_, 2, "v_user", "if", ".u_a", "1"), "page"},
                             {rtl_line(source_, 2, "v_line", "if", "x", "1"), "h"},
                             {rtl_line("", 2, "v_line", "if", ".u_a", "1"), "f"},
                             {rtl_line(source_, 7, "v_line", "if", ".u_a", "1"), "line"},
                             {rtl_line(directory_ / "gone.sv", 2, "v_line", "if", ".u_a", "1"), "line"}};
  for (const Bad& bad : all) {
    const std::string message = input_error([&] { rtl(kHead + bad.line); });
    EXPECT_NE(message.find(": " + bad.field + ": "), std::string::npos) << message;
  }
}

TEST_F(model_points, lines_and_both_sides_of_branches) {
  const auto points = model(source_.string() + ":\n" +
                            "    1|       |always_comb begin\n"
                            "    2|  1.25k|  if (a) begin\n"
                            "  ------------------\n"
                            "  |  Branch (2:7): [True: 0, False: 12]\n"
                            "  |  Branch (2:7): [True: 3, False: 0]\n"
                            "  |  Branch (4:9): [Folded - Ignored]\n"
                            "  |  Branch (5:7): [True: 2M, False: 0]\n"
                            "  ------------------\n"
                            "    3|      0|    b = 1;\n");
  ASSERT_EQ(points.size(), 6U);
  EXPECT_EQ(points[0].kind, Kind::kModelLine);
  EXPECT_EQ(points[0].name, "feline_x.sv/if (a) begin");
  EXPECT_EQ(points[0].count, 1250U);
  EXPECT_EQ(points[1].count, 0U);
  EXPECT_EQ(points[2].name, "feline_x.sv/true: a) begin");
  EXPECT_EQ(points[2].count, 3U);
  EXPECT_EQ(points[3].name, "feline_x.sv/false: a) begin");
  EXPECT_EQ(points[3].count, 12U);
  EXPECT_EQ(points[4].name, "feline_x.sv/true: a) begin #2");
  EXPECT_EQ(points[4].count, 2000000U);
  EXPECT_EQ(points[5].count, 0U);
}

TEST_F(model_points, refuses_what_llvm_does_not_print) {
  EXPECT_NE(input_error([&] { model("    2|      1|  if (a) begin\n"); }).find("line"), std::string::npos);
  for (const char* const branch : {"  |  Branch (2:7): [True: 1]\n", "  |  Branch (2): [True: 1, False: 2]\n"}) {
    const std::string message = input_error([&] { model(source_.string() + ":\n" + branch); });
    EXPECT_NE(message.find("counts:2: branch: "), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace feline::coverage
