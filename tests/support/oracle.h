// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/memory.h"
#include "model/sampler.h"
#include "tables/sampler_state.h"
#include "testbench/prove/exact_tables.h"
#include "testbench/prove/set_field.h"

// The third witness: every stage stated once more, exactly, from the contract comments and the papers. It shares with
// the model the names of fields and formats, and no arithmetic: rationals of 128-bit integers here, tables by MPFR.
namespace feline::oracle {

__extension__ using Wide = __int128;

// numerator/denominator, denominator > 0, never reduced; small enough here to be compared by multiplying across.
struct Rational {
  Wide numerator = 0;
  Wide denominator = 1;
  friend bool operator<(const Rational& a, const Rational& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }
};
Wide floor_of(const Rational& x);
Wide ceil_of(const Rational& x);
Wide nearest_up(const Rational& x);    // ties towards plus infinity
Wide nearest_away(const Rational& x);  // ties away from zero

using prove::set;

using State = SamplerState<kDefaultConfig>;
using Request = RequestBeat<kDefaultConfig>;
using Group = GroupBeat<kDefaultConfig>;
using Footprint = FootprintBeat<kDefaultConfig>;
using Plan = PlanBeat<kDefaultConfig>;
using Walk = WalkBeat<kDefaultConfig>;
using Address = AddressBeat<kDefaultConfig>;
using Fetch = FetchBeat<kDefaultConfig>;
using Filter = FilterBeat<kDefaultConfig>;
using Pixel = AccumulateBeat<kDefaultConfig>;

// level_base is left 0 where `bases` ends.
State sampler_state(const SamplerOptions& options, TexelFormat format, bool srgb, int width, int height, int levels,
                    const std::vector<std::int64_t>& bases);
Group group(const Request& request, const State& state);
Footprint footprint(const Group& group, const State& state);
Plan plan(const Footprint& footprint, const State& state);
Walk walk(const Plan& plan, int probe);
Address address(const Walk& walk, const State& state);
// From the texture itself, by texel indices: neither lines nor layout.
Fetch fetch(const Address& address, const State& state, const Texture& texture);
Filter filter(const Fetch& fetch, const State& state);
Pixel accumulate(const std::vector<Filter>& probes);
// All of it.
Pixel sample(const Request& request, const State& state, const Texture& texture);

}  // namespace feline::oracle
