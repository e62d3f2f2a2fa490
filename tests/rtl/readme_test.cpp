// SPDX-License-Identifier: Apache-2.0
// What README.md says of the machine is so.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "model/sampler.h"
#include "tables/emit.h"
#include "testbench/cosim/cosimulation.h"
#include "testbench/coverage/ratchet.h"
#include "tests/rtl/fault.h"
#include "tests/testbench/run_program.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

const std::filesystem::path kRoot = FELINE_SOURCE_DIR;

std::string readme() { return read_bytes(kRoot / "README.md"); }

void expect_said(const std::string& text) {
  EXPECT_NE(readme().find(text), std::string::npos) << "README.md does not say: " << text;
}

TEST(readme, every_file_that_it_names_exists) {
  const std::string text = readme();
  const std::regex link(R"(\]\(([^)]+)\)|`((?:tables|model|rtl|testbench|tests)/[A-Za-z0-9_./]+)`)");
  int links = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at, ++links) {
    const std::string path = (*at)[1].matched ? (*at)[1] : (*at)[2];
    EXPECT_TRUE(std::filesystem::exists(kRoot / path)) << path;
  }
  EXPECT_GT(links, 15);
}

TEST(readme, commands) {
  const std::string text = readme();
  const std::regex command("\n\\| `feline ([a-z]+)` \\|");
  int commands = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), command), end; at != end; ++at, ++commands) {
    EXPECT_EQ(run_program(FELINE_PROGRAM, (*at)[1].str() + " --help").code, 0) << (*at)[1];
  }
  EXPECT_EQ(commands, 18);
}

TEST(readme, faults) { expect_said(fmt::format("| {0} of {0} faults |", std::size(kFaults))); }

// CI compares the ratchet with what is reached.
TEST(readme, coverage) {
  using namespace coverage;
  const Ratchet ratchet = read_ratchet(kRoot / "testbench/coverage/ratchet.json");
  const auto text = [&](Kind kind) {
    const Figure& figure = ratchet.figures[static_cast<std::size_t>(kind)];
    return fmt::format("{} of {}", figure.hit, figure.total);
  };
  std::uint64_t excluded = 0;
  for (const Kind kind : {Kind::kRtlLine, Kind::kRtlBranch, Kind::kRtlToggle}) {
    excluded += ratchet.figures[static_cast<std::size_t>(kind)].excluded;
  }
  expect_said(fmt::format("| {}, {}, {}, but for {} that nothing can reach", text(Kind::kRtlLine),
                          text(Kind::kRtlBranch), text(Kind::kRtlToggle), excluded));
  expect_said(fmt::format("| {}, {}; {} |", text(Kind::kModelLine), text(Kind::kModelBranch), text(Kind::kBin)));
}

TEST(readme, roms) {
  const Roms measured = measured_roms(kDefaultConfig);
  for (const Rom* rom : measured.all()) {
    expect_said(fmt::format("| {} | {} x {} | {:.6g}", rom->name, rom->words.size(), rom->data_bits, rom->worst_error));
  }
}

TEST(readme, formats) {
  using F = Formats<kDefaultConfig>;
  const std::string text = std::regex_replace(readme(), std::regex("\\s+"), " ");
  for (const auto& [name, format] : {std::pair{"Position", F::kPosition},
                                     {"half step", F::kHalfStep},
                                     {"mantissa", F::kMantissa},
                                     {"radius", F::kRadius},
                                     {"vector", F::kVector},
                                     {"level of detail", F::kLevelOfDetail},
                                     {"weight", F::kWeight},
                                     {"texel fraction", F::kTexelFractionOf},
                                     {"texel channel", F::kChannel},
                                     {"result", F::kPixel}}) {
    EXPECT_NE(text.find(std::string(name) + " " + notation(format)), std::string::npos) << name << notation(format);
  }
}

// The message of a mismatch, line by line but for those left out.
TEST(readme, mismatch_message) {
  const TempDir dir;
  const std::string fault = std::to_string(find_fault("turn_the_other_way")->number);
  const std::string before = "cd " + (dir / "").string() + "; FELINE_FAULT=" + fault;
  std::string text = run_program(FELINE_BROKEN, "cosim --size 128 --scene window", before).text;
  text = std::regex_replace(text, std::regex(FELINE_BROKEN), "build/feline");
  const std::string said = readme();
  std::istringstream lines(said.substr(said.find("    MISMATCH at stage")));
  int compared = 0;
  for (std::string line; std::getline(lines, line) && line.starts_with("    ");) {
    if (line.ends_with("...")) continue;
    EXPECT_NE(text.find(line.substr(4) + "\n"), std::string::npos) << line << "\n" << text;
    ++compared;
  }
  EXPECT_GT(compared, 8);
}

// The cycles of each stage: of a lone lookup of one probe whose lines are there, from beat to beat. Between walk and
// address there is one register more.
TEST(readme, cycles_of_the_stages) {
  const Texture texture{TexelFormat::kR8, false, {{4, 4, std::vector<std::uint8_t>(16, 77)}}};
  const TextureMemory memory = layout_texture(texture);
  const auto unit = make_fast_unit(1);
  std::array<std::uint32_t, beat_words<SamplerState<kUnit>>()> sampler{};
  pack(make_sampler<kUnit>({}, texture, memory), sampler);
  unit->set_sampler(sampler);
  std::array<std::uint32_t, beat_words<RequestBeat<kUnit>>()> request{};
  pack(make_request<kUnit>({0.5F, 0.5F, 0.1F, 0, 0, 0.1F}, 1), request);
  unit->set_request(request);
  unit->set_memory_response(memory.line(0));
  RtlUnit::Inputs inputs;
  inputs.reset = true;
  unit->cycle(inputs);
  unit->cycle(inputs);
  inputs = {};
  inputs.accumulate_ready = inputs.memory_request_ready = inputs.memory_response_valid = true;
  std::array<int, kStageCount> left{};
  for (int lookup = 0; lookup < 2; ++lookup) {  // the first brings the lines
    for (int cycle = 0; cycle < 100; ++cycle) {
      inputs.request_valid = cycle == 0;
      unit->cycle(inputs);
      for (std::size_t stage = 0; stage < kStageCount; ++stage) {
        if ((unit->outputs().taken >> stage & 1) != 0) left[stage] = cycle;
      }
    }
  }
  int before = 0;
  for (std::size_t stage = 0; stage < kStageCount; ++stage) {
    const bool behind_spill = static_cast<Stage>(stage) == Stage::kAddress;
    const int cycles = left[stage] - before - (behind_spill ? 1 : 0);
    before = left[stage];
    const std::regex row(
        fmt::format(R"(\| \[`{0}`\]\(model/{0}\.h\) \|[^|]*\| {1}( and misses)? \|)", kStageNames[stage], cycles));
    EXPECT_TRUE(std::regex_search(readme(), row)) << kStageNames[stage] << " takes " << cycles;
  }
}

// The figures of the default scene, by the main job's own command, and its picture.
TEST(readme_long, default_scene) {
  const TempDir dir;
  ASSERT_EQ(run_program(FELINE_PROGRAM, "render --size 512 --mode table --output " + (dir / "a.png").string()).code, 0);
  EXPECT_EQ(read_bytes(dir / "a.png"), read_bytes(kRoot / "testbench/bricks.png"));
  const Outcome outcome = run_program(FELINE_PROGRAM, "cosim --size 512 --mode simple,table --json");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto json = nlohmann::json::parse(outcome.text);
  ASSERT_EQ(json["runs"].size(), 2U);
  for (const auto& run : json["runs"]) {
    const double lookups = run["lookups"];
    expect_said(fmt::format("| {:.2f} probes and {:.1f} cycles a pixel, 0 mismatches",
                            run["probes"].get<double>() / lookups, run["cycles"].get<double>() / lookups));
  }
}

// The row of feline stability. The formulas' last digits are libm's, so theirs are limits.
TEST(readme_long, stability) {
  const Outcome outcome = run_program(FELINE_PROGRAM, "stability --json");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto json = nlohmann::json::parse(outcome.text);
  std::map<std::string, double> level;
  int bounds = 0;
  for (const auto& of : json["classes"]) {
    for (const auto& subject : of["subjects"]) {
      double& worst = level[subject["name"]];
      worst = std::max(worst, subject["errors"]["level"].value("worst", 0.0));
      for (const auto& measure : subject["errors"]) bounds += measure.value("holds", false) ? 1 : 0;
    }
  }
  EXPECT_LT(level["stable float32"], 1e-6);
  EXPECT_LT(level["stable double"], 2e-15);
  expect_said(
      fmt::format("| stiff and extreme input, {} classes of {} lookups: worst level of detail against {} bits | "
                  "Simple {:.2f} octaves, Table {:.2f}; stable formulas below 1e-6 in float32 and 2e-15 in "
                  "double, the printed ones all digits; {} of {} bounds hold |",
                  json["classes"].size(), json["lookups_a_class"].get<int>(), json["precision_bits"].get<int>(),
                  level["unit Simple"], level["unit Table"], bounds, bounds));
}

}  // namespace
}  // namespace feline
