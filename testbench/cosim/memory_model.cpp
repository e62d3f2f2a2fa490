// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/memory_model.h"

#include <algorithm>

namespace feline {

void MemoryModel::begin_cycle(std::uint64_t cycle) {
  request_ready_ = stall_ == 0 || !random_.chance(stall_);
  // Once offered, a response stays until it is taken.
  const bool due = !waiting_.empty() && waiting_.front().due <= cycle;
  response_valid_ = due && (response_valid_ || stall_ == 0 || !random_.chance(stall_));
}

void MemoryModel::take_request(std::uint32_t line, std::uint64_t cycle) {
  // A line beyond the texture is the unit's mistake, which the address stage's beats show; answer with the last one.
  const auto last = static_cast<std::int64_t>(memory_.lines()) - 1;
  waiting_.push_back({std::min<std::int64_t>(line, last), cycle + static_cast<std::uint64_t>(latency_)});
  ++requests_;
}

void MemoryModel::take_response() {
  waiting_.pop_front();
  response_valid_ = false;
}

}  // namespace feline
