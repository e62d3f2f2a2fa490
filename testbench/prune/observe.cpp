// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/observe.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <vector>

#include "model/unit.h"
#include "testbench/parallel.h"
#include "testbench/prune/needs.h"
#include "testbench/prune/prune.h"

namespace feline {
namespace {

using F = Formats<kDefaultConfig>;

int magnitude_bits(std::int64_t raw) { return bit_length(std::abs(raw)); }

// Takes every beat of a part of the lookups. Counts stand in plain arrays, which maps would be too slow for.
class Recorder {
 public:
  // Without a texture, which memory is read is nobody's concern.
  Recorder(const SamplerState<kDefaultConfig>& sampler, const TextureUse* unread)
      : sampler_(sampler), mode_(supported_mode<kDefaultConfig>(sampler)) {
    if (unread != nullptr) {
      use_ = *unread;
      shift_ = unread->block_shift() + kTileLog2;
      block_columns_ = unread->block_columns();
    }
    for (std::size_t i = static_cast<std::size_t>(kFirstOfBeats); i < kReachCount; ++i) {
      counts_[i].resize(static_cast<std::size_t>(kReachFacts[i].most - kReachFacts[i].least + 1));
    }
  }

  void operator()(const RequestBeat<kDefaultConfig>& beat) { count(Reach::kDerivatives, needed_derivatives(beat)); }

  void operator()(const GroupBeat<kDefaultConfig>& beat) {
    ++lookups_;
    count(Reach::kPositionBitsS, magnitude_bits(beat.s.raw()));
    count(Reach::kPositionBitsT, magnitude_bits(beat.t.raw()));
    const bool is_zero = (beat.dudx.raw() | beat.dvdx.raw() | beat.dudy.raw() | beat.dvdy.raw()) == 0;
    if (!is_zero) count(Reach::kExponent, beat.exponent.raw());
    count(Reach::kDudx, beat.dudx.raw());
    count(Reach::kDvdx, beat.dvdx.raw());
    count(Reach::kDudy, beat.dudy.raw());
    count(Reach::kDvdy, beat.dvdy.raw());
    if (mode_ == Mode::kTable) {
      const TableCell cell = table_cell<kDefaultConfig>(gradients_of<kDefaultConfig>(beat));
      count(Reach::kCell, cell.row * kDefaultConfig.table_columns + cell.column);
    }
  }

  void operator()(const FootprintBeat<kDefaultConfig>& beat) {
    const ClampedRadii radii = clamp_radii<kDefaultConfig>(beat, mode_, sampler_.length_factor.raw());
    count(Reach::kMagnified, radii.magnified ? 1 : 0);
    count(Reach::kWantedProbes, choose_probes<kDefaultConfig>(radii, mode_, sampler_).probes);
  }

  void operator()(const PlanBeat<kDefaultConfig>& beat) {
    const std::int64_t level = beat.level_of_detail.raw() >> kDefaultConfig.level_fraction_bits;
    count(Reach::kProbes, beat.probes.raw());
    count(Reach::kWeightRow, beat.weight_row.raw());
    count(Reach::kHalfStepBitsS, magnitude_bits(beat.half_step_s.raw()));
    count(Reach::kHalfStepBitsT, magnitude_bits(beat.half_step_t.raw()));
    count(Reach::kLevel, level);
    count(Reach::kBlended, beat.level_of_detail.raw() == level << kDefaultConfig.level_fraction_bits ? 0 : 1);
    count(Reach::kLinear, beat.linear.raw());
  }

  void operator()(const WalkBeat<kDefaultConfig>& beat) {
    ++probes_;
    count(Reach::kProbeBitsS, magnitude_bits(beat.s.raw()));
    count(Reach::kProbeBitsT, magnitude_bits(beat.t.raw()));
  }

  void operator()(const AddressBeat<kDefaultConfig>& beat) {
    int outside = read_level(beat.level.raw(), beat.fine_x, beat.fine_y, beat.fine_border.raw(), beat.fine_line);
    count(Reach::kFineLevel, beat.level.raw());
    if (beat.coarse_used.raw() != 0) {
      const std::int64_t coarse = beat.level.raw() + 1;
      outside += read_level(coarse, beat.coarse_x, beat.coarse_y, beat.coarse_border.raw(), beat.coarse_line);
      count(Reach::kCoarseLevel, coarse);
    }
    count(Reach::kBorderTexels, outside);
  }

  void operator()(const FetchBeat<kDefaultConfig>& beat) {
    count(Reach::kTranslucent, reads_translucent(beat) ? 1 : 0);
  }

  void operator()(const AccumulateBeat<kDefaultConfig>& beat) { count(Reach::kStatus, beat.status.raw()); }

  // What the unit is given, and colours.
  template <typename Beat>
  void operator()(const Beat&) {}

  void add_to(Profile& profile, const std::string& hash) {
    Profile part;
    part.lookups = lookups_;
    part.probes = probes_;
    for (std::size_t i = 0; i < kReachCount; ++i) {
      for (std::size_t at = 0; at < counts_[i].size(); ++at) {
        if (counts_[i][at] == 0) continue;
        part.reached[i][kReachFacts[i].least + static_cast<std::int64_t>(at)] = counts_[i][at];
      }
    }
    if (use_) part.textures[hash] = std::move(*use_);
    merge(profile, part);
  }

 private:
  void count(Reach reach, std::int64_t value) {
    const auto i = static_cast<std::size_t>(reach);
    ++counts_[i][static_cast<std::size_t>(value - kReachFacts[i].least)];
  }

  // The texels that memory is read for; returns how many are not, because they lie outside.
  template <typename Indices, typename Lines>
  int read_level(std::int64_t level, const Indices& xs, const Indices& ys, std::int64_t border, const Lines& lines) {
    int outside = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if ((border >> (i % 2) & 1) != 0 || (border >> (2 + i / 2) & 1) != 0) {
        ++outside;
        continue;
      }
      if (!use_) continue;
      use_->touched.insert(static_cast<std::size_t>(lines[i].raw()));
      if (level != 0) continue;
      const std::int64_t row = ys[i / 2].raw() >> shift_;
      ++use_->blocks[static_cast<std::size_t>(row * block_columns_ + (xs[i % 2].raw() >> shift_))];
    }
    return outside;
  }

  const SamplerState<kDefaultConfig>& sampler_;
  Mode mode_;
  std::uint64_t lookups_ = 0;
  std::uint64_t probes_ = 0;
  std::array<std::vector<std::uint64_t>, kReachCount> counts_;
  std::optional<TextureUse> use_;
  int shift_ = 0;  // from a texel of level 0 to its block
  int block_columns_ = 0;
};

// The sampler state's own, each met by every lookup.
void count_sampler(Profile& profile, const SamplerState<kDefaultConfig>& sampler, std::uint64_t lookups) {
  const auto count = [&](Reach reach, std::int64_t value) {
    std::uint64_t& sum = profile[reach][value];
    sum = saturating_sum(sum, lookups);
  };
  count(Reach::kMode, sampler.mode.raw());
  count(Reach::kKernel, sampler.kernel.raw());
  count(Reach::kMagnify, sampler.magnify.raw());
  count(Reach::kWrap, sampler.wrap_s.raw());
  if (sampler.wrap_t != sampler.wrap_s) count(Reach::kWrap, sampler.wrap_t.raw());
  count(Reach::kTexelFormat, sampler.texel_format.raw());
  count(Reach::kSrgb, sampler.srgb.raw());
  count(Reach::kProbeRounding, sampler.probe_rounding.raw());
  count(Reach::kLengthFactor, sampler.length_factor.raw());
  count(Reach::kBlurFactor, sampler.blur_factor.raw());
  count(Reach::kInverseAliasFactor, sampler.inverse_alias_factor.raw());
  count(Reach::kMaxProbes, sampler.max_probes.raw());
  count(Reach::kLevelBias, sampler.level_bias.raw());
  count(Reach::kMinLevel, sampler.min_level.raw());
  count(Reach::kMaxLevel, sampler.max_level.raw());
  count(Reach::kWidth, sampler.width.raw());
  count(Reach::kHeight, sampler.height.raw());
  count(Reach::kPowerOfTwo, are_powers_of_two(sampler.width.raw(), sampler.height.raw()) ? 1 : 0);
  count(Reach::kLastLevel, sampler.last_level.raw());
}

}  // namespace

ProfiledTexture profiled_texture(const std::string& name, const Texture& texture) {
  const MipLevel& base = texture.levels.front();
  TextureUse unread{{name}, texture.format, base.width, base.height, static_cast<int>(texture.levels.size()), {}, {}};
  unread.touched = LineSet(unread.first_line(unread.levels));
  unread.blocks.resize(unread.block_count());
  return {texture_hash(texture), std::move(unread)};
}

void observe(Profile& profile, const std::string& source, std::span<const Lookup> lookups,
             const SamplerState<kDefaultConfig>& sampler, const TextureMemory& memory, const ProfiledTexture& texture,
             Progress* progress) {
  std::uint64_t& frames = profile.sources[source];
  frames = saturating_sum(frames, 1);
  if (lookups.empty()) return;
  count_sampler(profile, sampler, lookups.size());
  constexpr std::size_t kPart = 16384;
  std::mutex mutex;
  for_each_index(0, static_cast<std::int64_t>((lookups.size() + kPart - 1) / kPart), [&](std::int64_t index) {
    const std::size_t first = static_cast<std::size_t>(index) * kPart;
    const auto part = lookups.subspan(first, std::min(kPart, lookups.size() - first));
    Recorder recorder(sampler, &texture.unread);
    for (const Lookup& lookup : part) {
      sample<kDefaultConfig>(make_request<kDefaultConfig>(lookup, 0), sampler, memory, recorder);
    }
    if (progress != nullptr) progress->advance(part.size());
    const std::scoped_lock lock(mutex);
    recorder.add_to(profile, texture.hash);
  });
}

Config needed_config(const Lookup& lookup, const SamplerState<kDefaultConfig>& sampler, const TextureMemory& memory) {
  Profile profile;
  count_sampler(profile, sampler, 1);
  Recorder recorder(sampler, nullptr);
  sample<kDefaultConfig>(make_request<kDefaultConfig>(lookup, 0), sampler, memory, recorder);
  recorder.add_to(profile, "");
  return pruned_config(profile);
}

}  // namespace feline
