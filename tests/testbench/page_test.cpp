// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "testbench/page/html.h"
#include "testbench/page/plot.h"
#include "tests/testbench/html_check.h"
#include "tests/testbench/temp_dir.h"

namespace feline::page {
namespace {

TEST(page, text_is_escaped) {
  EXPECT_EQ(escape("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
  EXPECT_EQ(paragraph("<script>"), "<p>&lt;script&gt;</p>\n");
}

// RFC 4648, section 10.
TEST(page, base64) {
  const auto encoded = [](std::string_view text) { return base64(std::as_bytes(std::span(text))); };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encoded("\xff\xfe\xfd"), "//79");
}

TEST(page, a_row_is_as_long_as_its_table) {
  Table of{"caption", {{"name"}, {"value", true}}, {{{"a"}, {"1", Tone::kBad}}}};
  EXPECT_NE(table(of).find("<td class=\"number bad\">1</td>"), std::string::npos) << table(of);
  of.rows.push_back({{"b"}});
  EXPECT_THROW(table(of), std::invalid_argument);
}

Plot example() {
  Plot plot{"errors", "Errors & \"bounds\"", {"condition <k>", true}, {"it's an error", true}, {}};
  plot.series.push_back({"it's a", {{1, 1e-7, "first \"one\""}, {1e3, 1e-4}, {1e6, NAN}, {1e9, 0}, {1e12, 1}}});
  plot.series.push_back({"bound `id`", {{1, 1e-3}, {1e12, 1e-3}}, Style::kDashed});
  return plot;
}

TEST(page, a_document_is_balanced_and_alone) {
  const std::vector<std::string> figures{figure(svg(example()), "one < two"),
                                         figure(png(std::as_bytes(std::span("png")), "a picture"), "two")};
  const Table of{"", {{"name"}}, {{{"<&>"}}}};
  const std::string html =
      document("A & B", heading(2, "x") + bullets(std::vector<std::string>{"<1>", "2"}) + table(of) + gallery(figures));
  EXPECT_EQ(html_fault(html), "");
  EXPECT_NE(html.find("<title>A &amp; B</title>"), std::string::npos);
}

TEST(page, a_plot_is_an_element_of_its_own) {
  const std::string drawn = svg(example());
  EXPECT_TRUE(drawn.starts_with("<svg "));
  EXPECT_TRUE(drawn.ends_with("</svg>"));
  EXPECT_EQ(drawn, svg(example()));
  for (const char* const text : {"it's a", "bound `id`", "condition &lt;k", "Errors &amp;", "first 'one'"}) {
    EXPECT_NE(drawn.find(text), std::string::npos) << text;
  }
  for (const char* const text : {"black", "GNUPLOT", "'#gp", "id=\"gnuplot"}) {
    EXPECT_EQ(drawn.find(text), std::string::npos) << text;
  }
}

TEST(page, plots_of_every_style_and_none) {
  Plot plot{"bars", "bars", {"", false, 0, 0, {"first", "second"}}, {"errors"}, {}};
  EXPECT_NE(svg(plot).find("second"), std::string::npos);
  for (const Style style : {Style::kPoints, Style::kLines, Style::kLinesPoints, Style::kDashed, Style::kBars}) {
    plot.series.push_back({"series", {{0, 1}, {1, 2}}, style});
  }
  EXPECT_NE(svg(plot).find("series"), std::string::npos);
  plot.y = {"errors", true, 1e-3, 10};
  EXPECT_NE(svg(plot).find(">0.001<"), std::string::npos);
  EXPECT_NE(svg({"none", "none", {"", true}, {"", true}, {{"nothing", {{-1, NAN}}}}}).find("none"), std::string::npos);
}

TEST(page, gnuplot_is_missing_or_fails) {
  const TempDir dir;
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", (dir / "").string().c_str(), 1);
  const std::string missing = input_error([] { svg(example()); });
  write_bytes(dir / "gnuplot", "#!/bin/sh\necho bad plot >&2\nexit 1\n");
  std::filesystem::permissions(dir / "gnuplot", std::filesystem::perms::owner_all);
  const std::string failed = input_error([] { svg(example()); });
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_NE(missing.find("gnuplot-nox"), std::string::npos) << missing;
  EXPECT_NE(failed.find("exit code 1"), std::string::npos) << failed;
  EXPECT_NE(failed.find("bad plot"), std::string::npos) << failed;
}

}  // namespace
}  // namespace feline::page
