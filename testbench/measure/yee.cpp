// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/yee.h"

#include <algorithm>
#include <cmath>

namespace feline {
namespace {

constexpr std::size_t kBands = 6;
constexpr std::size_t kBlurs = kBands + 2;
constexpr double kFull = 100;    // cd/m^2 of a display's white
constexpr double kLeast = 1e-5;  // what is divided by

using Plane = std::vector<double>;

// One axis by the five weights of Burt and Adelson, 1983, a = 0.4; edges go on.
Plane blur_along(const Plane& plane, int count, std::size_t step, int lines, std::size_t line_step) {
  constexpr std::array<double, 5> kWeights{0.05, 0.25, 0.4, 0.25, 0.05};
  Plane result(plane.size());
  for (int line = 0; line < lines; ++line) {
    for (int i = 0; i < count; ++i) {
      double sum = 0;
      for (int k = 0; k < 5; ++k) {
        const auto at = static_cast<std::size_t>(std::clamp(i + k - 2, 0, count - 1));
        sum += kWeights[static_cast<std::size_t>(k)] * plane[static_cast<std::size_t>(line) * line_step + at * step];
      }
      result[static_cast<std::size_t>(line) * line_step + static_cast<std::size_t>(i) * step] = sum;
    }
  }
  return result;
}

// Luminance, and each time blurred once more.
std::array<Plane, kBlurs> blurs_of(const Displayed& picture) {
  std::array<Plane, kBlurs> blurs;
  for (const auto& [red, green, blue] : picture.pixels) {
    blurs[0].push_back(kFull * (0.2126 * red + 0.7152 * green + 0.0722 * blue));
  }
  const auto width = static_cast<std::size_t>(picture.width);
  for (std::size_t i = 1; i < kBlurs; ++i) {
    const Plane across = blur_along(blurs[i - 1], picture.width, 1, picture.height, width);
    blurs[i] = blur_along(across, picture.height, width, picture.width, 1);
  }
  return blurs;
}

// a* and b* of CIE L*a*b*, white D65.
std::array<double, 2> hue(const std::array<double, 3>& rgb) {
  const auto& [red, green, blue] = rgb;
  const auto compressed = [](double part) {
    return part > 216.0 / 24389 ? std::cbrt(part) : (24389.0 / 27 * part + 16) / 116;
  };
  const double x = compressed((0.4124 * red + 0.3576 * green + 0.1805 * blue) / 0.9505);
  const double y = compressed(0.2126 * red + 0.7152 * green + 0.0722 * blue);
  const double z = compressed((0.0193 * red + 0.1192 * green + 0.9505 * blue) / 1.089);
  return {500 * (x - y), 200 * (y - z)};
}

// Barten, 1989: of a grating's cycles a degree at a luminance.
double sensitivity(double cycles, double luminance) {
  const double a = 440 * std::pow(1 + 0.7 / luminance, -0.2);
  const double b = 0.3 * std::pow(1 + 100 / luminance, 0.15);
  return a * cycles * std::exp(-b * cycles) * std::sqrt(1 + 0.06 * std::exp(b * cycles));
}

// Daly, 1993: how much a contrast, in units of its threshold, raises the threshold.
double masking(double contrast) { return std::pow(1 + std::pow(0.0153 * std::pow(392.498 * contrast, 0.7), 4), 0.25); }

// Ward Larson, Rushmeier, Piatko, 1997: the least difference of luminance that is seen at an adaptation.
double threshold(double adaptation) {
  const double a = std::log10(adaptation);
  const double t = a < -3.94     ? -2.86
                   : a < -1.44   ? std::pow(0.405 * a + 1.6, 2.18) - 2.86
                   : a < -0.0184 ? a - 0.395
                   : a < 1.9     ? std::pow(0.249 * a + 0.65, 2.7) - 0.72
                                 : a - 1.255;
  return std::pow(10, t);
}

class Viewer {
 public:
  Viewer(const Displayed& a, const Displayed& b, double pixels_per_degree) : a_(blurs_of(a)), b_(blurs_of(b)) {
    for (std::size_t band = 0; band < kBands; ++band) {
      cycles_[band] = 0.5 * pixels_per_degree / std::exp2(band);
      // The most that the eye is sensitive to, at 3.248 cycles a degree.
      raise_[band] = sensitivity(3.248, kFull) / sensitivity(cycles_[band], kFull);
    }
    while (adaptation_ + 1 < kBlurs && std::exp2(adaptation_) < pixels_per_degree) ++adaptation_;
  }

  bool sees(std::size_t pixel, const std::array<double, 3>& a, const std::array<double, 3>& b) const {
    const double adaptation = std::max((a_[adaptation_][pixel] + b_[adaptation_][pixel]) / 2, kLeast);
    double sum = 0;
    double raised = 0;
    for (std::size_t band = 0; band < kBands; ++band) {
      const auto change = [&](const std::array<Plane, kBlurs>& blurs) {
        return std::abs(blurs[band][pixel] - blurs[band + 1][pixel]);
      };
      const double around = std::max({a_[band + 2][pixel], b_[band + 2][pixel], kLeast});
      const double contrast = std::max(change(a_), change(b_)) / around;
      sum += contrast;
      raised += contrast * raise_[band] * masking(contrast * sensitivity(cycles_[band], adaptation));
    }
    const double factor = std::clamp(raised / std::max(sum, kLeast), 1.0, 10.0);
    if (std::abs(a_[0][pixel] - b_[0][pixel]) > factor * threshold(adaptation)) return true;
    // Hues fade in the dark.
    const double scale = std::min(adaptation / 10, 1.0);
    const auto hue_a = hue(a);
    const auto hue_b = hue(b);
    const double apart = (hue_a[0] - hue_b[0]) * (hue_a[0] - hue_b[0]) + (hue_a[1] - hue_b[1]) * (hue_a[1] - hue_b[1]);
    return apart * scale * scale > factor;
  }

 private:
  std::array<Plane, kBlurs> a_;
  std::array<Plane, kBlurs> b_;
  std::array<double, kBands> cycles_{};  // a degree
  std::array<double, kBands> raise_{};
  std::size_t adaptation_ = 0;  // the blur about a degree wide
};

}  // namespace

std::int64_t count_visible(const Displayed& a, const Displayed& b, double pixels_per_degree) {
  const Viewer viewer(a, b, pixels_per_degree);
  std::int64_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) count += viewer.sees(i, a.pixels[i], b.pixels[i]) ? 1 : 0;
  return count;
}

}  // namespace feline
