// SPDX-License-Identifier: Apache-2.0
#include "testbench/mip_chain.h"

#include <OpenImageIO/filter.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "testbench/srgb.h"

namespace feline {
namespace {

// OpenImageIO resamples; the kernels are ours. Its own "lanczos3" goes through fast_sinpi, an
// approximation good to 9e-4 (fmath.h), and its "box" takes the texels whose centres are inside,
// which is uneven as soon as the ratio is not a whole number.

// sinc(x) sinc(x / 3) in destination texels (Duchon 1979).
class Lanczos3 final : public OIIO::Filter2D {
 public:
  Lanczos3() : Filter2D(2 * kRadius, 2 * kRadius) {}
  bool separable() const override { return true; }
  float operator()(float x, float y) const override { return xfilt(x) * yfilt(y); }
  float xfilt(float x) const override {
    if (std::abs(x) >= kRadius) return 0.0f;
    return static_cast<float>(sinc(x) * sinc(double{x} / kRadius));
  }
  float yfilt(float y) const override { return xfilt(y); }
  OIIO::string_view name() const override { return "feline-lanczos3"; }

 private:
  static constexpr float kRadius = 3.0f;
  static double sinc(double x) {
    if (x == 0.0) return 1.0;
    return std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
  }
};

// The overlap of a source texel, ratio = destination / source wide, with a destination texel.
class AreaBox final : public OIIO::Filter2D {
 public:
  AreaBox(float x_ratio, float y_ratio)
      : Filter2D(1.0f + x_ratio, 1.0f + y_ratio), x_ratio_(x_ratio), y_ratio_(y_ratio) {}
  bool separable() const override { return true; }
  float operator()(float x, float y) const override { return xfilt(x) * yfilt(y); }
  float xfilt(float x) const override { return overlap(x, x_ratio_); }
  float yfilt(float y) const override { return overlap(y, y_ratio_); }
  OIIO::string_view name() const override { return "feline-box"; }

 private:
  static float overlap(float x, float ratio) { return std::clamp(0.5f + 0.5f * ratio - std::abs(x), 0.0f, ratio); }
  float x_ratio_;
  float y_ratio_;
};

std::unique_ptr<OIIO::Filter2D> make_filter(MipFilter filter, float x_ratio, float y_ratio) {
  if (filter == MipFilter::kBox) return std::make_unique<AreaBox>(x_ratio, y_ratio);
  return std::make_unique<Lanczos3>();
}

// From a stored channel to light and back. Encoding searches the 255 boundaries between codes,
// which are the decoded half-way values: the nearest code of the encoded value, without an inverse.
class Transfer {
 public:
  explicit Transfer(bool srgb) {
    const auto light = [srgb](double encoded) { return srgb ? srgb_to_linear(encoded) : encoded; };
    for (std::size_t code = 0; code < 256; ++code) {
      decode_[code] = static_cast<float>(light(static_cast<double>(code) / 255.0));
    }
    for (std::size_t code = 0; code < 255; ++code) {
      boundary_[code] = static_cast<float>(light((static_cast<double>(code) + 0.5) / 255.0));
    }
  }
  float decode(std::uint8_t code) const { return decode_[code]; }
  std::uint8_t encode(float value) const {
    const auto above = std::upper_bound(boundary_.begin(), boundary_.end(), value);
    return static_cast<std::uint8_t>(above - boundary_.begin());
  }

 private:
  std::array<float, 256> decode_{};
  std::array<float, 255> boundary_{};
};

std::size_t value_count(int width, int height, int channels) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels);
}

// A copy with pad more texels on every side, taken from the other end of the periodic image.
FloatLevel pad_periodic(const FloatLevel& level, int channels, int pad) {
  FloatLevel padded{level.width + 2 * pad, level.height + 2 * pad, {}};
  padded.values.reserve(value_count(padded.width, padded.height, channels));
  const auto wrap = [](int i, int size) { return ((i % size) + size) % size; };
  for (int y = -pad; y < level.height + pad; ++y) {
    for (int x = -pad; x < level.width + pad; ++x) {
      const std::size_t from = value_count(level.width, wrap(y, level.height), channels) +
                               static_cast<std::size_t>(wrap(x, level.width)) * static_cast<std::size_t>(channels);
      for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
        padded.values.push_back(level.values[from + c]);
      }
    }
  }
  return padded;
}

FloatLevel resize(FloatLevel& from, int width, int height, int channels, MipFilter filter, MipEdge edge) {
  FloatLevel to{width, height, {}};
  to.values.resize(value_count(to.width, to.height, channels));

  OIIO::ImageSpec spec(from.width, from.height, channels, OIIO::TypeDesc::FLOAT);
  FloatLevel padded;
  float* source = from.values.data();
  if (edge == MipEdge::kRepeat) {
    // A ratio below 3 (3 to 1) times a radius of 3. OpenImageIO maps the full windows onto each
    // other and reads what the data window has beyond them.
    constexpr int kPad = 10;
    padded = pad_periodic(from, channels, kPad);
    source = padded.values.data();
    spec.x = spec.y = -kPad;
    spec.width = padded.width;
    spec.height = padded.height;
  }
  const OIIO::ImageBuf source_image(spec, source);
  OIIO::ImageBuf target_image(OIIO::ImageSpec(to.width, to.height, channels, OIIO::TypeDesc::FLOAT), to.values.data());
  const auto kernel = make_filter(filter, static_cast<float>(to.width) / static_cast<float>(from.width),
                                  static_cast<float>(to.height) / static_cast<float>(from.height));
  if (!OIIO::ImageBufAlgo::resize(target_image, source_image, kernel.get())) {
    throw std::runtime_error("mip chain: " + target_image.geterror());
  }
  return to;
}

// From stored texels to light and back, alpha left alone.
class Light {
 public:
  Light(int channels, bool srgb) : channels_(channels), colour_(srgb), linear_(false) {}

  FloatLevel decode(const MipLevel& stored) const {
    if (stored.width < 1 || stored.height < 1 ||
        stored.texels.size() != value_count(stored.width, stored.height, channels_)) {
      throw std::invalid_argument("mip chain: the texels do not fill the level");
    }
    FloatLevel level{stored.width, stored.height, std::vector<float>(stored.texels.size())};
    for (std::size_t i = 0; i < level.values.size(); ++i) level.values[i] = of(i).decode(stored.texels[i]);
    return level;
  }
  MipLevel encode(const FloatLevel& level) const {
    MipLevel stored{level.width, level.height, std::vector<std::uint8_t>(level.values.size())};
    for (std::size_t i = 0; i < level.values.size(); ++i) stored.texels[i] = of(i).encode(level.values[i]);
    return stored;
  }

 private:
  const Transfer& of(std::size_t index) const { return channels_ == 4 && index % 4 == 3 ? linear_ : colour_; }
  int channels_;
  Transfer colour_, linear_;
};

}  // namespace

std::vector<FloatLevel> build_float_mip_chain(FloatLevel base, int channels, MipFilter filter, MipEdge edge) {
  std::vector<FloatLevel> levels;
  levels.push_back(std::move(base));
  while (levels.back().width > 1 || levels.back().height > 1) {
    FloatLevel& finer = levels.back();
    levels.push_back(resize(finer, mip_size(finer.width, 1), mip_size(finer.height, 1), channels, filter, edge));
  }
  return levels;
}

std::vector<MipLevel> build_mip_chain(MipLevel base, int channels, MipFilter filter, bool srgb, MipEdge edge) {
  const Light light(channels, srgb);
  const std::vector<FloatLevel> chain = build_float_mip_chain(light.decode(base), channels, filter, edge);
  std::vector<MipLevel> levels;
  levels.push_back(std::move(base));
  for (std::size_t k = 1; k < chain.size(); ++k) levels.push_back(light.encode(chain[k]));
  return levels;
}

RipChain build_rip_chain(const MipLevel& base, int channels, MipFilter filter, bool srgb, MipEdge edge) {
  const Light light(channels, srgb);
  RipChain chain{mip_count(base.width, 1), mip_count(1, base.height), {}};
  FloatLevel row = light.decode(base);
  for (int j = 0; j < chain.rows; ++j) {
    if (j > 0) row = resize(row, row.width, mip_size(row.height, 1), channels, filter, edge);
    FloatLevel image = row;
    for (int i = 0; i < chain.columns; ++i) {
      if (i > 0) image = resize(image, mip_size(image.width, 1), image.height, channels, filter, edge);
      chain.images.push_back(i + j == 0 ? base : light.encode(image));
    }
  }
  return chain;
}

}  // namespace feline
