// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/stage_mutants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

#include "tables/stages.h"
#include "testbench/area/yosys.h"
#include "testbench/error.h"
#include "testbench/text_file.h"

namespace feline::mutation {
namespace {

constexpr std::string_view kNeed = "mutants need it";

std::string quoted_path(const std::filesystem::path& path) { return fmt::format("\"{}\"", path.string()); }

// All files of a directory that begin so, in the order of names, each quoted.
std::string files(const std::filesystem::path& directory, std::string_view begin) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begin) && name.ends_with(".sv")) names.insert(quoted_path(entry.path()));
  }
  return fmt::format(" {}", fmt::join(names, " "));
}

void run_script(const std::string& script) {
  const page::Finished finished = run_yosys({"-q", "-p", script}, kNeed);
  if (finished.code != 0) throw std::runtime_error(fmt::format("yosys: {}{}", finished.output, finished.errors));
}

// Keeps where each cell was written: Yosys adds the places of the instances that it flattens.
void note_places(nlohmann::ordered_json& netlist) {
  for (auto& [top, module] : netlist["modules"].items()) {
    for (auto& [name, cell] : module["cells"].items()) {
      auto& attributes = cell["attributes"];
      if (attributes.contains("src")) attributes["place"] = attributes["src"];
    }
  }
}

// "u_length" of "$flatten\u_length.$add$...", and of an instance its own name.
std::string instance_of(std::string_view cell) {
  constexpr std::string_view kBegin = "$flatten\\";
  std::vector<std::string_view> names;
  while (cell.starts_with(kBegin)) {
    cell.remove_prefix(kBegin.size());
    const std::size_t end = cell.find(".$");
    if (end == std::string_view::npos) break;
    names.push_back(cell.substr(0, end));
    cell.remove_prefix(end + 1);
  }
  if (!cell.starts_with('$')) names.push_back(cell);
  std::string path = fmt::format("{}", fmt::join(names, "."));
  std::erase(path, '\\');
  return path;
}

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

}  // namespace

void check_sources(const std::filesystem::path& source) {
  if (!std::filesystem::exists(source / "rtl" / "feline_unit.sv") ||
      !std::filesystem::exists(source / "testbench" / "mutation" / "build.sh")) {
    bad_input(source.string(), "--source", "no rtl/feline_unit.sv and testbench/mutation/build.sh in it",
              "this project's sources");
  }
}

StageMutants::StageMutants(std::string stage, const std::filesystem::path& source,
                           const std::filesystem::path& directory)
    : stage_(std::move(stage)), source_(std::filesystem::absolute(source)), directory_(directory) {
  const std::string top = "feline_" + stage_;
  const std::filesystem::path plain = directory_ / "stage.json";
  const std::filesystem::path generated = source_ / "tables" / "generated";
  std::string kept = files(generated, "feline_rom_");
  if (stage_ == kUnitName) {
    for (const std::string_view name : kStageNames) {
      kept += fmt::format(" {}", quoted_path(source_ / "rtl" / fmt::format("feline_{}.sv", name)));
    }
  }
  run_script(fmt::format(
      "read_verilog -sv -noautowire {0}; read_verilog -sv -noautowire -overwrite{1}; "
      "read_verilog -sv -noautowire -lib -overwrite{2}; hierarchy -check -top {3}; proc; write_json {4}",
      quoted_path(generated / "feline_pkg.sv"), files(source_ / "rtl", "feline_"), kept, top, quoted_path(plain)));
  netlist_ = nlohmann::ordered_json::parse(read_text(plain, "netlist", "what Yosys wrote"));
  note_places(netlist_);
  write_text(plain, netlist_.dump());
  run_script(
      fmt::format("read_json {0}; hierarchy -top {1}; flatten; opt_clean; memory_collect; opt_clean; "
                  "write_json {0}",
                  quoted_path(plain), top));
  netlist_ = nlohmann::ordered_json::parse(read_text(plain, "netlist", "what Yosys wrote"));
  InstrumentedStage instrumented = instrument(netlist_, top, nullptr, false);
  sites_ = std::move(instrumented.sites);
  labels_ = site_labels(sites_);
  const std::filesystem::path json = directory_ / "sites.json";
  write_text(json, instrumented.netlist.dump());
  const std::filesystem::path verilog = directory_ / (top + ".v");
  run_script(fmt::format("read_json {}; write_verilog -noattr {}", quoted_path(json), quoted_path(verilog)));
  text_ = read_text(verilog, "netlist", "what Yosys wrote");
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
  const std::string& place = mutant.kind == Kind::kRomBit ? std::string() : sites_[mutant.site - 1].source;
  return place.find("/rtl/") == std::string::npos || place.find("/feline_stream_register.sv") != std::string::npos;
}

std::string StageMutants::logic(const std::vector<Mutant>& mutants) const {
  std::set<std::uint32_t> numbers;
  for (const Mutant& mutant : mutants) numbers.insert(mutant.site);
  const std::vector<std::uint32_t> only(numbers.begin(), numbers.end());
  const std::string top = "feline_" + stage_;
  const std::filesystem::path json = directory_ / "survivors.json";
  const std::filesystem::path aiger = directory_ / "survivors.aig";
  nlohmann::ordered_json netlist = instrument(netlist_, top, &only, true).netlist;
  std::string sources = quoted_path(source_ / "testbench" / "mutation" / "feline_mutation_site.sv");
  for (const Rom& rom : roms_) sources += fmt::format(" {}", quoted_path(rom_file(rom.name)));
  const std::filesystem::path rules =
      source_ / "testbench" / "mutation" / "rules" / fmt::format("feline_rules_{}.sv", stage_);
  if (std::filesystem::exists(rules)) {
    add_rules(netlist["modules"][top], stage_, read_text(rules, "rules", "a module"));
    sources = fmt::format("{} {}{}", quoted_path(source_ / "tables" / "generated" / "feline_pkg.sv"), sources,
                          files(rules.parent_path(), "feline_rules_"));
  }
  write_text(json, netlist.dump());
  run_script(
      fmt::format("read_json {}; read_verilog -sv -noautowire {}; hierarchy -check -top {}; proc; flatten; "
                  "opt_clean; memory_map; opt_clean; async2sync; dffunmap; techmap; dffunmap; setundef -zero; "
                  "opt_clean; aigmap; opt_clean; write_aiger -symbols {}",
                  quoted_path(json), sources, top, quoted_path(aiger)));
  return read_text(aiger, "netlist", "what Yosys wrote");
}

}  // namespace feline::mutation
