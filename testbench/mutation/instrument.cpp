// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "testbench/mutation/mutant.h"

namespace feline::mutation {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::string_view kRomPrefix = "feline_rom_";
constexpr std::uint32_t kMutantBits = 64;

class Instrumenter {
 public:
  Instrumenter(Json module, const std::vector<std::uint32_t>* only) : module_(std::move(module)), only_(only) {
    for (const auto& [name, port] : module_["ports"].items()) {
      note(port["bits"], port["direction"] == "output");
    }
    for (const auto& [name, cell] : module_["cells"].items()) {
      for (const auto& [port, bits] : cell["connections"].items()) note(bits, cell["port_directions"][port] == "input");
    }
    for (const auto& [name, net] : module_["netnames"].items()) note(net["bits"], false);
    mutant_ = new_bits(kMutantBits);
    module_["netnames"]["mutant"] = net(mutant_);
  }

  void add_source(bool port) {
    if (port) {
      module_["ports"]["mutant"] = {{"direction", "input"}, {"bits", mutant_}};
    } else {
      module_["cells"]["mutation_source"] =
          cell("feline_mutation_source", Json::object(), {{"mutant_o", "output"}}, {{"mutant_o", mutant_}});
    }
  }

  // After the sites of cells. Without `only` they are told, but stay as they are.
  void add_port_sites() {
    const Json ports = module_["ports"];
    for (const auto& [name, port] : ports.items()) {
      if (name == "clk_i") continue;
      const Json& bits = port["bits"];
      Site site;
      site.number = ++last_;
      site.port = name;
      site.width = static_cast<std::uint32_t>(bits.size());
      for (std::uint32_t place = 0; place < site.width; ++place) site.bits.push_back({place, false});
      if (only_ != nullptr && is_wanted(site)) {
        const Json outer = new_bits(site.width);
        module_["ports"][name]["bits"] = outer;
        module_["netnames"][name] = net(outer);
        insert(site, port["direction"] == "output" ? bits : outer, port["direction"] == "output" ? outer : bits);
      }
      ports_.push_back(std::move(site));
    }
  }

  InstrumentedStage take(const std::string& top) {
    InstrumentedStage stage;
    stage.netlist = {{"creator", "feline"}, {"modules", {{top, std::move(module_)}}}};
    stage.sites = std::move(sites_);
    stage.ports = std::move(ports_);
    stage.roms = {roms_.begin(), roms_.end()};
    return stage;
  }

  void add_sites() {
    const Json cells = module_["cells"];
    for (const auto& [name, cell] : cells.items()) {
      const std::string type = cell["type"];
      if (type.starts_with(kRomPrefix)) {
        roms_.insert(type.substr(kRomPrefix.size()));
      }
      for (const auto& [port, bits] : cell["connections"].items()) {
        // A clock that is wrong is another design; Yosys wants constants where a read without a clock has no use for
        // more.
        const bool is_fixed = type == "$mem_v2" && port.starts_with("RD_") && port != "RD_ADDR" && port != "RD_DATA";
        if (port.ends_with("CLK") || port == "clk_i" || bits.empty() || is_fixed) continue;
        add_site(name, cell, port, bits, cell["port_directions"][port] == "output");
      }
    }
  }

 private:
  void note(const Json& bits, bool read) {
    for (const Json& bit : bits) {
      if (!bit.is_number()) continue;
      next_ = std::max(next_, bit.get<std::uint32_t>() + 1);
      if (read) read_.insert(bit.get<std::uint32_t>());
    }
  }

  Json new_bits(std::uint32_t count) {
    Json bits = Json::array();
    for (std::uint32_t i = 0; i < count; ++i) bits.push_back(next_++);
    return bits;
  }

  static Json net(const Json& bits) { return {{"hide_name", 0}, {"bits", bits}, {"attributes", Json::object()}}; }

  static Json cell(const std::string& type, const Json& parameters, const Json& directions, const Json& connections) {
    return {{"hide_name", 0},
            {"type", type},
            {"parameters", parameters},
            {"attributes", Json::object()},
            {"port_directions", directions},
            {"connections", connections}};
  }

  bool is_wanted(const Site& site) const { return only_ == nullptr || std::ranges::binary_search(*only_, site.number); }

  void insert(const Site& site, const Json& from, const Json& to) {
    module_["cells"][fmt::format("mutation_{}", site.number)] =
        cell("feline_mutation_site",
             {{"Width", fmt::format("{:032b}", site.width)}, {"Site", fmt::format("{:032b}", site.number)}},
             {{"mutant_i", "input"}, {"data_i", "input"}, {"data_o", "output"}},
             {{"mutant_i", mutant_}, {"data_i", from}, {"data_o", to}});
  }

  void add_site(const std::string& name, const Json& of, const std::string& port, const Json& bits, bool output) {
    Site site;
    site.number = ++last_;
    site.cell = name;
    site.type = of["type"];
    site.port = port;
    site.source = of["attributes"].value("place", of["attributes"].value("src", ""));
    site.width = static_cast<std::uint32_t>(bits.size());
    for (std::uint32_t place = 0; place < site.width; ++place) {
      const Json& bit = bits[place];
      const bool constant = !bit.is_number();
      if (constant ? bit == "0" || bit == "1" : !output || read_.contains(bit.get<std::uint32_t>())) {
        site.bits.push_back({place, constant});
      }
    }
    if (is_wanted(site) && !site.bits.empty()) {
      const Json inner = new_bits(site.width);
      module_["netnames"]["mutated_" + std::to_string(site.number)] = net(inner);
      module_["cells"][name]["connections"][port] = inner;
      insert(site, output ? inner : bits, output ? bits : inner);
    }
    sites_.push_back(std::move(site));
  }

  Json module_;
  const std::vector<std::uint32_t>* only_;
  std::set<std::uint32_t> read_;
  std::set<std::string> roms_;
  std::uint32_t next_ = 2;
  std::uint32_t last_ = 0;
  Json mutant_;
  std::vector<Site> sites_;
  std::vector<Site> ports_;
};

}  // namespace

InstrumentedStage instrument(const Json& netlist, const std::string& top, const std::vector<std::uint32_t>* only,
                             bool port) {
  if (!netlist["modules"].contains(top)) throw std::runtime_error(fmt::format("no module {} in the netlist", top));
  Instrumenter instrumenter(netlist["modules"][top], only);
  instrumenter.add_sites();
  instrumenter.add_port_sites();
  instrumenter.add_source(port);
  return instrumenter.take(top);
}

}  // namespace feline::mutation
