// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <exception>
#include <optional>
#include <thread>
#include <variant>

#include "testbench/error.h"
#include "testbench/progress.h"
#include "testbench/prove/journal.h"
#include "testbench/thread_time.h"

namespace feline::prove {
namespace {

struct Task {
  const Leaf* leaf;
  std::uint64_t chunk;
};

std::string describe(const Leaf& leaf, const Disagreement& disagreement) {
  return fmt::format(
      "MISMATCH in leaf {}, input {}: {} against exact arithmetic\n  inputs: {}\n  {}: {}\n  exact: {}\n", leaf.name,
      disagreement.input, disagreement.witness, describe_lane(leaf.inputs, disagreement.inputs.data()),
      disagreement.witness, describe_lane(leaf.outputs, disagreement.got.data()),
      describe_lane(leaf.outputs, disagreement.exact.data()));
}

// Runs work(i) for every i below `count` on all processors and throws what one of them threw. In order of their
// numbers, as far as there are hands.
template <typename Own, typename Work>
void on_all_processors(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr thrown;
  std::mutex mutex;
  const auto run = [&] {
    try {
      Own own;
      for (std::size_t i = next++; i < count; i = next++) work(i, own);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!thrown) thrown = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
    threads.emplace_back(run);
  }
  for (std::thread& thread : threads) thread.join();
  if (thrown) std::rethrow_exception(thrown);
}

std::map<std::string_view, Netlist> synthesize(const std::vector<const Leaf*>& leaves, const LeafSynthesis& synthesis,
                                               const Cache& cache) {
  std::vector<std::string_view> wrappers;
  for (const Leaf* const leaf : leaves) {
    if (std::ranges::find(wrappers, leaf->wrapper) == wrappers.end()) wrappers.push_back(leaf->wrapper);
  }
  std::vector<std::optional<Netlist>> netlists(wrappers.size());
  Progress progress("synthesizing", wrappers.size());
  on_all_processors<std::monostate>(wrappers.size(), [&](std::size_t i, std::monostate&) {
    netlists[i].emplace(synthesis.netlist(wrappers[i], cache));
    progress.advance(1);
  });
  std::map<std::string_view, Netlist> by_name;
  for (std::size_t i = 0; i < wrappers.size(); ++i) by_name.emplace(wrappers[i], std::move(*netlists[i]));
  return by_name;
}

// What is not as another certificate has it: the sources, or the first chunk that came out otherwise.
void compare(const std::string& name, const LeafCertificate& certificate, const Certificate& against,
             std::vector<std::string>& disagreements) {
  const auto known = against.leaves.find(name);
  if (known == against.leaves.end()) {
    disagreements.push_back(fmt::format("CHANGED: leaf {}: not in the certificate\n", name));
    return;
  }
  if (known->second.sources != certificate.sources) {
    disagreements.push_back(fmt::format("CHANGED: leaf {}: sources {}, the certificate has {}\n", name,
                                        certificate.sources, known->second.sources));
  }
  for (const auto& [chunk, digest] : certificate.digests) {
    const auto it = known->second.digests.find(chunk);
    const std::string expected = it == known->second.digests.end() ? "none" : it->second;
    if (digest == expected) continue;
    disagreements.push_back(
        fmt::format("CHANGED: leaf {}, chunk {}: digest {}, the certificate has {}\n", name, chunk, digest, expected));
    return;
  }
  const bool same_chunks = known->second.digests.size() == certificate.digests.size();
  if (same_chunks && known->second.worst != certificate.worst) {
    disagreements.push_back(fmt::format("CHANGED: leaf {}: other worst errors than the certificate has\n", name));
  }
}

}  // namespace

std::optional<Shard> parse_shard(std::string_view text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.index);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != '/') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, shard.count);
  if (second.ec != std::errc() || second.ptr != end || shard.index >= shard.count) return std::nullopt;
  return shard;
}

Campaign run_campaign(const std::vector<const Leaf*>& leaves, const Shard& shard, const LeafSynthesis& synthesis,
                      const Cache& cache, const std::filesystem::path& directory, const Certificate* against) {
  const std::map<std::string_view, Netlist> netlists = synthesize(leaves, synthesis, cache);
  Campaign campaign{empty_certificate(synthesis.version()), {}, {}, 0, {}};
  std::map<std::string, LeafCertificate>& proved = campaign.certificate.leaves;
  std::uint64_t inputs = 0;
  std::vector<Task> tasks;
  const LeafSynthesis program(built_in_sources(), {});
  for (const Leaf& leaf : all_leaves()) {
    LeafCertificate& certificate = proved[leaf.name];
    certificate.sources = sources_of(leaf, synthesis, program);
    certificate.worst.resize(leaf.quantities.size());
  }
  // Entries of other sources stay in the file, but count for nothing here.
  Journal journal(
      directory / "journal.jsonl", content_hash("/proc/self/exe") + " " + synthesis.version(),
      [&](const Journal::Entry& entry) {
        const auto leaf = std::ranges::find(all_leaves(), entry.leaf, &Leaf::name);
        if (leaf == all_leaves().end() || entry.sources != proved[entry.leaf].sources || entry.chunk >= leaf->chunks())
          return;
        LeafCertificate& certificate = proved[entry.leaf];
        if (certificate.worst.size() == entry.result.worst.size()) certificate.add(entry.chunk, entry.result);
      });
  const auto is_chosen = [&](std::string_view name) {
    return std::ranges::any_of(leaves, [&](const Leaf* leaf) { return leaf->name == name; });
  };
  std::erase_if(proved, [&](const auto& each) { return each.second.digests.empty() && !is_chosen(each.first); });
  for (const Leaf* const leaf : leaves) {
    for (std::uint64_t chunk = 0; chunk < leaf->chunks(); ++chunk) {
      if (!shard.has(chunk)) continue;
      if (proved[leaf->name].digests.contains(chunk)) {
        ++campaign.resumed;
      } else {
        tasks.push_back({leaf, chunk});
        inputs += leaf->chunk_count(chunk);
      }
    }
  }

  Progress progress("proving", inputs);
  std::mutex mutex;
  on_all_processors<ChunkProver>(tasks.size(), [&](std::size_t i, ChunkProver& prover) {
    const auto [leaf, chunk] = tasks[i];
    const std::int64_t start = thread_nanoseconds();
    const ChunkResult result = prover.prove(*leaf, chunk, netlists.at(leaf->wrapper));
    const double seconds = static_cast<double>(thread_nanoseconds() - start) * 1e-9;
    const std::lock_guard lock(mutex);
    LeafCertificate& certificate = proved[leaf->name];
    if (result.first && certificate.mismatch_count() == 0) {
      campaign.disagreements.push_back(describe(*leaf, *result.first));
    }
    certificate.add(chunk, result);
    if (!result.first) journal.append({leaf->name, certificate.sources, chunk, result});
    Campaign::Work& work = campaign.work[leaf->name];
    work.inputs += leaf->chunk_count(chunk);
    work.seconds += seconds;
    progress.advance(leaf->chunk_count(chunk));
  });

  if (against != nullptr) {
    for (const Leaf* const leaf : leaves) {
      compare(leaf->name, proved[leaf->name], *against, campaign.disagreements);
    }
  }
  return campaign;
}

namespace {

std::string proof_key(const LeafSynthesis& synthesis, const Cache& cache, const std::string& hash) {
  return cache.key({"proof", synthesis.version(), hash});
}

// Those that an earlier run has made of the same sources.
void add_known_proofs(const LeafSynthesis& synthesis, const Cache& cache, Certificate& certificate) {
  for (const Proof& proof : all_proofs()) {
    try {
      const std::string hash = proof_hash(proof, synthesis);
      if (cache.read(proof_key(synthesis, cache, hash))) certificate.proofs[std::string(proof.name)] = hash;
    } catch (const InputError&) {
      // One that these sources do not have is not asked for.
    }
  }
}

}  // namespace

void run_proofs(const std::vector<const Proof*>& proofs, const Shard& shard, const LeafSynthesis& synthesis,
                const Cache& cache, const Certificate* against, Campaign& campaign) {
  add_known_proofs(synthesis, cache, campaign.certificate);
  std::vector<const Proof*> mine;
  for (std::size_t i = 0; i < proofs.size(); ++i) {
    if (shard.has(i)) mine.push_back(proofs[i]);
  }
  if (mine.empty()) return;
  // Wrong sources are told before the work.
  std::vector<std::string> hashes;
  for (const Proof* const proof : mine) hashes.push_back(proof_hash(*proof, synthesis));
  Progress progress("proving by SAT", mine.size());
  progress.show();
  std::mutex mutex;
  on_all_processors<std::monostate>(mine.size(), [&](std::size_t i, std::monostate&) {
    using Verdict = ProofResult::Verdict;
    const Proof& proof = *mine[i];
    const std::string name(proof.name);
    const std::string key = proof_key(synthesis, cache, hashes[i]);
    const bool is_known = cache.read(key).has_value();
    const ProofResult result = is_known ? ProofResult{Verdict::kHolds, "", 0} : run_proof(proof, synthesis);
    const bool holds = result.verdict == Verdict::kHolds;
    if (holds && !is_known) cache.write(key, "holds");
    const std::lock_guard lock(mutex);
    if (!is_known) campaign.proof_seconds[name] = result.seconds;
    if (holds) {
      campaign.certificate.proofs[name] = hashes[i];
    } else {
      campaign.disagreements.push_back(fmt::format("NOT PROVED: {}: {}: {}\n{}\n", name, proof.claim,
                                                   result.verdict == Verdict::kBroken ? "it does not hold"
                                                   : result.verdict == Verdict::kControlNotFound
                                                       ? "the bug of a control was not found"
                                                       : "not decided in ten minutes",
                                                   result.said));
    }
    if (against != nullptr && (!against->proofs.contains(name) || against->proofs.at(name) != hashes[i])) {
      campaign.disagreements.push_back(fmt::format("CHANGED: proof {}: not that of the certificate\n", name));
    }
    progress.advance(1);
  });
}

}  // namespace feline::prove
