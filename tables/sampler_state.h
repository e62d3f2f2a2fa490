// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/beats.h"
#include "tables/sampler_enums.h"

namespace feline {

// What the driver's code prepares once per texture and sampler (model/sampler.h makes and checks it) and the unit holds
// still while it works. A legal state has: sizes 1 .. 2^max_size_log2; 1 <= levels <= smallest_level + 1;
// kLeastLengthFactor <= length_factor <= 1; 1 <= blur_factor < 2; 1/2 <= inverse_alias_factor <= 1; 0 < probe_factor <=
// 1; 1 <= max_probes; min_level <= max_level. A footprint has minor_radius <= major_radius.
template <Config kConfig>
struct SamplerState {
  using F = Formats<kConfig>;
  static constexpr Name kName{"sampler"};
  Fixed<F::kMode> mode;
  Fixed<F::kFlag> kernel;
  Fixed<F::kFlag> magnify;
  Fixed<F::kWrap> wrap_s, wrap_t;
  Fixed<F::kTexelFormat> texel_format;
  Fixed<F::kFlag> srgb;
  Fixed<F::kSize> width, height;
  Fixed<F::kFullLevel> smallest_level;  // where the full chain reaches 1 x 1: floor(log2(max(width, height)))
  Fixed<F::kLevel> last_level;          // the coarsest level in memory, or of the machine
  Fixed<F::kFlag> levels_cut;           // the texture has more levels than the machine
  Fixed<F::kSizeReciprocal> width_reciprocal, height_reciprocal;  // 1/size = reciprocal * 2^-shift
  Fixed<F::kSizeShift> width_shift, height_shift;
  Fixed<F::kFlag> probe_rounding;
  Fixed<F::kProbeCount> max_probes;
  Fixed<F::kFlag> probes_cut;              // the application grants more probes than the machine has
  Fixed<F::kFactor> length_factor;         // <= 1
  Fixed<F::kFactor> blur_factor;           // >= 1
  Fixed<F::kFactor> inverse_alias_factor;  // 1/aliasFactor
  Fixed<F::kFactor> probe_factor;          // 1/(blurFactor * aliasFactor)
  Fixed<F::kLevelOfDetail> level_bias;
  Fixed<F::kSampledLevel> min_level, max_level;
  std::array<Fixed<F::kChannel>, 4> border;
  std::array<Fixed<F::kLine>, F::kLevels> level_base;  // the first memory line of each level

  static constexpr auto fields() {
    return std::tuple{field("mode", &SamplerState::mode),
                      field("kernel", &SamplerState::kernel),
                      field("magnify", &SamplerState::magnify),
                      field("wrap_s", &SamplerState::wrap_s),
                      field("wrap_t", &SamplerState::wrap_t),
                      field("texel_format", &SamplerState::texel_format),
                      field("srgb", &SamplerState::srgb),
                      field("width", &SamplerState::width),
                      field("height", &SamplerState::height),
                      field("smallest_level", &SamplerState::smallest_level),
                      field("last_level", &SamplerState::last_level),
                      field("levels_cut", &SamplerState::levels_cut),
                      field("width_reciprocal", &SamplerState::width_reciprocal),
                      field("height_reciprocal", &SamplerState::height_reciprocal),
                      field("width_shift", &SamplerState::width_shift),
                      field("height_shift", &SamplerState::height_shift),
                      field("probe_rounding", &SamplerState::probe_rounding),
                      field("max_probes", &SamplerState::max_probes),
                      field("probes_cut", &SamplerState::probes_cut),
                      field("length_factor", &SamplerState::length_factor),
                      field("blur_factor", &SamplerState::blur_factor),
                      field("inverse_alias_factor", &SamplerState::inverse_alias_factor),
                      field("probe_factor", &SamplerState::probe_factor),
                      field("level_bias", &SamplerState::level_bias),
                      field("min_level", &SamplerState::min_level),
                      field("max_level", &SamplerState::max_level),
                      field("border", &SamplerState::border),
                      field("level_base", &SamplerState::level_base)};
  }
};

}  // namespace feline
