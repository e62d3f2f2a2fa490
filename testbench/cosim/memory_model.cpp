// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/memory_model.h"

namespace feline {

MemoryModel::MemoryModel(const TextureMemory& memory, const Conditions& conditions, std::uint64_t seed)
    : memory_(memory),
      latency_(static_cast<std::uint32_t>(conditions.memory_latency)),
      jitter_(conditions.at(Port::kMemoryResponse).chance != 0),
      request_stalls_(conditions.at(Port::kMemoryRequest), derived_seed(seed, 1)),
      response_stalls_(conditions.at(Port::kMemoryResponse), derived_seed(seed, 2)),
      random_(seed) {}

void MemoryModel::begin_cycle(std::uint64_t cycle) {
  request_ready_ = !request_stalls_.stalls();
  // Once offered, a response stays until it is taken.
  const bool due = !waiting_.empty() && waiting_.front().due <= cycle;
  const bool stalls = response_stalls_.stalls();
  response_valid_ = due && (response_valid_ || !stalls);
  responds_in_same_cycle_ = latency_ == 0 && waiting_.empty() && !stalls;
}

bool MemoryModel::take_request(std::uint32_t line, std::uint64_t cycle) {
  ++requests_;
  if (!memory_.has_line(line)) return false;
  waiting_.push_back({line, cycle + latency_ + (jitter_ ? random_.below(latency_ + 1) : 0)});
  response_valid_ = response_valid_ || responds_in_same_cycle_;
  return true;
}

void MemoryModel::take_response() {
  waiting_.pop_front();
  response_valid_ = false;
}

}  // namespace feline
