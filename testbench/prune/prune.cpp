// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/prune.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>

#include "tables/formats.h"
#include "tables/rounding.h"
#include "tables/sampler_enums.h"

namespace feline {
namespace {

using F = Formats<kDefaultConfig>;

bool reaches(const Profile& profile, Reach reach, auto value) {
  return profile.count(reach, static_cast<std::int64_t>(value)) != 0;
}

std::int64_t greatest(const Profile& profile, Reach reach) {
  const Histogram& histogram = profile[reach];
  return histogram.empty() ? 0 : histogram.rbegin()->first;
}

std::int64_t least(const Profile& profile, Reach reach) {
  const Histogram& histogram = profile[reach];
  return histogram.empty() ? 0 : histogram.begin()->first;
}

bool reaches_other_than(const Profile& profile, Reach reach, std::int64_t value) {
  return std::ranges::any_of(profile[reach], [&](const auto& entry) { return entry.first != value; });
}

// Some derivative is not 0: bit `place` of the sets of those that are not.
bool derivative_is_given(const Profile& profile, int place) {
  return std::ranges::any_of(profile[Reach::kDerivatives],
                             [&](const auto& entry) { return (entry.first >> place & 1) != 0; });
}

Features pruned_features(const Profile& profile) {
  Features features;
  features.nearest = reaches(profile, Reach::kMode, Mode::kNearest);
  features.bilinear = reaches(profile, Reach::kMode, Mode::kBilinear);
  features.trilinear = reaches(profile, Reach::kMode, Mode::kTrilinear);
  features.ext = reaches(profile, Reach::kMode, Mode::kExt);
  features.simple_feline = reaches(profile, Reach::kMode, Mode::kSimple);
  features.table_feline = reaches(profile, Reach::kMode, Mode::kTable);
  features.gaussian = reaches(profile, Reach::kKernel, Kernel::kGaussian);
  features.factors = reaches(profile, Reach::kProbeRounding, ProbeRounding::kCeiling) ||
                     reaches_other_than(profile, Reach::kLengthFactor, F::kFactor.one());
  features.repeat = reaches(profile, Reach::kWrap, Wrap::kRepeat);
  features.mirrored_repeat = reaches(profile, Reach::kWrap, Wrap::kMirroredRepeat);
  features.clamp_to_edge = reaches(profile, Reach::kWrap, Wrap::kClampToEdge);
  features.clamp_to_border = reaches(profile, Reach::kWrap, Wrap::kClampToBorder);
  features.r8 = reaches(profile, Reach::kTexelFormat, TexelFormat::kR8);
  features.rg8 = reaches(profile, Reach::kTexelFormat, TexelFormat::kRg8);
  features.rgba8 = reaches(profile, Reach::kTexelFormat, TexelFormat::kRgba8);
  features.srgb = reaches(profile, Reach::kSrgb, true);
  features.alpha = reaches(profile, Reach::kTranslucent, true);
  features.any_size = reaches(profile, Reach::kPowerOfTwo, false);
  features.level_blend = reaches(profile, Reach::kBlended, true);
  features.linear_texels = reaches(profile, Reach::kLinear, true);
  features.nearest_texels = reaches(profile, Reach::kLinear, false);
  features.dudx = derivative_is_given(profile, 0);
  features.dvdx = derivative_is_given(profile, 1);
  features.dudy = derivative_is_given(profile, 2);
  features.dvdy = derivative_is_given(profile, 3);
  return features;
}

int pruned_exponent_bits(const Profile& profile) {
  const std::int64_t low = least(profile, Reach::kExponent);
  const std::int64_t high = greatest(profile, Reach::kExponent);
  const int bits = std::max(bit_length(high < 0 ? ~high : high), bit_length(low < 0 ? ~low : low));
  return std::max(bits, 2);
}

// What does not saturate in the full unit must not in this one; what does, may earlier.
int pruned_range_log2(const Profile& profile, const Features& features, const FormatSet& full) {
  if (!features.clamp_to_edge && !features.clamp_to_border) return 0;
  std::int64_t range = 0;
  for (const Reach reach : {Reach::kPositionBitsS, Reach::kPositionBitsT}) {
    for (const auto& [bits, count] : profile[reach]) {
      const std::int64_t needed = bits - full.position_fraction;
      if (needed <= full.saturation_log2) range = std::max(range, needed);
    }
  }
  return static_cast<int>(range);
}

// A smaller texture would take fraction bits from positions, which guard bits give back.
void set_max_size(Config& config, int max_size_log2) {
  config.guard_bits += config.max_size_log2 - max_size_log2;
  config.max_size_log2 = max_size_log2;
}

// Rows of the weight table are numbered by the most probes: Gaussian ones first, then equal ones.
WordMask<std::size_t{5} * Config::kMostProbes> pruned_weight_rows(const Profile& profile, int gaussian_rows) {
  auto rows = WordMask<std::size_t{5} * Config::kMostProbes>::none();
  for (const auto& [row, count] : profile[Reach::kWeightRow]) {
    rows.add(static_cast<std::size_t>(row < F::kGaussianRows ? row : row - F::kGaussianRows + gaussian_rows));
  }
  return rows;
}

}  // namespace

Config pruned_config(const Profile& profile, const Config& full) {
  Config config = full;
  config.features = pruned_features(profile);
  config.exponent_bits = pruned_exponent_bits(profile);
  config.max_probes = static_cast<int>(std::max<std::int64_t>(greatest(profile, Reach::kWantedProbes), 1));
  const std::int64_t coarsest = std::max(greatest(profile, Reach::kFineLevel), greatest(profile, Reach::kCoarseLevel));
  config.max_levels = static_cast<int>(coarsest) + 1;
  const std::int64_t side = std::max(greatest(profile, Reach::kWidth), greatest(profile, Reach::kHeight));
  constexpr int kLeastSizeLog2 = 4;
  set_max_size(config, std::clamp(bit_length(side - 1), kLeastSizeLog2, full.max_size_log2));
  config.least_range_log2 = pruned_range_log2(profile, config.features, FormatSet(full));
  config.table_cells = decltype(config.table_cells)::none();
  for (const auto& [cell, count] : profile[Reach::kCell]) config.table_cells.add(static_cast<std::size_t>(cell));
  config.weight_rows = pruned_weight_rows(profile, FormatSet(config).gaussian_rows);
  return config;
}

bool is_within(const Config& needed, const Config& available) {
  for (const FeatureField& each : kFeatureFields) {
    if (needed.features.*each.field && !(available.features.*each.field)) return false;
  }
  if (needed.exponent_bits > available.exponent_bits || needed.max_probes > available.max_probes ||
      needed.max_levels > available.max_levels || needed.max_size_log2 > available.max_size_log2) {
    return false;
  }
  const bool clamps = needed.features.clamp_to_edge || needed.features.clamp_to_border;
  if (clamps && needed.least_range_log2 > FormatSet(available).saturation_log2) return false;
  for (std::size_t i = 0; i < needed.table_cells.bits.size(); ++i) {
    if ((needed.table_cells.bits[i] & ~available.table_cells.bits[i]) != 0) return false;
  }
  const auto own = static_cast<std::size_t>(FormatSet(needed).gaussian_rows);
  const auto other = static_cast<std::size_t>(FormatSet(available).gaussian_rows);
  for (std::size_t row = 0; row < static_cast<std::size_t>(FormatSet(needed).weight_rows); ++row) {
    if (needed.weight_rows.has(row) && !available.weight_rows.has(row < own ? row : row - own + other)) return false;
  }
  return true;
}

std::vector<PartSize> part_sizes(const Config& config) {
  const FormatSet formats(config);
  constexpr Config kFull = kDefaultConfig;
  const auto present = [](const auto& mask, int words) {
    int count = 0;
    for (int word = 0; word < words; ++word) count += mask.has(static_cast<std::size_t>(word)) ? 1 : 0;
    return count;
  };
  const int cells = config.table_rows * config.table_columns;
  return {{"probes", config.max_probes, kFull.max_probes},
          {"levels", formats.levels, F::kLevels},
          {"size bits", config.max_size_log2, kFull.max_size_log2},
          {"exponent bits", config.exponent_bits, kFull.exponent_bits},
          {"position bits", formats.position.width(), F::kPosition.width()},
          {"table cells", config.features.table_feline ? present(config.table_cells, cells) : 0,
           kFull.table_rows * kFull.table_columns},
          {"weight rows", present(config.weight_rows, formats.weight_rows), F::kWeightRows}};
}

std::vector<std::string> left_out(const Config& config) {
  std::vector<std::string> lines;
  std::vector<std::string_view> missing;
  for (const FeatureField& each : kFeatureFields) {
    if (!(config.features.*each.field)) missing.push_back(each.name);
  }
  if (!missing.empty()) lines.push_back(fmt::format("features: {}", fmt::join(missing, ", ")));
  for (const PartSize& part : part_sizes(config)) {
    if (part.have < part.full) lines.push_back(fmt::format("{}: {} of {}", part.what, part.have, part.full));
  }
  return lines;
}

nlohmann::ordered_json config_to_json(const Config& config) {
  nlohmann::ordered_json json;
  for (const ConfigField& each : kConfigFields) json[std::string(each.name)] = config.*each.field;
  for (const FeatureField& each : kFeatureFields) {
    json["features"][std::string(each.name)] = config.features.*each.field;
  }
  return json;
}

std::string unit_header(const Config& config) {
  std::string out =
      "// SPDX-License-Identifier: Apache-2.0\n// Written by `feline prune`.\ninline constexpr Config kUnit{\n";
  for (const ConfigField& each : kConfigFields) out += fmt::format("    .{} = {},\n", each.name, config.*each.field);
  const auto mask = [&](std::string_view name, const auto& words) {
    std::vector<std::string> texts;
    for (const std::uint64_t word : words.bits) texts.push_back(fmt::format("{:#x}", word));
    out += fmt::format("    .{} = {{.bits = {{{}}}}},\n", name, fmt::join(texts, ", "));
  };
  mask("table_cells", config.table_cells);
  mask("weight_rows", config.weight_rows);
  out += "    .features = {\n";
  for (const FeatureField& each : kFeatureFields)
    out += fmt::format("        .{} = {},\n", each.name, config.features.*each.field);
  return out + "    }};\n";
}

}  // namespace feline
