// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "testbench/prove/chunk.h"
#include "testbench/prove/proof.h"

namespace feline::prove {

// What was proved of one leaf: some or all chunks of its domain.
struct LeafCertificate {
  std::string sources;                           // sources_of
  std::map<std::uint64_t, std::string> digests;  // of each chunk that is done
  std::array<std::uint64_t, kWitnesses.size()> mismatches{};
  std::vector<Worst> worst;

  void add(std::uint64_t chunk, const ChunkResult& result);
  // All of `leaf`.
  bool is_complete(const Leaf& leaf) const { return digests.size() == leaf.chunks(); }
  std::uint64_t mismatch_count() const;
  // Of all inputs and outputs of a complete one: of the chunks' digests in order.
  std::string digest() const;
};

// What feline prove has shown, by whom. The same work gives the same bytes, wherever and in however many parts.
struct Certificate {
  std::string fingerprint;                             // of configuration, formats and beats, in hex
  std::map<std::string, std::set<std::string>> tools;  // verilator, yosys, compiler: of all that took part
  std::map<std::string, LeafCertificate> leaves;
  std::map<std::string, std::string> proofs;  // of those that hold, proof_hash

  // Chunks of both. Throws InputError when they are of different configurations or sources, or a chunk has two
  // digests.
  void merge(const Certificate& other, const std::string& name);
};

// Of all that a leaf's certificate is about, in hex: its modules, of which the netlist is made, those and the C++ that
// the program was built from, and its domain. Of a program that was built from other sources than the netlists it is
// nobody else's.
std::string sources_of(const Leaf& leaf, const LeafSynthesis& netlists, const LeafSynthesis& program);

// The tools of this build; `yosys` is of LeafSynthesis.
Certificate empty_certificate(const std::string& yosys);

nlohmann::ordered_json to_json(const Certificate& certificate);
// Throws InputError naming the file, the field and what is legal.
Certificate read_certificate(const std::filesystem::path& file);

// What a certificate lacks to cover every chunk of these leaves without a mismatch and to hold these proofs, a line
// each; none when it is whole. With sources, also what was proved of others.
std::vector<std::string> missing_from(const Certificate& certificate, const std::vector<const Leaf*>& leaves,
                                      const std::vector<const Proof*>& proofs,
                                      const LeafSynthesis* synthesis = nullptr);

}  // namespace feline::prove
