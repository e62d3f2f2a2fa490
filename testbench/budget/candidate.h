// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/sampler.h"
#include "testbench/budget/variant.h"

namespace feline {

// The sets of probe parameters that are searched.
enum class ParameterSet : std::uint8_t { kExact, kHighQuality, kHighEfficiency };
inline constexpr std::array<std::string_view, 3> kParameterSetNames{"exact", "high_quality", "high_efficiency"};

// One point of the space: a unit's widths, and what its one sampler state asks for.
struct Candidate {
  Widths widths;
  Mode mode = Mode::kTable;
  Kernel kernel = Kernel::kBilinear;
  ParameterSet parameters = ParameterSet::kExact;
  int max_probes = kDefaultConfig.max_probes;

  constexpr bool operator==(const Candidate&) const = default;
};

// small: the widest and the narrowest unit, fewer parameters and probes; full: everything.
enum class Space : std::uint8_t { kSmall, kFull };
inline constexpr std::array<std::string_view, 2> kSpaceNames{"small", "full"};

// Each choice that makes a difference, once, in the order of modes:
//   a kernel where texels are interpolated, parameters in Simple and Table, probes where there can be several;
//   weight bits where there are several probes, and the table's sides in Table: otherwise they are the least.
std::vector<Candidate> candidates_of(Space space);

// The full unit in Table mode with the exact parameters, which budgets count from. It is in every space.
constexpr Candidate full_candidate(Kernel kernel) { return {{}, Mode::kTable, kernel}; }

// "table, bilinear, exact, 16 probes" and "mantissa 8, table 16, sub-texel 8, level 8, weight 8"; what makes no
// difference is left out.
std::string sampler_name(const Candidate& candidate);
std::string widths_name(const Candidate& candidate);

bool takes_kernel(Mode mode);
bool takes_parameters(Mode mode);
bool takes_probes(Mode mode);

// What an application asks for, wraps and border aside.
SamplerOptions sampler_options(const Candidate& candidate);

// The least unit that gives the candidate's pixels: of its widths, with what its sampler and the lookups need and with
// whole ROMs. Whatever else is asked of it, it flags. `sampler` is the default configuration's.
Config hardware_of(const Candidate& candidate, const SamplerState<kDefaultConfig>& sampler, const VariantUse& use);

// Whether no width and no feature of a unit is more than another's: then it is taken to have no more gates. Which words
// of the ROMs are there is not looked at: hardware_of has them all.
bool needs_no_more(const Config& unit, const Config& than);

}  // namespace feline
