// SPDX-License-Identifier: Apache-2.0
// The worst errors of the certificate that is checked in, once more at 200 bits, and that no other input is worse.
#include "testbench/prove/errors.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <numbers>

#include "testbench/prove/certificate.h"
#include "testbench/prove/lane_loop.h"
#include "testbench/prove/leaves.h"
#include "testbench/random.h"
#include "testbench/stability/real.h"
#include "tests/support/random.h"

namespace feline::prove {
namespace {

const Certificate& certificate() {
  static const Certificate read =
      read_certificate(std::filesystem::path(FELINE_SOURCE_DIR) / "testbench/prove/certificate.json");
  return read;
}

const Leaf& named_leaf(const std::string& name) { return *std::ranges::find(all_leaves(), name, &Leaf::name); }

// The four errors of a footprint, at 200 bits: by the sides' singular values, from their sum and product.
std::array<Real, 4> ellipse_errors(const Footprint::Inputs& in, const Footprint::Outputs& out) {
  const Real a(static_cast<double>(in[1]));
  const Real b(static_cast<double>(in[2]));
  const Real c(static_cast<double>(in[3]));
  const Real d(static_cast<double>(in[4]));
  const Real area = abs(a * d - b * c);
  const Real squares = a * a + b * b + c * c + d * d;
  const Real sum = sqrt(squares + area * 2);
  const Real difference = sqrt(squares - area * 2);
  const Real major = (sum + difference) / 2;
  const Real minor = (sum - difference) / 2;
  const Real unit_major = Real::ratio(out[2], 128);
  const Real unit_minor = Real::ratio(out[3], 128);
  const auto widened = [](const Real& low, const Real& high) {
    const Real least = high * Real::ratio(2, 17);
    return low < least ? least : low;
  };
  const Real level = log2(widened(unit_minor, unit_major) / widened(minor, major));
  const Real direction = atan2((a * b + c * d) * 2, a * a + c * c - b * b - d * d) / 2;
  const Real angle = atan2(Real(static_cast<double>(out[1])), Real(static_cast<double>(out[0]))) - direction;
  return {abs(unit_major - major) / major, abs(unit_minor - minor) / major, abs(level),
          atan2(abs(sin(angle)), abs(cos(angle))) * 180 / std::numbers::pi};
}

TEST(prove_errors, the_worst_footprints_are_so_at_200_bits) {
  for (const char* const name : {"footprint.simple", "footprint.table", "footprint.ext"}) {
    const Leaf& leaf = named_leaf(name);
    const LeafCertificate& proved = certificate().leaves.at(name);
    ASSERT_EQ(proved.worst.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      std::uint64_t lane = 0;
      std::uint64_t result = 0;
      leaf.domain.fill(proved.worst[k].input, 1, &lane);
      leaf.exact(&lane, &result, 1);
      const auto errors =
          ellipse_errors(unpack_lane<Footprint::kInputs>(&lane), unpack_lane<Footprint::kOutputs>(&result));
      EXPECT_NEAR(errors[k].to_double(), leaf.quantities[k].present(proved.worst[k].value), 1e-9)
          << name << ": " << leaf.quantities[k].name;
    }
  }
}

TEST(prove_errors, the_readme_tells_those_of_the_certificate) {
  std::ifstream file(std::filesystem::path(FELINE_SOURCE_DIR) / "README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  for (const auto& [mode, name] :
       {std::pair{"Simple", "footprint.simple"}, {"Table", "footprint.table"}, {"EXT", "footprint.ext"}}) {
    const Leaf& leaf = named_leaf(name);
    const LeafCertificate& proved = certificate().leaves.at(name);
    std::string row = fmt::format("| {} |", mode);
    for (std::size_t k = 0; k < 4; ++k) {
      std::uint64_t lane = 0;
      leaf.domain.fill(proved.worst[k].input, 1, &lane);
      const auto in = unpack_lane<Footprint::kInputs>(&lane);
      const double worst = leaf.quantities[k].present(proved.worst[k].value);
      const std::string number = k < 2    ? fmt::format("{:.4f}", worst)
                                 : k == 2 ? fmt::format("{:.3f} octaves", worst)
                                          : fmt::format("{:.2f} degrees", worst);
      row += fmt::format(" {} at ({}, {}, {}, {}) |", number, in[1], in[2], in[3], in[4]);
    }
    EXPECT_NE(readme.find(row), std::string::npos) << row;
  }
  const auto worst = [](const char* name) {
    return named_leaf(name).quantities[0].present(certificate().leaves.at(name).worst[0].value);
  };
  const std::string rest = fmt::format(
      "The level of detail of a radius is within {:.5f} octave, a weight within {:.5f} of its row's own, a Gaussian "
      "texel weight\nwithin {:.5f},",
      worst("plan.level_of_radius"), worst("walk.probe_weight"), worst("filter.kernel_weight"));
  EXPECT_NE(readme.find(rest), std::string::npos) << rest;
  std::uint64_t inputs = 0;
  for (const Leaf& leaf : all_leaves()) inputs += leaf.domain.count;
  std::string count = fmt::format("{}", inputs);
  for (auto at = static_cast<std::ptrdiff_t>(count.size()) - 3; at > 0; at -= 3) {
    count.insert(static_cast<std::size_t>(at), ",");
  }
  EXPECT_NE(readme.find(count + " inputs, 0 mismatches"), std::string::npos) << count;
}

TEST(prove_errors, no_input_is_worse_than_the_certificate_says) {
  const SeedTrace trace(__FILE__, __LINE__);
  constexpr std::size_t kLanes = 4096;
  for (const Leaf& leaf : all_leaves()) {
    if (leaf.measure == nullptr) continue;
    const LeafCertificate& proved = certificate().leaves.at(leaf.name);
    SplitMix64 draw(seed());
    const std::size_t lanes = std::min<std::uint64_t>(kLanes, leaf.domain.count);
    std::vector<std::uint64_t> inputs(lanes * leaf.input_words);
    std::vector<std::uint64_t> outputs(lanes * leaf.output_words);
    std::vector<double> errors(lanes * leaf.quantities.size());
    for (std::size_t i = 0; i < lanes; ++i) {
      leaf.domain.fill(draw.next() % leaf.domain.count, 1, inputs.data() + i * leaf.input_words);
    }
    leaf.exact(inputs.data(), outputs.data(), lanes);
    leaf.measure(inputs.data(), outputs.data(), lanes, errors.data());
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const std::size_t k = i % leaf.quantities.size();
      EXPECT_FALSE(errors[i] > proved.worst[k].value + 0x1p-39) << leaf.name << ": " << leaf.quantities[k].name;
    }
  }
}

}  // namespace
}  // namespace feline::prove
