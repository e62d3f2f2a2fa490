// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tables/emit.h"
#include "testbench/atomic_file.h"
#include "testbench/ellipse_choice.h"
#include "testbench/error.h"
#include "testbench/image.h"
#include "testbench/program/commands.h"

namespace feline {
namespace {

struct TablesOptions {
  std::string output;
  bool json = false;
};

// The ellipse table as four panels, uvScale, uvScale90, minor and major radius scale: row 0 at the top, dark is 0.
void write_heat_map(OutputFiles& outputs, const std::filesystem::path& path, const Rom& ellipse) {
  constexpr int kCell = 16;
  constexpr int kGap = 8;
  constexpr int kRows = kDefaultConfig.table_rows;
  constexpr int kColumns = kDefaultConfig.table_columns;
  constexpr std::int64_t kMax = (std::int64_t{1} << kDefaultConfig.entry_bits) - 1;
  const int width = 4 * kColumns * kCell + 3 * kGap;
  const int height = kRows * kCell;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3, 255);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int panel = x / (kColumns * kCell + kGap);
      const int within = x % (kColumns * kCell + kGap);
      if (within >= kColumns * kCell) continue;
      const auto word = static_cast<std::size_t>(y / kCell * kColumns + within / kCell);
      const EllipseEntry entry = ellipse_entry(kDefaultConfig, ellipse.words[word]);
      const std::array values{entry.uv_scale, entry.uv_scale_90, entry.minor_radius, entry.major_radius};
      const auto value = static_cast<int>(255 * values[static_cast<std::size_t>(panel)] / kMax);
      const auto at = static_cast<std::size_t>((y * width + x) * 3);
      // Black, red, yellow, white.
      for (std::size_t c = 0; c < 3; ++c) {
        pixels[at + c] = static_cast<std::uint8_t>(std::clamp(3 * value - 255 * static_cast<int>(c), 0, 255));
      }
    }
  }
  write_png(outputs, path, width, height, 3, std::span<const std::uint8_t>(pixels));
}

struct Judged {
  const char* name;
  EllipseErrors errors;
};

std::vector<Judged> judge_representations() {
  constexpr int kLattice = 16;
  std::vector<Judged> all;
  for (const auto& [name, representation] : {std::pair{"centre", CellRepresentation::kCentre},
                                             {"least worst", CellRepresentation::kLeastWorst},
                                             {"least mean", CellRepresentation::kLeastMean}}) {
    all.push_back({name, ellipse_errors(kDefaultConfig, ellipse_rom(kDefaultConfig, representation), kLattice)});
  }
  return all;
}

int run_tables(const TablesOptions& options) {
  const Roms measured = measured_roms(kDefaultConfig);
  if (!options.output.empty()) {
    const std::filesystem::path directory = options.output;
    if (!std::filesystem::is_directory(directory)) {
      bad_input(options.output, "--output", "no directory", "a directory that exists");
    }
    OutputFiles outputs;
    for (const GeneratedFile& file : generate(kDefaultConfig, measured)) {
      outputs.write(directory / file.name, file.text);
    }
    write_heat_map(outputs, directory / "ellipse.png", measured.ellipse);
    outputs.commit();
  }
  if (options.json) {
    fmt::print("{}", emit_json(kDefaultConfig, measured, fingerprint<kDefaultConfig>()));
    return kHolds;
  }
  fmt::print("{:<12}{:>7}{:>6}{:>14}{:>7}  {}\n", "rom", "words", "bits", "worst error", "word", "unit");
  for (const Rom* rom : measured.all()) {
    fmt::print("{:<12}{:>7}{:>6}{:>14.6g}{:>7}  {}\n", rom->name, rom->words.size(), rom->data_bits, rom->worst_error,
               rom->worst_word, rom->error_unit);
  }
  fmt::print(
      "\nHow an ellipse entry stands for its cell: errors over all cells, at most {} probes.\n"
      "{:<14}{:>24}{:>24}{:>26}\n{:<14}{:>12}{:>12}{:>12}{:>12}{:>13}{:>13}\n",
      kDefaultConfig.max_probes, "", "level of detail, octaves", "major radius, relative", "line end, minor radii", "",
      "worst", "mean", "worst", "mean", "worst", "mean");
  for (const auto& [name, errors] : judge_representations()) {
    fmt::print("{:<14}{:>12.4f}{:>12.5f}{:>12.4f}{:>12.5f}{:>13.4f}{:>13.5f}\n", name, errors.worst_level,
               errors.mean_level, errors.worst_major, errors.mean_major, errors.worst_line, errors.mean_line);
  }
  fmt::print("The table holds the least mean.\n");
  return kHolds;
}

}  // namespace

void add_tables(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<TablesOptions>();
  CLI::App* command = program.add_subcommand("tables", "generates the ROMs and reports the exact error of each");
  command->footer(
      "Writes .mem ($readmemh), SystemVerilog, C, CSV, JSON and a heat map (PNG).\n"
      "Example: feline tables --output /tmp");
  command->add_option("--output", options->output, "directory for the files");
  command->add_flag("--json", options->json, "the ROMs and their errors as JSON");
  command->callback([options, &exit_code] { exit_code = run_tables(*options); });
}

}  // namespace feline
