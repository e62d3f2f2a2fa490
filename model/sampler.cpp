// SPDX-License-Identifier: Apache-2.0
#include "model/sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tables/rounding.h"

namespace feline {
namespace {

double checked(std::string_view field, double value, double low, double high) {
  // Written so that NaN fails.
  if (value >= low && value <= high) return value;
  throw SamplerError(std::string(field), fmt::format("{}", value), fmt::format("{} to {}", low, high));
}

template <Format kFormat>
Fixed<kFormat> quantized(double value) {
  return Fixed<kFormat>::saturate(std::llround(value * static_cast<double>(kFormat.one())));
}

struct SizeReciprocal {
  std::int64_t mantissa;
  std::int64_t shift;
};

// 1/size = mantissa * 2^-(bits + shift), 2^(bits) <= mantissa < 2^(bits + 1), nearest.
SizeReciprocal size_reciprocal(int size, int bits) {
  const int shift = bit_length(size - 1);
  const std::int64_t scaled = std::int64_t{1} << (bits + shift + 1);
  return {(scaled / size + 1) / 2, shift};
}

void check_size(int width, int height, int max_size) {
  if (width < 1 || height < 1 || width > max_size || height > max_size) {
    throw SamplerError("size", std::to_string(width) + " x " + std::to_string(height),
                       "1 x 1 to " + std::to_string(max_size) + " x " + std::to_string(max_size));
  }
}

void check_chain(const Texture& texture, int max_size) {
  if (texture.levels.empty()) throw SamplerError("levels", "0", "at least 1");
  const MipLevel& base = texture.levels.front();
  check_size(base.width, base.height, max_size);
  for (std::size_t k = 0; k < texture.levels.size(); ++k) {
    const MipLevel& level = texture.levels[k];
    const int width = std::max(base.width >> k, 1);
    const int height = std::max(base.height >> k, 1);
    const auto bytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                       static_cast<std::size_t>(bytes_per_texel(texture.format));
    if (level.width != width || level.height != height || level.texels.size() != bytes) {
      throw SamplerError(
          "level " + std::to_string(k),
          std::to_string(level.width) + " x " + std::to_string(level.height) + ", " +
              std::to_string(level.texels.size()) + " bytes",
          std::to_string(width) + " x " + std::to_string(height) + ", " + std::to_string(bytes) + " bytes");
    }
  }
}

}  // namespace

SamplerError::SamplerError(std::string field_name, std::string got, std::string range)
    : std::invalid_argument(field_name + ": got " + got + ", legal is " + range),
      field(std::move(field_name)),
      value(std::move(got)),
      legal(std::move(range)) {}

template <Config kConfig>
SamplerState<kConfig> make_sampler(const SamplerOptions& options, const Texture& texture, const TextureMemory& memory) {
  check_chain(texture, 1 << kConfig.max_size_log2);
  const MipLevel& base = texture.levels.front();
  return make_sampler<kConfig>(options, TextureShape{texture.format, texture.srgb, base.width, base.height,
                                                     static_cast<int>(texture.levels.size()), memory.level_base});
}

template <Config kConfig>
SamplerState<kConfig> make_sampler(const SamplerOptions& options, const TextureShape& texture) {
  using F = Formats<kConfig>;
  const int width = texture.width;
  const int height = texture.height;
  check_size(width, height, 1 << kConfig.max_size_log2);
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
  state.last_level = state.last_level.from_raw(texture.levels - 1);
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
  state.max_probes = state.max_probes.from_raw(
      static_cast<std::int64_t>(checked("max_probes", options.max_probes, 1, kConfig.max_probes)));
  state.length_factor = quantized<F::kFactor>(length);
  state.blur_factor = quantized<F::kFactor>(blur);
  state.inverse_alias_factor = quantized<F::kFactor>(1 / alias);
  state.probe_factor = quantized<F::kFactor>(1 / (blur * alias));

  const double level_step = 1.0 / static_cast<double>(std::int64_t{1} << kConfig.level_fraction_bits);
  state.level_bias = quantized<F::kLevelOfDetail>(checked("level_bias", options.level_bias, -16, 16 - level_step));
  const double max_level =
      checked("max_level", options.max_level, 0, F::kSampledLevel.value(F::kSampledLevel.max_raw()));
  state.max_level = quantized<F::kSampledLevel>(max_level);
  state.min_level = quantized<F::kSampledLevel>(checked("min_level", options.min_level, 0, max_level));
  const auto channels = static_cast<std::size_t>(bytes_per_texel(texture.format));
  for (std::size_t c = 0; c < 4; ++c) {
    const double border = checked("border", options.border[c], 0, 1);
    const double missing = c == 3 ? 1 : 0;
    state.border[c] = quantized<F::kChannel>(255 * (c < channels ? border : missing));
  }
  for (std::size_t k = 0; k < texture.level_base.size(); ++k) {
    state.level_base[k] = state.level_base[k].from_raw(texture.level_base[k]);
  }
  return state;
}

template SamplerState<kDefaultConfig> make_sampler<kDefaultConfig>(const SamplerOptions&, const Texture&,
                                                                   const TextureMemory&);
template SamplerState<kDefaultConfig> make_sampler<kDefaultConfig>(const SamplerOptions&, const TextureShape&);

}  // namespace feline
