// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <unordered_map>

#include "testbench/prove/netlist.h"

// As wide as the processor's registers, chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define FELINE_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define FELINE_WIDE
#endif

namespace feline::prove {
namespace {

constexpr std::uint32_t kZeroSlot = 0;
constexpr std::uint32_t kOneSlot = 1;

// Eight words that are worked on at once.
using Slice = std::uint64_t __attribute__((vector_size(64), may_alias));
constexpr std::size_t kSliceWords = sizeof(Slice) / sizeof(std::uint64_t);

// Eight squares of 64 x 64 bits at once, rows to columns: bit j of row i to bit i of row j.
struct alignas(64) Squares {
  std::array<std::array<std::uint64_t, kSliceWords>, 64> rows;
};

FELINE_WIDE void transpose(Squares& squares) {
  auto* const rows = reinterpret_cast<Slice*>(squares.rows.data());
  std::uint64_t mask = 0x00000000ffffffff;
  for (unsigned step = 32; step != 0; step >>= 1, mask ^= mask << step) {
    for (unsigned i = 0; i < 64; i = (i + step + 1) & ~step) {
      const Slice swapped = ((rows[i] >> step) ^ rows[i + step]) & mask;
      rows[i] ^= swapped << step;
      rows[i + step] ^= swapped;
    }
  }
}

}  // namespace

NetlistProgram::NetlistProgram(const Netlist& netlist) {
  // The last gate that reads each net; outputs are read at the end.
  const std::size_t end = netlist.gates.size();
  std::unordered_map<std::uint32_t, std::size_t> last;
  for (std::size_t i = 0; i < end; ++i) {
    for (const std::uint32_t net : netlist.gates[i].reads) last[net] = i;
  }
  for (const std::uint32_t net : netlist.outputs) last[net] = end;

  std::unordered_map<std::uint32_t, std::uint32_t> slot_of{{kZeroSlot, kZeroSlot}, {kOneSlot, kOneSlot}};
  std::vector<std::uint32_t> free;
  const auto take = [&](std::uint32_t net) {
    if (free.empty()) free.push_back(static_cast<std::uint32_t>(slots_++));
    slot_of[net] = free.back();
    free.pop_back();
    return slot_of[net];
  };
  for (const std::uint32_t net : netlist.inputs) inputs_.push_back(take(net));
  const auto slot = [&](std::uint32_t net) {
    const auto it = slot_of.find(net);
    if (it == slot_of.end()) throw std::runtime_error(fmt::format("net {} has no driver", net));
    return it->second;
  };
  for (std::size_t i = 0; i < end; ++i) {
    const Netlist::Gate& gate = netlist.gates[i];
    Step step{gate.kind, slot(gate.reads[0]), slot(gate.reads[1]), slot(gate.reads[2]), 0};
    for (const std::uint32_t net : gate.reads) {
      if (net <= kOneSlot || last[net] != i) continue;
      free.push_back(slot_of[net]);
      last[net] = end + 1;  // once
    }
    step.out = take(gate.writes);
    steps_.push_back(step);
  }
  for (const std::uint32_t net : netlist.outputs) outputs_.push_back(slot(net));
}

FELINE_WIDE void NetlistProgram::run(const Step* steps, std::size_t count, std::uint64_t* slots) {
  using Kind = Netlist::Kind;
  constexpr std::size_t kSlices = kWords / kSliceWords;
  auto* const values = reinterpret_cast<Slice*>(slots);
  for (const Step* step = steps; step != steps + count; ++step) {
    const Slice* const a = values + step->a * kSlices;
    const Slice* const b = values + step->b * kSlices;
    const Slice* const select = values + step->select * kSlices;
    Slice* const out = values + step->out * kSlices;
    switch (step->kind) {
      case Kind::kAnd:
        for (std::size_t i = 0; i < kSlices; ++i) out[i] = a[i] & b[i];
        break;
      case Kind::kAndNot:
        for (std::size_t i = 0; i < kSlices; ++i) out[i] = a[i] & ~b[i];
        break;
      case Kind::kOr:
        for (std::size_t i = 0; i < kSlices; ++i) out[i] = a[i] | b[i];
        break;
      case Kind::kOrNot:
        for (std::size_t i = 0; i < kSlices; ++i) out[i] = a[i] | ~b[i];
        break;
      case Kind::kNand:
        for (std::size_t i = 0; i < kSlices; ++i) out[i] = ~(a[i] & b[i]);
        break;
      case Kind::kNor:
        for (std::size_t i = 0; i < kSlices; ++i) out[i] = ~(a[i] | b[i]);
        break;
      case Kind::kXor:
        for (std::size_t i = 0; i < kSlices; ++i) out[i] = a[i] ^ b[i];
        break;
      case Kind::kXnor:
        for (std::size_t i = 0; i < kSlices; ++i) out[i] = ~(a[i] ^ b[i]);
        break;
      case Kind::kNot:
        for (std::size_t i = 0; i < kSlices; ++i) out[i] = ~a[i];
        break;
      case Kind::kMux:
        for (std::size_t i = 0; i < kSlices; ++i) out[i] = a[i] ^ ((a[i] ^ b[i]) & select[i]);
        break;
    }
  }
}

void NetlistProgram::evaluate(const std::uint64_t* inputs, std::size_t input_words, std::uint64_t* outputs,
                              std::size_t output_words, std::size_t count, std::vector<std::uint64_t>& scratch) const {
  scratch.resize(slots_ * kWords + 8);
  const auto address = reinterpret_cast<std::uintptr_t>(scratch.data());
  std::uint64_t* const slots = scratch.data() + (64 - address % 64) % 64 / sizeof(std::uint64_t);
  std::fill_n(slots + kZeroSlot * kWords, kWords, 0);
  std::fill_n(slots + kOneSlot * kWords, kWords, ~std::uint64_t{0});
  constexpr std::size_t kSquareLanes = 64 * kSliceWords;
  Squares squares;
  for (std::size_t first = 0; first < count; first += kSquareLanes) {
    for (std::size_t word = 0; word < input_words; ++word) {
      for (std::size_t square = 0; square < kSliceWords; ++square) {
        for (std::size_t i = 0; i < 64; ++i) {
          const std::size_t lane = first + square * 64 + i;
          squares.rows[i][square] = lane < count ? inputs[lane * input_words + word] : 0;
        }
      }
      transpose(squares);
      for (std::size_t bit = word * 64; bit < std::min(inputs_.size(), word * 64 + 64); ++bit) {
        std::ranges::copy(squares.rows[bit % 64], slots + inputs_[bit] * kWords + first / 64);
      }
    }
  }
  run(steps_.data(), steps_.size(), slots);
  for (std::size_t first = 0; first < count; first += kSquareLanes) {
    for (std::size_t word = 0; word < output_words; ++word) {
      squares = {};
      for (std::size_t bit = word * 64; bit < std::min(outputs_.size(), word * 64 + 64); ++bit) {
        std::copy_n(slots + outputs_[bit] * kWords + first / 64, kSliceWords, squares.rows[bit % 64].begin());
      }
      transpose(squares);
      for (std::size_t square = 0; square < kSliceWords; ++square) {
        for (std::size_t i = 0; i < 64; ++i) {
          const std::size_t lane = first + square * 64 + i;
          if (lane < count) outputs[lane * output_words + word] = squares.rows[i][square];
        }
      }
    }
  }
}

}  // namespace feline::prove
