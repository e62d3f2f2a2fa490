// SPDX-License-Identifier: Apache-2.0
// The sampler state, plan and walk.
#include <algorithm>
#include <cmath>

#include "tests/support/oracle.h"

namespace feline::oracle {
namespace {

Rational times(const Rational& x, Wide numerator, Wide denominator = 1) {
  return {x.numerator * numerator, x.denominator * denominator};
}

// log2(radius/128 * 2^exponent) in 1/256, of a whole radius: 9 significant bits, then the correctly rounded logarithm.
Wide level_of(Wide radius, Wide exponent) {
  if (radius == 0) return -32 * 256;
  Rational significand{radius, 1};
  Wide octave = exponent - 7 + 8;
  while (significand.numerator < 256 * significand.denominator) significand.numerator *= 2, --octave;
  while (significand.numerator >= 512 * significand.denominator) significand.denominator *= 2, ++octave;
  Wide rounded = nearest_up(significand);
  if (rounded == 512) rounded = 256, ++octave;
  const Wide level = octave * 256 + tables().log2[static_cast<std::size_t>(rounded - 256)];
  return std::clamp<Wide>(level, -32 * 256, 32 * 256 - 1);
}

struct Size {
  long reciprocal, shift;
};
Size size_of(int size) {
  long shift = 0;
  while ((1L << shift) < size) ++shift;
  return {static_cast<long>(nearest_up({Wide{1} << (15 + shift), size})), shift};
}

}  // namespace

State sampler_state(const SamplerOptions& options, TexelFormat format, bool srgb, int width, int height, int levels,
                    const std::vector<std::int64_t>& bases) {
  State state;
  const auto nearest = [](double value, int scale) { return static_cast<std::int64_t>(std::llround(value * scale)); };
  set(state.mode, static_cast<int>(options.mode));
  set(state.kernel, static_cast<int>(options.kernel));
  set(state.magnify, static_cast<int>(options.magnify));
  set(state.wrap_s, static_cast<int>(options.wrap_s));
  set(state.wrap_t, static_cast<int>(options.wrap_t));
  set(state.texel_format, static_cast<int>(format));
  set(state.srgb, srgb ? 1 : 0);
  set(state.width, width);
  set(state.height, height);
  int smallest = 0;
  while ((std::max(width, height) >> smallest) > 1) ++smallest;
  set(state.smallest_level, smallest);
  set(state.last_level, levels - 1);
  set(state.width_reciprocal, size_of(width).reciprocal);
  set(state.width_shift, size_of(width).shift);
  set(state.height_reciprocal, size_of(height).reciprocal);
  set(state.height_shift, size_of(height).shift);
  const ProbeParameters& probes = options.probes;
  set(state.probe_rounding, static_cast<int>(probes.rounding));
  set(state.max_probes, options.max_probes);
  set(state.length_factor, nearest(probes.length_factor, 256));
  set(state.blur_factor, nearest(probes.blur_factor, 256));
  set(state.inverse_alias_factor, nearest(1 / probes.alias_factor, 256));
  set(state.probe_factor, nearest(1 / (probes.blur_factor * probes.alias_factor), 256));
  set(state.level_bias, std::min<std::int64_t>(nearest(options.level_bias, 256), 8191));
  set(state.min_level, std::min<std::int64_t>(nearest(options.min_level, 256), 4095));
  set(state.max_level, std::min<std::int64_t>(nearest(options.max_level, 256), 4095));
  const std::array<double, 4> absent{0, 0, 0, 1};
  const std::size_t present = format == TexelFormat::kR8 ? 1 : format == TexelFormat::kRg8 ? 2 : 4;
  for (std::size_t c = 0; c < 4; ++c)
    set(state.border[c], nearest(c < present ? options.border[c] : absent[c], 255 * 16));
  for (std::size_t k = 0; k < bases.size(); ++k) set(state.level_base[k], bases[k]);
  return state;
}

Plan plan(const Footprint& footprint, const State& state) {
  const auto mode = static_cast<Mode>(state.mode.raw());
  const bool ext = mode == Mode::kExt;
  const Wide exponent = footprint.exponent.raw();
  const Wide whole_major = footprint.major_radius.raw();
  const auto& reciprocal = tables().reciprocal;

  // One texel in the radii's unit; beyond 2^16 it is larger than any radius.
  const Rational texel{Wide{1} << std::clamp<Wide>(7 - exponent, 0, 16), Wide{1} << std::max<Wide>(exponent - 7, 0)};
  const bool magnified = Rational{whole_major, 1} < texel;
  const Rational minor = std::max(Rational{footprint.minor_radius.raw(), 1}, texel);
  Rational major{whole_major, 1};
  if (!ext) major = std::max(Rational{nearest_up({whole_major * state.length_factor.raw(), 256}), 1}, minor);

  // major/minor.
  const Rational ratio{major.numerator * minor.denominator, major.denominator * minor.numerator};
  const Rational twice = times(ratio, 2);
  const bool ceiling = state.probe_rounding.raw() != 0;
  Wide wanted = 1;
  if (ext) {
    wanted = ceil_of(ratio);
  } else if (ceiling) {
    wanted = ceil_of(times(twice, state.probe_factor.raw(), 256)) - 1;
  } else {
    wanted = nearest_up({twice.numerator - twice.denominator, twice.denominator});
  }
  const Wide most = state.max_probes.raw();
  Wide probes = magnified ? 1 : std::clamp<Wide>(wanted, 1, most);

  Wide fitted = whole_major;
  if (!magnified && ext) {
    fitted = nearest_up({whole_major * reciprocal[static_cast<std::size_t>(probes)], 65536});
  } else if (!magnified) {
    const Wide widened = nearest_up(times(major, 2 * Wide{reciprocal[static_cast<std::size_t>(probes + 1)]}, 65536));
    if (!ceiling) {
      fitted = Rational{widened, 1} < minor ? ceil_of(minor) : widened;
    } else if (wanted > most) {
      fitted = nearest_up({widened * state.inverse_alias_factor.raw(), 256});
    } else {
      fitted = std::min(widened, nearest_up(times(minor, state.blur_factor.raw(), 256)));
    }
  }
  const Wide level = level_of(fitted, exponent);
  if (level > state.smallest_level.raw() * 256) probes = 1;

  const Wide lambda = std::clamp<Wide>(level + state.level_bias.raw(), state.min_level.raw(), state.max_level.raw());
  const bool one_level = mode == Mode::kNearest || mode == Mode::kBilinear;
  // The nearest level, of two equally near ones the finer: ceil(lambda - 1/2).
  const Wide sampled = one_level ? 256 * ceil_of({lambda - 128, 256}) : lambda;

  Wide row = probes - 1 + 61;
  if (!ext) {
    const Wide quarters = floor_of(times({twice.numerator - twice.denominator, twice.denominator}, 4));
    row = probes == 1 ? 0 : std::clamp(quarters, 4 * probes - 3, 4 * probes) - 4;
  }

  Wide factor = 0;
  if (probes > 1 && ext) factor = nearest_up({reciprocal[static_cast<std::size_t>(probes + 1)], 2});
  if (probes > 1 && !ext) {
    const Wide line =
        floor_of({4096 * (major.numerator - fitted * major.denominator), major.denominator * whole_major});
    factor = nearest_up({line * reciprocal[static_cast<std::size_t>(probes - 1)], 4096});
  }
  // vector/2^8 texels * 2^exponent * factor/2^16 * reciprocal/2^15 * 2^-shift, in 2^-24.
  const auto half_step = [&](Wide vector, Wide size_reciprocal, Wide shift) -> Wide {
    const Wide product = vector * factor * size_reciprocal;
    const Wide down = 8 + 16 + 15 - 24 + shift - exponent;
    if (product == 0 || down > 70) return 0;
    return nearest_away({product * (Wide{1} << std::max<Wide>(-down, 0)), Wide{1} << std::max<Wide>(down, 0)});
  };
  Plan beat;
  beat.tag = footprint.tag;
  beat.status = footprint.status;
  beat.s = footprint.s;
  beat.t = footprint.t;
  set(beat.half_step_s, half_step(footprint.major_u.raw(), state.width_reciprocal.raw(), state.width_shift.raw()));
  set(beat.half_step_t, half_step(footprint.major_v.raw(), state.height_reciprocal.raw(), state.height_shift.raw()));
  set(beat.probes, probes);
  set(beat.weight_row, row);
  set(beat.level_of_detail, std::min<Wide>(sampled, state.last_level.raw() * 256));
  const bool magnifies = lambda <= 0;
  set(beat.linear, (magnifies ? state.magnify.raw() == 1 : mode != Mode::kNearest) ? 1 : 0);
  return beat;
}

Walk walk(const Plan& plan, int probe) {
  Walk beat;
  const auto count = static_cast<int>(plan.probes.raw());
  const int n = 2 * probe - count + 1;
  const auto stepped = [&](Wide centre, Wide half_step) {
    const Wide turn = Wide{1} << 45;
    const Wide left = ((centre + n * half_step) % turn + turn) % turn;
    return left >= turn / 2 ? left - turn : left;
  };
  beat.tag = plan.tag;
  beat.status = plan.status;
  set(beat.probe, probe);
  set(beat.first, probe == 0 ? 1 : 0);
  set(beat.last, probe + 1 == count ? 1 : 0);
  set(beat.s, stepped(plan.s.raw(), plan.half_step_s.raw()));
  set(beat.t, stepped(plan.t.raw(), plan.half_step_t.raw()));
  const auto column = static_cast<std::size_t>((std::abs(n) + 1) / 2);
  set(beat.weight, tables().weight[static_cast<std::size_t>(plan.weight_row.raw())][column]);
  beat.level_of_detail = plan.level_of_detail;
  beat.linear = plan.linear;
  return beat;
}

}  // namespace feline::oracle
