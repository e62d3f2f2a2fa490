// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/memory.h"
#include "tables/formats.h"
#include "testbench/prune/line_set.h"

namespace feline {

// Of a value: how often it was met.
using Histogram = std::map<std::int64_t, std::uint64_t>;

// What is counted of a lookup's way through the unit, each in a histogram of its own. `sampler` and `texture` are the
// sampler state's fields; the others are named after the stage whose beat has them. kReachFacts says more of each.
enum class Reach : std::uint8_t {
  // sampler
  kMode,
  kKernel,
  kMagnify,
  kWrap,
  kTexelFormat,
  kSrgb,
  kProbeRounding,
  kLengthFactor,
  kBlurFactor,
  kInverseAliasFactor,
  kMaxProbes,
  kLevelBias,
  kMinLevel,
  kMaxLevel,
  // texture
  kWidth,
  kHeight,
  kPowerOfTwo,
  kLastLevel,
  // request
  kDerivatives,
  // group
  kPositionBitsS,
  kPositionBitsT,
  kExponent,
  kDudx,
  kDvdx,
  kDudy,
  kDvdy,
  // footprint
  kCell,
  // plan
  kMagnified,
  kWantedProbes,
  kProbes,
  kWeightRow,
  kHalfStepBitsS,
  kHalfStepBitsT,
  kLevel,
  kBlended,
  kLinear,
  // walk
  kProbeBitsS,
  kProbeBitsT,
  // address
  kFineLevel,
  kCoarseLevel,
  kBorderTexels,
  // fetch
  kTranslucent,
  // accumulate
  kStatus,
};
inline constexpr std::size_t kReachCount = static_cast<std::size_t>(Reach::kStatus) + 1;
// From here on a value is a beat's, before it the sampler state's.
inline constexpr Reach kFirstOfBeats = Reach::kDerivatives;

// From walk to fetch values are a probe's, all others a lookup's.
constexpr bool is_of_probes(Reach reach) { return reach >= Reach::kProbeBitsS && reach <= Reach::kTranslucent; }

// What is met once for every lookup or every probe, and what only for some of them, or twice.
enum class Each : std::uint8_t { kLookup, kProbe, kSome };

struct ReachFacts {
  std::string_view part;  // sampler, texture or a stage: where JSON has it
  std::string_view name;
  std::string_view text;  // what a value is, and of what it is counted
  std::int64_t least;     // legal values
  std::int64_t most;
  Each each;
  std::span<const std::string_view> names = {};  // of least .. most; numbers where empty
};

// In the order of Reach.
extern const std::array<ReachFacts, kReachCount> kReachFacts;
inline const ReachFacts& facts(Reach reach) { return kReachFacts[static_cast<std::size_t>(reach)]; }

// "table", "64": a value as JSON and pages name it.
std::string value_name(const ReachFacts& of, std::int64_t value);

// Of Reach::kPowerOfTwo.
constexpr bool are_powers_of_two(std::int64_t width, std::int64_t height) {
  return std::has_single_bit(static_cast<std::uint64_t>(width)) &&
         std::has_single_bit(static_cast<std::uint64_t>(height));
}

// What was read of one texture. Its size is bounded by the texture's.
struct TextureUse {
  std::set<std::string> names;  // of the sources that it came with
  TexelFormat format = TexelFormat::kRgba8;
  int width = 0;
  int height = 0;
  int levels = 0;
  LineSet touched;  // of the lines of all levels, as TextureMemory has them
  // Texels read of level 0 in each block of it, row by row.
  std::vector<std::uint64_t> blocks;

  // Of a level: its memory lines, which are tiles of 4 x 4 texels.
  int tile_columns(int level) const;
  int tile_rows(int level) const;
  std::size_t first_line(int level) const;
  std::size_t line_count(int level) const;
  // A block is 2^shift tiles wide and high, so that there are at most 64 x 64 of them.
  int block_shift() const;
  int block_columns() const;
  int block_rows() const;
  std::size_t block_count() const;
  bool operator==(const TextureUse&) const = default;
};

// What part of the unit lookups reach, and how often. Every count adds, every set joins: profiles of the parts of a
// sequence, in any order, merge to the profile of the whole, and it does not grow with the number of frames.
struct Profile {
  std::map<std::string, std::uint64_t> sources;  // by name: the G-buffers seen, once for each sampler
  std::uint64_t lookups = 0;
  std::uint64_t probes = 0;
  std::array<Histogram, kReachCount> reached;  // by Reach; a value that is not reached is not there
  std::map<std::string, TextureUse> textures;  // by content (texture_hash)

  Histogram& operator[](Reach reach) { return reached[static_cast<std::size_t>(reach)]; }
  const Histogram& operator[](Reach reach) const { return reached[static_cast<std::size_t>(reach)]; }
  std::uint64_t count(Reach reach, std::int64_t value) const;
  // Of all sources.
  std::uint64_t frames() const;
  bool operator==(const Profile&) const = default;
};

// Counts saturate, so that the order of sums never matters.
constexpr std::uint64_t saturating_sum(std::uint64_t a, std::uint64_t b) {
  return a + b < a ? ~std::uint64_t{0} : a + b;
}
std::uint64_t total(const Histogram& histogram);

// Commutative and associative. Throws InputError when the same texture has two shapes, which no profile of lookups has.
void merge(Profile& into, const Profile& from);

// Tells textures apart: format, size and texels of all levels, 40 hexadecimal digits in capitals.
std::string texture_hash(const Texture& texture);

}  // namespace feline
