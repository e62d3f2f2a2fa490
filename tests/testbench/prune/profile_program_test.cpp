// SPDX-License-Identifier: Apache-2.0
// `feline profile` as a user meets it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "testbench/prune/profile_json.h"
#include "tests/testbench/html_check.h"
#include "tests/testbench/run_program.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

namespace fs = std::filesystem;

Outcome run(const std::string& arguments, const std::string& before = "") {
  return run_program(FELINE_PROGRAM, arguments, before);
}

std::string path(const TempDir& dir, const std::string& name) { return "'" + (dir / name).string() + "'"; }

Profile profile_of(const std::string& arguments) {
  const Outcome outcome = run("profile --json " + arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  return profile_from_json(outcome.text, "standard output");
}

// Wrong input: exit code 2, a message that holds all of `parts`, and nothing new in the directory.
void expect_refused(const TempDir& dir, const std::string& arguments, const std::vector<std::string>& parts,
                    const std::string& before = "") {
  const auto files = dir.file_count();
  const Outcome outcome = run("profile " + arguments, before);
  EXPECT_EQ(outcome.code, 2) << arguments << "\n" << outcome.text;
  for (const std::string& part : parts) {
    EXPECT_NE(outcome.text.find(part), std::string::npos) << arguments << ": no \"" << part << "\" in\n"
                                                          << outcome.text;
  }
  EXPECT_EQ(dir.file_count(), files) << arguments;
}

TEST(profile_program, writes_page_and_json) {
  const TempDir dir;
  const Outcome outcome = run("profile --scene repeat --size 16x8 --output " + path(dir, "a/b"));
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("128 lookups"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("never nearest"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find((dir / "a/b/profile.html").string()), std::string::npos) << outcome.text;
  EXPECT_EQ(html_fault(read_bytes(dir / "a/b/profile.html")), "");
  const Profile profile = read_profile(dir / "a/b/profile.json");
  EXPECT_EQ(profile.lookups, 128U);
  EXPECT_EQ(profile, profile_of("--scene repeat --size 16x8 --output " + path(dir, "a/b")));
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
    ASSERT_EQ(run("profile --size 8 --scene " + scene + " --output " + path(dir, scene)).code, 0);
  }
  const std::string both = path(dir, "repeat/profile.json") + " " + path(dir, "spin/profile.json");
  const Profile merged = profile_of("--merge " + both);
  EXPECT_EQ(merged, profile_of("--size 8 --scene repeat,spin"));
  EXPECT_EQ(merged, profile_of("--size 8 --scene spin --merge " + path(dir, "repeat/profile.json")));
}

// A sequence of files: one by one, as a directory, and each with its own texture.
TEST(profile_program, your_own_sequence) {
  const TempDir dir;
  fs::create_directory(dir / "frames");
  ASSERT_EQ(run("scene --scene repeat --size 12x8 --output " + path(dir, "")).code, 0);
  ASSERT_EQ(run("scene --scene window --size 8x4 --output " + path(dir, "")).code, 0);
  fs::copy_file(dir / "repeat.exr", dir / "frames/frame_0001.exr");
  fs::copy_file(dir / "window.exr", dir / "frames/frame_0002.exr");
  write_bytes(dir / "frames/notes.txt", "no frame");
  ASSERT_EQ(std::system(("oiiotool --pattern noise 40x20 3 -o " + path(dir, "noise.png")).c_str()), 0);
  const std::string texture = " --texture " + path(dir, "noise.png");
  const Profile whole = profile_of("--gbuffer " + path(dir, "frames") + texture);
  EXPECT_EQ(whole.lookups, 12U * 8U + 8U * 4U);
  EXPECT_EQ(whole.sources, (std::map<std::string, std::uint64_t>{{"frame_#", 2}}));
  EXPECT_EQ(whole.count(Reach::kPowerOfTwo, 0), whole.lookups);
  ASSERT_EQ(whole.textures.size(), 1U);
  EXPECT_EQ(whole.textures.begin()->second.names, (std::set<std::string>{"noise"}));
  EXPECT_EQ(profile_of("--gbuffer " + (dir / "frames").string() + "/*.exr" + texture), whole);
  EXPECT_EQ(profile_of("--gbuffer " + path(dir, "frames/frame_0002.exr") + " " + path(dir, "frames/frame_0001.exr") +
                       texture),
            whole);
  ASSERT_EQ(std::system(("oiiotool --pattern noise 16x16 4 -o " + path(dir, "other.png")).c_str()), 0);
  const Profile two = profile_of("--gbuffer " + path(dir, "frames") + texture + " " + path(dir, "other.png"));
  EXPECT_EQ(two.textures.size(), 2U);
  EXPECT_EQ(two.count(Reach::kWidth, 40), 12U * 8U);
  EXPECT_EQ(two.count(Reach::kWidth, 16), 8U * 4U);
  expect_refused(dir, "--gbuffer " + path(dir, "frames") + texture + texture + texture,
                 {"--texture", "3 files", "one for each"});
}

TEST(profile_program, refuses_and_says_what_is_legal) {
  const TempDir dir;
  const std::string output = " --output " + path(dir, "out");
  write_bytes(dir / "no.json", "{\"version\": 1}");
  write_bytes(dir / "a.png", "no picture");
  fs::create_directory(dir / "empty");
  ASSERT_EQ(run("scene --scene repeat --size 8 --output " + path(dir, "")).code, 0);
  const std::string gbuffer = path(dir, "repeat.exr");
  expect_refused(dir, "--scene moon" + output, {"moon", "bricks"});
  expect_refused(dir, "--scene repeat,repeat" + output, {"--scene", "each once"});
  expect_refused(dir, "--size 0" + output, {"--size", "0", "1 to 16384"});
  expect_refused(dir, "--mode fancy" + output, {"--mode", "fancy", "nearest"});
  expect_refused(dir, "--scene repeat --gbuffer " + gbuffer + output, {"--gbuffer", "--scene"});
  expect_refused(dir, "--size 8 --texture a.png --gbuffer " + gbuffer + output, {"--gbuffer", "--size"});
  expect_refused(dir, "--gbuffer " + gbuffer + output, {"--texture", "nothing", "one file"});
  expect_refused(dir, "--texture " + path(dir, "a.png") + output, {"--texture", "--gbuffer"});
  expect_refused(dir, "--srgb" + output, {"--srgb", "--texture"});
  expect_refused(dir, "--gbuffer " + path(dir, "none.exr") + " --texture a.png" + output, {"none.exr", "no such file"});
  expect_refused(dir, "--gbuffer " + gbuffer + " --texture none.png" + output, {"none.png", "no such file"});
  expect_refused(dir, "--gbuffer " + path(dir, "empty") + " --texture a.png" + output, {"empty", "without .exr files"});
  expect_refused(dir, "--merge " + path(dir, "none.json") + output, {"none.json", "open"});
  expect_refused(dir, "--merge " + path(dir, "no.json") + output, {"no.json", "configuration", "got nothing"});
  expect_refused(dir, "--merge " + gbuffer + output, {"repeat.exr", "JSON"});
  expect_refused(dir, "--gbuffer " + path(dir, "a.png") + " --texture " + path(dir, "a.png"), {"a.png", "open"});
  expect_refused(dir, "--gbuffer " + gbuffer + " --texture " + path(dir, "a.png"), {"a.png", "open"});
  expect_refused(dir, "--size 8 --output /proc/none/out", {"--output", "/proc/none/out", "directory"});
  expect_refused(dir, "--size 8 --output " + path(dir, "no.json"), {"--output", "no.json", "directory"});
  expect_refused(dir, "--size 8" + output, {"gnuplot-nox"}, "PATH=/none");
  fs::create_directories(dir / "taken" / "profile.html");
  expect_refused(dir, "--size 8 --output " + path(dir, "taken"), {"profile.html"});
  EXPECT_FALSE(fs::exists(dir / "taken" / "profile.json"));
}

}  // namespace
}  // namespace feline
