// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/certificate.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/testbench/temp_dir.h"

namespace feline::prove {
namespace {

const Leaf& small_leaf() {
  static const Leaf& leaf = *std::ranges::find(all_leaves(), "plan.level_of_radius", &Leaf::name);
  return leaf;
}

std::string digest_of(std::uint64_t chunk) { return fmt::format("{:032x}", 1000 + chunk); }

// Chunks of one leaf, as if they had been proved.
Certificate with_chunks(const std::vector<std::uint64_t>& chunks) {
  Certificate certificate = empty_certificate("Yosys 0.23");
  LeafCertificate& leaf = certificate.leaves[small_leaf().name];
  leaf.sources = "0123456789abcdef";
  for (const std::uint64_t chunk : chunks) {
    leaf.add(chunk, {digest_of(chunk), {0, 0, 0}, {}, {{static_cast<double>(chunk % 3) / 1024, 7 + chunk}}});
  }
  return certificate;
}

std::string text_of(const Certificate& certificate) { return to_json(certificate).dump(1); }

std::vector<std::uint64_t> all_chunks() {
  std::vector<std::uint64_t> chunks;
  for (std::uint64_t chunk = 0; chunk < small_leaf().chunks(); ++chunk) chunks.push_back(chunk);
  return chunks;
}

TEST(certificate, is_the_same_after_writing_and_reading) {
  const TempDir dir;
  for (const auto& chunks : {all_chunks(), std::vector<std::uint64_t>{1, 3}}) {
    write_bytes(dir / "c.json", text_of(with_chunks(chunks)));
    EXPECT_EQ(text_of(read_certificate(dir / "c.json")), text_of(with_chunks(chunks)));
  }
}

TEST(certificate, parts_make_the_whole_in_any_order) {
  Certificate merged = with_chunks({3, 1});
  merged.merge(with_chunks({2}), "b");
  merged.merge(with_chunks({0, 2}), "c");
  EXPECT_EQ(text_of(merged), text_of(with_chunks(all_chunks())));
  EXPECT_EQ(merged.leaves.at(small_leaf().name).worst[0], (Worst{2.0 / 1024, 9}));
}

TEST(certificate, parts_that_do_not_agree_are_refused) {
  Certificate certificate = with_chunks({1, 2});
  Certificate other = with_chunks({2});
  other.leaves.begin()->second.digests[2] = digest_of(9);
  EXPECT_NE(input_error([&] { certificate.merge(other, "other.json"); }).find("digest of chunk 2"), std::string::npos);
  other = with_chunks({3});
  other.leaves.begin()->second.sources = "fedcba9876543210";
  EXPECT_NE(input_error([&] { certificate.merge(other, "other.json"); }).find("sources"), std::string::npos);
  other = with_chunks({3});
  other.fingerprint = "0";
  EXPECT_NE(input_error([&] { certificate.merge(other, "other.json"); }).find("fingerprint"), std::string::npos);
}

TEST(certificate, says_what_is_missing) {
  const std::vector<const Leaf*> leaves{&small_leaf()};
  EXPECT_TRUE(missing_from(with_chunks(all_chunks()), leaves, {}).empty());
  EXPECT_EQ(missing_from(with_chunks({0, 2}), leaves, {}),
            std::vector<std::string>{"plan.level_of_radius: 2 of 4 chunks"});
  EXPECT_EQ(missing_from(empty_certificate(""), leaves, {}),
            std::vector<std::string>{"plan.level_of_radius: all of it"});
  Certificate wrong = with_chunks(all_chunks());
  wrong.leaves.begin()->second.mismatches[1] = 3;
  EXPECT_EQ(missing_from(wrong, leaves, {}), std::vector<std::string>{"plan.level_of_radius: 3 mismatches"});
}

TEST(certificate, proofs_must_be_made_of_the_same_sources) {
  const std::vector<const Proof*> proofs{&all_proofs()[0], &all_proofs()[1]};
  const std::string first(proofs[0]->name);
  const std::string second(proofs[1]->name);
  Certificate certificate = empty_certificate("");
  certificate.proofs[first] = "0123456789abcdef";
  EXPECT_EQ(missing_from(certificate, {}, proofs), std::vector<std::string>{"proof " + second});
  Certificate other = empty_certificate("");
  other.proofs[second] = "00000000000000ff";
  certificate.merge(other, "other");
  EXPECT_TRUE(missing_from(certificate, {}, proofs).empty());
  const TempDir dir;
  write_bytes(dir / "c.json", text_of(certificate));
  EXPECT_EQ(read_certificate(dir / "c.json").proofs, certificate.proofs);
  other.proofs[first] = "0123456789abcdee";
  EXPECT_NE(input_error([&] { certificate.merge(other, "other.json"); }).find("proof " + first), std::string::npos);
}

// A changed field is told by its name.
TEST(certificate, refuses_what_was_tampered_with) {
  const TempDir dir;
  const std::string text = text_of(with_chunks(all_chunks()));
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    write_bytes(dir / "c.json", changed);
    return input_error([&] { read_certificate(dir / "c.json"); });
  };
  const auto expect_part = [&](const std::string& from, const std::string& to, const std::string& part) {
    const std::string message = refused(from, to);
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_NE(message.find("c.json"), std::string::npos) << message;
  };
  expect_part("\"version\": 1", "\"version\": 2", "version: got 2, legal is 1");
  expect_part(digest_of(2), digest_of(7), "digest: got");
  expect_part(digest_of(2), "short", "digests");
  expect_part("\"count\": 4194304", "\"count\": 4194303", "count: got 4194303, legal is 4194304");
  expect_part("\"leaf\": \"plan.level_of_radius\"", "\"leaf\": \"plan.moon\"", "leaf: got plan.moon");
  expect_part("\"sources\": \"0123456789abcdef\"", "\"sources\": 5", "sources: got 5");
  expect_part("\"rtl\": 0", "\"rtl\": -1", "mismatches");
  expect_part("\"measured\": 0.001953125", "\"measured\": 0.0029296875", "errors");
  expect_part("\"input\": 9", "\"input\": 8", "errors");
  expect_part("\"input\": 9", "\"input\": 1e23", "errors");
  expect_part("{", "", "JSON: got");
  // More than a double holds, once it is in the error's unit or in its digits.
  expect_part("\"measured\": 0.001953125", "\"measured\": 1.7976931348623157e308", "errors");
  expect_part("\"proofs\": []", "\"proofs\": null", "proofs: got null, legal is an array");
  // Two halves of 2^64 would be no mismatches at all.
  expect_part("\"rtl\": 0", "\"rtl\": 9223372036854775808", "mismatches");
  expect_part("\"digests\": [", "\"digests\": " + std::string(200000, '['), "nesting");
  EXPECT_NE(input_error([&] { read_certificate(dir / "none.json"); }).find("none.json"), std::string::npos);
}

}  // namespace
}  // namespace feline::prove
