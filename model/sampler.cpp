// SPDX-License-Identifier: Apache-2.0
#include "model/sampler.h"

#include <fmt/format.h>

#include "model/make_sampler.h"
#include "tables/unit.h"

namespace feline {
namespace sampler_parts {

double checked(std::string_view field, double value, double low, double high) {
  // Written so that NaN fails.
  if (value >= low && value <= high) return value;
  throw SamplerError(std::string(field), fmt::format("{}", value), fmt::format("{} to {}", low, high));
}

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

void check_powers_of_two(int width, int height) {
  if (std::has_single_bit(static_cast<unsigned>(width)) && std::has_single_bit(static_cast<unsigned>(height))) return;
  throw SamplerError("size", std::to_string(width) + " x " + std::to_string(height), "powers of two");
}

}  // namespace sampler_parts

SamplerError::SamplerError(std::string field_name, std::string got, std::string range)
    : std::invalid_argument(field_name + ": got " + got + ", legal is " + range),
      field(std::move(field_name)),
      value(std::move(got)),
      legal(std::move(range)) {}

template SamplerState<kDefaultConfig> make_sampler<kDefaultConfig>(const SamplerOptions&, const Texture&,
                                                                   const TextureMemory&);
template SamplerState<kDefaultConfig> make_sampler<kDefaultConfig>(const SamplerOptions&, const TextureShape&);
#ifdef FELINE_UNIT_HEADER
template SamplerState<kUnit> make_sampler<kUnit>(const SamplerOptions&, const Texture&, const TextureMemory&);
#endif

}  // namespace feline
