// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/aiger.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "testbench/mutation/copy_gates.h"
#include "testbench/text_number.h"

namespace feline::mutation {
namespace {

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  bool at_end() const { return at_ == text_.size(); }

  std::string_view line() {
    const std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) fail("a line without an end");
    const std::string_view found = text_.substr(at_, end - at_);
    at_ = end + 1;
    return found;
  }

  // Seven bits a byte, the least first; the highest bit says that more follow.
  std::uint32_t delta() {
    std::uint32_t value = 0;
    for (int shift = 0; shift < 32; shift += 7) {
      if (at_ == text_.size()) fail("its gates are cut short");
      const auto byte = static_cast<std::uint8_t>(text_[at_++]);
      value |= std::uint32_t{byte & 0x7fU} << shift;
      if ((byte & 0x80) == 0) return value;
    }
    fail("a number of more than 32 bits");
  }

  [[noreturn]] static void fail(std::string_view why) { throw std::runtime_error(fmt::format("AIGER: {}", why)); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

std::uint32_t number(std::string_view text) {
  const auto value = number_of<std::uint32_t>(text);
  if (!value) Reader::fail("no number: " + std::string(text));
  return *value;
}

void append_delta(std::string& text, std::uint32_t value) {
  for (; value >= 0x80; value >>= 7) text.push_back(static_cast<char>(value | 0x80));
  text.push_back(static_cast<char>(value));
}

std::vector<std::uint32_t> read_head(std::string_view head) {
  if (!head.starts_with("aig ")) Reader::fail("it does not begin with \"aig\"");
  std::vector<std::uint32_t> fields;
  for (std::size_t at = 4; at < head.size();) {
    const std::size_t end = std::min(head.find(' ', at), head.size());
    fields.push_back(number(head.substr(at, end - at)));
    at = end + 1;
  }
  constexpr std::uint32_t kMost = 1U << 22;  // no stage is as large; names take memory that the file does not show
  if (fields.size() != 5 || *std::ranges::max_element(fields) > kMost ||
      fields[0] != fields[1] + fields[2] + fields[4]) {
    Reader::fail("a head that is none");
  }
  return fields;
}

// "i12 data_i[3]": the names of inputs and outputs.
void read_names(Reader& reader, Aiger& aiger) {
  while (!reader.at_end()) {
    const std::string_view line = reader.line();
    if (line == "c") return;
    const std::size_t space = line.find(' ');
    if (line.empty() || space == std::string_view::npos) Reader::fail("a name of nothing");
    const std::uint32_t place = number(line.substr(1, space - 1));
    const std::string name(line.substr(space + 1));
    if (line[0] == 'i' && place < aiger.inputs.size()) {
      aiger.inputs[place] = name;
    } else if (line[0] == 'o' && place < aiger.outputs.size()) {
      aiger.outputs[place].name = name;
    }
  }
}

}  // namespace

std::uint32_t Aiger::add_gate(std::uint32_t left, std::uint32_t right) {
  if (left < right) std::swap(left, right);
  if (right == 0 || left == (right ^ 1)) return 0;
  if (right == 1 || left == right) return left;
  gates.push_back({left, right});
  return 2 * (first_gate() + static_cast<std::uint32_t>(gates.size()) - 1);
}

Aiger read_aiger(std::string_view binary) {
  Reader reader(binary);
  const std::vector<std::uint32_t> head = read_head(reader.line());
  Aiger aiger;
  aiger.inputs.resize(head[1]);
  const std::uint32_t end = 2 * (head[0] + 1);
  const auto literal = [&](std::string_view text) {
    const std::uint32_t value = number(text);
    if (value >= end) Reader::fail("a gate that is not there");
    return value;
  };
  for (std::uint32_t i = 0; i < head[2]; ++i) {
    const std::string_view line = reader.line();
    aiger.next.push_back(literal(line.substr(0, line.find(' '))));
  }
  for (std::uint32_t i = 0; i < head[3]; ++i) aiger.outputs.push_back({literal(reader.line()), ""});
  for (std::uint32_t i = 0; i < head[4]; ++i) {
    const std::uint32_t self = 2 * (aiger.first_gate() + i);
    const std::uint32_t first = reader.delta();
    if (first == 0 || first > self) Reader::fail("a gate that reads a later one");
    const std::uint32_t second = reader.delta();
    if (second > self - first) Reader::fail("a gate that reads a later one");
    aiger.gates.push_back({self - first, self - first - second});
  }
  read_names(reader, aiger);
  return aiger;
}

std::string to_binary(const Aiger& aiger) {
  std::string text = fmt::format("aig {} {} {} {} {}\n", aiger.first_gate() - 1 + aiger.gates.size(),
                                 aiger.inputs.size(), aiger.next.size(), aiger.outputs.size(), aiger.gates.size());
  for (const std::uint32_t literal : aiger.next) text += fmt::format("{}\n", literal);
  for (const Aiger::Output& output : aiger.outputs) text += fmt::format("{}\n", output.literal);
  for (std::size_t i = 0; i < aiger.gates.size(); ++i) {
    const auto [left, right] = std::minmax(aiger.gates[i].right, aiger.gates[i].left);
    append_delta(text, 2 * (aiger.first_gate() + static_cast<std::uint32_t>(i)) - right);
    append_delta(text, right - left);
  }
  return text;
}

namespace {

std::vector<std::uint32_t> copy_gates(const Aiger& from, std::vector<std::uint32_t> variables, Aiger& to) {
  return copy_gates(from, std::move(variables),
                    [&](std::uint32_t left, std::uint32_t right) { return to.add_gate(left, right); });
}

std::vector<std::uint32_t> own_variables(const Aiger& aiger) {
  std::vector<std::uint32_t> variables;
  for (std::uint32_t i = 0; i < aiger.first_gate(); ++i) variables.push_back(2 * i);
  return variables;
}

}  // namespace

Aiger with_input(const Aiger& aiger, std::string_view name, std::uint64_t value, std::uint32_t first) {
  Aiger fixed{aiger.inputs, {}, {}, {}};
  fixed.next.resize(aiger.next.size());
  std::vector<std::uint32_t> variables = own_variables(aiger);
  for (std::size_t i = 0; i < aiger.inputs.size(); ++i) {
    const std::string_view full = aiger.inputs[i];
    if (full.size() < name.size() + 3 || !full.starts_with(name) || full[name.size()] != '[' || full.back() != ']') {
      continue;
    }
    const std::uint32_t bit = number(full.substr(name.size() + 1, full.size() - name.size() - 2));
    if (bit < first) continue;
    variables[i + 1] = bit - first < 64 ? static_cast<std::uint32_t>(value >> (bit - first) & 1) : 0;
  }
  variables = copy_gates(aiger, std::move(variables), fixed);
  const auto moved = [&](std::uint32_t literal) { return variables[literal / 2] ^ (literal & 1); };
  for (std::size_t i = 0; i < aiger.next.size(); ++i) fixed.next[i] = moved(aiger.next[i]);
  for (const Aiger::Output& output : aiger.outputs) fixed.outputs.push_back({moved(output.literal), output.name});
  return fixed;
}

std::string port_of(const std::string& bit) { return bit.substr(0, bit.find('[')); }

Aiger cut_latches(const Aiger& aiger) {
  Aiger cut{aiger.inputs, {}, aiger.gates, aiger.outputs};
  cut.inputs.resize(cut.inputs.size() + aiger.next.size());
  for (const std::uint32_t literal : aiger.next) cut.outputs.push_back({literal, ""});
  return cut;
}

namespace {

// Finds literals of ports by their names.
class Ports {
 public:
  explicit Ports(const Aiger& aiger) : aiger_(aiger) {}

  const Aiger::Output* output(const std::string& name) const {
    const auto found = std::ranges::find(aiger_.outputs, name, &Aiger::Output::name);
    return found == aiger_.outputs.end() ? nullptr : &*found;
  }
  // 0 where there is none.
  std::uint32_t input(const std::string& name) const {
    const auto found = std::ranges::find(aiger_.inputs, name);
    return found == aiger_.inputs.end() ? 0 : static_cast<std::uint32_t>(2 * (found - aiger_.inputs.begin() + 1));
  }

 private:
  const Aiger& aiger_;
};

// When an output is looked at, as a literal of the one that it is an output of.
std::uint32_t looked_at(const Ports& ports, const std::string& name, bool& of_input) {
  constexpr std::string_view kReady = "_ready_o";
  std::string base = port_of(name);
  of_input = false;
  // What a memory is given, and the valids of a register, which has one stream in and one out, without names.
  if (base.starts_with("cut_")) return 1;
  if (base == "valid_o" || base.ends_with("_valid_o") || base == "busy_o" || base == "flush_o") return 1;
  if (base == "ready_o" || base.ends_with(kReady)) {
    of_input = true;
    return ports.input(base == "ready_o" ? "valid_i" : base.substr(0, base.size() - kReady.size()) + "_valid_i");
  }
  if (const Aiger::Output* const valid = base == "data_o" ? ports.output("valid_o") : nullptr) return valid->literal;
  for (std::size_t end = base.rfind('_'); end != std::string::npos && end != 0; end = base.rfind('_', end - 1)) {
    const Aiger::Output* const valid = ports.output(base.substr(0, end) + "_valid_o");
    if (valid != nullptr) return valid->literal;
  }
  throw std::runtime_error("AIGER: no valid of output " + name);
}

}  // namespace

namespace {

// Two circuits of the same inputs in one, with the latches of both; one latch more is free.
struct Both {
  Aiger aiger;
  std::vector<std::uint32_t> rights, wrongs;  // literals of either's variables

  std::uint32_t of_right(std::uint32_t literal) const { return rights[literal / 2] ^ (literal & 1); }
  std::uint32_t of_wrong(std::uint32_t literal) const { return wrongs[literal / 2] ^ (literal & 1); }
};

// Latches of `wrong` that `are_same` use those of `right`; equal gates are one.
Both joined(const Aiger& right, const Aiger& wrong, const std::vector<bool>& are_same) {
  const auto latches = static_cast<std::uint32_t>(right.next.size());
  Both both{{right.inputs, std::vector<std::uint32_t>(2 * latches + 1), {}, {}}, {}, {}};
  std::vector<std::uint32_t> of_right;
  for (std::uint32_t i = 0; i < both.aiger.first_latch(); ++i) of_right.push_back(2 * i);
  std::vector<std::uint32_t> of_wrong = of_right;
  for (std::uint32_t i = 0; i < latches; ++i) {
    of_right.push_back(2 * (both.aiger.first_latch() + i));
    of_wrong.push_back(are_same[i] ? of_right.back() : of_right.back() + 2 * latches);
  }
  HashedGates gates(both.aiger);
  both.rights = copy_gates(right, std::move(of_right), gates);
  both.wrongs = copy_gates(wrong, std::move(of_wrong), gates);
  return both;
}

// With as many of the latches the same as take the same next, all of these being the same.
Both joined(const Aiger& right, const Aiger& wrong) {
  std::vector<bool> are_same(right.next.size(), true);
  while (true) {
    Both both = joined(right, wrong, are_same);
    const std::vector<bool> before = are_same;
    for (std::size_t i = 0; i < are_same.size(); ++i) {
      if (both.of_right(right.next[i]) != both.of_wrong(wrong.next[i])) are_same[i] = false;
    }
    if (are_same == before) return both;
  }
}

}  // namespace

Aiger observed_difference(const Aiger& right, const Aiger& wrong) {
  const auto latches = static_cast<std::uint32_t>(right.next.size());
  Both both = joined(right, wrong);
  Aiger& miter = both.aiger;
  const auto either = [&](std::uint32_t a, std::uint32_t b) { return miter.add_gate(a ^ 1, b ^ 1) ^ 1; };
  for (std::uint32_t i = 0; i < latches; ++i) {
    miter.next[i] = both.of_right(right.next[i]);
    miter.next[latches + i] = both.of_wrong(wrong.next[i]);
  }
  const Ports ports(right);
  std::uint32_t differs = 0;
  for (std::size_t i = 0; i < right.outputs.size(); ++i) {
    const std::string& name = right.outputs[i].name;
    if (name == "legal_o") continue;
    bool of_input = false;
    const std::uint32_t when = looked_at(ports, name, of_input);
    const std::uint32_t a = both.of_right(right.outputs[i].literal);
    const std::uint32_t b = both.of_wrong(wrong.outputs[i].literal);
    if (a == b) continue;
    const std::uint32_t other = either(miter.add_gate(a, b ^ 1), miter.add_gate(a ^ 1, b));
    differs = either(differs, miter.add_gate(other, of_input ? when : both.of_right(when)));
  }
  // The last latch: something was not legal.
  const std::uint32_t broken = 2 * (miter.first_latch() + 2 * latches);
  const Aiger::Output* const legal = ports.output("legal_o");
  const std::uint32_t is_legal = legal == nullptr ? 1 : either(both.of_right(legal->literal), ports.input("rst_i"));
  const std::uint32_t so_far = miter.add_gate(broken ^ 1, is_legal);
  miter.next[2 * latches] = so_far ^ 1;
  miter.outputs.push_back({miter.add_gate(so_far, differs), "differs"});
  return std::move(miter);
}

}  // namespace feline::mutation
