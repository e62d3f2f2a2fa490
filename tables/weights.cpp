// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "tables/interval.h"
#include "tables/roms.h"

namespace feline {
namespace {

// One row: `probes` probes and the real weight of column 0, 1, ... before normalization. An odd count uses column 0
// once and the others twice; an even count uses the columns from 1 on, twice each.
struct Row {
  int probes;
  std::vector<Interval> raw;
};

Row gaussian_row(const Config& config, int quarters) {
  const int probes = (quarters + 3) / 4;
  // A row of whole fProbes serves all footprints widened to it; the others serve a quarter, from the middle of which
  // they are taken: fProbes in eighths.
  const int eighths = quarters % 4 == 0 ? 2 * quarters : 2 * quarters + 1;
  Row row{probes, {}};
  for (int column = 0; column <= config.max_probes / 2; ++column) {
    const int n = probes % 2 == 0 ? 2 * column - 1 : 2 * column;
    if (n < 0 || n > probes - 1) {
      row.raw.push_back(Interval{});
      continue;
    }
    // d = n/2 * step/majorRadius with step = 2 (major - minor)/(probes - 1) and major/minor = (fProbes + 1)/2
    // (Feline 3.1); alpha = 2.
    const Interval distance =
        probes == 1 ? Interval{}
                    : Interval::ratio(std::int64_t{n} * (eighths - 8), std::int64_t{eighths + 8} * (probes - 1));
    row.raw.push_back(exponential(Interval::integer(-2) * distance * distance));
  }
  return row;
}

Row equal_row(const Config& config, int probes) {
  Row row{probes, {}};
  for (int column = 0; column <= config.max_probes / 2; ++column) {
    const int n = probes % 2 == 0 ? 2 * column - 1 : 2 * column;
    row.raw.push_back(n < 0 || n > probes - 1 ? Interval{} : Interval::integer(1));
  }
  return row;
}

int uses(const Row& row, std::size_t column) {
  const int n = row.probes % 2 == 0 ? 2 * static_cast<int>(column) - 1 : 2 * static_cast<int>(column);
  return n < 0 || n > row.probes - 1 ? 0 : n == 0 ? 1 : 2;
}

// Rounds a row so that it sums to exactly one: every weight down, then the units that are missing to the weights that
// lost most (ties to the lower column), which is the rounding of least worst error.
void append_row(const Config& config, Rom& rom, const Row& row) {
  Interval sum;
  for (std::size_t i = 0; i < row.raw.size(); ++i) sum = sum + row.raw[i] * Interval::integer(uses(row, i));
  std::vector<std::int64_t> weight(row.raw.size());
  std::vector<double> real(row.raw.size());
  std::int64_t missing = std::int64_t{1} << config.weight_bits;
  const double one = static_cast<double>(missing);
  for (std::size_t i = 0; i < row.raw.size(); ++i) {
    const Interval normalized = uses(row, i) == 0 ? Interval{} : row.raw[i] / sum;
    real[i] = normalized.middle();
    // A single probe weighs exactly one, which the enclosure cannot tell from a little less.
    weight[i] =
        row.probes == 1 ? (i == 0 ? missing : 0) : static_cast<std::int64_t>(std::floor(real[i] * one + 0x1p-30));
    missing -= weight[i] * uses(row, i);
  }
  std::vector<std::size_t> order(row.raw.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return std::llround((real[a] * one - static_cast<double>(weight[a])) * 0x1p30) >
           std::llround((real[b] * one - static_cast<double>(weight[b])) * 0x1p30);
  });
  // A unit left alone by pairs can only go to the centre, which is used once.
  if (missing % 2 != 0) {
    ++weight[0];
    --missing;
  }
  for (const std::size_t i : order) {
    if (missing > 0 && uses(row, i) == 2) {
      ++weight[i];
      missing -= 2;
    }
  }
  for (std::size_t i = 0; i < row.raw.size(); ++i) {
    const double error = std::abs(static_cast<double>(weight[i]) / one - real[i]);
    if (error > rom.worst_error) {
      rom.worst_error = error;
      rom.worst_word = rom.words.size();
    }
    rom.words.push_back(static_cast<std::uint64_t>(weight[i]));
  }
}

}  // namespace

Rom weight_rom(const Config& config) {
  Rom rom;
  rom.name = "weight";
  rom.contents =
      "Word row * columns + column; column floor((|n| + 1)/2) of probe n; rows: fProbes in quarters from 1 to "
      "max_probes, Gaussian exp(-2 d^2) (Feline 3.1, 3.2), then equal weights of 1 to max_probes probes "
      "(EXT_texture_filter_anisotropic). The weights of a pixel sum to exactly one.";
  rom.data_bits = config.weight_bits + 1;
  rom.error_unit = "weight";
  for (int quarters = 4; quarters <= 4 * config.max_probes; ++quarters)
    append_row(config, rom, gaussian_row(config, quarters));
  for (int probes = 1; probes <= config.max_probes; ++probes) append_row(config, rom, equal_row(config, probes));
  return rom;
}

}  // namespace feline
