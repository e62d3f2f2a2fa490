// SPDX-License-Identifier: Apache-2.0
// Areas: what is read from Yosys's words, and one small stage synthesized.
#include "testbench/area/area.h"

#include <gtest/gtest.h>

#include "tables/beats.h"
#include "tables/formats.h"
#include "tables/pack.h"
#include "tables/unit.h"
#include "testbench/area/synthesis.h"
#include "tests/testbench/run_program.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

constexpr const char* kLibrary =
    "library (cells) {\n cell (NAND2X1) {\n  area : 24;\n }\n cell (INVX1) {\n  area : 12;\n }\n"
    " cell (DFFPOSX1) {\n  area : 96;\n }\n}\n";

// A multiplier, a multiple (of 3), a ROM and a memory; a net's bit is a number, a constant one a text.
constexpr const char* kWords = R"({"modules": {
  "stage_walk": {"cells": {
    "a": {"type": "$mul", "parameters": {"A_WIDTH": 4, "B_WIDTH": 12}, "connections": {"A": [2, 3, 4, "0"], "B": [5]}},
    "b": {"type": "$mul", "parameters": {"A_WIDTH": 12, "B_WIDTH": 4}, "connections": {"A": [6], "B": [7]}},
    "c": {"type": "$mul", "parameters": {"A_WIDTH": 2, "B_WIDTH": 4}, "connections": {"A": ["1", "1"], "B": [8]}},
    "d": {"type": "$mem_v2", "parameters": {"SIZE": 256, "WIDTH": 9, "WR_PORTS": 0}}}},
  "stage_fetch": {"cells": {"e": {"type": "$mem_v2", "parameters": {"SIZE": 16, "WIDTH": 512, "WR_PORTS": 1}}}}}})";

constexpr const char* kCells = R"({"modules": {
  "\\feline_unit": {"num_cells_by_type": {"INVX1": 2, "stage_walk": 1, "stage_fetch": 1}},
  "\\stage_fetch": {"num_cells_by_type": {"$mem_v2": 1, "DFFPOSX1": 3}},
  "\\stage_walk": {"num_cells_by_type": {"NAND2X1": 10, "INVX1": 4, "DFFPOSX1": 2}}}})";

TEST(area, is_read_from_words_and_cells) {
  const std::vector<StageArea> stages = parse_area(kWords, kCells, kLibrary);
  ASSERT_EQ(stages.size(), 3U);
  const StageArea walk{"walk", 16, 20, 2, 2304, 0, {{12, 4, 2}}};
  const StageArea fetch{"fetch", 3, 12, 3, 0, 8192, {}};
  const StageArea rest{"rest", 2, 1, 0, 0, 0, {}};
  EXPECT_EQ(stages[0], walk);
  EXPECT_EQ(stages[1], fetch);
  EXPECT_EQ(stages[2], rest);
  const StageArea total = AreaReport{"yosys", "cells", stages}.total();
  EXPECT_EQ(total, (StageArea{"all", 21, 33, 5, 2304, 8192, {{12, 4, 2}}}));
  EXPECT_EQ(total.multiplier_count(), 2);
  EXPECT_EQ(total.product_bits(), 96);
  for (const StageArea& stage : stages) EXPECT_EQ(stage_area_from_json(to_json(stage)), stage);
}

TEST(area, refuses_what_is_no_text_of_yosys) {
  EXPECT_THROW(parse_area("", kCells, kLibrary), std::runtime_error);
  EXPECT_THROW(parse_area(kWords, "{}", kLibrary), std::runtime_error);
  EXPECT_THROW(parse_area(kWords, kCells, "library (cells) {}"), std::runtime_error);
  EXPECT_THROW(parse_area(kWords, R"({"modules": {"\\other": {"num_cells_by_type": {}}}})", kLibrary),
               std::runtime_error);
  EXPECT_DOUBLE_EQ(cell_area(kLibrary, "INVX1"), 12);
  EXPECT_THROW(cell_area(kLibrary, "NAND3X1"), std::runtime_error);
  EXPECT_THROW(cell_area("cell (NAND2X1) {} cell (INVX1) { area : 12; }", "NAND2X1"), std::runtime_error);
  EXPECT_THROW(cell_area("cell (NAND2X1) { area : 1e999; }", "NAND2X1"), std::runtime_error);
  for (const char* const count : {"-1", "1e300", "1.5", "9223372036854775807", "\"1\""}) {
    const std::string cells = R"({"modules": {"\\feline_unit": {"num_cells_by_type": {"INVX1": )";
    EXPECT_THROW(parse_area(kWords, cells + count + "}}}}", kLibrary), std::runtime_error) << count;
  }
}

std::string full_unit() {
  const std::filesystem::path root = FELINE_SOURCE_DIR;
  return unit_source(root / "rtl", root / "tables" / "generated");
}

TEST(area, source_is_the_package_and_every_module_once) {
  const std::string source = full_unit();
  const auto count = [&](const std::string& text) {
    int found = 0;
    for (std::size_t at = source.find(text); at != std::string::npos; at = source.find(text, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("package feline_pkg;"), 1);
  EXPECT_LT(source.find("package feline_pkg;"), source.find("module feline_"));
  EXPECT_EQ(count("\nmodule feline_unit "), 1);
  EXPECT_EQ(count("\nmodule feline_rom_weight "), 1);
  const TempDir empty;
  EXPECT_NE(input_error([&] { unit_source(empty / "", empty / ""); }).find("--source"), std::string::npos);
  const std::filesystem::path rtl = std::filesystem::path(FELINE_SOURCE_DIR) / "rtl";
  EXPECT_NE(input_error([&] { unit_source(rtl, empty / ""); }).find("--generated"), std::string::npos);
}

// The four channels' products, and the flip-flops of two registers of every bit of a beat.
TEST(area, of_small_stages) {
  const Synthesis synthesis(kCellLibrary, nullptr);
  const StageArea accumulate = synthesis.stage(full_unit(), "accumulate");
  ASSERT_EQ(accumulate.multipliers.size(), 1U);
  EXPECT_EQ(accumulate.multipliers.front(),
            (Multipliers{Formats<kUnit>::kFiltered.width(), Formats<kUnit>::kWeight.width(), 4}));
  EXPECT_GT(accumulate.cells, accumulate.flip_flops);
  EXPECT_GT(accumulate.gates, static_cast<double>(accumulate.cells));
  EXPECT_EQ(accumulate.rom_bits + accumulate.memory_bits, 0);
  const TempDir directory;
  const Cache cache(directory / "cache");
  const Synthesis kept(kCellLibrary, &cache);
  const StageArea spill = kept.stage(full_unit(), "spill");
  EXPECT_EQ(spill.flip_flops, 2 * beat_width<WalkBeat<kUnit>>() + 2);
  EXPECT_EQ(kept.stage(full_unit(), "spill"), spill);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory / "cache"), {}), 1);
}

TEST(area, program_says_what_is_missing) {
  const auto complaint = [&](const std::string& arguments, const std::string& before = "") {
    const Outcome outcome = run_program(FELINE_PROGRAM, "area " + arguments, before);
    EXPECT_EQ(outcome.code, 2) << outcome.text;
    return outcome.text;
  };
  EXPECT_EQ(complaint("", "PATH=/nonexistent"),
            "feline: yosys: No such file or directory; areas need it (Debian package yosys)\n");
  EXPECT_NE(complaint("--library /nonexistent.lib").find("/nonexistent.lib: --library: got no file that can be read"),
            std::string::npos);
  EXPECT_NE(complaint("--library /dev/null").find("/dev/null: --library: got no area of a cell NAND2X1"),
            std::string::npos);
  EXPECT_NE(complaint("--stage walk,trot").find("--stage: got trot, legal is one of group, footprint"),
            std::string::npos);
  EXPECT_NE(complaint("--generated /nonexistent").find("/nonexistent: --generated: got no such files"),
            std::string::npos);
}

}  // namespace
}  // namespace feline
