// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/leaf.h"

#include <fmt/format.h>

#include <algorithm>

#include "tables/emit.h"
#include "testbench/prove/domains.h"

namespace feline::prove {
namespace {

constexpr int kLeastChunkLog2 = 20;
constexpr std::uint64_t kMostChunks = 256;

}  // namespace

int Leaf::chunk_log2() const {
  int log2 = kLeastChunkLog2;
  while ((domain.count - 1) >> log2 >= kMostChunks) ++log2;
  return log2;
}

std::uint64_t Leaf::chunks() const { return ((domain.count - 1) >> chunk_log2()) + 1; }

std::uint64_t Leaf::chunk_count(std::uint64_t chunk) const {
  return std::min(domain.count - chunk_first(chunk), std::uint64_t{1} << chunk_log2());
}

int Leaf::steady_place() const {
  int place = 0;
  for (std::size_t i = steady_fields; i < inputs.size(); ++i) place += inputs[i].width();
  return place;
}

const std::vector<Leaf>& all_leaves() {
  static const std::vector<Leaf> leaves = [] {
    std::vector<Leaf> all;
    append_front_leaves(all);
    append_back_leaves(all);
    return all;
  }();
  return leaves;
}

std::string describe_lane(std::span<const Format> fields, const std::uint64_t* lane) {
  std::vector<std::string> texts(fields.size());
  int place = 0;
  for (std::size_t i = fields.size(); i-- > 0;) {
    const Format& format = fields[i];
    std::uint64_t bits = 0;
    for (int k = 0; k < format.width(); ++k) {
      const auto at = static_cast<std::size_t>(place + k);
      bits |= (lane[at / 64] >> (at % 64) & 1) << k;
    }
    place += format.width();
    auto raw = static_cast<std::int64_t>(bits);
    if (format.is_signed && (bits >> (format.width() - 1)) != 0) raw -= std::int64_t{1} << format.width();
    texts[i] = fmt::format("{} 0x{:0{}x} = {} ({}, {})", format.name.view(), bits, (format.width() + 3) / 4,
                           format.value(raw), notation(format), format.unit.view());
  }
  std::string text;
  for (const std::string& each : texts) text += (text.empty() ? "" : ", ") + each;
  return text;
}

}  // namespace feline::prove
