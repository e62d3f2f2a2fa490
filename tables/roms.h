// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tables/formats.h"

namespace feline {

// One read-only memory of the machine and what its generator found out about it. The largest error is taken over all
// that the words stand for, against the real function, in the unit named; it is exact to the digits of a double.
struct Rom {
  std::string name;      // log2; the RTL module is feline_rom_log2
  std::string contents;  // what word i holds, with formats and source
  int data_bits = 0;
  std::vector<std::uint64_t> words;
  std::vector<bool> left_out{};  // none, or one a word: the word is 0, and the module says that it is not there
  bool tells_presence = false;   // the module has an output for it
  std::string error_unit;
  double worst_error = 0;
  std::size_t worst_word = 0;

  bool has(std::size_t word) const { return left_out.empty() || !left_out[word]; }
};

// The four values of an ellipse table word, raw (Feline 3.3): the factors of the longer vector and of the longer vector
// turned by 90 degrees, and the radii in units of the longer vector.
struct EllipseEntry {
  std::int64_t uv_scale = 0;      // U1.7
  std::int64_t uv_scale_90 = 0;   // U0.8
  std::int64_t minor_radius = 0;  // U0.8
  std::int64_t major_radius = 0;  // U1.7
};

// How an entry stands for its cell.
enum class CellRepresentation : std::uint8_t { kCentre, kLeastWorst, kLeastMean };

struct Roms {
  Rom ellipse;
  Rom weight;
  Rom gaussian;
  Rom log2;
  Rom reciprocal;
  Rom srgb;

  std::vector<const Rom*> all() const { return {&ellipse, &weight, &gaussian, &log2, &reciprocal, &srgb}; }
};

// Words that a configuration needs, without their errors: quick.
Rom ellipse_rom(const Config& config, CellRepresentation representation = CellRepresentation::kLeastMean);
Rom weight_rom(const Config& config);
Rom gaussian_rom(const Config& config);
Rom log2_rom(const Config& config);
Rom reciprocal_rom(const Config& config);
Rom srgb_rom(const Config& config);
// All of them; ellipse table and weights without their errors, which take a while.
Roms make_roms(const Config& config);
// The same, built when first asked for.
template <Config kConfig>
const Roms& roms() {
  static const Roms built = make_roms(kConfig);
  return built;
}

EllipseEntry ellipse_entry(const Config& config, std::uint64_t word);
// Fill a table's worst error. Ellipse: the largest of the four values' errors on a lattice of 33 x 33 points a cell,
// its edges included, and in the limit at the circle, where it is largest. Weights: over all fProbes that a row serves,
// blur and alias factors being 1.
void judge_ellipse(const Config& config, Rom& rom);
void judge_weights(const Config& config, Rom& rom);

}  // namespace feline
