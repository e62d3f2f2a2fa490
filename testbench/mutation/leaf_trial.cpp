// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/leaf_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "testbench/parallel.h"
#include "testbench/progress.h"
#include "testbench/prove/steady_program.h"
#include "testbench/text_number.h"

namespace feline::mutation {
namespace {

using prove::Netlist;
using prove::NetlistProgram;
using Gate = Netlist::Gate;

// Gates of many circuits of the same inputs, those of the first one shared. Literals are 2n for what net n has, 2n + 1
// for its opposite; net 0 is the constant 0.
class SharedGates {
 public:
  explicit SharedGates(std::uint32_t first_net) : next_(first_net) {}

  // What is added from now on is forgotten by the next call.
  void begin_another() {
    shared_ = true;
    own_.clear();
  }

  std::uint32_t both(std::uint32_t a, std::uint32_t b) {
    if (a < b) std::swap(a, b);
    if (b == 0 || a == (b ^ 1)) return 0;
    if (b == 1 || a == b) return a;
    const std::uint64_t key = std::uint64_t{a} << 32 | b;
    if (const auto found = common_.find(key); found != common_.end()) return found->second;
    const auto [place, is_new] = (shared_ ? own_ : common_).emplace(key, 0);
    if (!is_new) return place->second;
    Netlist::Kind kind = Netlist::Kind::kNor;
    if ((a & 1) == 0) {
      kind = (b & 1) == 0 ? Netlist::Kind::kAnd : Netlist::Kind::kAndNot;
    } else if ((b & 1) == 0) {
      kind = Netlist::Kind::kAndNot;
      std::swap(a, b);
    }
    return place->second = 2 * add(kind, a / 2, b / 2);
  }

  std::uint32_t add(Netlist::Kind kind, std::uint32_t a, std::uint32_t b) {
    gates_.push_back({kind, {a, b, 0}, next_});
    return next_++;
  }

  std::vector<Gate> take() { return std::move(gates_); }

 private:
  std::uint32_t next_;
  bool shared_ = false;
  std::unordered_map<std::uint64_t, std::uint32_t> common_, own_;
  std::vector<Gate> gates_;
};

// The literals of the outputs.
std::vector<std::uint32_t> add_circuit(const Aiger& aiger, const std::vector<std::uint32_t>& inputs,
                                       SharedGates& gates) {
  std::vector<std::uint32_t> literals = inputs;
  const auto moved = [&](std::uint32_t literal) { return literals[literal / 2] ^ (literal & 1); };
  for (const Aiger::Gate& gate : aiger.gates) literals.push_back(gates.both(moved(gate.left), moved(gate.right)));
  std::vector<std::uint32_t> outputs;
  for (const Aiger::Output& output : aiger.outputs) outputs.push_back(moved(output.literal));
  return outputs;
}

// The number of a bit of inputs_i.
std::optional<std::uint32_t> input_place(std::string_view name) {
  constexpr std::string_view kBegin = "inputs_i[";
  if (name == "inputs_i") return 0;
  if (!name.starts_with(kBegin) || !name.ends_with(']')) return std::nullopt;
  return number_of<std::uint32_t>(name.substr(kBegin.size(), name.size() - kBegin.size() - 1));
}

// The net of whether the outputs differ.
std::uint32_t add_difference(const std::vector<std::uint32_t>& right, const std::vector<std::uint32_t>& wrong,
                             SharedGates& gates) {
  std::uint32_t differs = 0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (right[i] == wrong[i]) continue;
    const bool opposite = ((right[i] ^ wrong[i]) & 1) != 0;
    const std::uint32_t one =
        gates.add(opposite ? Netlist::Kind::kXnor : Netlist::Kind::kXor, right[i] / 2, wrong[i] / 2);
    differs = differs == 0 ? one : gates.add(Netlist::Kind::kOr, differs, one);
  }
  return differs;
}

}  // namespace

Netlist difference_netlist(const Aiger& logic, std::span<const std::uint64_t> codes) {
  if (!logic.next.empty()) throw std::runtime_error("a leaf with state");
  constexpr std::uint32_t kFirst = 2;
  std::vector<std::uint32_t> nets;
  std::vector<std::uint32_t> inputs{0};
  for (const std::string& name : logic.inputs) {
    const auto place = input_place(name);
    inputs.push_back(place ? 2 * (kFirst + *place) : 0);
    if (!place) continue;
    if (nets.size() <= *place) nets.resize(*place + 1);
    nets[*place] = kFirst + *place;
  }
  SharedGates gates(kFirst + static_cast<std::uint32_t>(nets.size()));
  const auto right = add_circuit(with_input(logic, "mutant", 0), inputs, gates);
  std::vector<std::uint32_t> outputs;
  for (const std::uint64_t code : codes) {
    gates.begin_another();
    const auto wrong = add_circuit(with_input(logic, "mutant", code), inputs, gates);
    outputs.push_back(add_difference(right, wrong, gates));
  }
  return {gates.take(), std::move(nets), std::move(outputs)};
}

namespace {

constexpr std::size_t kBlock = NetlistProgram::kLanes;
// Inputs that are looked at one after the other, so that some of their bits stay.
constexpr std::uint64_t kRun = 64 * kBlock;

// Mutants that differ, each with the first input of a run at which it does.
std::map<std::size_t, std::uint64_t> differing_in_run(const prove::Leaf& leaf, const Netlist& netlist,
                                                      std::uint64_t first) {
  const std::uint64_t end = std::min(first + kRun, leaf.domain.count);
  const std::size_t words = (netlist.outputs.size() + 63) / 64;
  std::vector<std::uint64_t> inputs(kBlock * leaf.input_words);
  std::vector<std::uint64_t> outputs(kBlock * words);
  std::vector<std::uint64_t> scratch;
  std::vector<std::uint64_t> seen(words, 0);
  std::map<std::size_t, std::uint64_t> found;
  prove::SteadyProgram program;
  for (; first < end; first += kBlock) {
    const auto lanes = static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, end - first));
    leaf.domain.fill(first, lanes, inputs.data());
    const std::span<const std::uint64_t> block(inputs.data(), lanes * leaf.input_words);
    program.of(netlist, static_cast<std::size_t>(leaf.steady_place()), block, leaf.input_words)
        .evaluate(inputs.data(), leaf.input_words, outputs.data(), words, lanes, scratch);
    for (std::size_t i = 0; i < lanes * words; ++i) {
      std::uint64_t fresh = outputs[i] & ~seen[i % words];
      seen[i % words] |= fresh;
      for (; fresh != 0; fresh &= fresh - 1) {
        found[64 * (i % words) + static_cast<std::size_t>(std::countr_zero(fresh))] = first + i / words;
      }
    }
  }
  return found;
}

// Every number below `count` once, neighbours far from each other.
class Scattered {
 public:
  explicit Scattered(std::uint64_t count) : count_(count), stride_(count * 5 / 8 + 1) {
    while (std::gcd(stride_, count_) != 1) ++stride_;
  }
  std::uint64_t operator[](std::uint64_t i) const {
    return static_cast<std::uint64_t>(static_cast<unsigned __int128>(i) * stride_ % count_);
  }

 private:
  std::uint64_t count_, stride_;
};

}  // namespace

std::vector<std::optional<std::uint64_t>> differing_inputs(const prove::Leaf& leaf, const Aiger& logic,
                                                           std::span<const std::uint64_t> codes,
                                                           std::uint64_t most_inputs) {
  std::vector<std::optional<std::uint64_t>> differs(codes.size());
  std::vector<std::size_t> open(codes.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  const std::uint64_t all_runs = (leaf.domain.count + kRun - 1) / kRun;
  const std::uint64_t runs = std::min(all_runs, (most_inputs + kRun - 1) / kRun);
  const Scattered scattered(all_runs);
  Progress progress(fmt::format("{}: {} mutants", leaf.name, codes.size()), runs);
  // Most are found in the first few; each round takes as many as all before, with the netlist of what is open.
  std::uint64_t done = 0;
  for (std::uint64_t round = 2; done < runs && !open.empty(); round = done) {
    const std::uint64_t end = std::min(runs, done + round);
    std::vector<std::uint64_t> open_codes;
    for (const std::size_t place : open) open_codes.push_back(codes[place]);
    const Netlist netlist = difference_netlist(logic, open_codes);
    std::mutex mutex;
    for_each_index(static_cast<std::int64_t>(done), static_cast<std::int64_t>(end), [&](std::int64_t i) {
      const auto found = differing_in_run(leaf, netlist, scattered[static_cast<std::uint64_t>(i)] * kRun);
      const std::scoped_lock lock(mutex);
      for (const auto& [which, input] : found) {
        std::optional<std::uint64_t>& known = differs[open[which]];
        known = std::min(known.value_or(input), input);
      }
      progress.advance(1);
    });
    std::erase_if(open, [&](std::size_t place) { return differs[place].has_value(); });
    done = end;
  }
  return differs;
}

}  // namespace feline::mutation
