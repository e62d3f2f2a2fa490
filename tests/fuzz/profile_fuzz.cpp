// SPDX-License-Identifier: Apache-2.0
// profile.json of feline profile: what is taken is written again as it is, merges, and has a legal unit.
#include "testbench/prune/profile_json.h"
#include "testbench/prune/profile_text.h"
#include "testbench/prune/prune.h"
#include "tests/fuzz/fuzz.h"

namespace feline {
namespace {

void check(const Profile& profile) {
  fuzz::require(profile_from_json(profile_to_json(profile), "again") == profile, "profile_to_json: the same again");
  Profile twice = profile;
  merge(twice, profile);
  fuzz::require(twice.lookups == 2 * profile.lookups && twice.textures.size() == profile.textures.size(),
                "merge: counts add, sets join");
  profile_to_text(profile);
  const Config config = pruned_config(profile);
  for (const ConfigField& each : kConfigFields) {
    fuzz::require(config.*each.field >= each.least && config.*each.field <= each.most, "pruned_config: a legal unit");
  }
  fuzz::require(is_within(config, kDefaultConfig), "pruned_config: within the full unit");
}

}  // namespace
}  // namespace feline

void feline::fuzz::run(Input input) {
  accepts([&] { check(profile_from_json(input.rest(), "profile")); });
}
