// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include "tables/beats.h"

namespace feline {

// The arguments of a shader's textureGrad: normalized coordinates and their derivatives by pixel, t along the texture's
// rows, row 0 at t = 0.
struct Lookup {
  float s = 0, t = 0, dsdx = 0, dtdx = 0, dsdy = 0, dtdy = 0;
};

template <Config kConfig>
RequestBeat<kConfig> make_request(const Lookup& lookup, std::int64_t tag) {
  RequestBeat<kConfig> request;
  const auto bits = [](float value) { return decltype(request.s)::from_raw(std::bit_cast<std::uint32_t>(value)); };
  request.tag = request.tag.from_raw(tag & request.tag.kFormatOf.max_raw());
  request.s = bits(lookup.s);
  request.t = bits(lookup.t);
  request.dsdx = bits(lookup.dsdx);
  request.dtdx = bits(lookup.dtdx);
  request.dsdy = bits(lookup.dsdy);
  request.dtdy = bits(lookup.dtdy);
  return request;
}

}  // namespace feline
