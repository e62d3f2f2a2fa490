// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "testbench/stability/study.h"

namespace feline::stability {

// Everything in the study but the single jumps. Numbers that are not finite are null; a worst lookup is its six
// operands in the shortest decimals that read back as the same float32.
nlohmann::ordered_json to_json(const Study& study);
// One line for each class, subject and metric.
std::string to_csv(const Study& study);
// One line for each jump of more than a step, with the lookup before it, on a texture of 256 x 256.
std::string jumps_to_csv(const Study& study);
// The tables of a terminal, 120 columns wide.
std::string to_text(const Study& study);

// What words tell of numbers, for every form of the study.
std::string subject_name(const std::optional<Subject>& subject);
// Whose a jump is: of Feline itself, of Simple or Table Feline, or of the number format.
std::string_view origin(Cause cause);
// Whether anything is promised of any lookup.
bool has_bound(const ClassResult::Row& row);
// "holds", "broken", or "no bound".
std::string verdict(const ClassResult::Row& row);
// Worst and mean, "lost" where values are.
std::string measure_text(const Measure& measure);
// The largest share of error to bound among a row's metrics.
double worst_share(const ClassResult::Row& row);
std::uint64_t bound_count(const Study& study);

}  // namespace feline::stability
