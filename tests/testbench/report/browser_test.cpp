// SPDX-License-Identifier: Apache-2.0
// The pages as a reader has them: in a browser, wide and narrow.
#include "tests/testbench/report/browser.h"

#include <gtest/gtest.h>

#include "tests/testbench/run_program.h"

namespace feline {
namespace {

constexpr int kWide = 1280;
constexpr int kNarrow = 400;

void expect_whole(const Visit& visit, std::size_t drawings, std::size_t pictures) {
  EXPECT_TRUE(visit.console.empty()) << visit.console.front();
  EXPECT_TRUE(visit.requests.empty()) << visit.requests.front();
  EXPECT_GT(visit.frame_width, 0);
  EXPECT_LE(visit.scroll_width, visit.frame_width);
  EXPECT_EQ(visit.drawings.size(), drawings);
  EXPECT_EQ(visit.pictures.size(), pictures);
  for (const Visit::Box& box : visit.drawings) {
    if (box.folded) continue;
    EXPECT_GT(box.right - box.left, 100);
    EXPECT_GT(box.height, 50);
    EXPECT_GE(box.left, 0);
    EXPECT_LE(box.right, visit.frame_width);
  }
  for (const Visit::Box& box : visit.pictures) {
    EXPECT_GT(box.natural_width, 0);
    if (box.folded) continue;
    EXPECT_GT(box.right - box.left, 10);
    EXPECT_GT(box.height, 10);
    EXPECT_GE(box.left, 0);
    EXPECT_LE(box.right, visit.frame_width);
  }
}

Visit visit_text(const TempDir& dir, const std::string& body) {
  write_bytes(dir / "page.html", "<!DOCTYPE html><html><body style=\"margin:0\">" + body + "</body></html>");
  return visit(dir, dir / "page.html", kNarrow);
}

TEST(report_browser_long, the_report) {
  const TempDir dir;
  const Outcome outcome =
      run_program(FELINE_PROGRAM, "report --size 48 --scene bricks,spin --filter trilinear,ewa,unit_table --output " +
                                      (dir / "report").string());
  ASSERT_LE(outcome.code, 1) << outcome.text;
  for (const int width : {kWide, kNarrow}) {
    for (const bool unfolded : {false, true}) {
      SCOPED_TRACE(testing::Message() << width << " pixels wide, unfolded " << unfolded);
      // Eight plots of each scene and of both together; for each scene the whole picture, two truths, two pictures of
      // each filter, and the probes of the only one that takes several.
      expect_whole(visit(dir, dir / "report" / "report.html", width, unfolded), 3 * 8, 2 * (1 + 2 + 2 * 3 + 1));
    }
  }
}

TEST(report_browser_long, the_stability_page) {
  const TempDir dir;
  const Outcome outcome = run_program(FELINE_PROGRAM, "stability --count 50 --output " + (dir / "").string());
  ASSERT_LE(outcome.code, 1) << outcome.text;
  for (const int width : {kWide, kNarrow}) {
    for (const bool unfolded : {false, true}) {
      SCOPED_TRACE(testing::Message() << width << " pixels wide, unfolded " << unfolded);
      const Visit seen = visit(dir, dir / "stability.html", width, unfolded);
      EXPECT_GT(seen.drawings.size(), 5U);
      expect_whole(seen, seen.drawings.size(), seen.pictures.size());
    }
  }
}

// What the tests above would miss if the browser did not tell it.
TEST(report_browser_long, faults_are_seen) {
  const TempDir dir;
  const Visit clean = visit_text(dir, "<p>text</p>");
  EXPECT_TRUE(clean.console.empty());
  EXPECT_TRUE(clean.requests.empty());
  EXPECT_EQ(clean.frame_width, kNarrow);
  EXPECT_EQ(clean.scroll_width, kNarrow);

  const Visit error = visit_text(dir, "<script>console.error('broken')</script>");
  ASSERT_EQ(error.console.size(), 1U);
  EXPECT_NE(error.console[0].find("broken"), std::string::npos);
  EXPECT_EQ(visit_text(dir, "<script>nothing.at.all()</script>").console.size(), 1U);

  const Visit picture = visit_text(dir, "<img src=\"http://example.invalid/a.png\">");
  ASSERT_EQ(picture.requests, std::vector<std::string>{"http://example.invalid/a.png"});
  ASSERT_EQ(picture.pictures.size(), 1U);
  EXPECT_EQ(picture.pictures[0].natural_width, 0);
  EXPECT_EQ(visit_text(dir, "<link rel=\"stylesheet\" href=\"https://example.invalid/a.css\">").requests.size(), 1U);

  EXPECT_EQ(visit_text(dir, "<div style=\"width:500px;height:9px\"></div>").scroll_width, 500);
  const Visit drawings = visit_text(dir, "<svg width=\"120\" height=\"60\"></svg><details><svg></svg></details>");
  ASSERT_EQ(drawings.drawings.size(), 2U);
  EXPECT_EQ(drawings.drawings[0].right - drawings.drawings[0].left, 120);
  EXPECT_FALSE(drawings.drawings[0].folded);
  EXPECT_TRUE(drawings.drawings[1].folded);
}

TEST(report_browser_long, no_browser_is_a_failure) {
  const TempDir dir;
  write_bytes(dir / "page.html", "<p>text</p>");
  const std::string before = std::getenv("PATH");
  std::filesystem::create_symlink("/usr/bin/timeout", dir / "timeout");
  ::setenv("PATH", (dir / "").string().c_str(), 1);
  std::string message;
  try {
    visit(dir, dir / "page.html", kWide);
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_NE(message.find("Debian package chromium"), std::string::npos) << message;
}

}  // namespace
}  // namespace feline
