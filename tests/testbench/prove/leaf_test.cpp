// SPDX-License-Identifier: Apache-2.0
// Every leaf by every witness but the netlist, on inputs drawn from its domain; and that a wrong witness is told.
#include "testbench/prove/leaf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "testbench/prove/chunk.h"
#include "testbench/prove/leaves.h"
#include "testbench/random.h"
#include "tests/support/random.h"

namespace feline::prove {
namespace {

constexpr std::size_t kLanes = 3000;

const Leaf& leaf_of(const std::string& name) {
  const auto it = std::ranges::find(all_leaves(), name, &Leaf::name);
  EXPECT_NE(it, all_leaves().end()) << name;
  return *it;
}

TEST(leaf, model_and_rtl_are_exact_on_inputs_of_the_domain) {
  const SeedTrace trace(__FILE__, __LINE__);
  for (const Leaf& leaf : all_leaves()) {
    const std::unique_ptr<RtlLeaf> rtl = make_rtl_leaf(leaf.wrapper);
    ASSERT_NE(rtl, nullptr) << leaf.wrapper;
    SplitMix64 draw(seed());
    std::vector<std::uint64_t> inputs(kLanes * leaf.input_words);
    const std::uint64_t runs = std::min<std::uint64_t>(kLanes, leaf.domain.count);
    for (std::uint64_t i = 0; i < runs; ++i) {
      leaf.domain.fill(draw.next() % leaf.domain.count, 1, inputs.data() + i * leaf.input_words);
    }
    std::vector<std::uint64_t> exact(kLanes * leaf.output_words);
    std::vector<std::uint64_t> got(exact);
    leaf.exact(inputs.data(), exact.data(), runs);
    leaf.model(inputs.data(), got.data(), runs);
    EXPECT_EQ(got, exact) << leaf.name << ": model";
    rtl->evaluate(inputs.data(), got.data(), runs);
    EXPECT_EQ(got, exact) << leaf.name << ": rtl";
  }
}

// Wherever a block begins, its inputs are the same.
TEST(leaf, domains_are_filled_in_any_pieces) {
  const SeedTrace trace(__FILE__, __LINE__);
  for (const Leaf& leaf : all_leaves()) {
    SplitMix64 draw(seed());
    for (int round = 0; round < 10; ++round) {
      const std::uint64_t lanes = std::min<std::uint64_t>(500, leaf.domain.count);
      const std::uint64_t first = draw.next() % (leaf.domain.count - lanes + 1);
      std::vector<std::uint64_t> whole(lanes * leaf.input_words);
      leaf.domain.fill(first, lanes, whole.data());
      std::vector<std::uint64_t> pieces(whole.size());
      for (std::uint64_t i = 0; i < lanes;) {
        const std::uint64_t some = std::min<std::uint64_t>(1 + draw.below(100), lanes - i);
        leaf.domain.fill(first + i, some, pieces.data() + i * leaf.input_words);
        i += some;
      }
      ASSERT_EQ(pieces, whole) << leaf.name << ", from " << first;
    }
  }
}

TEST(leaf, the_last_input_is_there_and_chunks_cover_all) {
  for (const Leaf& leaf : all_leaves()) {
    std::vector<std::uint64_t> lane(leaf.input_words);
    leaf.domain.fill(leaf.domain.count - 1, 1, lane.data());
    std::uint64_t covered = 0;
    for (std::uint64_t chunk = 0; chunk < leaf.chunks(); ++chunk) {
      EXPECT_EQ(leaf.chunk_first(chunk), covered) << leaf.name;
      covered += leaf.chunk_count(chunk);
    }
    EXPECT_EQ(covered, leaf.domain.count) << leaf.name;
    EXPECT_LE(leaf.chunks(), 256U) << leaf.name;
  }
}

TEST(leaf, domains_have_the_counts_that_the_readme_tells) {
  EXPECT_EQ(leaf_of("footprint.simple").domain.count, std::uint64_t{255} * 255 * 255 * 255);
  EXPECT_EQ(leaf_of("footprint.table").domain.count, std::uint64_t{255} * 255 * 255 * 255);
  EXPECT_EQ(leaf_of("group.position").domain.count, std::uint64_t{1} << 34);
  EXPECT_EQ(leaf_of("filter.interpolate").domain.count, std::uint64_t{1} << 32);
  EXPECT_EQ(leaf_of("plan.level_of_radius").domain.count, std::uint64_t{1} << 22);
  EXPECT_EQ(leaf_of("address.scale").domain.count, (std::uint64_t{4096 + 2} << 24));
  // Rows of four mantissas, the last fastest, from -127 on.
  std::uint64_t lane = 0;
  leaf_of("footprint.table").domain.fill(256, 1, &lane);
  EXPECT_EQ(unpack_lane<Footprint::kInputs>(&lane), (Footprint::Inputs{5, -127, -127, -126, -126}));
}

// A witness that is wrong for one input of a chunk.
void wrong_once(const std::uint64_t* inputs, std::uint64_t* outputs, std::size_t count) {
  evaluate_model<ProbeWeight>(inputs, outputs, count);
  for (std::size_t i = 0; i < count; ++i) {
    if (unpack_lane<ProbeWeight::kInputs>(inputs + i) == ProbeWeight::Inputs{7, 22, 3}) outputs[i] ^= 1U << 4;
  }
}

// Gates that give what the RTL gives are not at hand here: all outputs are 0, and every input is a mismatch.
Netlist no_gates(const Leaf& leaf) {
  int in = 0;
  int out = 0;
  for (const Format& field : leaf.inputs) in += field.width();
  for (const Format& field : leaf.outputs) out += field.width();
  nlohmann::json inputs = nlohmann::json::array();
  for (int i = 0; i < in; ++i) inputs.push_back(2 + i);
  const std::vector<std::string> outputs(static_cast<std::size_t>(out), "0");
  const nlohmann::json json{{"modules",
                             {{"top",
                               {{"ports", {{"inputs_i", {{"bits", inputs}}}, {"outputs_o", {{"bits", outputs}}}}},
                                {"cells", nlohmann::json::object()}}}}}};
  return {json.dump(), "top"};
}

TEST(leaf, a_wrong_witness_is_counted_and_told) {
  Leaf leaf = leaf_of("walk.probe_weight");
  leaf.model = &wrong_once;
  ChunkProver prover;
  ChunkResult result = prover.prove(leaf, 0, no_gates(leaf));
  EXPECT_EQ(result.mismatches[0], 1U);
  EXPECT_EQ(result.mismatches[1], 0U);
  EXPECT_EQ(result.mismatches[2], leaf.domain.count);
  ASSERT_TRUE(result.first.has_value());
  const ChunkResult right = prover.prove(leaf_of("walk.probe_weight"), 0, no_gates(leaf));
  EXPECT_EQ(right.mismatches[0], 0U);
  EXPECT_EQ(right.digest, result.digest);

  // Exact arithmetic that differs: model and RTL are told, and the digest is another.
  leaf = leaf_of("walk.probe_weight");
  leaf.exact = &wrong_once;
  result = prover.prove(leaf, 0, no_gates(leaf));
  EXPECT_EQ(result.mismatches[0], 1U);
  EXPECT_EQ(result.mismatches[1], 1U);
  EXPECT_NE(result.digest, right.digest);
}

TEST(leaf, lanes_are_told_field_by_field) {
  const Leaf& leaf = leaf_of("footprint.table");
  std::uint64_t lane = 0;
  pack_lane<Footprint::kInputs>({5, -3, 127, 0, 1}, &lane);
  EXPECT_EQ(describe_lane(leaf.inputs, &lane),
            "mode 0x5 = 5 (U3.0, code), dudx 0xfd = -3 (S7.0, texel * 2^exponent), dvdx 0x7f = 127 (S7.0, texel * "
            "2^exponent), dudy 0x00 = 0 (S7.0, texel * 2^exponent), dvdy 0x01 = 1 (S7.0, texel * 2^exponent)");
}

}  // namespace
}  // namespace feline::prove
