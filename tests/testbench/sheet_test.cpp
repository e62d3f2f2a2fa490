// SPDX-License-Identifier: Apache-2.0
#include "testbench/page/sheet.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "testbench/mip_chain.h"
#include "testbench/page/surface.h"

namespace feline {
namespace {

TEST(sheet, lines_break_at_words) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(page::wrapped("one two three", 7), (Lines{"one two", "three"}));
  EXPECT_EQ(page::wrapped("unbreakable a b", 3), (Lines{"unbreakable", "a b"}));
  EXPECT_EQ(page::wrapped("", 3), Lines{});
}

TEST(sheet, panels_stand_in_rows) {
  const std::string square = "<svg viewBox=\"0 0 1 1\"></svg>";
  const page::Sheet sheet{"A & B", {{square, "<1>", "note"}, {square, "2", ""}, {square, "3", ""}}, 2, 100, 50,
                          "words"};
  const std::string svg = to_svg(sheet);
  for (const char* const part : {"aria-label=\"A &amp; B\"", "&lt;1&gt;", "<svg x=\"12\" y=\"12\" width=\"100\"",
                                 "<svg x=\"124\" y=\"12\"", "<svg x=\"12\" y=\"110\"", ">words</text>"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part << "\n" << svg;
  }
}

TEST(sheet, surfaces_are_drawn) {
  page::SurfacePlot plot{"hill", "A hill", "u", "v", 0.5, 3, {0, 0, 0, 0, 1, 0, 0, 0, 0}};
  const std::string drawn = svg(plot);
  EXPECT_TRUE(drawn.starts_with("<svg "));
  EXPECT_NE(drawn.find("<polygon"), std::string::npos);
  EXPECT_EQ(drawn, svg(plot));
  plot.heights.pop_back();
  EXPECT_THROW(svg(plot), std::invalid_argument);
}

// The chain before rounding is linear: twice the texture is twice every level, and its levels round to the stored ones.
TEST(mip_chain_float, is_linear_and_rounds_to_the_stored_one) {
  FloatLevel base{8, 4, std::vector<float>(32)};
  MipLevel stored{8, 4, std::vector<std::uint8_t>(32)};
  for (std::size_t i = 0; i < 32; ++i) {
    stored.texels[i] = static_cast<std::uint8_t>(i * 77 % 256);
    base.values[i] = static_cast<float>(stored.texels[i]) / 255;
  }
  FloatLevel doubled = base;
  for (float& value : doubled.values) value *= 2;
  for (const MipFilter filter : {MipFilter::kLanczos, MipFilter::kBox}) {
    const auto chain = build_float_mip_chain(base, 1, filter, MipEdge::kRepeat);
    const auto twice = build_float_mip_chain(doubled, 1, filter, MipEdge::kRepeat);
    const auto rounded = build_mip_chain(stored, 1, filter, false, MipEdge::kRepeat);
    ASSERT_EQ(chain.size(), rounded.size());
    for (std::size_t k = 0; k < chain.size(); ++k) {
      for (std::size_t i = 0; i < chain[k].values.size(); ++i) {
        EXPECT_NEAR(twice[k].values[i], 2 * chain[k].values[i], 1e-6);
        EXPECT_NEAR(255 * std::clamp(chain[k].values[i], 0.0f, 1.0f), rounded[k].texels[i], 0.501);
      }
    }
  }
}

}  // namespace
}  // namespace feline
