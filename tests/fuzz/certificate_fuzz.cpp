// SPDX-License-Identifier: Apache-2.0
// certificate.json of feline prove: what is taken is written again as it is, and none is whole that has a mismatch.
#include "testbench/prove/certificate.h"
#include "tests/fuzz/fuzz.h"

namespace feline::prove {
namespace {

void check(Certificate certificate) {
  const std::string text = to_json(certificate).dump(1);
  const Certificate again = read_certificate(fuzz::file_with("again.json", text));
  fuzz::require(to_json(again).dump(1) == text, "to_json: the same after reading");
  certificate.merge(again, "again");
  for (const auto& [name, leaf] : certificate.leaves) {
    fuzz::require((leaf.mismatch_count() == 0) == std::ranges::all_of(leaf.mismatches, [](auto n) { return n == 0; }),
                  "mismatch_count: none is lost");
    fuzz::require(leaf.digests == again.leaves.at(name).digests, "merge: with itself changes nothing");
  }
  std::vector<const Leaf*> leaves;
  for (const Leaf& leaf : all_leaves()) leaves.push_back(&leaf);
  std::vector<const Proof*> proofs;
  for (const Proof& proof : all_proofs()) proofs.push_back(&proof);
  const bool has_all = certificate.leaves.size() == leaves.size() && certificate.proofs.size() == proofs.size();
  fuzz::require(has_all || !missing_from(certificate, leaves, proofs).empty(), "missing_from: tells what is missing");
}

}  // namespace
}  // namespace feline::prove

void feline::fuzz::run(Input input) {
  const auto path = file_with("certificate.json", input.rest());
  accepts([&] { prove::check(prove::read_certificate(path)); });
}
