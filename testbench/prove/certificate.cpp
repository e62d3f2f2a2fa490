// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/certificate.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "tables/emit.h"
#include "tables/unit.h"
#include "testbench/error.h"
#include "testbench/json_input.h"
#include "testbench/prove/rtl_leaf.h"

namespace feline::prove {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
// Sums of as many counts as there are stay below 2^64.
constexpr std::uint64_t kMostMismatches = std::uint64_t{1} << 53;

// As many digits as every host's mathematics agrees on.
Json rounded(double value, int digits) { return Json::parse(fmt::format("{:.{}g}", value, digits)); }

Json worst_to_json(const Leaf& leaf, const std::vector<Worst>& worst) {
  Json all = Json::array();
  for (std::size_t k = 0; k < worst.size(); ++k) {
    const Quantity& quantity = leaf.quantities[k];
    if (worst[k].value < 0) continue;
    std::vector<std::uint64_t> lane(leaf.input_words);
    leaf.domain.fill(worst[k].input, 1, lane.data());
    all.push_back({{"quantity", quantity.name},
                   {"worst", rounded(quantity.present(worst[k].value), 6)},
                   {"unit", quantity.unit},
                   {"measured", worst[k].value},
                   {"input", worst[k].input},
                   {"at", describe_lane(leaf.inputs, lane.data())}});
  }
  return all;
}

Json leaf_to_json(const Leaf& leaf, const LeafCertificate& certificate) {
  Json json{{"leaf", leaf.name},
            {"stage", leaf.stage()},
            {"domain", leaf.domain.text},
            {"count", leaf.domain.count},
            {"chunk", std::uint64_t{1} << leaf.chunk_log2()},
            {"chunks", leaf.chunks()},
            {"done", certificate.digests.size()},
            {"sources", certificate.sources},
            {"digest", certificate.is_complete(leaf) ? Json(certificate.digest()) : Json(nullptr)}};
  Json mismatches;
  for (std::size_t i = 0; i < kWitnesses.size(); ++i) mismatches[kWitnesses[i]] = certificate.mismatches[i];
  json["mismatches"] = mismatches;
  json["errors"] = worst_to_json(leaf, certificate.worst);
  Json digests = Json::array();
  for (std::uint64_t chunk = 0; chunk < leaf.chunks(); ++chunk) {
    const auto it = certificate.digests.find(chunk);
    digests.push_back(it == certificate.digests.end() ? Json(nullptr) : Json(it->second));
  }
  json["digests"] = digests;
  return json;
}

const Leaf* find_leaf(const std::string& name) {
  for (const Leaf& leaf : all_leaves()) {
    if (leaf.name == name) return &leaf;
  }
  return nullptr;
}

// The value of a field, checked; what it is of stands before its name in messages.
class Fields {
 public:
  Fields(const std::filesystem::path& file, std::string of, const Json& json)
      : file_(file.string()), of_(std::move(of)), json_(json) {}

  template <typename T>
  T get(const std::string& name, std::string_view legal) const {
    try {
      return json_.at(name).get<T>();
    } catch (const nlohmann::json::exception&) {
      fail(name, legal);
    }
  }
  [[noreturn]] void fail(const std::string& name, std::string_view legal) const {
    const bool there = json_.is_object() && json_.contains(name);
    bad_input(file_, of_ + name, there ? json_.at(name).dump().substr(0, 60) : "nothing", legal);
  }
  void expect(const std::string& name, const Json& value) const {
    if (!json_.is_object() || !json_.contains(name) || json_.at(name) != value) {
      fail(name, value.dump() + ", as this program has it");
    }
  }

 private:
  std::string file_, of_;
  const Json& json_;
};

// Inputs spread over a domain, which are others when it becomes another.
std::string some_inputs(const Leaf& leaf) {
  constexpr std::uint64_t kSome = 4096;
  std::vector<std::uint64_t> inputs(kSome * leaf.input_words);
  const std::uint64_t step = std::max<std::uint64_t>(leaf.domain.count / kSome, 1);
  for (std::uint64_t i = 0; i < std::min(kSome, leaf.domain.count); ++i) {
    leaf.domain.fill(i * step, 1, inputs.data() + i * leaf.input_words);
  }
  return {reinterpret_cast<const char*>(inputs.data()), inputs.size() * sizeof(std::uint64_t)};
}

bool is_hex(const std::string& text, std::size_t digits) {
  return text.size() == digits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::vector<Worst> worst_from_json(const Leaf& leaf, const Fields& fields) {
  std::vector<Worst> worst(leaf.quantities.size());
  const auto errors = fields.get<Json>("errors", "an array");
  try {
    for (const Json& error : errors) {
      const auto name = error.at("quantity").get<std::string>();
      const auto quantity = std::ranges::find(leaf.quantities, name, &Quantity::name);
      const auto input = whole_from_json<std::uint64_t>(error.at("input"));
      if (quantity == leaf.quantities.end() || input >= leaf.domain.count) fields.fail("errors", "those of the leaf");
      const auto measured = error.at("measured").get<double>();
      if (!std::isfinite(quantity->present(measured))) fields.fail("errors", "what can be measured");
      worst[static_cast<std::size_t>(quantity - leaf.quantities.begin())] = {measured, input};
    }
  } catch (const InputError&) {
    throw;
  } catch (const std::exception&) {
    fields.fail("errors", "an array of objects with quantity, measured and input");
  }
  if (Json again = worst_to_json(leaf, worst); again != errors)
    fields.fail("errors", "what follows from measured and input");
  return worst;
}

LeafCertificate leaf_from_json(const Leaf& leaf, const Fields& fields) {
  fields.expect("domain", leaf.domain.text);
  fields.expect("count", leaf.domain.count);
  fields.expect("chunk", std::uint64_t{1} << leaf.chunk_log2());
  LeafCertificate certificate;
  certificate.sources = fields.get<std::string>("sources", "16 hexadecimal digits");
  if (!is_hex(certificate.sources, 16)) fields.fail("sources", "16 hexadecimal digits");
  const auto digests = fields.get<Json>("digests", "an array");
  if (!digests.is_array() || digests.size() != leaf.chunks()) {
    fields.fail("digests", fmt::format("{} digests or nulls", leaf.chunks()));
  }
  for (std::uint64_t chunk = 0; chunk < leaf.chunks(); ++chunk) {
    const Json& digest = digests[chunk];
    if (digest.is_null()) continue;
    if (!digest.is_string() || !is_hex(digest.get<std::string>(), 32)) {
      fields.fail("digests", "32 hexadecimal digits or null, each");
    }
    certificate.digests[chunk] = digest.get<std::string>();
  }
  const auto mismatches = fields.get<Json>("mismatches", "an object");
  for (std::size_t i = 0; i < kWitnesses.size(); ++i) {
    const std::string witness(kWitnesses[i]);
    const bool is_count = mismatches.is_object() && mismatches.contains(witness) &&
                          mismatches.at(witness).is_number_unsigned() &&
                          mismatches.at(witness).get<std::uint64_t>() <= kMostMismatches;
    if (!is_count) fields.fail("mismatches", fmt::format("a count of each witness, 0 to {}", kMostMismatches));
    certificate.mismatches[i] = mismatches.at(witness).get<std::uint64_t>();
  }
  certificate.worst = worst_from_json(leaf, fields);
  if (certificate.is_complete(leaf)) fields.expect("digest", certificate.digest());
  return certificate;
}

}  // namespace

void LeafCertificate::add(std::uint64_t chunk, const ChunkResult& result) {
  digests[chunk] = result.digest;
  for (std::size_t i = 0; i < mismatches.size(); ++i) mismatches[i] += result.mismatches[i];
  worst.resize(result.worst.size());
  for (std::size_t k = 0; k < worst.size(); ++k) {
    worst[k].keep_worse(result.worst[k]);
  }
}

std::uint64_t LeafCertificate::mismatch_count() const {
  std::uint64_t count = 0;
  for (const std::uint64_t each : mismatches) count += each;
  return count;
}

std::string LeafCertificate::digest() const {
  std::string all;
  for (const auto& [chunk, digest] : digests) all += digest;
  const XXH128_hash_t hash = XXH3_128bits(all.data(), all.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

void Certificate::merge(const Certificate& other, const std::string& name) {
  if (other.fingerprint != fingerprint) bad_input(name, "fingerprint", other.fingerprint, fingerprint);
  for (const auto& [tool, versions] : other.tools) tools[tool].insert(versions.begin(), versions.end());
  for (const auto& [proof, hash] : other.proofs) {
    const auto [it, is_new] = proofs.try_emplace(proof, hash);
    if (it->second != hash) bad_input(name, "proof " + proof, hash, it->second + ", as in the others");
  }
  for (const auto& [leaf_name, theirs] : other.leaves) {
    const auto [it, is_new] = leaves.try_emplace(leaf_name, theirs);
    if (is_new) continue;
    LeafCertificate& ours = it->second;
    if (theirs.sources != ours.sources) {
      bad_input(name, leaf_name + ": sources", theirs.sources, ours.sources + ", as in the others");
    }
    // Counts of mismatches are of whole files: of chunks that are in both they would be counted twice, which is as
    // well.
    for (std::size_t i = 0; i < ours.mismatches.size(); ++i) ours.mismatches[i] += theirs.mismatches[i];
    for (const auto& [chunk, digest] : theirs.digests) {
      const auto [known, added] = ours.digests.try_emplace(chunk, digest);
      if (known->second != digest) {
        bad_input(name, fmt::format("{}: digest of chunk {}", leaf_name, chunk), digest,
                  known->second + ", as in the others");
      }
    }
    ours.worst.resize(theirs.worst.size());
    for (std::size_t k = 0; k < theirs.worst.size(); ++k) {
      ours.worst[k].keep_worse(theirs.worst[k]);
    }
  }
}

std::string sources_of(const Leaf& leaf, const LeafSynthesis& netlists, const LeafSynthesis& program) {
  const std::string all = netlists.leaf_hash(leaf) + program.leaf_hash(leaf) + some_inputs(leaf);
  return fmt::format("{:016x}", XXH3_64bits(all.data(), all.size()));
}

Certificate empty_certificate(const std::string& yosys) {
  Certificate certificate;
  certificate.fingerprint = fmt::format("{:016x}", fingerprint<kUnit>());
  certificate.tools["verilator"] = {std::string(verilator_version())};
  certificate.tools["yosys"] = {yosys};
  certificate.tools["compiler"] = {__VERSION__};
  return certificate;
}

Json to_json(const Certificate& certificate) {
  Json json{{"version", kVersion}, {"fingerprint", certificate.fingerprint}};
  for (const auto& [tool, versions] : certificate.tools) json["tools"][tool] = versions;
  Json leaves = Json::array();
  for (const Leaf& leaf : all_leaves()) {
    const auto it = certificate.leaves.find(leaf.name);
    if (it != certificate.leaves.end()) leaves.push_back(leaf_to_json(leaf, it->second));
  }
  json["leaves"] = leaves;
  Json proofs = Json::array();
  for (const Proof& proof : all_proofs()) {
    const auto it = certificate.proofs.find(std::string(proof.name));
    if (it == certificate.proofs.end()) continue;
    proofs.push_back({{"proof", proof.name},
                      {"claim", proof.claim},
                      {"method", method_name(proof)},
                      {"controls", proof.controls.size()},
                      {"hash", it->second}});
  }
  json["proofs"] = proofs;
  return json;
}

Certificate read_certificate(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    bad_input(file.string(), "open", "no file that can be read", "a certificate of feline prove");
  }
  const std::string text(std::istreambuf_iterator<char>(in), {});
  const Json json = parse_json(text, file.string(), "a certificate of feline prove");
  if (!json.is_object()) bad_input(file.string(), "contents", "no JSON object", "a certificate of feline prove");
  const Fields fields(file, "", json);
  fields.expect("version", kVersion);
  Certificate certificate;
  certificate.fingerprint = fields.get<std::string>("fingerprint", "16 hexadecimal digits");
  certificate.tools = fields.get<decltype(certificate.tools)>("tools", "an object of arrays of versions");
  const auto leaves = fields.get<Json>("leaves", "an array");
  const auto proofs = fields.get<Json>("proofs", "an array");
  if (!leaves.is_array()) fields.fail("leaves", "an array");
  if (!proofs.is_array()) fields.fail("proofs", "an array");
  for (const Json& each : leaves) {
    const std::string name = Fields(file, "leaves: ", each).get<std::string>("leaf", "a leaf's name");
    const Leaf* const leaf = find_leaf(name);
    if (leaf == nullptr || certificate.leaves.contains(name)) {
      bad_input(file.string(), "leaf", name, "one of feline prove --list, once");
    }
    certificate.leaves[name] = leaf_from_json(*leaf, Fields(file, name + ": ", each));
  }
  for (const Json& each : proofs) {
    const Fields proof(file, "proofs: ", each);
    const auto name = proof.get<std::string>("proof", "a proof's name");
    if (std::ranges::find(all_proofs(), name, &Proof::name) == all_proofs().end()) {
      bad_input(file.string(), "proof", name, "one of feline prove --list");
    }
    certificate.proofs[name] = proof.get<std::string>("hash", "16 hexadecimal digits");
    if (!is_hex(certificate.proofs[name], 16)) proof.fail("hash", "16 hexadecimal digits");
  }
  return certificate;
}

std::vector<std::string> missing_from(const Certificate& certificate, const std::vector<const Leaf*>& leaves,
                                      const std::vector<const Proof*>& proofs, const LeafSynthesis* synthesis) {
  std::vector<std::string> missing;
  for (const Leaf* const leaf : leaves) {
    const auto it = certificate.leaves.find(leaf->name);
    if (it == certificate.leaves.end()) {
      missing.push_back(fmt::format("{}: all of it", leaf->name));
      continue;
    }
    const LeafCertificate& of_leaf = it->second;
    if (of_leaf.mismatch_count() != 0) {
      missing.push_back(fmt::format("{}: {} mismatches", leaf->name, of_leaf.mismatch_count()));
    }
    if (synthesis != nullptr && of_leaf.sources != sources_of(*leaf, *synthesis, *synthesis)) {
      missing.push_back(fmt::format("{}: what it was proved of are other sources", leaf->name));
    }
    if (!of_leaf.is_complete(*leaf)) {
      missing.push_back(
          fmt::format("{}: {} of {} chunks", leaf->name, leaf->chunks() - of_leaf.digests.size(), leaf->chunks()));
    }
  }
  for (const Proof* const proof : proofs) {
    const auto it = certificate.proofs.find(std::string(proof->name));
    if (it == certificate.proofs.end()) {
      missing.push_back(fmt::format("proof {}", proof->name));
    } else if (synthesis != nullptr && it->second != proof_hash(*proof, *synthesis)) {
      missing.push_back(fmt::format("proof {}: it was made of other sources", proof->name));
    }
  }
  return missing;
}

}  // namespace feline::prove
