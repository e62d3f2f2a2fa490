// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/model_mutants.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "testbench/error.h"
#include "testbench/mutation/model_site.h"
#include "testbench/mutation/model_source.h"
#include "testbench/progress.h"
#include "testbench/text_file.h"

namespace feline::mutation {
namespace {

// A file of the sources with its sites, which are appended to `sites`.
std::string with_sites(const std::filesystem::path& source, const std::string& file, std::vector<ModelSite>& sites) {
  return instrument_source(read_text(source / file, "source", "a file of the model"), file, sites);
}

std::string name_of(const ModelSite& site, std::uint32_t alternative) {
  return fmt::format("{}: {}", site.place(), site.alternative(alternative));
}
std::string not_run(const ModelSite& site) { return site.place() + ": not run"; }

// Writes the sources with their sites where the build finds them; gives all of their text.
std::string write_sources(const Workshop& workshop, std::vector<ModelSite>& sites) {
  const std::filesystem::path directory = workshop.directory / "model" / "sources";
  std::filesystem::remove_all(directory);
  std::string all;
  for (const std::string& file : model_files(workshop.source)) {
    const std::string instrumented =
        "#include \"testbench/mutation/model_site.h\"\n" + with_sites(workshop.source, file, sites);
    std::filesystem::create_directories((directory / file).parent_path());
    write_text(directory / file, instrumented);
    all += instrumented;
  }
  return all;
}

void tell_fates(const std::vector<ModelSite>& sites, const std::string& lines,
                std::map<std::string, FileFates>& by_file) {
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    const nlohmann::json json = nlohmann::json::parse(line);
    const std::uint32_t code = json["code"];
    const ModelSite& site = sites.at(code / kAlternatives);
    Fate fate;
    fate.mutant.site = site.number;
    fate.mutant.control = code % kAlternatives;
    fate.name = json.value("reached", true) ? name_of(site, code % kAlternatives) : not_run(site);
    if (json.contains("tier")) {
      fate.tier = json["tier"];
      fate.stage = json["way"] == "mismatch" ? json["leaf"] : json["way"];
      fate.milliseconds = json["milliseconds"];
    }
    by_file[site.file].fates.push_back(std::move(fate));
  }
}

}  // namespace

// The rounding that the model does is beside the tables.
std::vector<std::string> model_files(const std::filesystem::path& source) {
  std::vector<std::string> files{"tables/rounding.h"};
  for (const auto& entry : std::filesystem::directory_iterator(source / "model")) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".h" || extension == ".cpp") files.push_back("model/" + entry.path().filename().string());
  }
  std::ranges::sort(files);
  return files;
}

std::map<std::string, std::set<std::string>> model_mutant_names(const std::filesystem::path& source) {
  std::map<std::string, std::set<std::string>> names;
  for (const std::string& file : model_files(source)) {
    std::vector<ModelSite> sites;
    with_sites(source, file, sites);
    for (const ModelSite& site : sites) {
      names[file].insert(not_run(site));
      for (std::uint32_t k = 0; !site.alternative(k).empty(); ++k) names[file].insert(name_of(site, k));
    }
  }
  return names;
}

std::vector<FileFates> try_model(const Workshop& workshop) {
  std::vector<ModelSite> sites;
  const std::string text = write_sources(workshop, sites);
  std::map<std::string, FileFates> by_file;
  for (const ModelSite& site : sites) ++by_file.try_emplace(site.file, FileFates{site.file, 0, {}}).first->second.sites;
  Progress progress("mutants of the model", sites.size());
  progress.show();
  bool built = false;
  constexpr std::size_t kTogether = 200;  // what is lost when it is stopped
  for (std::size_t first = 0; first < sites.size(); first += kTogether) {
    const std::size_t end = std::min(first + kTogether, sites.size());
    const std::string key = workshop.cache.key({"model", workshop.trials, text, fmt::format("{} {}", first, end)});
    std::optional<std::string> lines = workshop.cache.read(key);
    if (!lines) {
      const auto script = workshop.source / "testbench" / "mutation" / "build.sh";
      if (!built) run_program({script.string(), workshop.directory.string(), "model"});
      built = true;
      const auto program = workshop.directory / "build" / "feline_mutated_model";
      lines = run_trials({program.string(), std::to_string(first), std::to_string(end)});
      workshop.cache.write(key, *lines);
    }
    tell_fates(sites, *lines, by_file);
    progress.advance(end - first);
  }
  std::vector<FileFates> all;
  for (auto& [file, fates] : by_file) {
    std::ranges::sort(fates.fates, {},
                      [](const Fate& fate) { return std::pair(fate.mutant.site, fate.mutant.control); });
    all.push_back(std::move(fates));
  }
  return all;
}

}  // namespace feline::mutation
