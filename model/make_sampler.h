// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "model/sampler.h"
#include "tables/rounding.h"

// make_sampler for configurations other than the default one, which has it compiled already.
namespace feline {

namespace sampler_parts {

// Gives the value back; SamplerError unless it is low to high.
double checked(std::string_view field, double value, double low, double high);

template <Format kFormat>
Fixed<kFormat> quantized(double value) {
  return Fixed<kFormat>::saturate(std::llround(value * static_cast<double>(kFormat.one())));
}

struct SizeReciprocal {
  std::int64_t mantissa;
  std::int64_t shift;
};

// 1/size = mantissa * 2^-(bits + shift), 2^(bits) <= mantissa < 2^(bits + 1), nearest.
SizeReciprocal size_reciprocal(int size, int bits);

// SamplerError unless both sides are 1 to max_size.
void check_size(int width, int height, int max_size);
void check_powers_of_two(int width, int height);
// SamplerError unless each level has the size that level 0 gives it.
void check_chain(const Texture& texture, int max_size);

}  // namespace sampler_parts

template <Config kConfig>
SamplerState<kConfig> make_sampler(const SamplerOptions& options, const Texture& texture, const TextureMemory& memory) {
  sampler_parts::check_chain(texture, 1 << kConfig.max_size_log2);
  const MipLevel& base = texture.levels.front();
  return make_sampler<kConfig>(options, TextureShape{texture.format, texture.srgb, base.width, base.height,
                                                     static_cast<int>(texture.levels.size()), memory.level_base});
}

template <Config kConfig>
SamplerState<kConfig> make_sampler(const SamplerOptions& options, const TextureShape& texture) {
  using F = Formats<kConfig>;
  using namespace sampler_parts;
  const int width = texture.width;
  const int height = texture.height;
  check_size(width, height, 1 << kConfig.max_size_log2);
  if (!kConfig.features.any_size) check_powers_of_two(width, height);
  const int smallest = bit_length(std::max(width, height)) - 1;
  if (texture.levels < 1) throw SamplerError("levels", "0", "at least 1");
  if (texture.levels > smallest + 1) {
    throw SamplerError("levels", std::to_string(texture.levels), "at most " + std::to_string(smallest + 1));
  }
  SamplerState<kConfig> state;
  state.mode = state.mode.from_raw(static_cast<std::int64_t>(options.mode));
  state.kernel = state.kernel.from_raw(static_cast<std::int64_t>(options.kernel));
  state.magnify = state.magnify.from_raw(static_cast<std::int64_t>(options.magnify));
  state.wrap_s = state.wrap_s.from_raw(static_cast<std::int64_t>(options.wrap_s));
  state.wrap_t = state.wrap_t.from_raw(static_cast<std::int64_t>(options.wrap_t));
  state.texel_format = state.texel_format.from_raw(static_cast<std::int64_t>(texture.format));
  state.srgb = state.srgb.from_raw(texture.srgb);
  state.width = state.width.from_raw(width);
  state.height = state.height.from_raw(height);
  state.smallest_level = state.smallest_level.from_raw(smallest);
  state.last_level = state.last_level.from_raw(std::min(texture.levels, F::kLevels) - 1);
  state.levels_cut = state.levels_cut.from_raw(texture.levels > F::kLevels);
  const SizeReciprocal across = size_reciprocal(width, kConfig.size_reciprocal_bits);
  const SizeReciprocal down = size_reciprocal(height, kConfig.size_reciprocal_bits);
  state.width_reciprocal = state.width_reciprocal.from_raw(across.mantissa);
  state.height_reciprocal = state.height_reciprocal.from_raw(down.mantissa);
  state.width_shift = state.width_shift.from_raw(across.shift);
  state.height_shift = state.height_shift.from_raw(down.shift);

  const ProbeParameters& probes = options.probes;
  const double factor_step = 1.0 / static_cast<double>(F::kFactor.one());
  const double length = checked("length_factor", probes.length_factor, F::kFactor.value(F::kLeastLengthFactor), 1);
  const double blur = checked("blur_factor", probes.blur_factor, 1, 2 - factor_step);
  const double alias = checked("alias_factor", probes.alias_factor, 1, 2);
  state.probe_rounding = state.probe_rounding.from_raw(static_cast<std::int64_t>(probes.rounding));
  const auto granted = static_cast<int>(
      checked("max_probes", options.max_probes, 1, std::max(kConfig.max_probes, kDefaultConfig.max_probes)));
  state.max_probes = state.max_probes.from_raw(std::min(granted, kConfig.max_probes));
  state.probes_cut = state.probes_cut.from_raw(granted > kConfig.max_probes);
  state.length_factor = quantized<F::kFactor>(length);
  state.blur_factor = quantized<F::kFactor>(blur);
  state.inverse_alias_factor = quantized<F::kFactor>(1 / alias);
  state.probe_factor = quantized<F::kFactor>(1 / (blur * alias));

  const double level_step = 1.0 / static_cast<double>(std::int64_t{1} << kConfig.level_fraction_bits);
  state.level_bias = quantized<F::kLevelOfDetail>(checked("level_bias", options.level_bias, -16, 16 - level_step));
  const double max_level = checked("max_level", options.max_level, 0, kMaxLevel);
  state.max_level = quantized<F::kSampledLevel>(max_level);
  state.min_level = quantized<F::kSampledLevel>(checked("min_level", options.min_level, 0, max_level));
  const auto channels = static_cast<std::size_t>(bytes_per_texel(texture.format));
  for (std::size_t c = 0; c < 4; ++c) {
    const double border = checked("border", options.border[c], 0, 1);
    const double missing = c == 3 ? 1 : 0;
    state.border[c] = quantized<F::kChannel>(255 * (c < channels ? border : missing));
  }
  for (std::size_t k = 0; k < std::min(texture.level_base.size(), state.level_base.size()); ++k) {
    state.level_base[k] = state.level_base[k].from_raw(texture.level_base[k]);
  }
  return state;
}

}  // namespace feline
