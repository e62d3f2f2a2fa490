// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/stall_bins.h"

#include <fmt/format.h>

namespace feline::coverage {
namespace {

// In the order of the grids.
enum StallGrid : std::size_t { kStalls, kResets };

constexpr std::size_t kRequest = kStageCount;
constexpr std::size_t kMemoryRequest = kRequest + 1;
constexpr std::size_t kMemoryResponse = kRequest + 2;

std::vector<std::string> boundaries() {
  std::vector<std::string> names(kStageNames.begin(), kStageNames.end());
  for (const char* port : {"request", "memory request", "memory response"}) names.emplace_back(port);
  return names;
}

constexpr std::size_t kClasses = 4;
constexpr std::array<const char*, kClasses> kClassNames{"0", "1", "2 to 7", "8 or more"};
std::size_t length_class(std::uint64_t cycles) { return cycles < 2 ? cycles : cycles < 8 ? 2 : 3; }

BinGrid stall_grid() {
  std::vector<std::string> columns;
  for (const char* gap : kClassNames) {
    for (const char* wait : kClassNames) columns.push_back(fmt::format("gap {}, wait {}", gap, wait));
  }
  return {"stall",
          "Cycles without an offer before a beat, and cycles that the beat waited to be taken.",
          {"boundary or port", boundaries()},
          {"gap, wait", columns}};
}

BinGrid reset_grid() {
  std::vector<std::string> columns(kStageNames.begin(), kStageNames.end());
  columns.emplace_back("memory request");
  return {"reset", "Beats on offer that a reset forgets.", {"", words({"reset"})}, {"boundary", columns}};
}

}  // namespace

StallBins::StallBins() : grids_{stall_grid(), reset_grid()} {}

void StallBins::beat(std::size_t index, bool valid, bool ready) {
  Wire& wire = wires_[index];
  if (!valid) {
    ++wire.gap;
    return;
  }
  if (!ready) {
    ++wire.wait;
    return;
  }
  if (wire.runs) grids_[kStalls].count(index, kClasses * length_class(wire.gap) + length_class(wire.wait));
  wire = {0, 0, true};
}

void StallBins::cycle(const RtlUnit::Inputs& inputs, const RtlUnit::Outputs& outputs) {
  if (inputs.reset) {
    // What was on offer in the cycle before and not taken is still there when the reset comes.
    for (std::size_t stage = 0; stage < kStageCount; ++stage) {
      if ((offered_ >> stage & 1) != 0) grids_[kResets].count(0, stage);
    }
    if (memory_request_) grids_[kResets].count(0, kStageCount);
    wires_ = {};
  } else {
    for (std::size_t stage = 0; stage < kStageCount; ++stage) {
      beat(stage, (outputs.offered >> stage & 1) != 0, (outputs.taken >> stage & 1) != 0);
    }
    beat(kRequest, inputs.request_valid, outputs.request_ready);
    beat(kMemoryRequest, outputs.memory_request_valid, inputs.memory_request_ready);
    beat(kMemoryResponse, inputs.memory_response_valid, outputs.memory_response_ready);
  }
  offered_ = inputs.reset ? 0 : outputs.offered & ~outputs.taken;
  memory_request_ = !inputs.reset && outputs.memory_request_valid && !inputs.memory_request_ready;
}

}  // namespace feline::coverage
