// SPDX-License-Identifier: Apache-2.0
// `feline report` and `feline render --filter` as a user meets them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "testbench/image.h"
#include "testbench/measure/contestant.h"
#include "testbench/scenes/scene.h"
#include "tests/testbench/feline_program.h"
#include "tests/testbench/html_check.h"
#include "tests/testbench/measure/surfaces.h"

namespace feline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSmall = "report --size 16 --scene repeat,spin --filter trilinear,ewa,unit_table --output ";

TEST(report_program, writes_three_files) {
  const TempDir dir;
  const Outcome outcome = run(kSmall + quoted_path(dir, "out"));
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  for (const char* const name : {"report.html", "report.json", "report.csv"}) {
    EXPECT_NE(outcome.text.find((dir / "out" / name).string()), std::string::npos) << name;
  }
  EXPECT_EQ(html_fault(read_bytes(dir / "out" / "report.html")), "");
  const std::string written = read_bytes(dir / "out" / "report.json");
  const auto json = nlohmann::json::parse(written);
  EXPECT_FALSE(json.contains("holds"));  // so small a picture is not judged
  ASSERT_EQ(json["scenes"].size(), 2U);
  EXPECT_EQ(json["scenes"][1]["frames"], 8);
  EXPECT_EQ(json["scenes"][1]["width"], 8);
  EXPECT_EQ(json["scenes"][0]["filters"][2]["filter"], "unit_table");
  const std::string csv = read_bytes(dir / "out" / "report.csv");
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 * 3);  // of two scenes, and of both together

  // Again, from the cache: the same, times included; as JSON, too.
  const std::string page = read_bytes(dir / "out" / "report.html");
  const Outcome again = run(kSmall + quoted_path(dir, "out") + " --json");
  ASSERT_EQ(again.code, 0) << again.text;
  EXPECT_EQ(nlohmann::json::parse(again.text), json);
  EXPECT_EQ(read_bytes(dir / "out" / "report.html"), page);
  EXPECT_EQ(read_bytes(dir / "out" / "report.json"), written);
  EXPECT_EQ(std::distance(fs::directory_iterator(dir / "out"), {}), 4);
}

TEST(report_program, a_budget_and_a_cache_elsewhere) {
  const TempDir dir;
  const std::string command = "report --size 8 --scene repeat --filter nearest --json --cache " +
                              quoted_path(dir, "known") + " --output " + quoted_path(dir, "out");
  const Outcome none = run(command + " --budget 0");
  ASSERT_EQ(none.code, 0) << none.text;
  EXPECT_EQ(nlohmann::json::parse(none.text)["missing"], 4);
  EXPECT_TRUE(fs::is_empty(dir / "known"));
  const Outcome all = run(command + " --budget 600");
  ASSERT_EQ(all.code, 0) << all.text;
  EXPECT_EQ(nlohmann::json::parse(all.text)["missing"], 0);
  EXPECT_FALSE(fs::is_empty(dir / "known"));
  EXPECT_FALSE(fs::exists(dir / "out" / "cache"));
}

TEST(report_program, refuses_and_says_what_is_legal) {
  const TempDir dir;
  const std::string output = " --output " + quoted_path(dir, "out");
  expect_refused(dir, "report --scene moon" + output, {"moon", "bricks"});
  expect_refused(dir, "report --scene bricks,bricks" + output, {"--scene", "each once"});
  expect_refused(dir, "report --scene bricks --filter best" + output, {"--filter", "best", "ewa", "unit_table", "all"});
  expect_refused(dir, "report --scene bricks --filter ewa," + output, {"--filter", "ewa,"});
  expect_refused(dir, "report --size 0" + output, {"--size", "0", "1 to 16384"});
  expect_refused(dir, "report --budget -1" + output, {"--budget", "-1", "0 to"});
  expect_refused(dir, "report --budget nan" + output, {"--budget", "nan", "0 to"});
  expect_refused(dir, "report --seed -1" + output, {"--seed", "-1", "0 to"});
  expect_refused(dir, "report --gbuffer a.exr" + output, {"--texture", "go together"});
  expect_refused(dir, "report --texture a.png" + output, {"--texture", "--gbuffer"});
  expect_refused(dir, "report --srgb" + output, {"--srgb", "--texture"});
  expect_refused(dir, "report --gbuffer a.exr --texture a.png --scene bricks" + output, {"--scene", "--gbuffer"});
  expect_refused(dir, "report --gbuffer a.exr --texture a.png --size 8" + output, {"--size", "--gbuffer"});
  expect_refused(dir, "report --gbuffer " + quoted_path(dir, "none.exr") + " --texture a.png" + output, {"none.exr"});
  const std::string small = "report --size 8 --scene repeat --filter nearest";
  expect_refused(dir, small + " --output /proc/none/out", {"--output", "/proc/none/out", "directory"});
  write_bytes(dir / "file", "");
  expect_refused(dir, small + " --output " + quoted_path(dir, "file"), {"--output", "file", "directory"});
  ASSERT_TRUE(fs::create_directory(dir / "out"));
  expect_refused(dir, small + output + " --cache " + quoted_path(dir, "file"), {"cache", "file", "directory"});
  fs::create_directory(dir / "out" / "report.json");
  expect_refused(dir, small + output, {"report.json"});
  EXPECT_FALSE(fs::exists(dir / "out" / "report.html"));
}

// Plots need it: said before the work, not after.
TEST(report_program, without_gnuplot_nothing_is_measured) {
  const TempDir dir;
  const Outcome outcome =
      run("report --size 8 --scene repeat --filter nearest --output " + quoted_path(dir, "out"), "PATH=/none");
  EXPECT_EQ(outcome.code, 2) << outcome.text;
  EXPECT_NE(outcome.text.find("gnuplot-nox"), std::string::npos) << outcome.text;
  EXPECT_FALSE(fs::exists(dir / "out"));
}

TEST(report_program, your_own_files) {
  const TempDir dir;
  ASSERT_EQ(run("scene --scene repeat --size 24x16 --output " + quoted_path(dir, "")).code, 0);
  const std::string name = "it's, a \"view\"";
  fs::rename(dir / "repeat.exr", dir / (name + ".exr"));
  ASSERT_EQ(std::system(("oiiotool --pattern noise 32x32 3 -o " + quoted_path(dir, "noise.png")).c_str()), 0);
  const Outcome outcome =
      run("report --gbuffer \"" + (dir / "it's, a \\\"view\\\".exr").string() + "\" --texture " +
          quoted_path(dir, "noise.png") + " --wrap mirrored_repeat --filter nearest,unit_table --json --output " +
          quoted_path(dir, "out"));
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto scene = nlohmann::json::parse(outcome.text)["scenes"][0];
  EXPECT_EQ(scene["scene"], name);
  EXPECT_EQ(scene["width"], 24);
  EXPECT_EQ(scene["height"], 16);
  EXPECT_EQ(scene["truth"]["projection"], "affine");
  const std::string html = read_bytes(dir / "out" / "report.html");
  EXPECT_EQ(html_fault(html), "");
  EXPECT_NE(html.find("projected affinely"), std::string::npos);
  expect_refused(dir,
                 "report --gbuffer " + quoted_path(dir, "noise.png") + " --texture " + quoted_path(dir, "noise.png") +
                     " --output " + quoted_path(dir, "out"),
                 {"noise.png", "s, t, dsdx"});
  expect_refused(dir,
                 "report --wrap round --gbuffer " + quoted_path(dir, "noise.png") + " --texture " +
                     quoted_path(dir, "noise.png") + " --output " + quoted_path(dir, "out"),
                 {"--wrap", "round", "mirrored_repeat"});
}

// What the contestants make of the same view, as 8-bit codes; the mesh is the scene's whatever its texture.
TEST(report_program, renders_by_any_filter) {
  const TempDir dir;
  const MipLevel small = paint_small<4>();
  write_png(dir / "small.png", small.width, small.height, 4, std::span<const std::uint8_t>(small.texels));
  ImageOptions image;
  image.srgb = true;
  image.mip_edge = MipEdge::kRepeat;
  const Surface surface = make_surface(load_texture(dir / "small.png", image), {}, MipEdge::kRepeat);
  const View view = make_view(find_scene("tessellated"), surface, 24, 16);
  for (const std::string filter : {"ewa", "rip_polygon", "vertex_max_staggered", "openimageio"}) {
    const bool told = filter != "openimageio";
    const Outcome outcome =
        run("render --scene tessellated --size 24x16 --srgb --json --texture " + quoted_path(dir, "small.png") +
            " --filter " + filter + " --output " + quoted_path(dir, filter + ".png") + (told ? " --map" : ""));
    ASSERT_EQ(outcome.code, 0) << outcome.text;
    const auto json = nlohmann::json::parse(outcome.text);
    EXPECT_EQ(json["filter"], filter);
    EXPECT_EQ(json["scene"], "tessellated");
    EXPECT_EQ(json["width"], 24);
    EXPECT_EQ(json["picture"], (dir / (filter + ".png")).string());
    EXPECT_EQ(json.contains("probe_map"), told);
    EXPECT_EQ(fs::exists(dir / (filter + "-probes.png")), told);
    const Rendering want = find_contestant(filter)->render(view, nullptr);
    EXPECT_EQ(json["probes"], want.cost.probes);
    EXPECT_EQ(load_texture(dir / (filter + ".png")).levels[0].texels, to_bytes(want.picture, true, 4)) << filter;
  }
}

// The first picture of a process: tables that are made on first use are not its time.
TEST(report_program, times_leave_out_what_is_made_once) {
  const TempDir dir;
  const Outcome outcome =
      run("render --scene spin --size 8 --json --filter feline_table --output " + quoted_path(dir, "a.png"));
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_LT(nlohmann::json::parse(outcome.text)["nanoseconds_a_pixel"], 30'000) << outcome.text;
}

TEST(report_program, a_filter_and_your_own_files) {
  const TempDir dir;
  ASSERT_EQ(run("scene --scene repeat --size 24x16 --output " + quoted_path(dir, "")).code, 0);
  for (const char* const from : {"--scene repeat --size 24x16", "--scene repeat --gbuffer "}) {
    const bool own = std::string(from).ends_with("gbuffer ");
    ASSERT_EQ(run("render --filter ewa --output " + quoted_path(dir, own ? "own.png" : "scene.png") + " " + from +
                  (own ? quoted_path(dir, "repeat.exr") : ""))
                  .code,
              0);
  }
  EXPECT_EQ(read_bytes(dir / "own.png"), read_bytes(dir / "scene.png"));
}

TEST(report_program, a_filter_is_not_the_unit) {
  const TempDir dir;
  const std::string render = "render --scene repeat --size 8 --output " + quoted_path(dir, "a.png") + " --filter ";
  expect_refused(dir, render + "best", {"--filter", "best", "ewa", "openimageio"});
  expect_refused(dir, render + "unit_table", {"--filter", "unit_table", "ewa"});
  expect_refused(dir, render + "ewa --mode table", {"--mode", "table", "--filter"});
  expect_refused(dir, render + "ewa --kernel gaussian", {"--kernel", "--filter"});
  expect_refused(dir, render + "ewa --engine rtl", {"--engine", "--filter"});
  expect_refused(dir, render + "ewa --parameters high_quality", {"--parameters", "--filter"});
  expect_refused(dir, render + "ewa --bias 1", {"--bias", "--filter"});
  expect_refused(dir, render + "ewa --allow-non-finite", {"--allow-non-finite", "--filter"});
  expect_refused(dir, render + "openimageio --map", {"--map", "this filter"});
  expect_refused(dir, render + "openimageio --wrap clamp_to_border --border 1,0,0,1", {"--border", "1,0,0,1", "black"});
  expect_refused(dir, render + "openimageio", {"TMPDIR", "/nonexistent"}, "TMPDIR=/nonexistent");
  expect_refused(dir, "render --size 8 --filter ewa --output /nonexistent/a.png", {"/nonexistent"});
  expect_refused(dir, "render --size 8 --filter ewa --output " + quoted_path(dir, "a.jpg"), {"a.jpg", ".png"});
}

}  // namespace
}  // namespace feline
