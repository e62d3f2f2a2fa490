// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tables/format.h"
#include "testbench/prove/domain.h"

namespace feline::prove {

using EvaluateLanes = void (*)(const std::uint64_t* inputs, std::uint64_t* outputs, std::size_t count);

// What is measured of a leaf's outputs against real arithmetic: of each input a number that rises with |error|, NaN
// where it does not count; `present` makes the error in its unit of it.
struct Quantity {
  std::string_view name;
  std::string_view unit;
  double (*present)(double) = nullptr;
};
using MeasureErrors = void (*)(const std::uint64_t* inputs, const std::uint64_t* outputs, std::size_t count,
                               double* errors);  // of each lane, each quantity

// One leaf over one domain. Several may share a wrapper.
struct Leaf {
  std::string name;          // stage.what
  std::string_view wrapper;  // feline_leaf_<wrapper>
  Domain domain;
  std::span<const Format> inputs, outputs;
  std::size_t input_words = 0, output_words = 0;
  EvaluateLanes model = nullptr, exact = nullptr;
  std::vector<Quantity> quantities{};
  MeasureErrors measure = nullptr;
  // So many of the first fields keep their values for many thousands of inputs.
  std::size_t steady_fields = 0;
  // Nothing else can come in, and what comes out is all that its modules give; or so it is of this instance in it.
  bool complete = false;
  std::string_view complete_in{};

  std::string_view stage() const { return std::string_view(name).substr(0, name.find('.')); }
  // Chunks are what is done, recorded and lost at once: seconds of work each.
  int chunk_log2() const;
  std::uint64_t chunks() const;
  std::uint64_t chunk_first(std::uint64_t chunk) const { return chunk << chunk_log2(); }
  std::uint64_t chunk_count(std::uint64_t chunk) const;
  // The lowest bit of the steady fields.
  int steady_place() const;
};

// All of them, in the order of the stages. They are those of the default configuration.
const std::vector<Leaf>& all_leaves();

// "dudx 0x7f = 127 (S7.0, texel * 2^exponent), ..." of one lane.
std::string describe_lane(std::span<const Format> fields, const std::uint64_t* lane);

}  // namespace feline::prove
