// SPDX-License-Identifier: Apache-2.0
// The unit without the work that a lookup does not need, bit for bit as sample() of model/unit.h: the same plan, the
// same colour, status and tag. Arithmetic is the stages' own.
//
// The stages run into each other: between plan and accumulate no beats are made, and as nothing is rounded there, each
// level is summed over the probes by itself and the two are mixed once a lookup. Further work is left out shortcut by
// shortcut, each with a switch and a counter of its own.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <string_view>

#include "model/unit.h"

namespace feline {

// What may be left out; none of it changes a bit.
struct Shortcuts {
  bool second_level = true;       // the coarse level where its weight is 0: whole levels of detail, isotropic modes
  bool weightless_probes = true;  // probes of weight 0
  bool round_footprints = true;   // the line's set-up where one probe is taken
  bool weightless_texels = true;  // texels of weight 0: on texel centres, nearest
  bool absent_channels = true;    // channels that all texels have the same: the format's absent ones, alpha if opaque
  bool decoded_codes = true;      // decoding of texels: each of the 256 codes of a channel is decoded once

  constexpr bool operator==(const Shortcuts&) const = default;
};
inline constexpr Shortcuts kNoShortcuts{false, false, false, false, false, false};

// What was asked for, and what each shortcut left out of it.
struct ShortcutCounts {
  std::int64_t lookups = 0;
  std::int64_t probes = 0;             // planned
  std::int64_t second_levels = 0;      // levels of probes not filtered
  std::int64_t weightless_probes = 0;  // probes not taken
  std::int64_t round_footprints = 0;   // lookups without a line
  std::int64_t weightless_texels = 0;  // texels not read
  std::int64_t absent_channels = 0;    // channels of a probe's level not filtered
  std::int64_t decoded_codes = 0;      // texels not decoded
};

// A shortcut's name, switch and counter.
struct ShortcutName {
  std::string_view name;
  bool Shortcuts::*is_on;
  std::int64_t ShortcutCounts::*saved;
  std::string_view unit;  // of the counter
};
inline constexpr std::array kShortcutNames{
    ShortcutName{"second_level", &Shortcuts::second_level, &ShortcutCounts::second_levels, "levels of probes"},
    ShortcutName{"weightless_probes", &Shortcuts::weightless_probes, &ShortcutCounts::weightless_probes, "probes"},
    ShortcutName{"round_footprints", &Shortcuts::round_footprints, &ShortcutCounts::round_footprints, "lines"},
    ShortcutName{"weightless_texels", &Shortcuts::weightless_texels, &ShortcutCounts::weightless_texels, "texels"},
    ShortcutName{"absent_channels", &Shortcuts::absent_channels, &ShortcutCounts::absent_channels, "channels"},
    ShortcutName{"decoded_codes", &Shortcuts::decoded_codes, &ShortcutCounts::decoded_codes, "texel decodings"}};

// Memory by lines, as TextureMemory has them; a line may be made when it is asked for, and is read at once. `opaque`:
// RGBA8, and known to have no alpha but 255.
template <typename Lines>
concept LineSource = requires(Lines& lines, std::int64_t index) {
  { lines.line(index) } -> std::convertible_to<std::span<const std::uint8_t>>;
  { lines.opaque() } -> std::convertible_to<bool>;
};

// One sampler state and one memory, which must both outlive it; for one thread. A configuration without alpha looks for
// it in every texel, those of no weight included.
template <Config kConfig, LineSource Lines>
class ShortcutUnit {
 public:
  ShortcutUnit(const SamplerState<kConfig>& sampler, Lines& lines, const Shortcuts& shortcuts = {})
      : sampler_(sampler),
        lines_(lines),
        shortcuts_(shortcuts),
        wrap_s_(supported_wrap<kConfig>(sampler.wrap_s)),
        wrap_t_(supported_wrap<kConfig>(sampler.wrap_t)),
        border_(packed(supported_texel<kConfig>(sampler.border))) {
    for (std::size_t code = 0; code < 256; ++code) {
      std::array<std::uint8_t, kLineBytes> line;
      line.fill(static_cast<std::uint8_t>(code));
      const Texel texel = packed(supported_texel<kConfig>(decode_texel<kConfig>(line, 0, 0, sampler)));
      for (std::size_t c = 0; c < 4; ++c) decoded_[c][code] = texel[c];
    }
    stored_ = texel_channels<kConfig>(sampler);
    for (std::size_t c = 0; c < 4; ++c) constant_[c] = decoded_[c][0];
    filtered_ = stored_;
    if (stored_ == 4 && lines.opaque()) {
      filtered_ = 3;
      constant_[3] = decoded_[3][255];
    }
    if (kLooksForAlpha) shortcuts_.weightless_texels = shortcuts_.weightless_probes = false;
    // A border may not be opaque where the texels are, and one that make_sampler did not make have channels they lack.
    const bool has_border = wrap_s_ == Wrap::kClampToBorder || wrap_t_ == Wrap::kClampToBorder;
    leaves_channels_ = shortcuts_.absent_channels;
    for (auto c = static_cast<std::size_t>(filtered_); c < 4; ++c) {
      if (has_border && border_[c] != constant_[c]) leaves_channels_ = false;
    }
  }

  // As sample(); `trace` is called with the plan.
  template <typename Trace = NoTrace>
  AccumulateBeat<kConfig> sample(const RequestBeat<kConfig>& request, Trace&& trace = {}) {
    const FootprintBeat<kConfig> shaped = footprint<kConfig>(group<kConfig>(request, sampler_), sampler_);
    const PlanBeat<kConfig> planned = plan<kConfig>(shaped, sampler_, shortcuts_.round_footprints);
    trace(planned);
    AccumulateBeat<kConfig> beat;
    beat.tag = planned.tag;
    lacks_alpha_ = false;
    walk_probes(planned);
    switch (stored_) {
      case 1: leaves_channels_ ? filter_levels<1, 1>(planned, beat) : filter_levels<1, 4>(planned, beat); break;
      case 2: leaves_channels_ ? filter_levels<2, 2>(planned, beat) : filter_levels<2, 4>(planned, beat); break;
      default:
        if (leaves_channels_ && filtered_ == 3) {
          filter_levels<4, 3>(planned, beat);
        } else {
          filter_levels<4, 4>(planned, beat);
        }
        break;
    }
    beat.status = beat.status.from_raw(row_status<kConfig>(planned).raw() | unsupported_if(lacks_alpha_));
    return beat;
  }

  const ShortcutCounts& counts() const { return counts_; }

 private:
  using F = Formats<kConfig>;
  using Texel = std::array<std::uint16_t, 4>;  // raw channels
  static_assert(F::kChannel.width() <= 16);
  static constexpr bool kLooksForAlpha = channel_count(kConfig.features) == 4 && !kConfig.features.alpha;
  struct Probe {
    std::int64_t s, t, weight;
  };

  static Texel packed(const typename FetchBeat<kConfig>::Texel& texel) {
    Texel packed;
    for (std::size_t c = 0; c < 4; ++c) packed[c] = static_cast<std::uint16_t>(texel[c].raw());
    return packed;
  }

  void walk_probes(const PlanBeat<kConfig>& planned) {
    const std::int64_t probes = planned.probes.raw();
    ++counts_.lookups;
    counts_.probes += probes;
    if (probes == 1 && shortcuts_.round_footprints) ++counts_.round_footprints;
    used_ = 0;
    for (std::int64_t n = 1 - probes; n < probes; n += 2) {
      const std::int64_t weight = probe_weight<kConfig>(planned.weight_row.raw(), n);
      if (weight == 0 && shortcuts_.weightless_probes) {
        ++counts_.weightless_probes;
        continue;
      }
      probes_[used_++] = Probe{probe_position<kConfig>(planned.s.raw(), planned.half_step_s.raw(), n).raw(),
                               probe_position<kConfig>(planned.t.raw(), planned.half_step_t.raw(), n).raw(), weight};
    }
  }

  // kStored channels of the format, of which and of what it lacks kChannels are filtered.
  template <std::size_t kStored, std::size_t kChannels>
  void filter_levels(const PlanBeat<kConfig>& planned, AccumulateBeat<kConfig>& beat) {
    constexpr int kFraction = kConfig.level_fraction_bits;
    const std::int64_t level = planned.level_of_detail.raw() >> kFraction;
    const std::int64_t fraction = planned.level_of_detail.raw() - (level << kFraction);
    const bool linear = planned.linear.raw() != 0;
    std::array<std::int64_t, kChannels> fine{};
    std::array<std::int64_t, kChannels> coarse{};
    sum_level<kStored, kChannels>(level_shape(sampler_, level), linear, fine);
    const bool second = fraction != 0;
    if (second) sum_level<kStored, kChannels>(level_shape(sampler_, level + 1), linear, coarse);
    if (second || !shortcuts_.second_level) {
      if (!second) sum_unused_level<kChannels>(coarse);
      for (std::size_t c = 0; c < kChannels; ++c) fine[c] = interpolate(fine[c], coarse[c], fraction, kFraction);
    } else {
      counts_.second_levels += static_cast<std::int64_t>(used_);
      for (std::size_t c = 0; c < kChannels; ++c) fine[c] <<= kFraction;
    }
    for (std::size_t c = 0; c < kChannels; ++c) beat.colour[c] = finished_channel<kConfig>(c, fine[c]);
    // All texels have the same of these. Weights that a configuration leaves out sum to nothing.
    std::int64_t weight = 0;
    for (std::size_t i = 0; i < used_; ++i) weight += probes_[i].weight;
    for (std::size_t c = kChannels; c < 4; ++c) {
      constexpr int kFractionBits = F::kAccumulated.fraction_bits - F::kChannel.fraction_bits - kConfig.weight_bits;
      beat.colour[c] = finished_channel<kConfig>(c, (constant_[c] * weight) << kFractionBits);
    }
  }

  // As filter does it, which takes eight texels even where four of them are 0.
  template <std::size_t kChannels>
  void sum_unused_level(std::array<std::int64_t, kChannels>& sums) {
    for (std::size_t i = 0; i < used_; ++i) {
      for (std::size_t c = 0; c < kChannels; ++c) {
        sums[c] +=
            probes_[i].weight * level_colour<kConfig>(unused_[0][c], unused_[1][c], unused_[2][c], unused_[3][c], 0, 0);
      }
    }
  }

  // The weighted probes at one level, exact.
  template <std::size_t kStored, std::size_t kChannels>
  void sum_level(const LevelShape& shape, bool linear, std::array<std::int64_t, kChannels>& sums) {
    const bool gaussian = takes_gaussian(sampler_, linear);
    for (std::size_t i = 0; i < used_; ++i) {
      const AxisTexels x = axis_texels<kConfig>(probes_[i].s, shape.width, wrap_s_, linear);
      const AxisTexels y = axis_texels<kConfig>(probes_[i].t, shape.height, wrap_t_, linear);
      const std::int64_t weight_x = kernel_weight<kConfig>(x.fraction, gaussian);
      const std::int64_t weight_y = kernel_weight<kConfig>(y.fraction, gaussian);
      std::array<Texel, 4> texels;
      if (shortcuts_.weightless_texels && (weight_x == 0 || weight_y == 0)) [[unlikely]] {
        texels = texels_of_weight<kStored>(shape, x, y, weight_x != 0, weight_y != 0);
      } else {
        for (std::size_t j = 0; j < 4; ++j) texels[j] = texel<kStored>(shape, x, y, j % 2, j / 2);
      }
      for (std::size_t c = 0; c < kChannels; ++c) {
        sums[c] += probes_[i].weight *
                   level_colour<kConfig>(texels[0][c], texels[1][c], texels[2][c], texels[3][c], weight_x, weight_y);
      }
    }
    counts_.absent_channels += static_cast<std::int64_t>(used_ * (4 - kChannels));
  }

  // Of the four texels those of two columns, of two rows, or only the first; the others are 0.
  template <std::size_t kStored>
  std::array<Texel, 4> texels_of_weight(const LevelShape& shape, const AxisTexels& x, const AxisTexels& y,
                                        bool two_columns, bool two_rows) {
    std::array<Texel, 4> texels{texel<kStored>(shape, x, y, 0, 0)};
    if (two_columns) texels[1] = texel<kStored>(shape, x, y, 1, 0);
    if (two_rows) texels[2] = texel<kStored>(shape, x, y, 0, 1);
    counts_.weightless_texels += two_columns || two_rows ? 2 : 3;
    return texels;
  }

  template <std::size_t kStored>
  Texel texel(const LevelShape& shape, const AxisTexels& x, const AxisTexels& y, std::size_t column, std::size_t row) {
    if (x.outside[column] || y.outside[row]) {
      lacks_alpha_ = lacks_alpha_ || lacks_alpha<kConfig>(sampler_.border);
      return border_;
    }
    const std::span<const std::uint8_t> line = lines_.line(shape.line(x.index[column], y.index[row]));
    if (!shortcuts_.decoded_codes) {
      const auto texel = decode_texel<kConfig>(line, x.index[column], y.index[row], sampler_);
      lacks_alpha_ = lacks_alpha_ || lacks_alpha<kConfig>(texel);
      return packed(supported_texel<kConfig>(texel));
    }
    ++counts_.decoded_codes;
    const std::size_t first = texel_slot(x.index[column], y.index[row]) * kStored;
    Texel texel{decoded_[0][0], decoded_[1][0], decoded_[2][0], decoded_[3][0]};
    for (std::size_t c = 0; c < kStored; ++c) texel[c] = decoded_[c][line[first + c]];
    if constexpr (kLooksForAlpha && kStored == 4) lacks_alpha_ = lacks_alpha_ || line[first + 3] != 255;
    return texel;
  }

  const SamplerState<kConfig>& sampler_;
  Lines& lines_;
  Shortcuts shortcuts_;
  Wrap wrap_s_, wrap_t_;
  Texel border_;
  int stored_ = 4;    // channels of the texel format
  int filtered_ = 4;  // of these, those that can differ from texel to texel
  bool leaves_channels_ = false;
  bool lacks_alpha_ = false;  // a texel of this lookup does
  std::array<Probe, static_cast<std::size_t>(kConfig.max_probes)> probes_{};
  std::size_t used_ = 0;
  std::array<Texel, 4> unused_{};                            // of a level of no weight
  Texel constant_{};                                         // of the channels that are not filtered
  std::array<std::array<std::uint16_t, 256>, 4> decoded_{};  // of each channel, by code
  ShortcutCounts counts_;
};

}  // namespace feline
