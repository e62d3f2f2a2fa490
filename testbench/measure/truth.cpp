// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "testbench/parallel.h"
#include "testbench/random.h"

namespace feline {
namespace {

constexpr std::size_t kHalves = 2;
constexpr double kEdgeWeight = 0.1353352832366127;  // exp(-2): the Gaussian at its radius

struct Sum {
  reference::Colour colour{};
  double weight = 0;

  void add(const reference::Colour& sample, double sample_weight) {
    reference::add_weighted(colour, sample_weight, sample);
    weight += sample_weight;
  }
  void add(const Sum& other) {
    reference::add_weighted(colour, 1, other.colour);
    weight += other.weight;
  }
};

// The sums of one pixel, in independent halves.
struct PixelSums {
  std::array<Sum, kHalves> gaussian;
  std::array<Sum, kHalves> box;

  void add(const PixelSums& other) {
    for (std::size_t half = 0; half < kHalves; ++half) {
      gaussian[half].add(other.gaussian[half]);
      box[half].add(other.box[half]);
    }
  }
};

reference::Colour sample_level0(const reference::MipMap& map, const reference::Vector2<double>& at) {
  return reference::two_by_two(map.base(), map.wrapping, reference::ProbeKernel::kBilinear, at.u, at.v);
}

// exp(-2 d^2) of a point at `at` (0 .. 1) of a square, seen from the middles of the squares before, here and after.
std::array<double, 3> falloffs(double at) {
  const auto falloff = [](double distance) { return std::exp(-2 * distance * distance); };
  return {falloff(at + 0.5), falloff(at - 0.5), falloff(at - 1.5)};
}

// Rows of a picture with a row more above and below, which their samples reach.
class Stripe {
 public:
  Stripe(int width, int first_row, int rows)
      : width_(width), first_(first_row - 1), end_(first_row + rows + 1), sums_(index(0, end_)) {}

  // A sample at (fx, fy) of the square in (column, row), which may be one beyond the picture.
  void add(std::size_t half, int column, int row, double fx, double fy, const reference::Colour& colour) {
    const std::array<double, 3> across = falloffs(fx);
    const std::array<double, 3> down = falloffs(fy);
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        const double weight = across[static_cast<std::size_t>(i)] * down[static_cast<std::size_t>(j)];
        if (weight > kEdgeWeight && holds(column + i - 1, row + j - 1)) {
          sums_[index(column + i - 1, row + j - 1)].gaussian[half].add(colour, weight);
        }
      }
    }
    if (holds(column, row)) sums_[index(column, row)].box[half].add(colour, 1);
  }

  // At most two stripes meet in a row, so the order in which they are merged changes nothing.
  void merge_into(std::vector<PixelSums>& picture) const {
    const auto height = static_cast<int>(picture.size() / static_cast<std::size_t>(width_));
    for (int row = std::max(first_, 0); row < std::min(end_, height); ++row) {
      for (int column = 0; column < width_; ++column) {
        const int pixel = row * width_ + column;
        picture[static_cast<std::size_t>(pixel)].add(sums_[index(column, row)]);
      }
    }
  }

 private:
  bool holds(int column, int row) const { return column >= 0 && column < width_ && row >= first_ && row < end_; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row - first_) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
  }

  int width_;
  int first_;
  int end_;
  std::vector<PixelSums> sums_;
};

// A point in each cell of a square of `cells` x `cells`, at its coordinates in 0 .. 1.
template <typename Visit>
void stratify(int cells, SplitMix64& random, Visit visit) {
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const double x = (i + random.unit()) / cells;
      visit(x, (j + random.unit()) / cells);
    }
  }
}

// The mean, and half the difference of the two halves' means squared, summed over the channels.
double resolve(const std::array<Sum, kHalves>& halves, std::array<float, 4>& pixel) {
  double square = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    const double mean = (halves[0].colour[c] + halves[1].colour[c]) / (halves[0].weight + halves[1].weight);
    const double apart = halves[0].colour[c] / halves[0].weight - halves[1].colour[c] / halves[1].weight;
    pixel[c] = static_cast<float>(mean);
    if (c < 3) square += apart * apart / 4;
  }
  return square;
}

Truth resolve(const std::vector<PixelSums>& sums, int width, int height, int samples) {
  Truth truth{{width, height, {}}, {width, height, {}}, 0, 0, samples};
  truth.gaussian.pixels.resize(sums.size());
  truth.box.pixels.resize(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    truth.gaussian_error += resolve(sums[i].gaussian, truth.gaussian.pixels[i]);
    truth.box_error += resolve(sums[i].box, truth.box.pixels[i]);
  }
  const double values = 3 * static_cast<double>(sums.size());
  truth.gaussian_error = std::sqrt(truth.gaussian_error / values);
  truth.box_error = std::sqrt(truth.box_error / values);
  return truth;
}

}  // namespace

Truth compute_truth(const reference::MipMap& map, const PictureProjection& projection, int width, int height,
                    int strata, std::uint64_t seed, Progress* progress) {
  constexpr int kRows = 8;
  std::vector<PixelSums> sums(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::mutex mutex;
  for_each_index(0, (height + kRows - 1) / kRows, [&](std::int64_t number) {
    const int first_row = static_cast<int>(number) * kRows;
    const int rows = std::min(kRows, height - first_row);
    Stripe stripe(width, first_row, rows);
    // Squares around the picture belong to its first and last stripe.
    const int from = first_row == 0 ? -1 : first_row;
    const int to = first_row + rows == height ? height + 1 : first_row + rows;
    for (int row = from; row < to; ++row) {
      for (int column = -1; column <= width; ++column) {
        SplitMix64 random(
            derived_seed(seed, static_cast<std::uint64_t>(row + 1) * (static_cast<std::uint64_t>(width) + 2) +
                                   static_cast<std::uint64_t>(column + 1)));
        for (std::size_t half = 0; half < kHalves; ++half) {
          stratify(strata, random, [&](double fx, double fy) {
            const reference::Vector2<double> at = projection(column + fx, row + fy);
            // Beyond the picture's edge a ray may miss the surface.
            if (!std::isfinite(at.u) || !std::isfinite(at.v)) return;
            stripe.add(half, column, row, fx, fy, sample_level0(map, at));
          });
        }
      }
      if (progress != nullptr) progress->advance(static_cast<std::uint64_t>(width));
    }
    const std::scoped_lock lock(mutex);
    stripe.merge_into(sums);
  });
  return resolve(sums, width, height, static_cast<int>(kHalves) * strata * strata);
}

Truth compute_truth(const reference::MipMap& map, const GBuffer& gbuffer, int strata, std::uint64_t seed,
                    Progress* progress) {
  // A whole number of cells in the box's half side.
  const int even = strata + strata % 2;
  std::vector<PixelSums> sums(gbuffer.lookups.size());
  for_each_index(0, gbuffer.height, [&](std::int64_t row) {
    for (int column = 0; column < gbuffer.width; ++column) {
      const auto pixel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(gbuffer.width) + static_cast<std::size_t>(column);
      const Lookup& lookup = gbuffer.lookups[pixel];
      SplitMix64 random(derived_seed(seed, pixel));
      for (std::size_t half = 0; half < kHalves; ++half) {
        stratify(2 * even, random, [&](double fx, double fy) {
          const double x = 2 * fx - 1;
          const double y = 2 * fy - 1;
          const double weight = std::exp(-2 * (x * x + y * y));
          if (weight <= kEdgeWeight) return;
          const reference::Colour colour =
              sample_level0(map, {double{lookup.s} + x * double{lookup.dsdx} + y * double{lookup.dsdy},
                                  double{lookup.t} + x * double{lookup.dtdx} + y * double{lookup.dtdy}});
          sums[pixel].gaussian[half].add(colour, weight);
          if (std::abs(x) < 0.5 && std::abs(y) < 0.5) sums[pixel].box[half].add(colour, 1);
        });
      }
    }
    if (progress != nullptr) progress->advance(static_cast<std::uint64_t>(gbuffer.width));
  });
  return resolve(sums, gbuffer.width, gbuffer.height, static_cast<int>(kHalves) * even * even);
}

}  // namespace feline
