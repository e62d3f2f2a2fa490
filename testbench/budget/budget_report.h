// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "testbench/budget/search.h"

namespace feline {

// Searches of the same options as text, JSON and a table of every candidate.
bool all_hold(const std::vector<SceneSearch>& searches);
std::string budget_text(const std::vector<SceneSearch>& searches, const SearchOptions& options);
nlohmann::ordered_json budget_json(const std::vector<SceneSearch>& searches, const SearchOptions& options);
std::string budget_csv(const std::vector<SceneSearch>& searches, const SearchOptions& options);

// As a page that needs no network. Throws InputError when gnuplot is missing.
std::string budget_page(const std::vector<SceneSearch>& searches, const SearchOptions& options);

std::string cost_text(CostKind kind, double cost);
// "-26 %" of the full unit's.
std::string saved_text(double cost, double full_cost);

}  // namespace feline
