// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/word_sites.h"

#include <fmt/format.h>

#include <algorithm>

namespace feline::mutation {
namespace {

using Json = nlohmann::ordered_json;

// No netlist has as many nets.
constexpr std::uint32_t kFirstNet = 1U << 29;

Json nets(std::uint32_t first, std::size_t count) {
  Json bits = Json::array();
  for (std::size_t i = 0; i < count; ++i) bits.push_back(first + i);
  return bits;
}

Json first_of(const Json& bits, std::size_t count) {
  return Json(bits.begin(), bits.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

void add_word_sites(Json& module, const std::vector<Rom>& roms) {
  std::uint32_t widest = 0;
  for (const Rom& rom : roms) widest = std::max(widest, rom.width);
  const Json mutant = module["ports"]["mutant"]["bits"];
  const Json any = nets(kFirstNet, widest);
  module["ports"]["any"] = {{"direction", "input"}, {"bits", any}};
  std::uint32_t next = kFirstNet + widest;
  const Json cells = module["cells"];
  for (const auto& [name, cell] : cells.items()) {
    for (std::size_t number = 0; number < roms.size(); ++number) {
      if (cell["type"] != "feline_rom_" + roms[number].name) continue;
      const std::uint32_t width = roms[number].width;
      const Json index = cell["connections"]["index_i"];
      const Json data = nets(next, width);
      next += width;
      module["cells"][name]["connections"]["data_o"] = data;
      module["cells"]["mutation_word." + name] = {{"hide_name", 0},
                                                  {"type", "feline_mutation_word"},
                                                  {"parameters",
                                                   {{"Width", fmt::format("{:032b}", width)},
                                                    {"IndexWidth", fmt::format("{:032b}", index.size())},
                                                    {"Rom", fmt::format("{:032b}", number + 1)}}},
                                                  {"attributes", Json::object()},
                                                  {"port_directions",
                                                   {{"mutant_i", "input"},
                                                    {"any_i", "input"},
                                                    {"index_i", "input"},
                                                    {"data_i", "input"},
                                                    {"data_o", "output"}}},
                                                  {"connections",
                                                   {{"mutant_i", mutant},
                                                    {"any_i", first_of(any, width)},
                                                    {"index_i", index},
                                                    {"data_i", data},
                                                    {"data_o", cell["connections"]["data_o"]}}}};
    }
  }
}

}  // namespace feline::mutation
