// SPDX-License-Identifier: Apache-2.0
// The truth against what mathematics says of it, none of it by its own samples.
#include "testbench/measure/truth.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstring>
#include <numbers>

#include "testbench/measure/truth_store.h"
#include "tests/testbench/measure/surfaces.h"

namespace feline {
namespace {

constexpr int kStrata = 8;
constexpr int kTruthSide = 16;
constexpr double kPi = std::numbers::pi;

// Leaning on each other, five to one.
constexpr Affine kSlanted{100, 90, 3.1, 1.3, -1.7, 0.9};

Truth truth_of(const reference::MipMap& map, const Affine& affine, std::uint64_t seed = 1, int strata = kStrata) {
  return compute_truth(map, affine.on(map), kTruthSide, kTruthSide, strata, seed, nullptr);
}

// Checks both pictures by their root mean square and worst error, in units of the error that the truth claims.
template <typename Gaussian, typename Box>
void expect_near(const Truth& truth, Gaussian gaussian, Box box) {
  EXPECT_LT(rms_from(truth.gaussian, gaussian), 1.25 * truth.gaussian_error);
  EXPECT_LT(rms_from(truth.box, box), 1.25 * truth.box_error);
  EXPECT_GT(rms_from(truth.gaussian, gaussian), 0.75 * truth.gaussian_error);
  EXPECT_GT(rms_from(truth.box, box), 0.75 * truth.box_error);
  // A pixel's own error may be twice the picture's.
  EXPECT_LT(worst_from(truth.gaussian, gaussian), 5 * truth.gaussian_error);
  EXPECT_LT(worst_from(truth.box, box), 5 * truth.box_error);
}

double sinc(double x) { return x == 0 ? 1 : std::sin(kPi * x) / (kPi * x); }

// The transform of exp(-2 r^2) within a radius of 1, by Simpson's rule over the radius; 1 for frequency 0.
double disc_transform(double frequency) {
  constexpr int kSteps = 2000;
  double sum = 0;
  double weight = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double r = static_cast<double>(i) / kSteps;
    const double w = (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2) * r * std::exp(-2 * r * r);
    sum += w * std::cyl_bessel_j(0, 2 * kPi * frequency * r);
    weight += w;
  }
  return sum / weight;
}

// 1/2 + cos/2 with `waves` over `size` texels, through which runs the bilinear surface: the wave and its images at all
// whole distances, each weighted by the tent's transform and what a filter leaves of it.
class FilteredWave {
 public:
  FilteredWave(int waves, int size, const std::function<double(double frequency)>& attenuation) {
    for (int image = -20; image <= 20; ++image) {
      const double frequency = static_cast<double>(waves) / size + image;
      const double tent = sinc(frequency) * sinc(frequency) * (image % 2 == 0 ? 1 : -1);
      parts_.emplace_back(frequency, 0.5 * tent * attenuation(frequency));
    }
  }
  double at(double u) const {
    double sum = 0.5;
    for (const auto& [frequency, height] : parts_) sum += height * std::cos(2 * kPi * frequency * u);
    return sum;
  }

 private:
  std::vector<std::pair<double, double>> parts_;
};

double u_of(const Affine& affine, int column, int row) {
  return affine.u + (column + 0.5) * affine.dudx + (row + 0.5) * affine.dudy;
}

TEST(measure_truth, a_constant_stays) {
  const reference::MipMap map{{{2, 2, std::vector<reference::Texel>(4, {0.25F, 0.5F, 0.7F, 0.9F})}}, {}};
  const Truth truth = truth_of(map, kSlanted);
  for (const FloatPicture& picture : {truth.gaussian, truth.box}) {
    ASSERT_EQ(picture.pixels.size(), static_cast<std::size_t>(kTruthSide * kTruthSide));
    for (const auto& pixel : picture.pixels) {
      for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(pixel[c], map.base().texels[0][c], 1e-7);
    }
  }
  EXPECT_LT(truth.gaussian_error, 1e-12);
  EXPECT_EQ(truth.samples, 2 * kStrata * kStrata);
}

TEST(measure_truth, a_ramp_is_its_value_in_the_middle) {
  const reference::Wrapping clamped{Wrap::kClampToEdge, Wrap::kClampToEdge, {}};
  const reference::MipMap map = grey_map(256, 256, clamped, [](int i, int) { return (i + 0.5) / 256; });
  const auto want = [](int column, int row) { return u_of(kSlanted, column, row) / 256; };
  expect_near(truth_of(map, kSlanted), want, want);
}

TEST(measure_truth, a_wave_fades_as_the_transform_says) {
  constexpr int kSize = 16;
  for (const int waves : {1, 3, 5}) {
    const reference::MipMap map = grey_map(
        kSize, kSize, {}, [&](int i, int) { return 0.5 + 0.5 * std::cos(2 * kPi * waves * (i + 0.5) / kSize); });
    for (const double scale : {0.4, 1.0}) {
      const Affine affine{0.3, 0.2, 1.3 * scale, 0.8 * scale, -0.9 * scale, 1.1 * scale};
      const Truth truth = truth_of(map, affine, 1, 23);
      SCOPED_TRACE(testing::Message() << waves << " waves, scale " << scale);
      const FilteredWave gaussian(waves, kSize, [&](double frequency) {
        return disc_transform(std::hypot(frequency * affine.dudx, frequency * affine.dudy));
      });
      const FilteredWave box(waves, kSize, [&](double frequency) {
        return sinc(frequency * affine.dudx) * sinc(frequency * affine.dudy);
      });
      expect_near(
          truth, [&](int column, int row) { return gaussian.at(u_of(affine, column, row)); },
          [&](int column, int row) { return box.at(u_of(affine, column, row)); });
    }
  }
}

// By a dense regular grid over each pixel's own filter.
TEST(measure_truth, perspective_is_projected_point_by_point) {
  constexpr int kSize = 16;
  constexpr int kGrid = 300;
  const reference::MipMap map = noise_map(kSize, 5);
  const auto project = [](double x, double y) {
    const double w = 1.3 - 0.05 * y;
    return reference::Vector2<double>{0.2 * (x - 7) / w + 0.3, 0.4 / w};
  };
  const auto texel = [&](int i, int j) {
    return static_cast<double>(map.base().at((i % kSize + kSize) % kSize, (j % kSize + kSize) % kSize)[0]);
  };
  const auto surface = [&](const reference::Vector2<double>& at) {
    const double u = at.u * kSize - 0.5;
    const double v = at.v * kSize - 0.5;
    const int i = static_cast<int>(std::floor(u));
    const int j = static_cast<int>(std::floor(v));
    const double fu = u - i;
    const double fv = v - j;
    return (1 - fv) * ((1 - fu) * texel(i, j) + fu * texel(i + 1, j)) +
           fv * ((1 - fu) * texel(i, j + 1) + fu * texel(i + 1, j + 1));
  };
  const auto integral = [&](int column, int row, bool box) {
    double sum = 0;
    double weights = 0;
    const double reach = box ? 0.5 : 1;
    for (int j = 0; j < kGrid; ++j) {
      for (int i = 0; i < kGrid; ++i) {
        const double x = reach * ((2 * i + 1.0) / kGrid - 1);
        const double y = reach * ((2 * j + 1.0) / kGrid - 1);
        const double square = x * x + y * y;
        if (!box && square >= 1) continue;
        const double weight = box ? 1 : std::exp(-2 * square);
        sum += weight * surface(project(column + 0.5 + x, row + 0.5 + y));
        weights += weight;
      }
    }
    return sum / weights;
  };
  const Truth truth = compute_truth(map, project, 6, 12, 12, 1, nullptr);
  expect_near(
      truth, [&](int column, int row) { return integral(column, row, false); },
      [&](int column, int row) { return integral(column, row, true); });
}

// Two truths with samples of their own are the square root of 2 farther apart than each is from what both mean.
TEST(measure_truth, its_error_is_honest) {
  const reference::MipMap map = noise_map(32, 7);
  const GBuffer gbuffer = kSlanted.gbuffer(map, kTruthSide, kTruthSide);
  for (const bool projected : {true, false}) {
    const auto make = [&](std::uint64_t seed) {
      return projected ? truth_of(map, kSlanted, seed) : compute_truth(map, gbuffer, kStrata, seed, nullptr);
    };
    const Truth a = make(1);
    const Truth b = make(2);
    EXPECT_NEAR(rms_between(a.gaussian, b.gaussian) / (std::numbers::sqrt2 * a.gaussian_error), 1, 0.25);
    EXPECT_NEAR(rms_between(a.box, b.box) / (std::numbers::sqrt2 * a.box_error), 1, 0.25);
    EXPECT_GT(a.box_error, a.gaussian_error);
  }
}

TEST(measure_truth, more_samples_less_error) {
  const reference::MipMap map = noise_map(32, 7);
  const Truth few = truth_of(map, kSlanted, 1, 4);
  const Truth many = truth_of(map, kSlanted, 1, 16);
  EXPECT_LT(4 * many.gaussian_error, few.gaussian_error);
  EXPECT_LT(4 * many.box_error, few.box_error);
}

TEST(measure_truth, a_gbuffer_is_an_affine_projection) {
  const reference::MipMap map = noise_map(32, 9);
  const Truth projected = truth_of(map, kSlanted, 1, 16);
  const Truth stored = compute_truth(map, kSlanted.gbuffer(map, kTruthSide, kTruthSide), 16, 1, nullptr);
  const double gaussian_error = std::hypot(projected.gaussian_error, stored.gaussian_error);
  const double box_error = std::hypot(projected.box_error, stored.box_error);
  EXPECT_NEAR(rms_between(projected.gaussian, stored.gaussian) / gaussian_error, 1, 0.25);
  EXPECT_NEAR(rms_between(projected.box, stored.box) / box_error, 1, 0.25);
  // As many samples: neither is much better than the other.
  EXPECT_EQ(projected.samples, stored.samples);
  EXPECT_NEAR(projected.box_error / stored.box_error, 1, 0.25);
}

TEST(measure_truth, threads_change_nothing) {
  const reference::MipMap map = noise_map(32, 11);
  const GBuffer gbuffer = kSlanted.gbuffer(map, kTruthSide, 2 * kTruthSide + 3);
  std::vector<std::string> made;
  for (const int threads : {1, 2, 4}) {
    OIIO::attribute("threads", threads);
    made.push_back(to_bytes(compute_truth(map, kSlanted.on(map), kTruthSide, 2 * kTruthSide + 3, 4, 3, nullptr)) +
                   to_bytes(compute_truth(map, gbuffer, 4, 3, nullptr)));
  }
  OIIO::attribute("threads", 0);
  EXPECT_EQ(made[0], made[1]);
  EXPECT_EQ(made[0], made[2]);
}

TEST(measure_truth, a_seed_is_other_samples) {
  const reference::MipMap map = noise_map(32, 11);
  EXPECT_NE(to_bytes(truth_of(map, kSlanted, 1, 4)), to_bytes(truth_of(map, kSlanted, 2, 4)));
}

TEST(measure_truth, is_stored) {
  const reference::MipMap map = noise_map(8, 13);
  const Truth truth = compute_truth(map, kSlanted.on(map), 5, 3, 2, 1, nullptr);
  const std::string bytes = to_bytes(truth);
  const Truth back = truth_from_bytes(bytes);
  EXPECT_EQ(back.gaussian.width, 5);
  EXPECT_EQ(back.box.height, 3);
  EXPECT_EQ(back.gaussian.pixels, truth.gaussian.pixels);
  EXPECT_EQ(back.box.pixels, truth.box.pixels);
  EXPECT_EQ(back.gaussian_error, truth.gaussian_error);
  EXPECT_EQ(back.box_error, truth.box_error);
  EXPECT_EQ(back.samples, truth.samples);
  for (const std::size_t size : {std::size_t{0}, std::size_t{12}, std::size_t{40}, bytes.size() - 1}) {
    EXPECT_THROW(truth_from_bytes(std::string_view(bytes).substr(0, size)), std::runtime_error) << size;
  }
  EXPECT_THROW(truth_from_bytes(bytes + "x"), std::runtime_error);
  // Sides whose product takes as many bytes as there are, modulo 2^64, or that are no sides at all.
  for (const auto& [width, height] : {std::pair{std::int64_t{1} << 60, std::int64_t{16}}, {-5, -3}, {0, 7}, {7, 0}}) {
    std::string changed = bytes;
    if (width >= 0) changed.resize(bytes.size() - std::size_t{2} * 5 * 3 * 4 * sizeof(float));
    std::memcpy(changed.data(), &width, sizeof width);
    std::memcpy(changed.data() + sizeof width, &height, sizeof height);
    EXPECT_THROW(truth_from_bytes(changed), std::runtime_error) << width;
  }
}

}  // namespace
}  // namespace feline
