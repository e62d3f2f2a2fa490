// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/stage_mutants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <regex>
#include <stdexcept>

#include "tables/stages.h"
#include "testbench/error.h"
#include "testbench/mutation/word_sites.h"
#include "testbench/text_file.h"

namespace feline::mutation {
namespace {

constexpr std::string_view kStreamRegister = "/feline_stream_register.sv";

// What a site is called; those that would be called alike are numbered.
std::vector<std::string> site_labels(const std::vector<Site>& sites) {
  std::map<std::string, int> used;
  std::vector<std::string> labels;
  for (const Site& site : sites) {
    const std::string instance = instance_of(site.cell);
    const std::size_t rtl = site.source.rfind("/rtl/");
    std::string label = fmt::format("{}{}{} at {}", site.type, instance.empty() ? "" : " in ", instance,
                                    rtl == std::string::npos ? site.source : site.source.substr(rtl + 1));
    const int number = ++used[fmt::format("{}, port {}", label, site.port)];
    if (number > 1) label += fmt::format(" ({})", number);
    labels.push_back(fmt::format("{}, port {}", label, site.port));
  }
  return labels;
}

// The stage with its rules: a module that has some of the stage's ports as inputs, and legal_o.
void add_rules(nlohmann::ordered_json& module, const std::string& stage, const std::string& rules) {
  nlohmann::ordered_json connections;
  nlohmann::ordered_json directions;
  for (const auto& [port, of] : module["ports"].items()) {
    if (rules.find(" " + port + ",") == std::string::npos) continue;
    connections[port] = of["bits"];
    directions[port] = "input";
  }
  // No netlist has as many nets.
  constexpr std::uint32_t kLegal = 1U << 30;
  connections["legal_o"] = {kLegal};
  directions["legal_o"] = "output";
  module["cells"]["rules"] = {{"hide_name", 0},
                              {"type", "feline_rules_" + stage},
                              {"parameters", nlohmann::ordered_json::object()},
                              {"attributes", nlohmann::ordered_json::object()},
                              {"port_directions", directions},
                              {"connections", connections}};
  module["ports"]["legal_o"] = {{"direction", "output"}, {"bits", {kLegal}}};
}

// A pipeline keeps nothing but what its streams hold, or a beat would not tell what comes of it.
void check_state(const std::vector<Site>& sites) {
  for (const Site& site : sites) {
    const bool keeps = site.type.find("dff") != std::string::npos || site.type.find("dlatch") != std::string::npos ||
                       site.type.starts_with("$mem");
    if (keeps && site.source.find(kStreamRegister) == std::string::npos) {
      throw std::runtime_error(fmt::format("{}: a pipeline with state of its own: {}", site.source, site.type));
    }
  }
}

}  // namespace

StageMutants::StageMutants(std::string stage, const std::filesystem::path& source,
                           const std::filesystem::path& directory)
    : stage_(std::move(stage)), source_(std::filesystem::absolute(source)), directory_(directory) {
  const std::string top = "feline_" + stage_;
  const std::filesystem::path generated = source_ / "tables" / "generated";
  std::vector<std::filesystem::path> kept = sources_in(generated, "feline_rom_");
  if (stage_ == kUnitName) {
    for (const std::string_view name : kStageNames) kept.push_back(source_ / "rtl" / fmt::format("feline_{}.sv", name));
  }
  elaboration_ = elaborate(top,
                           fmt::format("{}; {}; {}", read_command({generated / "feline_pkg.sv"}),
                                       read_command(sources_in(source_ / "rtl", "feline_")), read_command(kept, true)),
                           directory_);
  InstrumentedStage instrumented = instrument(elaboration_.netlist, top, nullptr, false);
  sites_ = std::move(instrumented.sites);
  ports_ = std::move(instrumented.ports);
  labels_ = site_labels(sites_);
  if (is_pipeline(*this)) check_state(sites_);
  text_ = to_verilog(instrumented.netlist, top, directory_);
  write_roms(instrumented.roms);
}

std::string StageMutants::rom_file(const std::string& name) const {
  return (source_ / "tables" / "generated" / ("feline_rom_" + name + ".sv")).string();
}

// Each ROM as a module of another name, and one of its own that has the wrong bit.
void StageMutants::write_roms(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const std::string text = read_text(rom_file(name), "ROM", "a generated file");
    std::smatch ports;
    static const std::regex ports_pattern(R"(input  wire logic (\[\d+:0\]) index_i,\s*(output logic present_o,)?\s*)"
                                          R"(output logic \[(\d+):0\] data_o)");
    if (!std::regex_search(text, ports, ports_pattern))
      throw std::runtime_error(rom_file(name) + ": no index_i and data_o");
    Rom rom{name, 0, static_cast<std::uint32_t>(std::stoul(ports[3])) + 1};
    static const std::regex word_pattern(R"('d(\d+): data_o)");
    for (std::sregex_iterator word(text.begin(), text.end(), word_pattern), end; word != end; ++word) {
      rom.words = std::max(rom.words, static_cast<std::uint32_t>(std::stoul((*word)[1])) + 1);
    }
    roms_.push_back(rom);
    const bool present = ports[2].matched;
    std::string renamed = text;
    const std::string module = "module feline_rom_" + name;
    renamed.replace(renamed.find(module), module.size(), module + "_right");
    const std::string wrong = fmt::format(
        "\nmodule feline_rom_{0} (\n  input  wire logic {1} index_i,\n{2}  output logic [{3}:0] data_o\n);\n"
        "  logic [63:0] mutant;\n  logic [{3}:0] right;\n"
        "  feline_mutation_source u_source (.mutant_o(mutant));\n"
        "  feline_rom_{0}_right u_right (.index_i, {4}.data_o(right));\n"
        "  assign data_o = mutant[15:0] == 16'd{5} && mutant[19:16] == 4'd5 && mutant[47:32] == 16'(index_i)\n"
        "    ? right ^ ({6}'(1) << mutant[31:20]) : right;\nendmodule\n",
        name, ports[1].str(), present ? "  output logic present_o,\n" : "", ports[3].str(),
        present ? ".present_o, " : "", roms_.size(), rom.width);
    const std::string all = renamed + wrong;
    write_text(directory_ / ("feline_rom_" + name + ".sv"), all);
    text_ += all;
  }
}

std::string StageMutants::describe(const Mutant& mutant) const {
  if (mutant.kind == Kind::kRomBit) {
    return fmt::format("ROM {}, word {}, bit {}", roms_[mutant.site - 1].name, mutant.control, mutant.bit);
  }
  const Site& site = sites_[mutant.site - 1];
  std::string what = kKindNames[static_cast<std::size_t>(mutant.kind)];
  if (mutant.kind >= Kind::kInvertWhenZero) what += fmt::format(" (bit {})", mutant.control);
  return fmt::format("{}, bit {} of {}: {}", labels_[mutant.site - 1], mutant.bit, site.width, what);
}

bool StageMutants::has(std::string_view description) const {
  const auto is_it = [&](const Mutant& mutant) { return describe(mutant) == description; };
  for (const Site& site : sites_) {
    if (!description.starts_with(labels_[site.number - 1] + ", ")) continue;
    if (std::ranges::any_of(site_mutants(site), is_it)) return true;
  }
  return std::ranges::any_of(rom_mutants(roms_), is_it);
}

bool StageMutants::in_stream(const Mutant& mutant) const {
  if (mutant.kind == Kind::kRomBit) return false;
  if (mutant.site > sites_.size()) {
    const std::string& port = ports_[mutant.site - sites_.size() - 1].port;
    return port == "rst_i" || port.find("_valid_") != std::string::npos || port.find("_ready_") != std::string::npos;
  }
  const std::string& place = sites_[mutant.site - 1].source;
  return place.find("/rtl/") == std::string::npos || place.find(kStreamRegister) != std::string::npos;
}

std::string StageMutants::logic(const std::vector<Mutant>& mutants, bool without_memories) const {
  const auto is_of_rom = [](const Mutant& mutant) { return mutant.kind == Kind::kRomBit; };
  std::vector<Mutant> of_sites;
  std::ranges::remove_copy_if(mutants, std::back_inserter(of_sites), is_of_rom);
  const std::vector<std::uint32_t> only = site_numbers(of_sites);
  const std::string top = "feline_" + stage_;
  nlohmann::ordered_json netlist = instrument(elaboration_.netlist, top, &only, true).netlist;
  if (std::ranges::any_of(mutants, is_of_rom)) add_word_sites(netlist["modules"][top], roms_);
  if (without_memories) cut_memories(netlist["modules"][top]);
  const std::filesystem::path package = source_ / "tables" / "generated" / "feline_pkg.sv";
  const std::filesystem::path room = source_ / "testbench" / "mutation";
  std::vector<std::filesystem::path> sources{package, room / "feline_mutation_site.sv",
                                             room / "feline_mutation_word.sv"};
  if (stage_ == kUnitName) {
    // The stages, whole, but not what is made of sites.
    for (const auto& [directory, begin] :
         {std::pair{source_ / "rtl", "feline_"}, {package.parent_path(), "feline_rom_"}}) {
      for (const std::filesystem::path& file : sources_in(directory, begin)) {
        if (file.stem() != top) sources.push_back(file);
      }
    }
  }
  for (const Rom& rom : roms_) sources.emplace_back(rom_file(rom.name));
  const std::filesystem::path rules = room / "rules" / fmt::format("feline_rules_{}.sv", stage_);
  if (std::filesystem::exists(rules)) {
    add_rules(netlist["modules"][top], stage_, read_text(rules, "rules", "a module"));
    const auto all_rules = sources_in(rules.parent_path(), "feline_rules_");
    sources.insert(sources.end(), all_rules.begin(), all_rules.end());
  }
  return to_gates(netlist, top, read_command(sources), directory_);
}

bool is_pipeline(const StageMutants& stage) {
  constexpr std::array<std::string_view, 5> kPipelines{"group", "footprint", "plan", "address", "filter"};
  return std::ranges::find(kPipelines, stage.stage()) != kPipelines.end();
}

}  // namespace feline::mutation
