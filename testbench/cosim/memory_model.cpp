// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/memory_model.h"

namespace feline {

void MemoryModel::begin_cycle(std::uint64_t cycle) {
  request_ready_ = stall_ == 0 || !random_.chance(stall_);
  // Once offered, a response stays until it is taken.
  const bool due = !waiting_.empty() && waiting_.front().due <= cycle;
  response_valid_ = due && (response_valid_ || stall_ == 0 || !random_.chance(stall_));
}

bool MemoryModel::take_request(std::uint32_t line, std::uint64_t cycle) {
  ++requests_;
  if (line >= memory_.lines()) return false;
  const auto latency = static_cast<std::uint64_t>(latency_);
  const std::uint64_t more = stall_ == 0 ? 0 : random_.below(static_cast<std::uint32_t>(latency) + 1);
  waiting_.push_back({line, cycle + latency + more});
  return true;
}

void MemoryModel::take_response() {
  waiting_.pop_front();
  response_valid_ = false;
}

}  // namespace feline
