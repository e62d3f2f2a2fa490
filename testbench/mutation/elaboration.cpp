// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/elaboration.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "testbench/area/yosys.h"
#include "testbench/text_file.h"

namespace feline::mutation {
namespace {

using Json = nlohmann::ordered_json;

std::string quoted(const std::filesystem::path& path) { return fmt::format("\"{}\"", path.string()); }

void run_script(const std::string& script) {
  const Finished finished = run_yosys({"-q", "-p", script}, kMutantsNeedIt);
  if (finished.code != 0) throw std::runtime_error(fmt::format("yosys: {}{}", finished.output, finished.errors));
}

Json read_json(const std::filesystem::path& file) {
  return Json::parse(read_text(file, "netlist", "what Yosys wrote"));
}

// Keeps where each cell was written: Yosys adds the places of the instances that it flattens.
void note_places(Json& netlist) {
  for (auto& [top, module] : netlist["modules"].items()) {
    for (auto& [name, cell] : module["cells"].items()) {
      auto& attributes = cell["attributes"];
      if (attributes.contains("src")) attributes["place"] = attributes["src"];
    }
  }
}

void note_instances(const Json& modules, const std::string& module, const std::string& path,
                    std::map<std::string, std::string>& instances) {
  instances[path] = module;
  for (const auto& [name, cell] : modules[module]["cells"].items()) {
    const std::string type = cell["type"];
    const std::string inner = path.empty() ? name : fmt::format("{}.{}", path, name);
    if (modules.contains(type)) note_instances(modules, type, inner, instances);
  }
}

}  // namespace

std::string read_command(const std::vector<std::filesystem::path>& files, bool library) {
  std::string command = fmt::format("read_verilog -sv -noautowire -overwrite{}", library ? " -lib" : "");
  for (const std::filesystem::path& file : files) command += " " + quoted(file);
  return command;
}

std::vector<std::filesystem::path> sources_in(const std::filesystem::path& directory, std::string_view begin) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begin) && name.ends_with(".sv")) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

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

namespace {

std::filesystem::path modules_file(const std::string& top, const std::filesystem::path& directory) {
  return directory / (top + ".modules.json");
}

Elaboration flattened(const Json& modules, const std::string& module, const std::filesystem::path& modules_json) {
  Elaboration elaboration;
  note_instances(modules["modules"], module, "", elaboration.instances);
  std::filesystem::path flat = modules_json;
  flat.replace_extension("flat.json");
  run_script(
      fmt::format("read_json {}; hierarchy -top {}; flatten; opt_clean; memory_collect; opt_clean; write_json {}",
                  quoted(modules_json), module, quoted(flat)));
  elaboration.netlist = read_json(flat);
  return elaboration;
}

}  // namespace

Elaboration elaborate(const std::string& top, const std::string& sources, const std::filesystem::path& directory) {
  const std::filesystem::path file = modules_file(top, directory);
  run_script(fmt::format("{}; hierarchy -check -top {}; proc; write_json {}", sources, top, quoted(file)));
  Json modules = read_json(file);
  note_places(modules);
  write_text(file, modules.dump());
  return flattened(modules, top, file);
}

Elaboration elaborate_module(const std::string& module, const std::string& top,
                             const std::filesystem::path& directory) {
  const std::filesystem::path file = modules_file(top, directory);
  return flattened(read_json(file), module, file);
}

void cut_memories(Json& module) {
  std::vector<std::string> memories;
  for (const auto& [name, cell] : module["cells"].items()) {
    if (cell["type"] == "$mem_v2") memories.push_back(name);
  }
  for (std::size_t i = 0; i < memories.size(); ++i) {
    const Json cell = module["cells"][memories[i]];
    for (const auto& [port, bits] : cell["connections"].items()) {
      const bool is_read = port == "RD_DATA";
      const bool is_given = std::ranges::any_of(bits, [](const Json& bit) { return bit.is_number(); });
      if (port.ends_with("CLK") || !is_given) continue;
      module["ports"][fmt::format("cut_{}_{}_{}", i, port, is_read ? "i" : "o")] = {
          {"direction", is_read ? "input" : "output"}, {"bits", bits}};
    }
    module["cells"].erase(memories[i]);
  }
}

std::string to_verilog(const Json& netlist, const std::string& top, const std::filesystem::path& directory) {
  const std::filesystem::path json = directory / "sites.json";
  const std::filesystem::path verilog = directory / (top + ".v");
  write_text(json, netlist.dump());
  run_script(fmt::format("read_json {}; write_verilog -noattr {}", quoted(json), quoted(verilog)));
  return read_text(verilog, "netlist", "what Yosys wrote");
}

std::string to_gates(const Json& netlist, const std::string& top, const std::string& sources,
                     const std::filesystem::path& directory) {
  const std::filesystem::path json = directory / "gates.json";
  const std::filesystem::path aiger = directory / "gates.aig";
  write_text(json, netlist.dump());
  run_script(
      fmt::format("read_json {}; {}; hierarchy -check -top {}; proc; flatten; "
                  "opt_clean; memory_map; opt_clean; async2sync; dffunmap; techmap; dffunmap; setundef -zero; "
                  "opt_clean; aigmap; opt_clean; write_aiger -symbols {}",
                  quoted(json), sources, top, quoted(aiger)));
  return read_text(aiger, "netlist", "what Yosys wrote");
}

}  // namespace feline::mutation
