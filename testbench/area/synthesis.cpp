// SPDX-License-Identifier: Apache-2.0
#include "testbench/area/synthesis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "testbench/area/yosys.h"
#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/text_file.h"

namespace feline {
namespace {

constexpr std::array<std::string_view, 9> kParts{"group",   "footprint", "plan",   "walk",      "spill",
                                                 "address", "fetch",     "filter", "accumulate"};

// Where a stage's beat can be watched, and what only the bench reads.
constexpr std::array<std::string_view, 10> kWatchPins{"offered_o", "taken_o",      "group_o",   "footprint_o",
                                                      "plan_o",    "walk_o",       "address_o", "fetch_o",
                                                      "filter_o",  "fingerprint_o"};

// Commands end with their line: a semicolon may be part of a selection.

// Operators of words, simplified until nothing changes. Memories are whole from here on.
constexpr std::string_view kSimplify = "opt -purge -full\nwreduce\npeepopt\nopt -purge -full\n";

// Words to gates; of memories only those that are never written.
constexpr std::string_view kToGates =
    "memory_map -rom-only\nopt -purge\nalumacc\nopt -purge\ntechmap\nopt -fast -purge\n";

// Gates to the library's cells. For area: abc's own script, with its search for choices, takes minutes over the
// dividers of plan, and is made for speed. Wires are buffered as if each output drove 50 fF and each input came from an
// INVX4.
constexpr std::string_view kMapping = "+strash;dc2;dc2;amap;buffer;upsize;dnsize";
constexpr std::string_view kConstraints = "set_driving_cell INVX4\nset_load 0.05 [all_outputs]\n";

// Cells keep this attribute through what simplifies them, whatever they are called in the end.
std::string mark(std::string_view part, std::string_view cells) {
  return fmt::format("setattr -set src \"stage_{}\" {}\n", part, cells);
}

// What is marked, a module each.
std::string part_modules() {
  std::string commands;
  for (const std::string_view part : kParts) {
    commands += fmt::format("select -set part feline_unit/a:src=*stage_{0}*\nsubmod -name stage_{0} @part\n", part);
  }
  return commands + "select -clear\n";
}

std::string in_quotes(const std::filesystem::path& path) { return fmt::format("\"{}\"", path.string()); }

constexpr std::string_view kNeedsIt = "areas need it";

// The SystemVerilog files of a directory that begin so, one after the other.
std::string text_of(const std::filesystem::path& directory, const std::string& prefix, std::string_view field) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(directory)) {
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(prefix) && entry.path().extension() == ".sv") files.push_back(entry.path());
    }
  }
  if (files.empty()) bad_input(directory.string(), field, "no such files", "a directory with " + prefix + "*.sv");
  std::ranges::sort(files);
  std::string text;
  for (const std::filesystem::path& file : files) text += read_text(file, "open", "a file");
  return text;
}

// The width of what the spill register holds, which the package says.
std::string spill_width(const std::string& source) {
  constexpr std::string_view kName = "WalkBeatWidth = ";
  const std::size_t at = source.find(kName);
  if (at == std::string::npos) bad_input("feline_pkg.sv", "WalkBeatWidth", "nothing", "a package of feline tables");
  const std::size_t start = at + kName.size();
  return source.substr(start, source.find(';', start) - start);
}

}  // namespace

std::string modules_text(const std::filesystem::path& rtl) { return text_of(rtl, "feline_", "--source"); }

std::string unit_source(const std::filesystem::path& rtl, const std::filesystem::path& generated) {
  // Wrong sources, of which `generated` may be a part, are told first.
  const std::string modules = modules_text(rtl);
  const std::string roms = text_of(generated, "feline_rom_", "--generated");
  return read_text(generated / "feline_pkg.sv", "--generated", "a directory with feline_pkg.sv") + roms + modules;
}

Synthesis::Synthesis(std::filesystem::path library, const Cache* cache) : library_(std::move(library)), cache_(cache) {
  version_ = yosys_version(kNeedsIt);
  library_text_ = read_text(library_, "--library",
                            "a Liberty file, as of Debian package qflow-tech-osu018: " + std::string(kCellLibrary));
  try {
    cell_area(library_text_, "NAND2X1");
  } catch (const std::runtime_error& error) {
    bad_input(library_.string(), "--library", error.what(), "a Liberty file with a cell NAND2X1");
  }
}

std::vector<StageArea> Synthesis::run(const std::string& source, const std::string& commands) const {
  const std::string key = cache_ == nullptr ? "" : cache_->key({"area", version_, library_text_, commands, source});
  if (cache_ != nullptr) {
    if (const auto stored = cache_->read(key)) {
      std::vector<StageArea> stages;
      for (const auto& stage : nlohmann::ordered_json::parse(*stored)) stages.push_back(stage_area_from_json(stage));
      return stages;
    }
  }
  // Never committed, and so removed at the end, or when the program is killed.
  const std::filesystem::path work = std::filesystem::temp_directory_path();
  const AtomicFile verilog(work / "feline-area.sv");
  const AtomicFile constraints(work / "feline-area.constr");
  const AtomicFile words(work / "feline-area-words.json");
  const AtomicFile cells(work / "feline-area-cells.json");
  for (const auto& [file, text] :
       {std::pair<const AtomicFile*, std::string_view>{&verilog, source}, {&constraints, kConstraints}}) {
    write_text(file->temporary(), text);
  }
  const std::string script = fmt::format(
      "read_verilog -sv -noautowire {0}\n{1}dfflibmap -liberty {2}\n"
      "abc -liberty {2} -constr {3} -script {4}\nopt_clean -purge\ntee -q -o {5} stat -json",
      in_quotes(verilog.temporary()), fmt::format(fmt::runtime(commands), in_quotes(words.temporary())),
      in_quotes(library_), in_quotes(constraints.temporary()), kMapping, cells.temporary().string());
  const Finished finished = run_yosys({"-q", "-p", script}, kNeedsIt);
  if (finished.code != 0) {
    throw InputError(fmt::format("yosys: exit code {}: {}", finished.code, finished.errors));
  }
  std::vector<StageArea> stages = parse_area(read_text(words.temporary(), "open", "a file"),
                                             read_text(cells.temporary(), "open", "a file"), library_text_);
  if (cache_ != nullptr) {
    nlohmann::ordered_json all;
    for (const StageArea& stage : stages) all.push_back(to_json(stage));
    cache_->write(key, all.dump());
  }
  return stages;
}

StageArea Synthesis::stage(const std::string& source, const std::string& name) const {
  const std::string top = name == "spill" ? "hierarchy -top feline_spill_register -chparam Width " + spill_width(source)
                                          : "hierarchy -top feline_" + name;
  return run(source, fmt::format("{}\nproc\nflatten\nmemory -nomap\n{}select t:$mul t:$mem_v2\n"
                                 "json -o {{}} -compat-int\nselect -clear\n{}",
                                 top, kSimplify, kToGates))
      .front();
}

std::vector<StageArea> Synthesis::unit(const std::string& source) const {
  std::string commands = "hierarchy -top feline_unit\nproc\ndelete -port";
  for (const std::string_view pin : kWatchPins) commands += fmt::format(" feline_unit/w:{}", pin);
  commands += "\nflatten\nmemory -nomap\nsetattr -unset src feline_unit/c:*\n";
  for (const std::string_view part : kParts) commands += mark(part, fmt::format("feline_unit/c:*u_{}.*", part));
  commands += fmt::format("{}{}select t:$mul t:$mem_v2\njson -o {{}} -compat-int\nselect -clear\n{}", kSimplify,
                          part_modules(), kToGates);
  // Once more together, bit by bit: what is constant here is so only for some bits of a word.
  commands += "setattr -unset src c:*\n";
  for (const std::string_view part : kParts) commands += mark(part, fmt::format("stage_{}/c:*", part));
  return run(source, commands + "flatten\nopt -fast -purge\n" + part_modules());
}

AreaReport Synthesis::report(std::vector<StageArea> stages) const {
  return {version_, library_.filename().string(), std::move(stages)};
}

}  // namespace feline
