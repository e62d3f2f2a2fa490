// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/exact_tables.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace feline::oracle {
namespace {

constexpr int kColumns = 9;

// The mean over the 8 x 8 midpoints of the cell (tables/ellipse.cpp), nearest, at most 255.
std::array<long, 4> ellipse_entry_of(int row, int column) {
  std::array<Real, 4> sum;
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y) {
      const Real ratio = Real::ratio(16 * row + 2 * x + 1, 256);
      const Real tangent = Real::ratio(16 * (column % 8) + 2 * y + 1, 128);
      const Real angle = column < 8 ? atan2(tangent, 1) : atan2(1, tangent);
      const auto scales = ellipse(ratio, angle);
      for (std::size_t i = 0; i < 4; ++i) sum[i] = sum[i] + scales[i];
    }
  }
  constexpr std::array kFraction{7, 8, 8, 7};
  std::array<long, 4> entry{};
  for (std::size_t i = 0; i < 4; ++i) entry[i] = std::min((sum[i] / 64).rounded(kFraction[i]), 255L);
  return entry;
}

// Real weight of the probe whose |n| belongs to `column`, before the row is divided by its sum.
Real relative_weight(int row, int column) {
  const int probes = probes_of_row(row);
  if (weight_uses(probes, column) == 0) return 0;
  if (row >= 61 || probes == 1) return 1;
  const int n = probes % 2 == 0 ? 2 * column - 1 : 2 * column;
  // fProbes: whole at the end of a probe count's four rows, else in the middle of the row's quarter.
  const int quarters = row + 4;
  const Real wanted = quarters % 4 == 0 ? Real::ratio(quarters, 4) : Real::ratio(2 * quarters + 1, 8);
  // Feline 3.1 with minor = 1: major = (fProbes + 1)/2, steps of 2 (major - minor)/(probes - 1), d = n/2 step/major.
  const Real major = (wanted + 1) / 2;
  const Real step = Real(2) * (major - 1) / (probes - 1);
  const Real d = Real::ratio(n, 2) * step / major;
  return exp(Real(-2) * d * d);
}

void fill_weight_row(Tables& tables, int row) {
  const int probes = probes_of_row(row);
  std::array<Real, kColumns> real;
  Real sum = 0;
  for (int c = 0; c < kColumns; ++c) {
    const auto i = static_cast<std::size_t>(c);
    real[i] = relative_weight(row, c);
    sum = sum + real[i] * weight_uses(probes, c);
  }
  // Down, then what is missing to those that lost most, the centre of an odd count first when the rest is odd.
  auto& weights = tables.weight[static_cast<std::size_t>(row)];
  long missing = 256;
  std::vector<std::pair<double, std::size_t>> lost;
  for (std::size_t i = 0; i < kColumns; ++i) {
    real[i] = real[i] / sum;
    // 2^-100 keeps what is exactly a multiple from falling below itself.
    weights[i] = (real[i] + 0x1p-100).floored(8);
    missing -= weights[i] * weight_uses(probes, static_cast<int>(i));
    const double part = (real[i] * 256 - static_cast<double>(weights[i])).to_double();
    if (weight_uses(probes, static_cast<int>(i)) == 2) lost.emplace_back(-std::round(part * 0x1p30), i);
    tables.weight_real[static_cast<std::size_t>(row)][i] = real[i].to_double();
  }
  if (missing % 2 != 0) ++weights[0], --missing;
  std::sort(lost.begin(), lost.end());
  for (std::size_t i = 0; missing > 0; missing -= 2) ++weights[lost[i++].second];
}

Tables make_tables() {
  Tables tables;
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 16; ++column)
      tables.ellipse[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = ellipse_entry_of(row, column);
  }
  for (int row = 0; row < 77; ++row) fill_weight_row(tables, row);
  for (int i = 0; i < 256; ++i) {
    const auto at = static_cast<std::size_t>(i);
    // The pair of weights exp(-2 (d/sqrt 2)^2) of both texels at distances x and 1 - x, divided by their sum.
    const Real x = Real::ratio(i, 256);
    const Real near = exp(Real(0) - x * x);
    const Real far = exp(Real(0) - (Real(1) - x) * (Real(1) - x));
    tables.gaussian[at] = (far / (near + far)).rounded(8);
    tables.log2[at] = log2(Real(1) + x).rounded(8);
    const Real code = Real::ratio(i, 255);
    const Real linear = Real::ratio(4045, 100000) < code
                            ? pow((code + Real::ratio(55, 1000)) / Real::ratio(1055, 1000), Real::ratio(24, 10))
                            : code / Real::ratio(1292, 100);
    tables.srgb[at] = (linear * 255).rounded(4);
  }
  for (int k = 1; k <= 17; ++k) tables.reciprocal[static_cast<std::size_t>(k)] = Real::ratio(1, k).rounded(16);
  return tables;
}

}  // namespace

const Tables& tables() {
  static const Tables made = make_tables();
  return made;
}

int probes_of_row(int row) { return row >= 61 ? row - 60 : (row + 4 + 3) / 4; }

int weight_uses(int probes, int column) {
  int uses = 0;
  for (int n = -(probes - 1); n <= probes - 1; n += 2) uses += (std::abs(n) + 1) / 2 == column ? 1 : 0;
  return uses;
}

std::array<Real, 4> ellipse(const Real& ratio, const Real& angle) {
  const Real u = ratio * cos(angle);
  const Real v = ratio * sin(angle);
  const Real a = v * v;
  const Real b = Real(-2) * (u * v);
  const Real c = Real(1) + u * u;
  const Real root = sqrt((a - c) * (a - c) + b * b);
  const Real major = sqrt((a + c + root) / 2);
  const Real minor = sqrt(abs((a + c - root) / 2));
  // Erratum 4: atan2. The axis of d^2 <= 1 along which it is longest.
  const Real theta = atan2(Real(0) - b, c - a) / 2;
  return {major * cos(theta), major * sin(theta), minor, major};
}

std::array<double, 4> ellipse(double ratio, double angle) {
  const double u = ratio * std::cos(angle);
  const double v = ratio * std::sin(angle);
  const double across = std::hypot(1 + u * u - v * v, 2 * u * v);
  const double major = std::sqrt((1 + u * u + v * v + across) / 2);
  const double theta = std::atan2(2 * u * v, 1 + u * u - v * v) / 2;
  return {major * std::cos(theta), major * std::sin(theta), v / major, major};
}

double cell_angle(int column, double within) {
  const double quotient = (column % 8 + within) / 8;
  return column < 8 ? std::atan2(quotient, 1.0) : std::atan2(1.0, quotient);
}

}  // namespace feline::oracle
