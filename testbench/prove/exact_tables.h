// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "testbench/stability/real.h"

// What the tables of the default configuration must hold, computed once more and by other means than their generator.
namespace feline::oracle {

// Table contents, by MPFR at 200 bits.
struct Tables {
  std::array<std::array<std::array<long, 4>, 16>, 16> ellipse{};  // row, column: uvScale, uvScale90, minor, major
  std::array<std::array<long, 9>, 77> weight{};                   // 61 Gaussian rows, 16 equal rows
  std::array<std::array<double, 9>, 77> weight_real{};
  std::array<long, 256> gaussian{};
  std::array<long, 256> log2{};
  std::array<long, 18> reciprocal{};
  std::array<long, 256> srgb{};
};
const Tables& tables();

// Feline 2.1 and 3.1 for the vectors (1, 0) and ratio * (cos angle, sin angle): uvScale, uvScale90, minor, major.
std::array<Real, 4> ellipse(const Real& ratio, const Real& angle);
// The same in double, for lattices of many points.
std::array<double, 4> ellipse(double ratio, double angle);
double cell_angle(int column, double within);  // the angle of column 0 .. 15, within = 0 .. 1 of its way
int weight_uses(int probes, int column);       // how often a column is used: 0, 1 or 2
int probes_of_row(int row);

}  // namespace feline::oracle
