// SPDX-License-Identifier: Apache-2.0
// address, fetch, filter and accumulate.
#include <algorithm>

#include "tests/support/oracle.h"

namespace feline::oracle {
namespace {

constexpr Wide kTexture = Wide{1} << 24;

Wide modulo(Wide value, Wide turn) { return value - turn * floor_of({value, turn}); }

struct Axis {
  std::array<Wide, 2> index;
  std::array<bool, 2> outside;
  Wide fraction;
};

Axis axis_of(Wide position, Wide size, Wrap wrap, bool linear) {
  Wide wrapped = position;
  if (wrap == Wrap::kRepeat) wrapped = modulo(position, kTexture);
  if (wrap == Wrap::kMirroredRepeat) {
    wrapped = modulo(position, 2 * kTexture);
    if (wrapped > kTexture) wrapped = 2 * kTexture - wrapped;
  }
  if (wrap == Wrap::kClampToEdge) wrapped = std::min(std::max<Wide>(position, 0), kTexture);
  if (wrap == Wrap::kClampToBorder) wrapped = std::min(std::max(position, -kTexture), 2 * kTexture - 1);
  // In 1/256 of a texel, from the first texel's centre or edge.
  const Wide coordinate = linear ? nearest_up({wrapped * size * 256, kTexture}) - 128 : 0;
  const Wide low = linear ? floor_of({coordinate, 256}) : floor_of({wrapped * size, kTexture});
  Axis axis{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Wide index = low + static_cast<Wide>(i);
    const bool inside = index >= 0 && index < size;
    axis.outside[i] = wrap == Wrap::kClampToBorder && !inside;
    axis.index[i] = wrap == Wrap::kRepeat ? modulo(index, size) : std::max<Wide>(std::min(index, size - 1), 0);
  }
  axis.fraction = linear ? coordinate - 256 * low : 0;
  return axis;
}

struct Square {
  Axis x, y;
  std::array<Wide, 4> line;
};

Square square_of(const Walk& walk, const State& state, Wide level) {
  Wide width = state.width.raw();
  Wide height = state.height.raw();
  for (Wide k = 0; k < level; ++k) {
    width = std::max<Wide>(width / 2, 1);
    height = std::max<Wide>(height / 2, 1);
  }
  const bool linear = walk.linear.raw() == 1;
  Square square{axis_of(walk.s.raw(), width, static_cast<Wrap>(state.wrap_s.raw()), linear),
                axis_of(walk.t.raw(), height, static_cast<Wrap>(state.wrap_t.raw()), linear),
                {}};
  const Wide tiles_a_row = ceil_of({width, 4});
  for (std::size_t i = 0; i < 4; ++i) {
    square.line[i] = state.level_base[static_cast<std::size_t>(level)].raw() + square.y.index[i / 2] / 4 * tiles_a_row +
                     square.x.index[i % 2] / 4;
  }
  return square;
}

using Texel = std::array<Fixed<Formats<kDefaultConfig>::kChannel>, 4>;

Texel texel_of(const MipLevel& level, Wide x, Wide y, const State& state) {
  const auto format = static_cast<TexelFormat>(state.texel_format.raw());
  const std::size_t channels = format == TexelFormat::kR8 ? 1 : format == TexelFormat::kRg8 ? 2 : 4;
  const auto at = (static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x));
  Texel texel;
  for (std::size_t c = 0; c < 4; ++c) {
    const long missing = c == 3 ? 255 : 0;
    const bool decodes = state.srgb.raw() == 1 && c < 3;
    if (c >= channels) {
      set(texel[c], missing * 16);
    } else {
      const std::uint8_t code = level.texels[at * channels + c];
      set(texel[c], decodes ? tables().srgb[code] : code * 16);
    }
  }
  return texel;
}

}  // namespace

Address address(const Walk& walk, const State& state) {
  Address beat;
  beat.tag = walk.tag;
  beat.status = walk.status;
  beat.probe = walk.probe;
  beat.first = walk.first;
  beat.last = walk.last;
  beat.weight = walk.weight;
  beat.linear = walk.linear;
  const Wide level = walk.level_of_detail.raw() / 256;
  const Wide between = walk.level_of_detail.raw() % 256;
  set(beat.level, level);
  set(beat.level_fraction, between);
  const auto outside = [](const Square& s) {
    return s.x.outside[0] + 2 * s.x.outside[1] + 4 * s.y.outside[0] + 8 * s.y.outside[1];
  };
  const Square fine = square_of(walk, state, level);
  for (std::size_t i = 0; i < 2; ++i) set(beat.fine_x[i], fine.x.index[i]), set(beat.fine_y[i], fine.y.index[i]);
  for (std::size_t i = 0; i < 4; ++i) set(beat.fine_line[i], fine.line[i]);
  set(beat.fine_border, outside(fine));
  set(beat.fine_fraction_x, fine.x.fraction);
  set(beat.fine_fraction_y, fine.y.fraction);
  if (between == 0) return beat;
  set(beat.coarse_used, 1);
  const Square coarse = square_of(walk, state, level + 1);
  for (std::size_t i = 0; i < 2; ++i)
    set(beat.coarse_x[i], coarse.x.index[i]), set(beat.coarse_y[i], coarse.y.index[i]);
  for (std::size_t i = 0; i < 4; ++i) set(beat.coarse_line[i], coarse.line[i]);
  set(beat.coarse_border, outside(coarse));
  set(beat.coarse_fraction_x, coarse.x.fraction);
  set(beat.coarse_fraction_y, coarse.y.fraction);
  return beat;
}

Fetch fetch(const Address& address, const State& state, const Texture& texture) {
  Fetch beat;
  beat.tag = address.tag;
  beat.status = address.status;
  beat.probe = address.probe;
  beat.first = address.first;
  beat.last = address.last;
  beat.weight = address.weight;
  beat.linear = address.linear;
  beat.level_fraction = address.level_fraction;
  beat.fine_fraction_x = address.fine_fraction_x;
  beat.fine_fraction_y = address.fine_fraction_y;
  beat.coarse_fraction_x = address.coarse_fraction_x;
  beat.coarse_fraction_y = address.coarse_fraction_y;
  const auto level = static_cast<std::size_t>(address.level.raw());
  const auto read = [&](bool outside, Wide x, Wide y, std::size_t k) {
    return outside ? state.border : texel_of(texture.levels[k], x, y, state);
  };
  const auto square = [&](const auto& xs, const auto& ys, std::int64_t border, std::size_t k, Texel& t00, Texel& t10,
                          Texel& t01, Texel& t11) {
    const bool left = border % 2 != 0;
    const bool right = border / 2 % 2 != 0;
    const bool top = border / 4 % 2 != 0;
    const bool bottom = border / 8 % 2 != 0;
    t00 = read(left || top, xs[0].raw(), ys[0].raw(), k);
    t10 = read(right || top, xs[1].raw(), ys[0].raw(), k);
    t01 = read(left || bottom, xs[0].raw(), ys[1].raw(), k);
    t11 = read(right || bottom, xs[1].raw(), ys[1].raw(), k);
  };
  square(address.fine_x, address.fine_y, address.fine_border.raw(), level, beat.fine_00, beat.fine_10, beat.fine_01,
         beat.fine_11);
  if (address.coarse_used.raw() == 1)
    square(address.coarse_x, address.coarse_y, address.coarse_border.raw(), level + 1, beat.coarse_00, beat.coarse_10,
           beat.coarse_01, beat.coarse_11);
  return beat;
}

Filter filter(const Fetch& fetch, const State& state) {
  Filter beat;
  beat.tag = fetch.tag;
  beat.status = fetch.status;
  beat.probe = fetch.probe;
  beat.first = fetch.first;
  beat.last = fetch.last;
  beat.weight = fetch.weight;
  const bool gaussian = state.kernel.raw() == 1 && fetch.linear.raw() == 1;
  const auto share = [&](std::int64_t fraction) -> Wide {
    return gaussian ? tables().gaussian[static_cast<std::size_t>(fraction)] : fraction;
  };
  const Wide fx = share(fetch.fine_fraction_x.raw());
  const Wide fy = share(fetch.fine_fraction_y.raw());
  const Wide cx = share(fetch.coarse_fraction_x.raw());
  const Wide cy = share(fetch.coarse_fraction_y.raw());
  const Wide l = fetch.level_fraction.raw();
  // One sum of eight texels, each with the product of its three shares.
  for (std::size_t c = 0; c < 4; ++c) {
    const Wide sum =
        (256 - l) * (256 - fx) * (256 - fy) * fetch.fine_00[c].raw() +
        (256 - l) * fx * (256 - fy) * fetch.fine_10[c].raw() + (256 - l) * (256 - fx) * fy * fetch.fine_01[c].raw() +
        (256 - l) * fx * fy * fetch.fine_11[c].raw() + l * (256 - cx) * (256 - cy) * fetch.coarse_00[c].raw() +
        l * cx * (256 - cy) * fetch.coarse_10[c].raw() + l * (256 - cx) * cy * fetch.coarse_01[c].raw() +
        l * cx * cy * fetch.coarse_11[c].raw();
    set(beat.colour[c], sum);
  }
  return beat;
}

Pixel accumulate(const std::vector<Filter>& probes) {
  Pixel pixel;
  pixel.tag = probes.back().tag;
  for (const Filter& probe : probes) set(pixel.status, pixel.status.raw() | probe.status.raw());
  for (std::size_t c = 0; c < 4; ++c) {
    Wide sum = 0;
    for (const Filter& probe : probes) sum += Wide{probe.weight.raw()} * probe.colour[c].raw();
    set(pixel.colour[c], nearest_up({sum, Wide{1} << 28}));
  }
  return pixel;
}

Pixel sample(const Request& request, const State& state, const Texture& texture) {
  const Plan planned = plan(footprint(group(request, state), state), state);
  std::vector<Filter> probes;
  for (int i = 0; i < static_cast<int>(planned.probes.raw()); ++i)
    probes.push_back(filter(fetch(address(walk(planned, i), state), state, texture), state));
  return accumulate(probes);
}

}  // namespace feline::oracle
