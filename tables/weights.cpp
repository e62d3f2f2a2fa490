// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tables/interval.h"
#include "tables/roms.h"

namespace feline {
namespace {

// |n| of the probes that use a column, or -1: an odd count uses column 0 once and the others twice; an even count uses
// the columns from 1 on, twice each.
int distance_of(int probes, int column) {
  const int n = probes % 2 == 0 ? 2 * column - 1 : 2 * column;
  return n > probes - 1 ? -1 : n;
}

int uses(int probes, int column) {
  const int n = distance_of(probes, column);
  return n < 0 ? 0 : n == 0 ? 1 : 2;
}

int column_count(const Config& config) { return config.max_probes / 2 + 1; }

// One row: its probes and what each column's weight is, a row's sum being one.
struct Row {
  int probes;
  std::vector<Interval> weight;
};

// The row of fProbes = numerator/denominator > probes - 1, for probes >= 2.
Row gaussian_row(const Config& config, int probes, std::int64_t numerator, std::int64_t denominator) {
  Row row{probes, std::vector<Interval>(static_cast<std::size_t>(column_count(config)))};
  Interval sum;
  for (int column = 0; column < column_count(config); ++column) {
    const int n = distance_of(probes, column);
    if (n < 0) continue;
    // d = n/2 * step/majorRadius with step = 2 (major - minor)/(probes - 1) and major/minor = (fProbes + 1)/2
    // (Feline 3.1); alpha = 2.
    const Interval distance = Interval::ratio(n * (numerator - denominator), (numerator + denominator) * (probes - 1));
    Interval& weight = row.weight[static_cast<std::size_t>(column)];
    weight = exponential(Interval::integer(-2) * distance * distance);
    sum = sum + weight * Interval::integer(uses(probes, column));
  }
  for (Interval& weight : row.weight) weight = weight / sum;
  return row;
}

Row equal_row(const Config& config, int probes) {
  Row row{probes, std::vector<Interval>(static_cast<std::size_t>(column_count(config)))};
  for (int column = 0; column < column_count(config); ++column) {
    if (uses(probes, column) != 0) row.weight[static_cast<std::size_t>(column)] = Interval::ratio(1, probes);
  }
  return row;
}

// The row that stands for fProbes in quarters. A row of whole fProbes serves the footprints widened to it; the others
// serve a quarter, from the middle of which they are taken, and the first of a probe count also the quarter below,
// which the ceiling of 3.4 rounds up to that count. One and two probes have nothing to choose.
Row representative_row(const Config& config, int quarters) {
  const int probes = (quarters + 3) / 4;
  if (probes <= 2) return equal_row(config, probes);
  const std::int64_t eighths = quarters % 4 == 0 ? 2 * quarters : 2 * quarters + 1;
  return gaussian_row(config, probes, eighths, 8);
}

// Whether column a lost more by rounding down than column b; throws when their enclosures leave it open, but for the
// columns of equal weight, which lose the same.
bool lost_more(const Row& row, const std::vector<Interval>& lost, std::size_t a, std::size_t b) {
  if (lost[b].certainly_less(lost[a])) return true;
  const bool equal = row.weight[a].middle() == row.weight[b].middle();
  if (!equal && !lost[a].certainly_less(lost[b])) throw std::domain_error("the order of two weights is not certain");
  return false;
}

// Rounds a row so that it sums to exactly one: every weight down, then the units that are missing to the weights that
// lost most (ties to the lower column), which is the rounding of least worst error.
void append_row(const Config& config, Rom& rom, const Row& row) {
  const bool is_left_out = !config.weight_rows.has(rom.words.size() / row.weight.size());
  rom.left_out.insert(rom.left_out.end(), row.weight.size(), is_left_out);
  if (is_left_out) {
    rom.words.resize(rom.words.size() + row.weight.size());
    return;
  }
  const std::int64_t one = std::int64_t{1} << config.weight_bits;
  std::vector<std::int64_t> rounded;
  std::vector<Interval> lost;
  std::vector<std::size_t> order;
  std::int64_t missing = one;
  for (std::size_t i = 0; i < row.weight.size(); ++i) {
    const int times = uses(row.probes, static_cast<int>(i));
    rounded.push_back(times == 0 ? 0 : row.weight[i].certified_floor(config.weight_bits));
    lost.push_back(row.weight[i] - Interval::ratio(rounded.back(), one));
    missing -= rounded.back() * times;
    if (times == 2) order.push_back(i);
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return lost_more(row, lost, a, b); });
  // A unit left alone by pairs can only go to the centre, which is used once.
  if (missing % 2 != 0) {
    ++rounded[0];
    --missing;
  }
  for (std::size_t i = 0; missing > 0; missing -= 2) ++rounded[order[i++]];
  for (const std::int64_t weight : rounded) rom.words.push_back(static_cast<std::uint64_t>(weight));
}

// How far a stored weight is from the real one over the fProbes from low to high quarters, which it serves. As fProbes
// grows, a probe's weight grows while its n^2 is below the weighted mean of all probes' n^2, which falls all the time:
// it is least at one of the ends, and greatest at an end or where n^2 equals the mean.
double worst_over(const Config& config, double stored, int probes, int column, int low, int high) {
  constexpr std::int64_t kQuarter = std::int64_t{1} << 24;
  const auto row_at = [&](std::int64_t f) { return gaussian_row(config, probes, f, 4 * kQuarter); };
  const auto error_at = [&](std::int64_t f) {
    return std::abs(stored - row_at(f).weight[static_cast<std::size_t>(column)].middle());
  };
  const auto grows_at = [&](std::int64_t f) {
    const Row row = row_at(f);
    double mean = 0;
    for (int c = 0; c < column_count(config); ++c) {
      const int n = distance_of(probes, c);
      mean += uses(probes, c) * row.weight[static_cast<std::size_t>(c)].middle() * n * n;
    }
    const int n = distance_of(probes, column);
    return n * n < mean;
  };
  std::int64_t from = low * kQuarter;
  std::int64_t to = high * kQuarter;
  const double at_ends = std::max(error_at(from), error_at(to));
  if (!grows_at(from) || grows_at(to)) return at_ends;
  while (to - from > 1) {
    const std::int64_t middle = (from + to) / 2;
    (grows_at(middle) ? from : to) = middle;
  }
  return std::max(at_ends, error_at(from));
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
  rom.tells_presence = true;
  rom.error_unit = "weight";
  for (int quarters = 4; quarters <= 4 * config.max_probes; ++quarters)
    append_row(config, rom, representative_row(config, quarters));
  for (int probes = 1; probes <= config.max_probes; ++probes) append_row(config, rom, equal_row(config, probes));
  return rom;
}

void judge_weights(const Config& config, Rom& rom) {
  const int columns = column_count(config);
  const int gaussian_rows = 4 * config.max_probes - 3;
  const double one = static_cast<double>(std::int64_t{1} << config.weight_bits);
  rom.worst_error = 0;
  for (std::size_t word = 0; word < rom.words.size(); ++word) {
    const int row = static_cast<int>(word) / columns;
    const int column = static_cast<int>(word) % columns;
    const int quarters = row + 4;
    const bool is_equal = row >= gaussian_rows;
    const int probes = is_equal ? row - gaussian_rows + 1 : (quarters + 3) / 4;
    if (uses(probes, column) == 0 || !rom.has(word)) continue;
    const double stored = static_cast<double>(rom.words[word]) / one;
    const int low = quarters % 4 == 1 ? quarters - 1 : quarters;
    const int high = quarters % 4 == 0 ? quarters : quarters + 1;
    const double error = is_equal || probes <= 2 ? std::abs(stored - 1.0 / probes)
                                                 : worst_over(config, stored, probes, column, low, high);
    if (error > rom.worst_error) {
      rom.worst_error = error;
      rom.worst_word = word;
    }
  }
}

}  // namespace feline
