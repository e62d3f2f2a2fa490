// SPDX-License-Identifier: Apache-2.0
#include "testbench/area/toggles.h"

#include <gtkwave/fstapi.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "tables/stages.h"
#include "testbench/error.h"

namespace feline {
namespace {

struct Signal {
  std::optional<std::size_t> stage;
  bool is_register = false;
  bool is_memory = false;
  std::string value;
};

struct Count {
  std::vector<StageToggles> stages;
  std::size_t rest = 0;
  std::vector<Signal> signals;  // by handle
};

// The names of a variable begin with its own and go on with an index or a range.
std::string_view own_name(std::string_view name) { return name.substr(0, name.find_first_of(" [(")); }

// An element of a memory: "line_q(3) [24:0]" or "line_q[3] [24:0]", where a vector is "line_q [24:0]".
bool is_element(std::string_view name) {
  const std::size_t end = own_name(name).size();
  return end < name.size() && name[end] != ' ' && name.find(':', end) > name.find_first_of("])", end);
}

// A signal belongs to the stage that drives it, which is where it is declared and no input.
void declare(Count& count, const std::vector<std::string>& scopes, const fstHier& entry) {
  const auto unit = std::ranges::find(scopes, "u_unit");
  if (unit == scopes.end() || entry.u.var.direction == FST_VD_INPUT) return;
  Signal& signal = count.signals.at(entry.u.var.handle);
  const std::string_view name(entry.u.var.name, entry.u.var.name_length);
  const bool is_register = own_name(name).ends_with("_q");
  signal.is_memory = signal.is_memory || (is_register && is_element(name));
  signal.is_register = signal.is_register || is_register;
  std::size_t stage = count.rest;
  if (unit + 1 != scopes.end()) {
    const auto found =
        std::ranges::find_if(count.stages, [&](const StageToggles& each) { return *(unit + 1) == "u_" + each.stage; });
    if (found != count.stages.end()) stage = static_cast<std::size_t>(found - count.stages.begin());
  }
  if (!signal.stage || *signal.stage == count.rest) signal.stage = stage;
}

void change(void* user, std::uint64_t /*time*/, fstHandle handle, const unsigned char* text) {
  auto& count = *static_cast<Count*>(user);
  Signal& signal = count.signals[handle];
  if (!signal.stage) return;
  const char* const bits = reinterpret_cast<const char*>(text);
  std::uint64_t toggles = 0;
  if (signal.value.empty()) {
    signal.value = bits;  // what it was when the waveform begins
  } else {
    for (std::size_t i = 0; i < signal.value.size(); ++i) toggles += signal.value[i] != bits[i] ? 1 : 0;
    signal.value.assign(bits, signal.value.size());
  }
  StageToggles& stage = count.stages[*signal.stage];
  if (signal.is_memory) {
    stage.memories += toggles;
  } else {
    stage.nets += toggles;
    if (signal.is_register) stage.registers += toggles;
  }
}

}  // namespace

std::vector<StageToggles> count_toggles(const std::filesystem::path& wave) {
  const std::unique_ptr<void, void (*)(void*)> reader(fstReaderOpen(wave.c_str()), fstReaderClose);
  if (!reader) bad_input(wave.string(), "open", "no waveform that can be read", "an FST file");
  Count count;
  for (const std::string_view name : kStageNames) {
    if (name == "address") count.stages.push_back({"spill"});
    count.stages.push_back({std::string(name)});
  }
  count.rest = count.stages.size();
  count.stages.push_back({"rest"});
  count.signals.resize(fstReaderGetMaxHandle(reader.get()) + std::size_t{1});
  std::vector<std::string> scopes;
  while (const fstHier* const entry = fstReaderIterateHier(reader.get())) {
    if (entry->htyp == FST_HT_SCOPE) scopes.emplace_back(entry->u.scope.name);
    if (entry->htyp == FST_HT_UPSCOPE && !scopes.empty()) scopes.pop_back();
    if (entry->htyp == FST_HT_VAR) declare(count, scopes, *entry);
  }
  if (std::ranges::none_of(count.signals, [](const Signal& signal) { return signal.stage.has_value(); })) {
    throw std::runtime_error(wave.string() + ": no unit u_unit in this waveform");
  }
  fstReaderSetFacProcessMaskAll(reader.get());
  fstReaderIterBlocks(reader.get(), change, &count, nullptr);
  return count.stages;
}

}  // namespace feline
