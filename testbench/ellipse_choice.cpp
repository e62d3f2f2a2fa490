// SPDX-License-Identifier: Apache-2.0
#include "testbench/ellipse_choice.h"

#include <algorithm>
#include <cmath>

#include "tables/ellipse.h"

namespace feline {
namespace {

// What a lookup makes of four scales.
struct Outcome {
  double minor, major, end_u, end_v;
};

Outcome outcome(const std::array<double, 4>& scales, int max_probes) {
  const double minor = std::max(scales[2], 2 * scales[3] / (max_probes + 1));
  const double along = (scales[3] - minor) / scales[3];
  return {minor, scales[3], scales[0] * along, scales[1] * along};
}

}  // namespace

EllipseErrors ellipse_errors(const Config& config, const Rom& ellipse, int lattice) {
  EllipseErrors errors;
  double points = 0;
  const auto add = [](double error, double& worst, double& sum) {
    worst = std::max(worst, error);
    sum += error;
  };
  for (std::size_t word = 0; word < ellipse.words.size(); ++word) {
    const Outcome got = outcome(entry_scales(config, ellipse.words[word]), config.max_probes);
    const int row = static_cast<int>(word) / config.table_columns;
    const int column = static_cast<int>(word) % config.table_columns;
    for (int x = 0; x <= lattice; ++x) {
      for (int y = 0; y <= lattice; ++y) {
        const auto real = ellipse_scales(config.table_rows, config.table_columns, {row, column, x, y, lattice});
        const Outcome want =
            outcome({real[0].middle(), real[1].middle(), real[2].middle(), real[3].middle()}, config.max_probes);
        add(std::abs(std::log2(got.minor / want.minor)), errors.worst_level, errors.mean_level);
        add(std::abs(got.major / want.major - 1), errors.worst_major, errors.mean_major);
        add(std::hypot(got.end_u - want.end_u, got.end_v - want.end_v) / want.minor, errors.worst_line,
            errors.mean_line);
        points += 1;
      }
    }
  }
  errors.mean_level /= points;
  errors.mean_major /= points;
  errors.mean_line /= points;
  return errors;
}

}  // namespace feline
