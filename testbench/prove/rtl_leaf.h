// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace feline::prove {

// A leaf's RTL, as Verilator compiles it: a function of the wrapper's inputs.
class RtlLeaf {
 public:
  virtual ~RtlLeaf() = default;
  virtual void evaluate(const std::uint64_t* inputs, std::uint64_t* outputs, std::size_t count) = 0;
};

// feline_leaf_<name>; each thread makes its own. nullptr when there is none of that name.
std::unique_ptr<RtlLeaf> make_rtl_leaf(std::string_view name);

// Of the Verilator that compiled them.
std::string_view verilator_version();

}  // namespace feline::prove
