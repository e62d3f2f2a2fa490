// SPDX-License-Identifier: Apache-2.0
#include "tables/ellipse.h"

#include <algorithm>
#include <cmath>

namespace feline {
namespace {

struct Squares {
  Interval sine2, cosine2, product;  // sin^2, cos^2, sin cos
};

Squares squares_of(int columns, const CellPoint& point) {
  const bool is_tangent = point.column < columns / 2;
  const int within = is_tangent ? point.column : point.column - columns / 2;
  const Interval quotient =
      Interval::ratio(std::int64_t{within} * point.steps + point.y, std::int64_t{columns} / 2 * point.steps);
  const Interval one = Interval::integer(1);
  const Interval norm = one + quotient * quotient;
  const Interval squared = quotient * quotient / norm;
  const Interval rest = one / norm;
  return is_tangent ? Squares{squared, rest, quotient / norm} : Squares{rest, squared, quotient / norm};
}

std::array<std::int64_t, 4> fraction_bits(const Config& config) {
  return {config.entry_bits - 1, config.entry_bits, config.entry_bits, config.entry_bits - 1};
}

std::int64_t entry_max(const Config& config) { return (std::int64_t{1} << config.entry_bits) - 1; }

std::uint64_t pack_entry(const Config& config, const std::array<std::int64_t, 4>& values) {
  std::uint64_t word = 0;
  for (const auto value : values) word = (word << config.entry_bits) | static_cast<std::uint64_t>(value);
  return word;
}

// Mean of an 8 x 8 midpoint lattice: the value of least mean square error, and within 0.1 % of the least mean error.
EllipseScales least_mean(const Config& config, int row, int column) {
  constexpr int kLattice = 8;
  EllipseScales sum{};
  for (int x = 0; x < kLattice; ++x) {
    for (int y = 0; y < kLattice; ++y) {
      const auto scales =
          ellipse_scales(config.table_rows, config.table_columns, {row, column, 2 * x + 1, 2 * y + 1, 2 * kLattice});
      for (std::size_t i = 0; i < 4; ++i) sum[i] = sum[i] + scales[i] * Interval::ratio(1, kLattice * kLattice);
    }
  }
  return sum;
}

EllipseScales least_worst(const Config& config, int row, int column) {
  constexpr int kLattice = 8;
  EllipseScales low{};
  EllipseScales high{};
  for (int x = 0; x <= kLattice; ++x) {
    for (int y = 0; y <= kLattice; ++y) {
      const auto scales = ellipse_scales(config.table_rows, config.table_columns, {row, column, x, y, kLattice});
      for (std::size_t i = 0; i < 4; ++i) {
        if ((x == 0 && y == 0) || scales[i].middle() < low[i].middle()) low[i] = scales[i];
        if ((x == 0 && y == 0) || scales[i].middle() > high[i].middle()) high[i] = scales[i];
      }
    }
  }
  for (std::size_t i = 0; i < 4; ++i) low[i] = (low[i] + high[i]) * Interval::ratio(1, 2);
  return low;
}

}  // namespace

EllipseScales ellipse_scales(int rows, int columns, const CellPoint& point) {
  const Squares squares = squares_of(columns, point);
  const Interval one = Interval::integer(1);
  const Interval two = Interval::integer(2);
  const Interval half = Interval::ratio(1, 2);
  const Interval ratio =
      Interval::ratio(std::int64_t{point.row} * point.steps + point.x, std::int64_t{rows} * point.steps);
  const Interval r2 = ratio * ratio;
  const Interval sum = one + r2;
  const Interval area2 = r2 * squares.sine2;
  const Interval root = square_root(sum * sum - Interval::integer(4) * area2);
  const Interval major = square_root((sum + root) * half);
  const Interval minor = square_root(area2) / major;
  // Equal and orthogonal vectors make a circle, whose axis is the longer vector by definition.
  if (!Interval::ratio(1, std::int64_t{1} << 40).certainly_less(root)) return {major, Interval{}, minor, major};
  const Interval cosine_2phi = ((one + r2 * (squares.cosine2 - squares.sine2)) / root).clamped(-1, 1);
  const Interval cosine = square_root((one + cosine_2phi) * half);
  const Interval sine = two * r2 * squares.product / root / (two * cosine);
  return {major * cosine, major * sine, minor, major};
}

Rom ellipse_rom(const Config& config, CellRepresentation representation) {
  Rom rom;
  rom.name = "ellipse";
  rom.contents =
      "Word row * columns + column: uvScale, uvScale90, minorRadiusScale, majorRadiusScale, first highest; scales of "
      "the longer vector (Feline 3.3). Row: ratio of the shorter to the longer vector; column: tangent, then cotangent "
      "+ 1.";
  rom.data_bits = 4 * config.entry_bits;
  rom.tells_presence = true;
  rom.error_unit = "longer vector";
  const auto bits = fraction_bits(config);
  for (int row = 0; row < config.table_rows; ++row) {
    for (int column = 0; column < config.table_columns; ++column) {
      const bool is_left_out = !config.table_cells.has(rom.words.size());
      rom.left_out.push_back(is_left_out);
      if (is_left_out) {
        rom.words.push_back(0);
        continue;
      }
      const auto scales = representation == CellRepresentation::kLeastMean ? least_mean(config, row, column)
                          : representation == CellRepresentation::kLeastWorst
                              ? least_worst(config, row, column)
                              : ellipse_scales(config.table_rows, config.table_columns, {row, column, 1, 1, 2});
      std::array<std::int64_t, 4> entry{};
      for (std::size_t i = 0; i < 4; ++i) {
        entry[i] = std::min(scales[i].certified_round(static_cast<int>(bits[i])), entry_max(config));
      }
      rom.words.push_back(pack_entry(config, entry));
    }
  }
  return rom;
}

EllipseEntry ellipse_entry(const Config& config, std::uint64_t word) {
  const auto part = [&](int index) {
    return static_cast<std::int64_t>(word >> (index * config.entry_bits)) & entry_max(config);
  };
  return {part(3), part(2), part(1), part(0)};
}

std::array<double, 4> entry_scales(const Config& config, std::uint64_t word) {
  const EllipseEntry entry = ellipse_entry(config, word);
  const std::array<std::int64_t, 4> raw{entry.uv_scale, entry.uv_scale_90, entry.minor_radius, entry.major_radius};
  const auto bits = fraction_bits(config);
  std::array<double, 4> scales{};
  for (std::size_t i = 0; i < 4; ++i) {
    scales[i] = static_cast<double>(raw[i]) / static_cast<double>(std::int64_t{1} << bits[i]);
  }
  return scales;
}

void judge_ellipse(const Config& config, Rom& rom) {
  constexpr int kLattice = 32;
  rom.worst_error = 0;
  const auto compare = [&](std::size_t word, const std::array<double, 4>& held, const EllipseScales& real) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double error = std::abs(held[i] - real[i].middle());
      if (error <= rom.worst_error) continue;
      rom.worst_error = error;
      rom.worst_word = word;
    }
  };
  for (std::size_t word = 0; word < rom.words.size(); ++word) {
    if (!rom.has(word)) continue;
    const auto held = entry_scales(config, rom.words[word]);
    const int row = static_cast<int>(word) / config.table_columns;
    const int column = static_cast<int>(word) % config.table_columns;
    for (int x = 0; x <= kLattice; ++x) {
      for (int y = 0; y <= kLattice; ++y) {
        compare(word, held, ellipse_scales(config.table_rows, config.table_columns, {row, column, x, y, kLattice}));
      }
    }
    // Towards the circle the axis turns from the longer vector to half way between both, by how one comes there.
    if (row == config.table_rows - 1 && column == config.table_columns / 2) {
      const Interval diagonal = square_root(Interval::ratio(1, 2));
      compare(word, held, {diagonal, diagonal, Interval::integer(1), Interval::integer(1)});
    }
  }
}

}  // namespace feline
