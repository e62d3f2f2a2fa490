// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/chunk.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace feline::prove {
namespace {

constexpr std::size_t kBlock = NetlistProgram::kLanes;
// Of a certificate's digests: so many inputs, then their outputs, and again, whatever the blocks.
constexpr std::size_t kDigestLanes = 4096;
static_assert(kBlock % kDigestLanes == 0);

// In steps that every host's mathematics agrees on.
double in_steps(double error) { return std::nearbyint(error * 0x1p40) * 0x1p-40; }

void find_worst(const std::vector<double>& errors, std::size_t lanes, std::uint64_t first, std::vector<Worst>& worst) {
  const std::size_t quantities = worst.size();
  for (std::size_t k = 0; k < quantities; ++k) {
    for (std::size_t i = 0; i < lanes; ++i) {
      // Not of a NaN.
      if (errors[i * quantities + k] > worst[k].value)
        worst[k].keep_worse({in_steps(errors[i * quantities + k]), first + i});
    }
  }
}

}  // namespace

void Worst::keep_worse(const Worst& other) {
  if (other.value > value || (other.value == value && other.input < input)) *this = other;
}

RtlLeaf& ChunkProver::rtl_of(std::string_view wrapper) {
  std::unique_ptr<RtlLeaf>& leaf = rtl_[wrapper];
  if (leaf == nullptr) leaf = make_rtl_leaf(wrapper);
  if (leaf == nullptr) throw std::logic_error(fmt::format("no RTL of leaf {}", wrapper));
  return *leaf;
}

ChunkResult ChunkProver::prove(const Leaf& leaf, std::uint64_t chunk, const Netlist& netlist) {
  const std::size_t in_words = leaf.input_words;
  const std::size_t out_words = leaf.output_words;
  inputs_.resize(kBlock * in_words);
  exact_.resize(kBlock * out_words);
  got_.resize(kBlock * out_words);
  errors_.resize(kBlock * leaf.quantities.size());
  RtlLeaf& rtl = rtl_of(leaf.wrapper);

  ChunkResult result;
  result.worst.resize(leaf.quantities.size());
  XXH3_state_t digest;
  XXH3_128bits_reset(&digest);
  const std::uint64_t end = leaf.chunk_first(chunk) + leaf.chunk_count(chunk);
  for (std::uint64_t first = leaf.chunk_first(chunk); first < end; first += kBlock) {
    const auto lanes = static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, end - first));
    leaf.domain.fill(first, lanes, inputs_.data());
    leaf.exact(inputs_.data(), exact_.data(), lanes);
    for (std::size_t lane = 0; lane < lanes; lane += kDigestLanes) {
      const std::size_t some = std::min(kDigestLanes, lanes - lane);
      XXH3_128bits_update(&digest, inputs_.data() + lane * in_words, some * in_words * sizeof(std::uint64_t));
      XXH3_128bits_update(&digest, exact_.data() + lane * out_words, some * out_words * sizeof(std::uint64_t));
    }

    const auto compare = [&](std::size_t witness) {
      if (std::equal(got_.begin(), got_.begin() + static_cast<std::ptrdiff_t>(lanes * out_words), exact_.begin()))
        return;
      for (std::size_t i = 0; i < lanes; ++i) {
        const auto at = static_cast<std::ptrdiff_t>(i * out_words);
        const auto words = static_cast<std::ptrdiff_t>(out_words);
        if (std::equal(got_.begin() + at, got_.begin() + at + words, exact_.begin() + at)) continue;
        ++result.mismatches[witness];
        if (result.first) continue;
        const auto in = inputs_.begin() + static_cast<std::ptrdiff_t>(i * in_words);
        result.first = Disagreement{kWitnesses[witness],
                                    first + i,
                                    {in, in + static_cast<std::ptrdiff_t>(in_words)},
                                    {exact_.begin() + at, exact_.begin() + at + words},
                                    {got_.begin() + at, got_.begin() + at + words}};
      }
    };
    leaf.model(inputs_.data(), got_.data(), lanes);
    compare(0);
    rtl.evaluate(inputs_.data(), got_.data(), lanes);
    compare(1);
    const std::span<const std::uint64_t> block(inputs_.data(), lanes * in_words);
    program_.of(netlist, static_cast<std::size_t>(leaf.steady_place()), block, in_words)
        .evaluate(inputs_.data(), in_words, got_.data(), out_words, lanes, scratch_);
    compare(2);
    if (leaf.measure != nullptr) {
      leaf.measure(inputs_.data(), exact_.data(), lanes, errors_.data());
      find_worst(errors_, lanes, first, result.worst);
    }
  }
  const XXH128_hash_t hash = XXH3_128bits_digest(&digest);
  result.digest = fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
  return result;
}

}  // namespace feline::prove
