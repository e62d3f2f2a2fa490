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

// The parts of the SystemVerilog package that follow from a configuration.
struct PackageParts {
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
  FormatSet formats;
  std::vector<Beat> beats;
};

// Of any legal configuration, known only when the program runs. Beats are declared as types: a beat of another
// configuration has the fields of the default one's, each in the format of the same name.
PackageParts package_parts(const Config& config);

// The same for configuration, formats, beats and ROM contents that are the same, and, short of chance, for no other.
std::uint64_t fingerprint(const Config& config, const PackageParts& parts, const Roms& roms);
template <Config kConfig>
std::uint64_t fingerprint() {
  static const std::uint64_t value = fingerprint(kConfig, package_parts(kConfig), roms<kConfig>());
  return value;
}

std::string emit_package(const Config& config, const PackageParts& parts, std::uint64_t fingerprint);
std::string emit_rom_module(const Rom& rom);
std::string emit_mem(const Rom& rom);
std::string emit_c_header(const Config& config, const Roms& roms);
std::string emit_csv(const Roms& roms);
std::string emit_json(const Config& config, const Roms& roms, std::uint64_t fingerprint);

// The ROMs with every error measured.
Roms measured_roms(const Config& config);

// Every generated file of a configuration. `measured` roms carry their errors.
std::vector<GeneratedFile> generate(const Config& config, const Roms& measured);

}  // namespace feline
