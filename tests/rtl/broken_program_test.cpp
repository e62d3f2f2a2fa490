// SPDX-License-Identifier: Apache-2.0
// The program with a fault in its RTL: exit code 1, the stage, a waveform of the window that it says, and a replay
// command that shows the same again.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/rtl/fault.h"
#include "tests/testbench/run_program.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

Outcome run_broken(const char* what, const std::string& arguments, const TempDir& dir) {
  const Fault* const fault = find_fault(what);
  if (fault == nullptr) throw std::invalid_argument(std::string("no fault ") + what);
  const std::string before = "cd " + (dir / "").string() + "; FELINE_FAULT=" + std::to_string(fault->number);
  return run_program(FELINE_BROKEN, arguments, before);
}

// The arguments of the replay command, which calls the program as it was called.
std::string replay_of(const std::string& text) {
  const std::string start = "  replay: " FELINE_BROKEN " ";
  const std::size_t at = text.find(start);
  if (at == std::string::npos) return "";
  return text.substr(at + start.size(), text.find('\n', at) - at - start.size());
}

struct Window {
  std::uint64_t first = 0, last = 0;  // cycles
};

// From "  waveform: PATH, cycles 12 to 92".
Window window_of(const std::string& text) {
  const std::string start = ", cycles ";
  const std::size_t at = text.find(start);
  if (at == std::string::npos) return {};
  std::size_t used = 0;
  const std::string rest = text.substr(at + start.size());
  const std::uint64_t first = std::stoull(rest, &used);
  return {first, std::stoull(rest.substr(used + std::string(" to ").size()))};
}

// First and last time in the header block of an FST file: big-endian, behind the block's type and length.
Window fst_times(const std::filesystem::path& path) {
  const std::string bytes = read_bytes(path);
  if (bytes.size() < 25 || bytes[0] != 0) return {};
  const auto number = [&](std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 8; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  return {number(9), number(17)};
}

void expect_mismatch(const char* what, const std::string& arguments, const std::string& stage, const char* wave) {
  const TempDir dir;
  const Outcome outcome = run_broken(what, arguments, dir);
  EXPECT_EQ(outcome.code, 1) << outcome.text;
  EXPECT_NE(outcome.text.find("MISMATCH at stage " + stage + ","), std::string::npos) << outcome.text;
  // A cycle is 10 ns, and two half cycles pass before the first.
  const Window said = window_of(outcome.text);
  const Window held = fst_times(dir / wave);
  EXPECT_GT(said.last, said.first) << outcome.text;
  EXPECT_NEAR(static_cast<double>(held.first), 10 * static_cast<double>(said.first), 20) << outcome.text;
  EXPECT_NEAR(static_cast<double>(held.last), 10 * static_cast<double>(said.last), 20) << outcome.text;
  const std::string replay = replay_of(outcome.text);
  ASSERT_FALSE(replay.empty()) << outcome.text;
  const Outcome again = run_broken(what, replay + " --no-wave", dir);
  EXPECT_EQ(again.code, 1) << replay << "\n" << again.text;
  EXPECT_NE(again.text.find("MISMATCH at stage " + stage + ","), std::string::npos) << replay << "\n" << again.text;
  EXPECT_EQ(run_program(FELINE_PROGRAM, replay).code, 0) << replay;
}

TEST(broken_program, scene) {
  expect_mismatch("rotation_as_printed", "cosim --scene window --size 32 --stalls 0.2 --seed 7", "footprint",
                  "feline-mismatch.fst");
}

TEST(broken_program, scene_with_many_options) {
  expect_mismatch(
      "mirror_not_turned",
      "cosim --scene=text --size 40x24 --mode simple --kernel gaussian --wrap mirrored_repeat --wrap-t repeat "
      "--memory-latency 7 --bias 0.5 --border 1,0,0.5,1 --wave 'a wave.fst'",
      "address", "a wave.fst");
}

TEST(broken_program, random_lookups) {
  expect_mismatch("rom_log2_word_150_bit_0", "cosim --random 20000 --seed 3 --stalls 0.1", "plan",
                  "feline-mismatch.fst");
}

TEST(broken_program, one_that_stops) {
  expect_mismatch("line_never_taken", "cosim --scene bricks --size 16", "fetch", "feline-mismatch.fst");
}

// One run of several: its waveform has its own name, the other runs hold.
TEST(broken_program, one_run_of_several) {
  expect_mismatch("gaussian_on_nearest_texels",
                  "cosim --scene checkerboard --size 16 --mode nearest,table --kernel gaussian", "filter",
                  "feline-mismatch-checkerboard-nearest-gaussian-repeat.fst");
}

// Parts of a million, each with a seed of its own.
TEST(broken_program, random_lookups_in_several_parts) {
  const TempDir dir;
  const Outcome outcome =
      run_broken("rom_log2_word_150_bit_0", "cosim --random 1000256 --seed 3 --jobs 1 --mode trilinear", dir);
  EXPECT_EQ(outcome.code, 1) << outcome.text;
  std::set<std::string> waves;
  for (const auto& entry : std::filesystem::directory_iterator(dir / "")) waves.insert(entry.path().filename());
  EXPECT_EQ(waves.size(), 2U) << outcome.text;
  for (const std::string& wave : waves) EXPECT_NE(outcome.text.find(wave), std::string::npos) << wave;
  EXPECT_TRUE(waves.contains("feline-mismatch-random-3.fst")) << outcome.text;
}

// What asks for something else than a comparison.
TEST(broken_program, activity) {
  const TempDir dir;
  const Outcome outcome = run_broken("step_sign_lost", "activity --scene sphere --size 24", dir);
  EXPECT_EQ(outcome.code, 1) << outcome.text;
  EXPECT_NE(outcome.text.find("RTL and model differ"), std::string::npos) << outcome.text;
}

TEST(broken_program, render_by_rtl) {
  const TempDir dir;
  const Outcome outcome =
      run_broken("step_sign_lost", "render --scene sphere --size 24 --engine rtl --map --output a.png", dir);
  EXPECT_EQ(outcome.code, 1) << outcome.text;
  EXPECT_FALSE(std::filesystem::exists(dir / "a.png"));
  const Outcome again = run_broken("step_sign_lost", replay_of(outcome.text) + " --no-wave", dir);
  EXPECT_EQ(again.code, 1) << outcome.text << again.text;
  EXPECT_NE(again.text.find("MISMATCH at stage plan,"), std::string::npos) << again.text;
}

TEST(broken_program, json_counts_mismatches) {
  const TempDir dir;
  const Outcome outcome = run_broken("sign_lost", "cosim --scene sphere --size 16 --json --no-wave", dir);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(nlohmann::json::parse(outcome.text.substr(outcome.text.find("\n{")))["mismatches"], 1);
}

TEST(broken_program, without_a_fault_it_holds) {
  EXPECT_EQ(run_program(FELINE_BROKEN, "cosim --scene bricks --size 16").code, 0);
}

}  // namespace
}  // namespace feline
