// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <tuple>

#include "tables/formats.h"

namespace feline {

// A field of a beat: its name and where it lives. The order of the fields is the order of the bits, first field
// highest.
template <typename Beat, typename Member>
struct Field {
  Name name;
  Member Beat::*member;
};

template <typename Beat, typename Member>
constexpr Field<Beat, Member> field(Name name, Member Beat::*member) {
  return {name, member};
}

// The stage boundaries, field by field, and the sampler state. Model, RTL package, traces, golden vectors and messages
// all come from these declarations. Arrays of channels are red, green, blue, alpha.

// Into group: the arguments of a shader's textureGrad. s and t are normalized, t along the texture's rows.
template <Config kConfig>
struct RequestBeat {
  using F = Formats<kConfig>;
  static constexpr Name kName{"request"};
  Fixed<F::kTag> tag;
  Fixed<F::kFloat> s, t, dsdx, dtdx, dsdy, dtdy;

  static constexpr auto fields() {
    return std::tuple{field("tag", &RequestBeat::tag),   field("s", &RequestBeat::s),
                      field("t", &RequestBeat::t),       field("dsdx", &RequestBeat::dsdx),
                      field("dtdx", &RequestBeat::dtdx), field("dsdy", &RequestBeat::dsdy),
                      field("dtdy", &RequestBeat::dtdy)};
  }
};

template <Config kConfig>
struct GroupBeat {
  using F = Formats<kConfig>;
  static constexpr Name kName{"group"};
  Fixed<F::kTag> tag;
  Fixed<F::kStatus> status;
  Fixed<F::kPosition> s, t;
  Fixed<F::kExponent> exponent;
  Fixed<F::kMantissa> dudx, dvdx, dudy, dvdy;

  static constexpr auto fields() {
    return std::tuple{
        field("tag", &GroupBeat::tag),   field("status", &GroupBeat::status),     field("s", &GroupBeat::s),
        field("t", &GroupBeat::t),       field("exponent", &GroupBeat::exponent), field("dudx", &GroupBeat::dudx),
        field("dvdx", &GroupBeat::dvdx), field("dudy", &GroupBeat::dudy),         field("dvdy", &GroupBeat::dvdy)};
  }
};

template <Config kConfig>
struct FootprintBeat {
  using F = Formats<kConfig>;
  static constexpr Name kName{"footprint"};
  Fixed<F::kTag> tag;
  Fixed<F::kStatus> status;
  Fixed<F::kPosition> s, t;
  Fixed<F::kExponent> exponent;
  Fixed<F::kVector> major_u, major_v;
  Fixed<F::kRadius> major_radius, minor_radius;

  static constexpr auto fields() {
    return std::tuple{field("tag", &FootprintBeat::tag),
                      field("status", &FootprintBeat::status),
                      field("s", &FootprintBeat::s),
                      field("t", &FootprintBeat::t),
                      field("exponent", &FootprintBeat::exponent),
                      field("major_u", &FootprintBeat::major_u),
                      field("major_v", &FootprintBeat::major_v),
                      field("major_radius", &FootprintBeat::major_radius),
                      field("minor_radius", &FootprintBeat::minor_radius)};
  }
};

template <Config kConfig>
struct PlanBeat {
  using F = Formats<kConfig>;
  static constexpr Name kName{"plan"};
  Fixed<F::kTag> tag;
  Fixed<F::kStatus> status;
  Fixed<F::kPosition> s, t;
  Fixed<F::kHalfStep> half_step_s, half_step_t;
  Fixed<F::kProbeCount> probes;
  Fixed<F::kWeightRow> weight_row;
  Fixed<F::kSampledLevel> level_of_detail;
  Fixed<F::kFlag> linear;

  static constexpr auto fields() {
    return std::tuple{field("tag", &PlanBeat::tag),
                      field("status", &PlanBeat::status),
                      field("s", &PlanBeat::s),
                      field("t", &PlanBeat::t),
                      field("half_step_s", &PlanBeat::half_step_s),
                      field("half_step_t", &PlanBeat::half_step_t),
                      field("probes", &PlanBeat::probes),
                      field("weight_row", &PlanBeat::weight_row),
                      field("level_of_detail", &PlanBeat::level_of_detail),
                      field("linear", &PlanBeat::linear)};
  }
};

template <Config kConfig>
struct WalkBeat {
  using F = Formats<kConfig>;
  static constexpr Name kName{"walk"};
  Fixed<F::kTag> tag;
  Fixed<F::kStatus> status;
  Fixed<F::kProbeIndex> probe;
  Fixed<F::kFlag> first, last;
  Fixed<F::kPosition> s, t;
  Fixed<F::kWeight> weight;
  Fixed<F::kSampledLevel> level_of_detail;
  Fixed<F::kFlag> linear;

  static constexpr auto fields() {
    return std::tuple{field("tag", &WalkBeat::tag),
                      field("status", &WalkBeat::status),
                      field("probe", &WalkBeat::probe),
                      field("first", &WalkBeat::first),
                      field("last", &WalkBeat::last),
                      field("s", &WalkBeat::s),
                      field("t", &WalkBeat::t),
                      field("weight", &WalkBeat::weight),
                      field("level_of_detail", &WalkBeat::level_of_detail),
                      field("linear", &WalkBeat::linear)};
  }
};

// Two levels, fine and coarse. Texel ij of a level is column i, row j of its 2 x 2 square: 00, 10, 01, 11. x and y are
// texel indices after wrapping; border: bit 0 and 1 say that column 0 and 1 lie outside, bit 2 and 3 the same of rows.
// A level whose texels have no weight is not used and its line addresses are 0.
template <Config kConfig>
struct AddressBeat {
  using F = Formats<kConfig>;
  static constexpr Name kName{"address"};
  static constexpr Format kBorder{"border", false, 4, 0, "bits"};
  Fixed<F::kTag> tag;
  Fixed<F::kStatus> status;
  Fixed<F::kProbeIndex> probe;
  Fixed<F::kFlag> first, last;
  Fixed<F::kWeight> weight;
  Fixed<F::kFlag> linear;
  Fixed<F::kLevel> level;
  Fixed<F::kLevelFraction> level_fraction;
  std::array<Fixed<F::kTexelIndex>, 2> fine_x, fine_y;
  Fixed<kBorder> fine_border;
  Fixed<F::kTexelFractionOf> fine_fraction_x, fine_fraction_y;
  std::array<Fixed<F::kLine>, 4> fine_line;
  Fixed<F::kFlag> coarse_used;
  std::array<Fixed<F::kTexelIndex>, 2> coarse_x, coarse_y;
  Fixed<kBorder> coarse_border;
  Fixed<F::kTexelFractionOf> coarse_fraction_x, coarse_fraction_y;
  std::array<Fixed<F::kLine>, 4> coarse_line;

  static constexpr auto fields() {
    return std::tuple{field("tag", &AddressBeat::tag),
                      field("status", &AddressBeat::status),
                      field("probe", &AddressBeat::probe),
                      field("first", &AddressBeat::first),
                      field("last", &AddressBeat::last),
                      field("weight", &AddressBeat::weight),
                      field("linear", &AddressBeat::linear),
                      field("level", &AddressBeat::level),
                      field("level_fraction", &AddressBeat::level_fraction),
                      field("fine_x", &AddressBeat::fine_x),
                      field("fine_y", &AddressBeat::fine_y),
                      field("fine_border", &AddressBeat::fine_border),
                      field("fine_fraction_x", &AddressBeat::fine_fraction_x),
                      field("fine_fraction_y", &AddressBeat::fine_fraction_y),
                      field("fine_line", &AddressBeat::fine_line),
                      field("coarse_used", &AddressBeat::coarse_used),
                      field("coarse_x", &AddressBeat::coarse_x),
                      field("coarse_y", &AddressBeat::coarse_y),
                      field("coarse_border", &AddressBeat::coarse_border),
                      field("coarse_fraction_x", &AddressBeat::coarse_fraction_x),
                      field("coarse_fraction_y", &AddressBeat::coarse_fraction_y),
                      field("coarse_line", &AddressBeat::coarse_line)};
  }
};

// Texels are named as in AddressBeat; those of a level that is not used are 0.
template <Config kConfig>
struct FetchBeat {
  using F = Formats<kConfig>;
  using Texel = std::array<Fixed<F::kChannel>, 4>;
  static constexpr Name kName{"fetch"};
  Fixed<F::kTag> tag;
  Fixed<F::kStatus> status;
  Fixed<F::kProbeIndex> probe;
  Fixed<F::kFlag> first, last;
  Fixed<F::kWeight> weight;
  Fixed<F::kFlag> linear;
  Fixed<F::kLevelFraction> level_fraction;
  Fixed<F::kTexelFractionOf> fine_fraction_x, fine_fraction_y, coarse_fraction_x, coarse_fraction_y;
  Texel fine_00, fine_10, fine_01, fine_11, coarse_00, coarse_10, coarse_01, coarse_11;

  static constexpr auto fields() {
    return std::tuple{field("tag", &FetchBeat::tag),
                      field("status", &FetchBeat::status),
                      field("probe", &FetchBeat::probe),
                      field("first", &FetchBeat::first),
                      field("last", &FetchBeat::last),
                      field("weight", &FetchBeat::weight),
                      field("linear", &FetchBeat::linear),
                      field("level_fraction", &FetchBeat::level_fraction),
                      field("fine_fraction_x", &FetchBeat::fine_fraction_x),
                      field("fine_fraction_y", &FetchBeat::fine_fraction_y),
                      field("coarse_fraction_x", &FetchBeat::coarse_fraction_x),
                      field("coarse_fraction_y", &FetchBeat::coarse_fraction_y),
                      field("fine_00", &FetchBeat::fine_00),
                      field("fine_10", &FetchBeat::fine_10),
                      field("fine_01", &FetchBeat::fine_01),
                      field("fine_11", &FetchBeat::fine_11),
                      field("coarse_00", &FetchBeat::coarse_00),
                      field("coarse_10", &FetchBeat::coarse_10),
                      field("coarse_01", &FetchBeat::coarse_01),
                      field("coarse_11", &FetchBeat::coarse_11)};
  }
};

template <Config kConfig>
struct FilterBeat {
  using F = Formats<kConfig>;
  static constexpr Name kName{"filter"};
  Fixed<F::kTag> tag;
  Fixed<F::kStatus> status;
  Fixed<F::kProbeIndex> probe;
  Fixed<F::kFlag> first, last;
  Fixed<F::kWeight> weight;
  std::array<Fixed<F::kFiltered>, 4> colour;

  static constexpr auto fields() {
    return std::tuple{field("tag", &FilterBeat::tag),      field("status", &FilterBeat::status),
                      field("probe", &FilterBeat::probe),  field("first", &FilterBeat::first),
                      field("last", &FilterBeat::last),    field("weight", &FilterBeat::weight),
                      field("colour", &FilterBeat::colour)};
  }
};

template <Config kConfig>
struct AccumulateBeat {
  using F = Formats<kConfig>;
  static constexpr Name kName{"accumulate"};
  Fixed<F::kTag> tag;
  Fixed<F::kStatus> status;
  std::array<Fixed<F::kPixel>, 4> colour;

  static constexpr auto fields() {
    return std::tuple{field("tag", &AccumulateBeat::tag), field("status", &AccumulateBeat::status),
                      field("colour", &AccumulateBeat::colour)};
  }
};

}  // namespace feline
