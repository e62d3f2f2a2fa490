// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tables/pack.h"
#include "tables/roms.h"
#include "tables/sampler_state.h"

namespace feline {

struct GeneratedFile {
  std::string name;
  std::string text;
};

// level_of_detail -> LevelOfDetail.
std::string upper_camel(std::string_view snake);
// S5.8.
std::string notation(const Format& format);

// The parts of the SystemVerilog package that depend on a configuration's types.
struct PackageParts {
  std::vector<Format> formats;
  struct Member {
    std::string name;
    Format format;
    int count;
    bool is_array;
  };
  struct Beat {
    std::string name;
    std::vector<Member> members;
  };
  std::vector<Beat> beats;
  int levels, weight_columns, gaussian_rows, tile_log2, saturation_log2, eighths_width, dividend_width;
};

template <typename Beat>
PackageParts::Beat describe_beat() {
  PackageParts::Beat beat{std::string(Beat::kName.view()), {}};
  for_each_shape<Beat>([&](Name name, const Format& format, int count, bool is_array) {
    beat.members.push_back({std::string(name.view()), format, count, is_array});
  });
  return beat;
}

template <Config kConfig>
PackageParts package_parts() {
  using F = Formats<kConfig>;
  PackageParts parts;
  parts.formats.assign(F::kAll.begin(), F::kAll.end());
  parts.beats = {describe_beat<SamplerState<kConfig>>(), describe_beat<RequestBeat<kConfig>>(),
                 describe_beat<GroupBeat<kConfig>>(),    describe_beat<FootprintBeat<kConfig>>(),
                 describe_beat<PlanBeat<kConfig>>(),     describe_beat<WalkBeat<kConfig>>(),
                 describe_beat<AddressBeat<kConfig>>(),  describe_beat<FetchBeat<kConfig>>(),
                 describe_beat<FilterBeat<kConfig>>(),   describe_beat<AccumulateBeat<kConfig>>()};
  parts.levels = F::kLevels;
  parts.weight_columns = F::kWeightColumns;
  parts.gaussian_rows = F::kGaussianRows;
  parts.tile_log2 = kTileLog2;
  parts.saturation_log2 = F::kSaturationLog2;
  parts.eighths_width = F::kEighthsWidth;
  parts.dividend_width = F::kDividendWidth;
  return parts;
}

// The same for configuration, formats, beats and ROM contents that are the same, and, short of chance, for no other.
std::uint64_t fingerprint(const Config& config, const PackageParts& parts, const Roms& roms);
template <Config kConfig>
std::uint64_t fingerprint() {
  static const std::uint64_t value = fingerprint(kConfig, package_parts<kConfig>(), roms<kConfig>());
  return value;
}

std::string emit_package(const Config& config, const PackageParts& parts, std::uint64_t fingerprint);
std::string emit_rom_module(const Rom& rom);
std::string emit_mem(const Rom& rom);
std::string emit_c_header(const Config& config, const Roms& roms);
std::string emit_csv(const Roms& roms);
std::string emit_json(const Config& config, const Roms& roms, std::uint64_t fingerprint);

// Every generated file of a configuration. `measured` roms carry their errors (measured_roms below).
template <Config kConfig>
std::vector<GeneratedFile> generate(const Roms& measured) {
  const PackageParts parts = package_parts<kConfig>();
  const std::uint64_t print = fingerprint(kConfig, parts, measured);
  std::vector<GeneratedFile> files{{"feline_pkg.sv", emit_package(kConfig, parts, print)},
                                   {"feline_roms.h", emit_c_header(kConfig, measured)},
                                   {"roms.csv", emit_csv(measured)},
                                   {"roms.json", emit_json(kConfig, measured, print)}};
  for (const Rom* rom : measured.all()) {
    files.push_back({"feline_rom_" + rom->name + ".sv", emit_rom_module(*rom)});
    files.push_back({rom->name + ".mem", emit_mem(*rom)});
  }
  return files;
}

// The ROMs with every error measured.
template <Config kConfig>
Roms measured_roms() {
  Roms measured = roms<kConfig>();
  judge_ellipse(kConfig, measured.ellipse);
  judge_weights(kConfig, measured.weight);
  return measured;
}

}  // namespace feline
