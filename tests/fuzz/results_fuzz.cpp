// SPDX-License-Identifier: Apache-2.0
// Results as JSON, from caches and from the programs of pruned units: what is taken is the same again after writing.
#include "testbench/area/activity.h"
#include "testbench/area/area.h"
#include "testbench/measure/cell.h"
#include "testbench/prune/check.h"
#include "tests/fuzz/fuzz.h"

namespace feline {
namespace {

using Json = nlohmann::ordered_json;

template <typename Read>
void check(const Json& json, Read read) {
  const std::string text = to_json(read(json)).dump();
  fuzz::require(to_json(read(Json::parse(text))).dump() == text, "from_json: the same again after writing");
}

void check_activity(const Json& json) {
  // A unit has stages.
  if (json.at("stages").empty()) return;
  check(json, activity_from_json);
}

}  // namespace
}  // namespace feline

void feline::fuzz::run(Input input) {
  const std::size_t kind = input.choose(5);
  accepts<std::exception>([&] {
    const Json json = Json::parse(input.rest());
    if (kind == 0) check(json, cell_from_json);
    if (kind == 1) check(json, errors_from_json);
    if (kind == 2) check(json, stage_area_from_json);
    if (kind == 3) check_activity(json);
    if (kind == 4) check(json, check_from_json);
  });
}
