// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/profile_page.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "testbench/page/heat_map.h"
#include "testbench/prune/profile_text.h"
#include "tests/testbench/html_check.h"
#include "tests/testbench/prune/profiles.h"
#include "tests/testbench/report/browser.h"

namespace feline {
namespace {

constexpr int kSide = 64;

Profile three_lookups() {
  const TestTexture test(flat_texture(kSide, kSide), "a <texture>");
  return test.profile({TexelLookup{8, 8, 13, 0, 12, 5}.in(kSide, kSide), TexelLookup{8, 8, 1, 0, 0, 8}.in(kSide, kSide),
                       TexelLookup{8, 8, 0.5, 0, 0, 0.5}.in(kSide, kSide)},
                      {});
}

const ReachWords& words_of(const std::vector<ReachWords>& words, Reach reach) {
  return words[static_cast<std::size_t>(reach)];
}

TEST(profile_page, words) {
  Profile profile = three_lookups();
  profile[Reach::kStatus] = {{0, 1}, {kOverflow, 1}, {kOverflow + kCoordinateNotFinite, 2}};
  profile[Reach::kProbes] = {{1, 1}, {3, 1}, {4, 1}, {5, 1}};
  const std::vector<ReachWords> words = reach_words(profile);
  ASSERT_EQ(words.size(), kReachCount);
  EXPECT_EQ(words_of(words, Reach::kMode).reached, "table 100 %");
  EXPECT_EQ(words_of(words, Reach::kMode).never, "nearest, bilinear, trilinear, ext, simple");
  EXPECT_EQ(words_of(words, Reach::kProbes).reached, "1, 3 to 5");
  EXPECT_EQ(words_of(words, Reach::kProbes).never, "2, 6 to 16");
  EXPECT_EQ(words_of(words, Reach::kWidth).reached, "64");
  EXPECT_EQ(words_of(words, Reach::kWidth).never, "");
  EXPECT_EQ(words_of(words, Reach::kStatus).reached, "coordinate_not_finite+overflow 50 %, none 25 %, overflow 25 %");
  EXPECT_EQ(words_of(words, Reach::kStatus).never, "derivative_not_finite, unsupported");
  EXPECT_EQ(words_of(reach_words(Profile{}), Reach::kProbes).reached, "nothing");
}

// Beyond eight ranges the rest is counted.
TEST(profile_page, long_lists_of_values_end) {
  Profile profile;
  for (int cell = 0; cell < 256; cell += 2) profile[Reach::kCell][cell] = 1;
  EXPECT_EQ(words_of(reach_words(profile), Reach::kCell).reached, "0, 2, 4, 6, 8, 10, 12, 14 and 120 more, up to 254");
}

TEST(profile_page, text) {
  const std::string text = profile_to_text(three_lookups());
  EXPECT_TRUE(text.starts_with("3 lookups with ")) << text;
  EXPECT_NE(text.find("in 1 frame of test.\n"), std::string::npos) << text;
  EXPECT_NE(text.find("; never nearest, bilinear"), std::string::npos) << text;
  EXPECT_NE(text.find("texture a <texture>"), std::string::npos) << text;
  EXPECT_EQ(percent(1, 0), "-");
  EXPECT_EQ(percent(1, 400), "0.25 %");
}

TEST(profile_page, is_whole) {
  const std::string html = profile_page(three_lookups());
  EXPECT_EQ(html_fault(html), "");
  EXPECT_NE(html.find("3 of 256 are reached"), std::string::npos);
  for (const std::string part : {"Probes of a lookup: ", "Exponent of the gradients: "}) {
    const std::size_t caption = html.find(part);
    ASSERT_NE(caption, std::string::npos) << part;
    EXPECT_NE(html.substr(caption, html.find('<', caption) - caption).find(", of 3 lookups."), std::string::npos);
  }
  EXPECT_NE(html.find("a &lt;texture&gt;"), std::string::npos);
  EXPECT_EQ(html_fault(profile_page(Profile{})), "");
}

TEST(profile_page, heat_map) {
  page::HeatMap map{"a map", "columns & more", "rows", 3, 2};
  map.counts = {1, 0, 1000, std::nullopt, 10, 10};
  map.column_names = {"0", "1", "2"};
  const std::string svg = page::svg(map);
  EXPECT_EQ(html_fault(svg), "");
  for (const char* const part :
       {"<title>1000</title>", "<title>0</title>", "columns &amp; more", "never", ">2</text>"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  }
  const std::string crossed = "M102 6l28 22";  // the second cell, and no other
  EXPECT_NE(svg.find(crossed), std::string::npos) << svg;
  map.counts.pop_back();
  EXPECT_THROW(page::svg(map), std::invalid_argument);
}

// Lighter the more often, and never like what is never reached.
TEST(profile_page, heat_colours) {
  int before = 0;
  for (const std::uint64_t count : {1U, 2U, 10U, 100U, 500U, 1000U}) {
    const auto [red, green, blue] = page::heat_colour(count, 1000);
    EXPECT_GT(red + green + blue, before);
    before = red + green + blue;
    EXPECT_NE(page::heat_colour(count, 1000), page::heat_colour(0, 1000));
    EXPECT_GE(red, green);
    EXPECT_GE(green, blue);
  }
  const auto [red, green, blue] = page::heat_colour(0, 1000);
  EXPECT_LT(red, blue);
}

// In a browser, wide and narrow: nothing is wider than the window.
TEST(profile_page_long, in_a_browser) {
  const TempDir dir;
  write_bytes(dir / "profile.html", profile_page(three_lookups()));
  for (const int width : {1280, 400}) {
    const Visit seen = visit(dir, dir / "profile.html", width, true);
    EXPECT_TRUE(seen.console.empty());
    EXPECT_TRUE(seen.requests.empty());
    EXPECT_GT(seen.frame_width, 0);
    EXPECT_LE(seen.scroll_width, seen.frame_width);
    EXPECT_EQ(seen.drawings.size(), 8U);
    EXPECT_EQ(seen.pictures.size(), 1U);
    for (const Visit::Box& box : seen.drawings) {
      EXPECT_GT(box.right - box.left, 300);
      EXPECT_LE(box.right, seen.frame_width);
    }
  }
}

}  // namespace
}  // namespace feline
