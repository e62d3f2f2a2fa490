// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/leaf_synthesis.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

#include "testbench/area/yosys.h"
#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/text_file.h"

namespace feline::prove {
namespace {

constexpr std::string_view kNeedsIt = "the second engine needs it";
constexpr std::string_view kPackage = "tables/generated/feline_pkg.sv";
constexpr std::string_view kModulePrefix = "feline_";

// Lines up to `//`, and those that hold something.
std::string without_comments(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    line.resize(std::min(line.find("//"), line.size()));
    line.resize(line.find_last_not_of(' ') + 1);
    if (!line.empty()) kept += line + "\n";
  }
  return kept;
}

// Words that begin as modules do.
std::set<std::string> module_words(const std::string& text) {
  const auto is_part = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  std::set<std::string> words;
  for (std::size_t at = text.find(kModulePrefix); at != std::string::npos; at = text.find(kModulePrefix, at + 1)) {
    std::size_t end = at;
    while (end < text.size() && is_part(text[end])) ++end;
    words.insert(text.substr(at, end - at));
  }
  return words;
}

}  // namespace

LeafSynthesis::LeafSynthesis(const Sources& sources, std::filesystem::path root) : root_(std::move(root)) {
  const std::array<std::pair<std::string_view, std::vector<Module>*>, 4> rooms{
      {{"rtl/", &rtl_},
       {"tables/generated/", &rtl_},
       {"testbench/prove/rtl_leaves/", &leaves_},
       {"testbench/prove/proofs/", &proofs_}}};
  for (const auto& source : sources) {
    const std::string& file = source.first;
    std::string bare = without_comments(source.second);
    const auto room = std::ranges::find_if(rooms, [&](const auto& each) { return file.starts_with(each.first); });
    if (file == kPackage) {
      package_ = std::move(bare);
    } else if (room != rooms.end()) {
      room->second->push_back({std::filesystem::path(file).stem().string(), file, std::move(bare)});
    } else {
      evaluating_[file] = std::move(bare);
    }
  }
}

std::string LeafSynthesis::closure(const std::string& top, const std::vector<Module>& own, const Change* change) const {
  std::map<std::string, const Module*> known;
  // The first of a name counts.
  for (const auto* const modules : {&own, &rtl_}) {
    for (const Module& module : *modules) known.try_emplace(module.name, &module);
  }
  std::map<std::string, std::string> taken;
  std::vector<std::string> waiting{top};
  while (!waiting.empty()) {
    const auto it = known.find(waiting.back());
    waiting.pop_back();
    if (it == known.end() || taken.contains(it->first)) continue;
    std::string text = it->second->text;
    if (change != nullptr && it->second->file == change->file) {
      const std::size_t at = text.find(change->original);
      if (at == std::string::npos || text.find(change->original, at + 1) != std::string::npos) {
        bad_input((root_ / it->second->file).string(), "text of a proof's control", "not once", change->original);
      }
      text.replace(at, change->original.size(), change->mutant);
    }
    for (const std::string& word : module_words(text)) waiting.push_back(word);
    taken[it->first] = std::move(text);
  }
  std::string all = package_;
  for (const auto& [name, text] : taken) all += text;
  return all;
}

std::string LeafSynthesis::version() const { return yosys_version(kNeedsIt); }

Netlist LeafSynthesis::netlist(std::string_view wrapper, const Cache& cache) const {
  const std::string module = fmt::format("feline_leaf_{}", wrapper);
  const std::string text = closure(module, leaves_, nullptr);
  // Words first, then gates of two inputs; abc's longer scripts take minutes over the dividers.
  constexpr std::string_view kScript =
      "read_verilog -sv -noautowire \"{0}\"\nsynth -flatten -top {1} -run begin:fine\nopt -full -purge\n"
      "synth -run fine:check\nabc -fast -g simple,ANDNOT,ORNOT,XNOR,NAND,NOR\nopt_clean -purge\nwrite_json \"{2}\"";
  const std::string key = cache.key({"leaf", version(), kScript, text, module});
  if (const auto stored = cache.read(key)) return {*stored, module};
  const std::filesystem::path work = std::filesystem::temp_directory_path();
  const AtomicFile verilog(work / "feline-leaf.sv");
  const AtomicFile json(work / "feline-leaf.json");
  write_text(verilog.temporary(), text);
  const Finished finished = run_yosys(
      {"-q", "-p", fmt::format(fmt::runtime(kScript), verilog.temporary().string(), module, json.temporary().string())},
      kNeedsIt);
  if (finished.code != 0) throw InputError(fmt::format("yosys: exit code {}: {}", finished.code, finished.errors));
  const std::string gates = read_text(json.temporary(), "open", "a file");
  cache.write(key, gates);
  return {gates, module};
}

std::string LeafSynthesis::leaf_hash(const Leaf& leaf) const {
  std::string text = closure(fmt::format("feline_leaf_{}", leaf.wrapper), leaves_, nullptr);
  const auto text_of = [this](const std::string& file) -> const std::string& { return evaluating_.at(file); };
  for (const std::string& file : evaluating_files(leaf.stage(), text_of)) text += text_of(file);
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

std::string LeafSynthesis::proof_text(std::string_view proof, const Change* change, bool wires) const {
  const std::string top = fmt::format("feline_proof_{}", proof);
  std::vector<Module> own = proofs_;
  if (wires) own.push_back(*std::ranges::find(leaves_, "feline_stream_register", &Module::name));
  std::string text = closure(top, own, change);
  if (change != nullptr && text == closure(top, own, nullptr)) {
    bad_input((root_ / change->file).string(), "text of a proof's control", "nothing changed", "a module of the proof");
  }
  return text;
}

}  // namespace feline::prove
