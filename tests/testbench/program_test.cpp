// SPDX-License-Identifier: Apache-2.0
// The program as a user meets it: exit codes, messages, and no partial file after wrong input.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "testbench/gbuffer.h"
#include "tests/testbench/feline_program.h"

namespace feline {
namespace {

namespace fs = std::filesystem;

std::string path(const TempDir& dir, const char* name) { return (dir / name).string(); }

// Every command has an example, and tells scripts what it tells people.
TEST(program, help_of_every_command) {
  const std::string all = run("--help").text;
  const std::string list = all.substr(all.find("Subcommands:"));
  const std::regex line("\n  ([a-z]+) ");
  const std::vector<std::smatch> commands(std::sregex_iterator(list.begin(), list.end(), line), {});
  EXPECT_EQ(commands.size(), 18U) << all;
  for (const std::smatch& match : commands) {
    const std::string command = match[1];
    const Outcome outcome = run(command + " --help");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.text.find("Example: feline " + command), std::string::npos) << outcome.text;
    EXPECT_NE(outcome.text.find("--json"), std::string::npos) << outcome.text;
  }
}

TEST(program, unknown_use) {
  const TempDir dir;
  expect_refused(dir, "", {"subcommand is required"});
  expect_refused(dir, "paint", {"paint"});
  expect_refused(dir, "cosim --fast", {"--fast"});
  expect_refused(dir, "render --mode fancy --output " + path(dir, "a.png"),
                 {"--mode", "fancy", "nearest, bilinear, trilinear"});
  expect_refused(dir, "render --kernel box --output " + path(dir, "a.png"), {"--kernel", "box", "bilinear, gaussian"});
  expect_refused(dir, "render --scene moon --output " + path(dir, "a.png"), {"moon", "bricks"});
  expect_refused(dir, "render --engine gpu --output " + path(dir, "a.png"), {"--engine", "gpu", "model, rtl"});
}

TEST(program, values_out_of_range) {
  const TempDir dir;
  const std::string output = " --output " + path(dir, "a.png");
  expect_refused(dir, "render --size 0" + output, {"command line: --size", "0", "1 to 16384"});
  expect_refused(dir, "render --size 16385x4" + output, {"16385x4", "1 to 16384"});
  expect_refused(dir, "render --size 12cats" + output, {"12cats"});
  expect_refused(dir, "render --max-probes 17 --size 8" + output, {"--max-probes", "17", "1 to 16"});
  expect_refused(dir, "render --bias nan --size 8" + output, {"--bias", "nan", "-16 to"});
  expect_refused(dir, "render --alias-factor 3 --size 8" + output, {"--alias-factor", "3", "1 to 2"});
  expect_refused(dir, "render --length-factor 1e-9 --size 8" + output, {"--length-factor", "1e-9", "0.00390625 to 1"});
  expect_refused(dir, "render --border 1,2,0,0 --size 8" + output, {"--border", "got 2", "0 to 1"});
  expect_refused(dir, "render --min-level 5 --max-level 2 --size 8" + output, {"--min-level", "5", "--max-level, 2"});
  expect_refused(dir, "render --rounding nearest --blur-factor 1.2 --size 8" + output, {"--rounding", "ceiling"});
  expect_refused(dir, "cosim --stalls 1 --size 8", {"--stalls", "1", "0 to 0.95"});
  expect_refused(dir, "cosim --memory-latency -1 --size 8", {"--memory-latency", "-1", "0 to"});
  expect_refused(dir, "cosim --size 8 --replay 64", {"--replay", "64", "0 to 63"});
  expect_refused(dir, "cosim --random 0", {"--random"});
  expect_refused(dir, "cosim --random -5", {"--random", "-5", "1 to"});
  expect_refused(dir, "vectors --random -1 --output " + path(dir, ""), {"--random", "-1", "1 to 1000000"});
  expect_refused(dir, "cosim --seed 18446744073709551616",
                 {"--seed", "18446744073709551616", "0 to 18446744073709551615"});
  expect_refused(dir, "cosim --stalls some", {"--stalls", "some", "0 to 0.95"});
  expect_refused(dir, "cosim --jobs -1", {"--jobs", "-1", "0 to"});
  expect_refused(dir, "render --size 8 --output " + path(dir, "a.jpg"), {"a.jpg", ".png"});
  expect_refused(dir, "explain --scene bricks --size 8 --pixel 8,0", {"--pixel", "8,0", "7,7"});
}

TEST(program, choices_that_contradict_each_other) {
  const TempDir dir;
  const std::string output = " --output " + path(dir, "a.png");
  expect_refused(dir, "cosim --random 5 --texture a.png", {"--texture", "a.png", "--random"});
  expect_refused(dir, "cosim --random 5 --bias 1", {"--bias", "1", "--random"});
  expect_refused(dir, "cosim --scene bricks --random 5", {"--scene", "bricks", "--random"});
  expect_refused(dir, "explain --derivatives 1,0,0,1 --scene bricks", {"--scene", "--derivatives"});
  expect_refused(dir, "explain --derivatives 1,0,0,1 --texture a.png --size 8", {"--size", "--texture"});
  expect_refused(dir, "explain --pixel 1,1 --position 0,0", {"--position", "--derivatives"});
  expect_refused(dir, "explain --derivatives 13,0,12,x", {"--derivatives", "got x", "float32"});
  expect_refused(dir, "explain --derivatives 1,0,0,1 --mip-filter box", {"--mip-filter", "--texture"});
  expect_refused(dir, "vectors --seed 5 --size 4", {"--seed", "5", "--random"});
  expect_refused(dir, "render --srgb" + output, {"--srgb", "--texture"});
  expect_refused(dir, "render --gbuffer a.exr --size 8 --texture a.png" + output, {"--size", "--gbuffer"});
  expect_refused(dir, "render --gbuffer a.exr --scene bricks --texture a.png" + output, {"--scene", "--gbuffer"});
  expect_refused(dir, "render --no-shortcuts --engine rtl" + output, {"--no-shortcuts", "--engine rtl"});
  expect_refused(dir, "render --no-shortcuts --filter ewa" + output, {"--no-shortcuts", "--filter"});
  expect_refused(dir, "shortcuts --runs 0", {"--runs", "0", "1 to 1000"});
  expect_refused(dir, "cosim --mode table,table", {"--mode", "table,table", "each once"});
  expect_refused(dir, "cosim --scene bricks,", {"--scene", "bricks,"});
  expect_refused(dir, "render --texture ''" + output, {"--texture", "an empty value"});
  expect_refused(dir, "render --texture=" + output, {"--texture", "an empty value"});
  expect_refused(dir, "cosim --size 8 --wave /nonexistent/a.fst", {"/nonexistent/a.fst"});
}

// A texture that repeats has other mip levels than one that does not: a run in a list is what it is alone.
TEST(program, runs_in_a_list_are_those_alone) {
  const TempDir dir;
  ASSERT_EQ(std::system(("oiiotool --pattern noise 64x64 3 -o " + path(dir, "noise.png")).c_str()), 0);
  const std::string texture = "cosim --scene sphere --size 24 --texture " + path(dir, "noise.png");
  for (const char* const name : {"list", "alone"}) ASSERT_EQ(::mkdir(path(dir, name).c_str(), 0700), 0);
  ASSERT_EQ(run(texture + " --wrap repeat,clamp_to_edge --output " + path(dir, "list")).code, 0);
  ASSERT_EQ(run(texture + " --wrap repeat --output " + path(dir, "alone")).code, 0);
  const std::string picture = "/sphere-table-bilinear-repeat.png";
  EXPECT_EQ(read_bytes(dir / ("list" + picture)), read_bytes(dir / ("alone" + picture)));
}

TEST(program, tells_json) {
  const TempDir dir;
  const auto json = [&](const std::string& arguments) {
    const Outcome outcome = run(arguments + " --json");
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    return nlohmann::json::parse(outcome.text);
  };
  const auto explained = json("explain --derivatives 13,0,12,5 --size 256x256");
  EXPECT_EQ(explained["beats"].front()["stage"], "group");
  EXPECT_EQ(explained["beats"].front()["fields"]["dudx"]["hex"], "0x68");
  EXPECT_EQ(explained["beats"].back()["stage"], "accumulate");
  EXPECT_NEAR(explained["footprints"][0]["minor"].get<double>(), 3.606, 1e-3);
  const auto scene = json("scene --scene runway --size 20x10 --output " + path(dir, ""));
  EXPECT_TRUE(fs::exists(scene["gbuffer"].get<std::string>()));
  EXPECT_TRUE(fs::exists(scene["texture"].get<std::string>()));
  EXPECT_EQ(json("scene --list").size(), 15U);
  const auto rendered = json("render --size 8 --map --output " + path(dir, "a.png"));
  EXPECT_TRUE(fs::exists(rendered["probe_map"].get<std::string>()));
  EXPECT_EQ(rendered["status"]["overflow"], 0);
  EXPECT_GT(rendered["left_out"]["decoded_codes"], 0);
  EXPECT_EQ(rendered["texture_memory"]["bytes"], rendered["texture_memory"]["of_bytes"]);
  const auto shortcuts = json("shortcuts --size 8 --runs 1");
  EXPECT_EQ(shortcuts["same_bits"], true);
  EXPECT_EQ(shortcuts["rows"].size(), 9u);
  EXPECT_EQ(shortcuts["rows"].back()["name"], "all");
  const auto vectors = json("vectors --stage plan --random 5 --output " + path(dir, ""));
  EXPECT_EQ(vectors["files"].size(), 3U);
  EXPECT_EQ(json("tables")["roms"].size(), 6U);
}

TEST(program, engines_make_the_same_picture) {
  const TempDir dir;
  for (const char* const engine : {"model", "rtl"}) {
    const std::string output = path(dir, engine) + ".png";
    ASSERT_EQ(run("render --scene window --size 40 --engine " + std::string(engine) + " --output " + output).code, 0);
  }
  EXPECT_EQ(read_bytes(dir / "model.png"), read_bytes(dir / "rtl.png"));
}

TEST(program, images_that_cannot_be_read) {
  const TempDir dir;
  const std::string output = " --size 8 --output " + path(dir, "a.png");
  expect_refused(dir, "render --texture " + path(dir, "none.png") + output, {"none.png"});
  std::ofstream(dir / "corrupt.png") << "this is not a picture";
  expect_refused(dir, "render --texture " + path(dir, "corrupt.png") + output, {"corrupt.png"});
}

TEST(program, gbuffers_that_cannot_be_read) {
  const TempDir dir;
  const std::string texture = " --scene bricks --output " + path(dir, "a.png");
  expect_refused(dir, "render --gbuffer " + path(dir, "none.exr") + texture, {"none.exr"});
  GBuffer gbuffer{4, 2, std::vector<Lookup>(8)};
  gbuffer.lookups[5].dtdx = std::numeric_limits<float>::quiet_NaN();
  write_gbuffer(dir / "nan.exr", gbuffer);
  expect_refused(dir, "render --gbuffer " + path(dir, "nan.exr") + texture, {"nan.exr", "dtdx", "1, 1", "nan"});
  EXPECT_EQ(run("render --allow-non-finite --gbuffer " + path(dir, "nan.exr") + texture).code, 0);
  ASSERT_EQ(std::system(("oiiotool --create 4x4 3 -d float -o " + path(dir, "rgb.exr")).c_str()), 0);
  expect_refused(dir, "render --gbuffer " + path(dir, "rgb.exr") + texture, {"rgb.exr", "s, t, dsdx"});
  expect_refused(dir, "render --gbuffer " + path(dir, "nan.exr") + " --output " + path(dir, "b.png"), {"--texture"});
}

TEST(program, outputs_that_cannot_be_written) {
  const TempDir dir;
  expect_refused(dir, "render --size 64 --output /nonexistent/a.png", {"/nonexistent"});
  expect_refused(dir, "render --size 64 --output /dev/full", {"/dev/full", "No space left"});
  expect_refused(dir, "render --size 256 --output " + path(dir, "big.png"), {"big.png", "File too large"},
                 "ulimit -f 4;");
  expect_refused(dir, "cosim --size 8 --json 3>&1 > /dev/full 2>&3; ( exit $? )", {"No space left"});
  expect_refused(dir, "scene --output /nonexistent", {"--output", "directory"});
  expect_refused(dir, "vectors --output /nonexistent", {"--output", "directory"});
  expect_refused(dir, "tables --output /nonexistent", {"--output", "directory"});
  expect_refused(dir, "cosim --size 8 --output /nonexistent", {"--output", "directory"});
}

// A signal leaves no temporary behind.
TEST(program, killed_leaves_nothing) {
  const TempDir dir;
  ASSERT_EQ(::mkdir(path(dir, "out").c_str(), 0700), 0);
  const Outcome outcome = run("vectors --random 1000000 --output " + path(dir, "out"), "timeout -s INT 0.5");
  EXPECT_EQ(outcome.code, 124) << outcome.text;
  EXPECT_TRUE(fs::is_empty(dir / "out"));
}

TEST(program, explain_shows_the_papers_example) {
  const Outcome simple = run("explain --derivatives 13,0,12,5 --size 256x256 --mode simple");
  EXPECT_EQ(simple.code, 0);
  const auto line = [&](const std::string& start) {
    const std::size_t at = simple.text.find("\n" + start);
    return at == std::string::npos ? "" : simple.text.substr(at + 1, simple.text.find('\n', at + 1) - at - 1);
  };
  EXPECT_NE(line("ideal ").find("18.028"), std::string::npos) << simple.text;
  EXPECT_NE(line("ideal ").find("3.606"), std::string::npos);
  EXPECT_NE(line("ideal ").find(" 9 "), std::string::npos) << line("ideal ");
  EXPECT_NE(line("simple ").find(" 4 "), std::string::npos) << line("simple ");
  EXPECT_NE(line("table ").find(" 9 "), std::string::npos) << line("table ");
  for (const char* const stage : {"group", "footprint", "plan", "walk", "address", "fetch", "filter", "accumulate"}) {
    EXPECT_NE(simple.text.find(std::string("\n") + stage + "\n"), std::string::npos) << stage;
  }
}

TEST(program, scene_and_gbuffer_are_the_same_picture) {
  const TempDir dir;
  ASSERT_EQ(run("scene --scene text --size 40x30 --output " + path(dir, "")).code, 0);
  ASSERT_EQ(run("render --scene text --size 40x30 --mip-filter box --output " + path(dir, "scene.png")).code, 0);
  ASSERT_EQ(run("render --scene text --mip-filter box --gbuffer " + path(dir, "text.exr") + " --output " +
                path(dir, "file.png"))
                .code,
            0);
  EXPECT_EQ(read_bytes(dir / "scene.png"), read_bytes(dir / "file.png"));
}

TEST(program, cosim_json_has_the_figures) {
  const Outcome outcome = run("cosim --scene window --mode table --size 24x16 --stalls 0.3 --seed 9 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto json = nlohmann::json::parse(outcome.text);
  EXPECT_EQ(json["scene"], "window");
  EXPECT_EQ(json["mode"], "table");
  EXPECT_EQ(json["lookups"], 24 * 16);
  EXPECT_EQ(json["mismatches"], 0);
  EXPECT_EQ(json["seed"], 9);
  EXPECT_EQ(json["beats"].size(), 8U);
  EXPECT_EQ(json["beats"]["walk"], json["probes"]);
  EXPECT_EQ(json["beats"]["accumulate"], json["lookups"]);
  EXPECT_GT(json["cycles"], json["probes"]);
  EXPECT_GT(json["seconds"], 0.0);
}

TEST(program, random_choices_are_kept) {
  const auto probes = [](const std::string& mode) {
    const Outcome outcome = run("cosim --random 500 --mode " + mode + " --json");
    return nlohmann::json::parse(outcome.text)["probes"].get<int>();
  };
  EXPECT_EQ(probes("nearest"), 500);
  EXPECT_GT(probes("table"), 700);
}

TEST(program, same_input_same_bytes) {
  const TempDir dir;
  for (const char* const name : {"a", "b"}) {
    ASSERT_EQ(::mkdir(path(dir, name).c_str(), 0700), 0);
    ASSERT_EQ(run("vectors --stage unit --random 20 --seed 3 --output " + path(dir, name)).code, 0);
  }
  for (const char* const file : {"request", "plan", "fetch", "accumulate", "sampler", "memory"}) {
    const std::string left = read_bytes(dir / ("a/" + std::string(file) + ".hex"));
    EXPECT_FALSE(left.empty());
    EXPECT_EQ(left, read_bytes(dir / ("b/" + std::string(file) + ".hex")));
  }
}

}  // namespace
}  // namespace feline
