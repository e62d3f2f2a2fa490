// SPDX-License-Identifier: Apache-2.0
// The tables of one variable: each generator holds the real function, rounds it with certainty, and judges the result.
#include <cmath>
#include <stdexcept>

#include "tables/interval.h"
#include "tables/roms.h"

namespace feline {
namespace {

// Appends the value nearest to `real` and keeps the worst error.
void append_rounded(Rom& rom, Interval real, int fraction_bits) {
  const std::int64_t rounded = real.certified_round(fraction_bits);
  const double one = static_cast<double>(std::int64_t{1} << fraction_bits);
  const double error = std::abs(static_cast<double>(rounded) / one - real.middle());
  if (error > rom.worst_error) {
    rom.worst_error = error;
    rom.worst_word = rom.words.size();
  }
  rom.words.push_back(static_cast<std::uint64_t>(rounded));
}

}  // namespace

Roms make_roms(const Config& config) {
  return {ellipse_rom(config), weight_rom(config),     gaussian_rom(config),
          log2_rom(config),    reciprocal_rom(config), srgb_rom(config)};
}

Rom gaussian_rom(const Config& config) {
  Rom rom;
  rom.name = "gaussian";
  rom.contents =
      "Word f: weight of the farther texel at fraction x = f/words, exp(-(1-x)^2) / (exp(-x^2) + exp(-(1-x)^2)): the "
      "Gaussian probe of nominal radius sqrt(2), truncated to 2 x 2 (Feline 3.4).";
  rom.data_bits = config.subtexel_bits;
  rom.error_unit = "weight";
  const int count = 1 << config.subtexel_bits;
  for (int f = 0; f < count; ++f) {
    const Interval one = Interval::integer(1);
    append_rounded(rom, one / (one + exponential(Interval::ratio(count - 2 * f, count))), config.subtexel_bits);
  }
  return rom;
}

Rom log2_rom(const Config& config) {
  Rom rom;
  rom.name = "log2";
  rom.contents = "Word i: log2(1 + i/words), the fraction of the level of detail (Feline 3.1).";
  rom.data_bits = config.level_fraction_bits;
  rom.error_unit = "octave";
  const int count = 1 << config.level_fraction_bits;
  for (int i = 0; i < count; ++i)
    append_rounded(rom, logarithm2(Interval::ratio(count + i, count)), config.level_fraction_bits);
  return rom;
}

Rom reciprocal_rom(const Config& config) {
  Rom rom;
  rom.name = "reciprocal";
  rom.contents = "Word k: 1/k for 1 <= k <= max_probes + 1; word 0 is never read.";
  rom.data_bits = config.reciprocal_bits + 1;
  rom.error_unit = "ratio";
  rom.words.push_back(0);
  for (int k = 1; k <= config.max_probes + 1; ++k) append_rounded(rom, Interval::ratio(1, k), config.reciprocal_bits);
  return rom;
}

Rom srgb_rom(const Config& config) {
  Rom rom;
  rom.name = "srgb";
  rom.contents =
      "Word c: linear light of sRGB code c, c/255/12.92 up to 0.04045, then ((c/255 + 0.055)/1.055)^2.4 "
      "(IEC 61966-2-1), in units of 1/255.";
  rom.data_bits = 8 + config.channel_fraction_bits;
  rom.error_unit = "1/255";
  for (int c = 0; c < 256; ++c) {
    // 10.31 is where the two pieces meet: 0.04045 * 255.
    if (c <= 10) {
      append_rounded(rom, Interval::ratio(100 * c, 1292), config.channel_fraction_bits);
      continue;
    }
    const Interval base = Interval::ratio(1000 * c + 55 * 255, 255 * 1055);
    const Interval square = base * base;
    const Interval linear = square * fifth_root(square);
    // 255 does not fit the interval's range in one factor.
    Interval scaled = linear * Interval::integer(51);
    scaled = scaled * Interval::integer(5);
    append_rounded(rom, scaled, config.channel_fraction_bits);
  }
  return rom;
}

}  // namespace feline
