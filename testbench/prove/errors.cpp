// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/errors.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "testbench/prove/exact_tables.h"
#include "testbench/prove/lane_loop.h"
#include "testbench/prove/leaves.h"

namespace feline::prove {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double same(double error) { return error; }
// From the ratio of two radii, the larger over the smaller.
double octaves(double ratio) { return std::log2(ratio); }
// From one less the cosine of twice the angle.
double degrees(double versine) { return std::acos(1 - versine) / 2 * 180 / std::numbers::pi; }

template <typename L>
Values<L::kInputs> inputs_at(const std::uint64_t* inputs, std::size_t i) {
  return unpack_lane<L::kInputs>(inputs + i * lane_words<L::kInputs>());
}
template <typename L>
Values<L::kOutputs> outputs_at(const std::uint64_t* outputs, std::size_t i) {
  return unpack_lane<L::kOutputs>(outputs + i * lane_words<L::kOutputs>());
}

template <typename L>
double value_of(std::int64_t raw, std::size_t field) {
  return L::kOutputs[field].value(raw);
}

}  // namespace

std::vector<Quantity> ellipse_quantities() {
  return {{"major radius", "of the exact major radius", &same},
          {"minor radius", "of the exact major radius", &same},
          {"level of detail at 16 probes", "octave", &octaves},
          {"angle of the axis, ratio 2 and more", "degree", &degrees}};
}

// Every lane alike, without branches, for the compiler to do several at once.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("arch=skylake-avx512", "avx2", "default")))
#endif
void measure_ellipse(const std::uint64_t* inputs, const std::uint64_t* outputs, std::size_t count, double* errors) {
  // The minor radius that the most probes leave of a major one: 2/(probes + 1).
  constexpr double kLeastRatio = 2.0 / 17;
  for (std::size_t i = 0; i < count; ++i) {
    const auto in = inputs_at<Footprint>(inputs, i);
    const auto out = outputs_at<Footprint>(outputs, i);
    const auto a = static_cast<double>(in[1]);
    const auto b = static_cast<double>(in[2]);
    const auto c = static_cast<double>(in[3]);
    const auto d = static_cast<double>(in[4]);
    // The singular values of [a c; b d], and twice the direction of the first.
    const double sum = a * a + b * b + c * c + d * d;
    const double area = std::abs(a * d - b * c);
    const double along = a * a + c * c - b * b - d * d;
    const double across = 2 * (a * b + c * d);
    const double root = std::sqrt(along * along + across * across);
    const double major = std::sqrt((sum + root) / 2);
    const bool is_point = sum == 0;
    const double minor = area / (is_point ? 1 : major);

    const double unit_major = static_cast<double>(out[2]) / 128;
    const double unit_minor = static_cast<double>(out[3]) / 128;
    const double scale = is_point ? 0 : 1 / (is_point ? 1 : major);
    errors[4 * i] = std::abs(unit_major - major) * scale;
    errors[4 * i + 1] = std::abs(unit_minor - minor) * scale;

    const double fitted = std::max(minor, kLeastRatio * major);
    const double unit_fitted = std::max(unit_minor, kLeastRatio * unit_major);
    const double ratio = (is_point ? 1 : unit_fitted) / (is_point ? 1 : fitted);
    errors[4 * i + 2] = std::max(ratio, 1 / ratio);

    const auto u = static_cast<double>(out[0]);
    const auto v = static_cast<double>(out[1]);
    const double length = u * u + v * v;
    const bool is_long = major >= 2 * minor && !is_point;
    const double cosine = ((u * u - v * v) * along + 2 * u * v * across) / (is_long ? length * root : 1);
    errors[4 * i + 3] = is_long ? 1 - cosine : kNone;
  }
}

std::vector<Quantity> level_quantities() { return {{"level of detail", "octave", &same}}; }

void measure_level(const std::uint64_t* inputs, const std::uint64_t* outputs, std::size_t count, double* errors) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto [exponent, radius] = inputs_at<LevelOfRadius>(inputs, i);
    const double level = value_of<LevelOfRadius>(outputs_at<LevelOfRadius>(outputs, i)[0], 0);
    const double real = std::log2(static_cast<double>(radius)) + static_cast<double>(exponent) - 7;
    // Beyond the format it saturates.
    const bool fits = radius != 0 && real >= -32 && real < 31.99;
    errors[i] = fits ? std::abs(level - real) : kNone;
  }
}

std::vector<Quantity> weight_quantities() { return {{"weight", "of the pixel", &same}}; }

void measure_weight(const std::uint64_t* inputs, const std::uint64_t* outputs, std::size_t count, double* errors) {
  const oracle::Tables& tables = oracle::tables();
  for (std::size_t i = 0; i < count; ++i) {
    const auto [probes, row, probe] = inputs_at<ProbeWeight>(inputs, i);
    const auto column = static_cast<std::size_t>((std::abs(2 * probe - probes + 1) + 1) / 2);
    const double weight = value_of<ProbeWeight>(outputs_at<ProbeWeight>(outputs, i)[1], 1);
    errors[i] = std::abs(weight - tables.weight_real[static_cast<std::size_t>(row)][column]);
  }
}

std::vector<Quantity> kernel_quantities() { return {{"weight of the Gaussian kernel", "of the texels", &same}}; }

void measure_kernel(const std::uint64_t* inputs, const std::uint64_t* outputs, std::size_t count, double* errors) {
  for (std::size_t i = 0; i < count; ++i) {
    const double x = KernelWeight::kInputs[0].value(inputs_at<KernelWeight>(inputs, i)[0]);
    const double weight = value_of<KernelWeight>(outputs_at<KernelWeight>(outputs, i)[0], 0);
    const double near = std::exp(-x * x);
    const double far = std::exp(-(1 - x) * (1 - x));
    errors[i] = std::abs(weight - far / (near + far));
  }
}

std::vector<Quantity> colour_quantities() { return {{"colour of a probe, weighed and rounded", "1/255", &same}}; }

void measure_colour(const std::uint64_t* inputs, const std::uint64_t* outputs, std::size_t count, double* errors) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto [weight, colour] = inputs_at<WeighColour>(inputs, i);
    const double exact = WeighColour::kInputs[0].value(weight) * WeighColour::kInputs[1].value(colour);
    errors[i] = std::abs(value_of<WeighColour>(outputs_at<WeighColour>(outputs, i)[0], 0) - exact);
  }
}

}  // namespace feline::prove
