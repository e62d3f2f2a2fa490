// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "testbench/prove/certificate.h"
#include "testbench/prove/leaf_synthesis.h"

namespace feline::prove {

// Which chunks: those whose number leaves `index` when divided by `count`.
struct Shard {
  std::uint64_t index = 0;
  std::uint64_t count = 1;
  bool has(std::uint64_t number) const { return number % count == index; }
};
// "I/N", 0 <= I < N; nothing for any other text.
std::optional<Shard> parse_shard(std::string_view text);

struct Campaign {
  Certificate certificate;
  std::vector<std::string> disagreements;  // of each leaf the first, told in full
  // Of this run: inputs, each evaluated by every witness, and seconds of one processor, by leaf.
  struct Work {
    std::uint64_t inputs = 0;
    double seconds = 0;
  };
  std::map<std::string, Work> work;
  std::uint64_t resumed = 0;                    // chunks that an earlier run had done
  std::map<std::string, double> proof_seconds;  // of this run
};

// Proves chunks of leaves on all processors. Each chunk that is done is in the journal, a file of `directory`, at once:
// a run that was killed goes on there, if program, tools and sources are the same. A certificate to compare with may be
// given: then other sources, or a chunk that comes out otherwise, is a disagreement.
Campaign run_campaign(const std::vector<const Leaf*>& leaves, const Shard& shard, const LeafSynthesis& synthesis,
                      const Cache& cache, const std::filesystem::path& directory, const Certificate* against);

// Makes every shard.count-th proof and adds it to a campaign; one that does not hold, whose control is not found, or
// that is not decided, is a disagreement, as is one that is not in the certificate to compare with. What the cache has
// of the same sources, tools and program is taken from there.
void run_proofs(const std::vector<const Proof*>& proofs, const Shard& shard, const LeafSynthesis& synthesis,
                const Cache& cache, const Certificate* against, Campaign& campaign);

}  // namespace feline::prove
