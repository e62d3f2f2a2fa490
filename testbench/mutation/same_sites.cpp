// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/same_sites.h"

#include <algorithm>
#include <tuple>

#include "testbench/mutation/elaboration.h"
#include "testbench/text_number.h"

namespace feline::mutation {
namespace {

// Instance below the one that is looked at, type, place in the sources, port.
using Identity = std::tuple<std::string, std::string, std::string, std::string>;

// Yosys ends the names of cells in numbers that rise while it reads a module.
std::uint64_t order(const Site& site) {
  const std::size_t end = site.cell.rfind('$');
  if (end == std::string::npos) return 0;
  return number_of<std::uint64_t>(std::string_view(site.cell).substr(end + 1)).value_or(0);
}

// The sites of an instance, those of one identity in the order of being read.
std::map<Identity, std::vector<const Site*>> sites_of(const std::vector<Site>& sites, const std::string& instance) {
  std::map<Identity, std::vector<const Site*>> of_instance;
  for (const Site& site : sites) {
    std::string path = instance_of(site.cell);
    if (!instance.empty()) {
      if (path != instance && !path.starts_with(instance + ".")) continue;
      path.erase(0, std::min(path.size(), instance.size() + 1));
    }
    of_instance[{path, site.type, site.source, site.port}].push_back(&site);
  }
  for (auto& [identity, alike] : of_instance)
    std::ranges::stable_sort(alike, {}, [](const Site* s) { return order(*s); });
  return of_instance;
}

}  // namespace

std::map<std::uint32_t, std::uint32_t> same_sites(const std::vector<Site>& sites, const std::string& path,
                                                  const std::vector<Site>& other_sites, const std::string& other_path) {
  std::map<std::uint32_t, std::uint32_t> same;
  const auto others = sites_of(other_sites, other_path);
  for (const auto& [identity, alike] : sites_of(sites, path)) {
    const auto found = others.find(identity);
    // Where one needs fewer of them, it is not known which.
    if (found == others.end() || found->second.size() != alike.size()) continue;
    for (std::size_t i = 0; i < alike.size(); ++i) {
      if (found->second[i]->width == alike[i]->width) same.emplace(alike[i]->number, found->second[i]->number);
    }
  }
  return same;
}

}  // namespace feline::mutation
