// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/candidate.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "tables/supported.h"
#include "testbench/prune/prune.h"

namespace feline {
namespace {

constexpr std::array kParameterSets{kExact, kHighQuality, kHighEfficiency};
constexpr std::array kSearchedProbes{1, 2, 3, 4, 6, 8, 12, kDefaultConfig.max_probes};
constexpr std::array kFewProbes{2, 4, kDefaultConfig.max_probes};
constexpr std::array kFewParameters{ParameterSet::kExact, ParameterSet::kHighEfficiency};
constexpr std::array kAllParameters{ParameterSet::kExact, ParameterSet::kHighQuality, ParameterSet::kHighEfficiency};
constexpr std::array kKernels{Kernel::kBilinear, Kernel::kGaussian};

constexpr Widths kWidest{};
constexpr Widths kNarrowest{Widths::kMantissaBits.front(), Widths::kTableSides.front(), Widths::kSubtexelBits.front(),
                            Widths::kLevelFractionBits.front(), Widths::kWeightBits.front()};

std::vector<Widths> all_widths() {
  std::vector<Widths> all;
  for (const int mantissa : Widths::kMantissaBits) {
    for (const int table : Widths::kTableSides) {
      for (const int subtexel : Widths::kSubtexelBits) {
        for (const int level : Widths::kLevelFractionBits) {
          for (const int weight : Widths::kWeightBits) all.push_back({mantissa, table, subtexel, level, weight});
        }
      }
    }
  }
  return all;
}

// The same pixels in the least unit, by the names of the fields.
Candidate reduced(Candidate candidate) {
  if (!takes_kernel(candidate.mode)) candidate.kernel = Kernel::kBilinear;
  if (!takes_parameters(candidate.mode)) candidate.parameters = ParameterSet::kExact;
  if (!takes_probes(candidate.mode)) candidate.max_probes = 1;
  if (candidate.max_probes == 1) candidate.widths.weight_bits = kNarrowest.weight_bits;
  if (candidate.mode != Mode::kTable) candidate.widths.table_side = kNarrowest.table_side;
  return candidate;
}

}  // namespace

bool takes_kernel(Mode mode) { return mode != Mode::kNearest; }
bool takes_parameters(Mode mode) { return mode == Mode::kSimple || mode == Mode::kTable; }
bool takes_probes(Mode mode) { return mode == Mode::kExt || takes_parameters(mode); }

std::vector<Candidate> candidates_of(Space space) {
  const bool is_full = space == Space::kFull;
  const std::vector<Widths> widths = is_full ? all_widths() : std::vector<Widths>{kNarrowest, kWidest};
  const std::span<const ParameterSet> parameters =
      is_full ? std::span<const ParameterSet>(kAllParameters) : std::span<const ParameterSet>(kFewParameters);
  const std::span<const int> probes =
      is_full ? std::span<const int>(kSearchedProbes) : std::span<const int>(kFewProbes);
  std::vector<Candidate> candidates;
  const auto add = [&](const Candidate& candidate) {
    if (!has_mode(kDefaultConfig.features, candidate.mode) || candidate.max_probes > kDefaultConfig.max_probes) return;
    if (candidate.kernel == Kernel::kGaussian && !kDefaultConfig.features.gaussian) return;
    // What makes no difference is met once.
    const Candidate least = reduced(candidate);
    if (std::ranges::find(candidates, least) == candidates.end()) candidates.push_back(least);
  };
  for (std::size_t mode = 0; mode < kModeNames.size(); ++mode) {
    for (const Kernel kernel : kKernels) {
      for (const ParameterSet set : parameters) {
        for (const int most : probes) {
          for (const Widths& each : widths) add({each, static_cast<Mode>(mode), kernel, set, most});
        }
      }
    }
  }
  return candidates;
}

std::string sampler_name(const Candidate& candidate) {
  std::string name(kModeNames[static_cast<std::size_t>(candidate.mode)]);
  if (takes_kernel(candidate.mode))
    name += fmt::format(", {}", kKernelNames[static_cast<std::size_t>(candidate.kernel)]);
  if (takes_parameters(candidate.mode)) {
    name += fmt::format(", {}", kParameterSetNames[static_cast<std::size_t>(candidate.parameters)]);
  }
  if (takes_probes(candidate.mode)) {
    name += fmt::format(", {} probe{}", candidate.max_probes, candidate.max_probes == 1 ? "" : "s");
  }
  return name;
}

std::string widths_name(const Candidate& candidate) {
  const Widths& widths = candidate.widths;
  std::string name = fmt::format("mantissa {}", widths.mantissa_bits);
  if (candidate.mode == Mode::kTable) name += fmt::format(", table {}", widths.table_side);
  name += fmt::format(", sub-texel {}, level {}", widths.subtexel_bits, widths.level_fraction_bits);
  if (candidate.max_probes > 1) name += fmt::format(", weight {}", widths.weight_bits);
  return name;
}

SamplerOptions sampler_options(const Candidate& candidate) {
  SamplerOptions options;
  options.mode = candidate.mode;
  options.kernel = candidate.kernel;
  options.magnify = candidate.mode == Mode::kNearest ? Magnify::kNearest : Magnify::kLinear;
  options.probes = kParameterSets[static_cast<std::size_t>(candidate.parameters)];
  options.max_probes = candidate.max_probes;
  return options;
}

Config hardware_of(const Candidate& candidate, const SamplerState<kDefaultConfig>& sampler, const VariantUse& use) {
  // What pruning reads of a profile, each value met once.
  Profile profile;
  const auto meet = [&](Reach reach, std::int64_t value) { profile[reach][value] = 1; };
  meet(Reach::kMode, sampler.mode.raw());
  meet(Reach::kKernel, sampler.kernel.raw());
  meet(Reach::kProbeRounding, sampler.probe_rounding.raw());
  meet(Reach::kLengthFactor, sampler.length_factor.raw());
  meet(Reach::kWrap, sampler.wrap_s.raw());
  meet(Reach::kWrap, sampler.wrap_t.raw());
  meet(Reach::kTexelFormat, sampler.texel_format.raw());
  meet(Reach::kSrgb, sampler.srgb.raw());
  meet(Reach::kWidth, sampler.width.raw());
  meet(Reach::kHeight, sampler.height.raw());
  meet(Reach::kPowerOfTwo, are_powers_of_two(sampler.width.raw(), sampler.height.raw()) ? 1 : 0);
  meet(Reach::kDerivatives, use.derivatives);
  meet(Reach::kPositionBitsS, use.position_bits);
  meet(Reach::kExponent, use.least_exponent);
  meet(Reach::kExponent, use.greatest_exponent);
  meet(Reach::kWantedProbes, use.wanted_probes);
  meet(Reach::kFineLevel, use.coarsest_level);
  meet(Reach::kBlended, use.blends ? 1 : 0);
  meet(Reach::kTranslucent, use.translucent ? 1 : 0);
  if (use.linear) meet(Reach::kLinear, 1);
  if (use.nearest) meet(Reach::kLinear, 0);
  const Config full = config_of(candidate.widths);
  Config config = pruned_config(profile, full);
  config.table_cells = full.table_cells;
  config.weight_rows = full.weight_rows;
  return config;
}

bool needs_no_more(const Config& unit, const Config& than) {
  const bool widths = std::ranges::all_of(kConfigFields, [&](const ConfigField& each) {
    // Guard bits and the least range give back what a smaller texture takes from positions, which count as a whole.
    return each.field == &Config::guard_bits || each.field == &Config::least_range_log2 ||
           unit.*each.field <= than.*each.field;
  });
  const bool features = std::ranges::all_of(kFeatureFields, [&](const FeatureField& each) {
    return !(unit.features.*each.field) || than.features.*each.field;
  });
  return widths && features && FormatSet(unit).position.width() <= FormatSet(than).position.width();
}

}  // namespace feline
