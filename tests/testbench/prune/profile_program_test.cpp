// SPDX-License-Identifier: Apache-2.0
// `feline profile` as a user meets it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "testbench/prune/profile_json.h"
#include "tests/testbench/feline_program.h"
#include "tests/testbench/html_check.h"

namespace feline {
namespace {

namespace fs = std::filesystem;

Profile profile_of(const std::string& arguments) {
  const Outcome outcome = run("profile --json " + arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  return profile_from_json(outcome.text, "standard output");
}

TEST(profile_program, writes_page_and_json) {
  const TempDir dir;
  const Outcome outcome = run("profile --scene repeat --size 16x8 --output " + quoted_path(dir, "a/b"));
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("128 lookups"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("never nearest"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find((dir / "a/b/profile.html").string()), std::string::npos) << outcome.text;
  EXPECT_EQ(html_fault(read_bytes(dir / "a/b/profile.html")), "");
  const Profile profile = read_profile(dir / "a/b/profile.json");
  EXPECT_EQ(profile.lookups, 128U);
  EXPECT_EQ(profile, profile_of("--scene repeat --size 16x8 --output " + quoted_path(dir, "a/b")));
  EXPECT_EQ(std::distance(fs::directory_iterator(dir / "a/b"), {}), 2);
}

// Every frame of a sequence, under every combination.
TEST(profile_program, scenes_and_combinations) {
  const Profile profile = profile_of("--scene spin,repeat --mode ext,table --wrap repeat,clamp_to_edge --size 8");
  EXPECT_EQ(profile.sources, (std::map<std::string, std::uint64_t>{{"repeat", 4}, {"spin", 32}}));
  EXPECT_EQ(profile.lookups, 36U * 64U);
  EXPECT_EQ(profile.count(Reach::kMode, static_cast<std::int64_t>(Mode::kExt)), 18U * 64U);
  EXPECT_EQ(profile.textures.size(), 4U);  // mip levels of both with and without a seam
  EXPECT_EQ(profile_of("--size 8").sources.begin()->first, "bricks");
}

TEST(profile_program, a_library_is_one_profile) {
  const TempDir dir;
  for (const std::string scene : {"repeat", "spin"}) {
    ASSERT_EQ(run("profile --size 8 --scene " + scene + " --output " + quoted_path(dir, scene)).code, 0);
  }
  const std::string both = quoted_path(dir, "repeat/profile.json") + " " + quoted_path(dir, "spin/profile.json");
  const Profile merged = profile_of("--merge " + both);
  EXPECT_EQ(merged, profile_of("--size 8 --scene repeat,spin"));
  EXPECT_EQ(merged, profile_of("--size 8 --scene spin --merge " + quoted_path(dir, "repeat/profile.json")));
}

// A sequence of files: one by one, as a directory, and each with its own texture.
TEST(profile_program, your_own_sequence) {
  const TempDir dir;
  fs::create_directory(dir / "frames");
  ASSERT_EQ(run("scene --scene repeat --size 12x8 --output " + quoted_path(dir, "")).code, 0);
  ASSERT_EQ(run("scene --scene window --size 8x4 --output " + quoted_path(dir, "")).code, 0);
  fs::copy_file(dir / "repeat.exr", dir / "frames/frame_0001.exr");
  fs::copy_file(dir / "window.exr", dir / "frames/frame_0002.exr");
  write_bytes(dir / "frames/notes.txt", "no frame");
  ASSERT_EQ(std::system(("oiiotool --pattern noise 40x20 3 -o " + quoted_path(dir, "noise.png")).c_str()), 0);
  const std::string texture = " --texture " + quoted_path(dir, "noise.png");
  const Profile whole = profile_of("--gbuffer " + quoted_path(dir, "frames") + texture);
  EXPECT_EQ(whole.lookups, 12U * 8U + 8U * 4U);
  EXPECT_EQ(whole.sources, (std::map<std::string, std::uint64_t>{{"frame_#", 2}}));
  EXPECT_EQ(whole.count(Reach::kPowerOfTwo, 0), whole.lookups);
  ASSERT_EQ(whole.textures.size(), 1U);
  EXPECT_EQ(whole.textures.begin()->second.names, (std::set<std::string>{"noise"}));
  EXPECT_EQ(profile_of("--gbuffer " + (dir / "frames").string() + "/*.exr" + texture), whole);
  EXPECT_EQ(profile_of("--gbuffer " + quoted_path(dir, "frames/frame_0002.exr") + " " +
                       quoted_path(dir, "frames/frame_0001.exr") + texture),
            whole);
  ASSERT_EQ(std::system(("oiiotool --pattern noise 16x16 4 -o " + quoted_path(dir, "other.png")).c_str()), 0);
  const Profile two =
      profile_of("--gbuffer " + quoted_path(dir, "frames") + texture + " " + quoted_path(dir, "other.png"));
  EXPECT_EQ(two.textures.size(), 2U);
  EXPECT_EQ(two.count(Reach::kWidth, 40), 12U * 8U);
  EXPECT_EQ(two.count(Reach::kWidth, 16), 8U * 4U);
  expect_refused(dir, "profile --gbuffer " + quoted_path(dir, "frames") + texture + texture + texture,
                 {"--texture", "3 files", "one for each"});
}

TEST(profile_program, refuses_and_says_what_is_legal) {
  const TempDir dir;
  const std::string output = " --output " + quoted_path(dir, "out");
  write_bytes(dir / "no.json", "{\"version\": 1}");
  write_bytes(dir / "a.png", "no picture");
  fs::create_directory(dir / "empty");
  ASSERT_EQ(run("scene --scene repeat --size 8 --output " + quoted_path(dir, "")).code, 0);
  const std::string gbuffer = quoted_path(dir, "repeat.exr");
  expect_refused(dir, "profile --scene moon" + output, {"moon", "bricks"});
  expect_refused(dir, "profile --scene repeat,repeat" + output, {"--scene", "each once"});
  expect_refused(dir, "profile --size 0" + output, {"--size", "0", "1 to 16384"});
  expect_refused(dir, "profile --mode fancy" + output, {"--mode", "fancy", "nearest"});
  expect_refused(dir, "profile --scene repeat --gbuffer " + gbuffer + output, {"--gbuffer", "--scene"});
  expect_refused(dir, "profile --size 8 --texture a.png --gbuffer " + gbuffer + output, {"--gbuffer", "--size"});
  expect_refused(dir, "profile --gbuffer " + gbuffer + output, {"--texture", "nothing", "one file"});
  expect_refused(dir, "profile --texture " + quoted_path(dir, "a.png") + output, {"--texture", "--gbuffer"});
  expect_refused(dir, "profile --srgb" + output, {"--srgb", "--texture"});
  expect_refused(dir, "profile --gbuffer " + quoted_path(dir, "none.exr") + " --texture a.png" + output,
                 {"none.exr", "no such file"});
  expect_refused(dir, "profile --gbuffer " + gbuffer + " --texture none.png" + output, {"none.png", "no such file"});
  expect_refused(dir, "profile --gbuffer " + quoted_path(dir, "empty") + " --texture a.png" + output,
                 {"empty", "without .exr files"});
  expect_refused(dir, "profile --merge " + quoted_path(dir, "none.json") + output, {"none.json", "open"});
  expect_refused(dir, "profile --merge " + quoted_path(dir, "no.json") + output,
                 {"no.json", "configuration", "got nothing"});
  expect_refused(dir, "profile --merge " + gbuffer + output, {"repeat.exr", "JSON"});
  expect_refused(dir, "profile --gbuffer " + quoted_path(dir, "a.png") + " --texture " + quoted_path(dir, "a.png"),
                 {"a.png", "open"});
  expect_refused(dir, "profile --gbuffer " + gbuffer + " --texture " + quoted_path(dir, "a.png"), {"a.png", "open"});
  expect_refused(dir, "profile --size 8 --output /proc/none/out", {"--output", "/proc/none/out", "directory"});
  expect_refused(dir, "profile --size 8 --output " + quoted_path(dir, "no.json"), {"--output", "no.json", "directory"});
  expect_refused(dir, "profile --size 8" + output, {"gnuplot-nox"}, "PATH=/none");
  fs::create_directories(dir / "taken" / "profile.html");
  expect_refused(dir, "profile --size 8 --output " + quoted_path(dir, "taken"), {"profile.html"});
  EXPECT_FALSE(fs::exists(dir / "taken" / "profile.json"));
}

}  // namespace
}  // namespace feline
