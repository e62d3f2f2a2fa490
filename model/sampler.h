// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "model/memory.h"
#include "tables/sampler_state.h"

namespace feline {

// Feline 3.4. exact: the rounding of 3.1, nothing shortened, blurred or aliased.
struct ProbeParameters {
  ProbeRounding rounding = ProbeRounding::kNearest;
  double length_factor = 1;  // 1/256 .. 1 by the default configuration (Formats::kLeastLengthFactor)
  double blur_factor = 1;    // 1 <= f < 2
  double alias_factor = 1;   // 1 <= f <= 2
};
inline constexpr ProbeParameters kExact{};
inline constexpr ProbeParameters kHighQuality{ProbeRounding::kCeiling, 0.9625, 1.15625, 1.1532};
inline constexpr ProbeParameters kHighEfficiency{ProbeRounding::kCeiling, 0.9625, 1.3125, 1.3544};

// The largest level of detail that a sampler can ask for: 15.996 by the default configuration.
inline constexpr double kMaxLevel =
    Formats<kDefaultConfig>::kSampledLevel.value(Formats<kDefaultConfig>::kSampledLevel.max_raw());

// What an application chooses; legal ranges beside each field, as the default configuration has them.
struct SamplerOptions {
  Mode mode = Mode::kTable;
  Kernel kernel = Kernel::kBilinear;
  Magnify magnify = Magnify::kLinear;
  Wrap wrap_s = Wrap::kRepeat;
  Wrap wrap_t = Wrap::kRepeat;
  ProbeParameters probes = kExact;
  int max_probes = kDefaultConfig.max_probes;  // 1 .. as many as the configuration or the default one has
  double level_bias = 0;                       // -16 .. 15.996
  double min_level = 0;                        // 0 .. 15.996, <= max_level
  double max_level = kMaxLevel;                // 0 .. 15.996
  std::array<double, 4> border{0, 0, 0, 0};    // 0 .. 1, linear
};

// A value that the machine cannot hold: field, got, legal.
class SamplerError : public std::invalid_argument {
 public:
  SamplerError(std::string field, std::string value, std::string legal);
  std::string field, value, legal;
};

// What the driver knows of a texture without looking at its texels.
struct TextureShape {
  TexelFormat format = TexelFormat::kRgba8;
  bool srgb = false;
  int width = 0, height = 0;  // of level 0, in texels
  int levels = 0;
  std::vector<std::int64_t> level_base;  // the first memory line of each level
};

// The driver's work, once per texture and sampler. Factors, levels and border are rounded to nearest, ties away. The
// border has the texture's channels only: others are 0, alpha 1, as those of its texels (OpenGL 4.6, 8.14.2).
// Throws SamplerError on anything illegal, a mip chain of wrong sizes included.
template <Config kConfig>
SamplerState<kConfig> make_sampler(const SamplerOptions& options, const Texture& texture, const TextureMemory& memory);
template <Config kConfig>
SamplerState<kConfig> make_sampler(const SamplerOptions& options, const TextureShape& texture);

extern template SamplerState<kDefaultConfig> make_sampler<kDefaultConfig>(const SamplerOptions&, const Texture&,
                                                                          const TextureMemory&);
extern template SamplerState<kDefaultConfig> make_sampler<kDefaultConfig>(const SamplerOptions&, const TextureShape&);

}  // namespace feline
