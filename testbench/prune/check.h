// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "model/sampler.h"
#include "testbench/gbuffer.h"
#include "testbench/progress.h"
#include "testbench/prune/observe.h"

namespace feline {

// What a unit that is not the full one makes of lookups, pixel by pixel. A lookup is inside when the unit has all that
// it needs, by its own profile. `silent` must be 0, and of what is inside nothing is flagged.
struct PrunedCheck {
  std::uint64_t lookups = 0;
  std::uint64_t refused = 0;     // by the driver: the unit cannot hold the texture
  std::uint64_t flagged = 0;     // by the unit, as unsupported
  std::uint64_t outside = 0;     // need what the unit has not
  std::uint64_t identical = 0;   // not flagged, colour and status the full unit's
  std::uint64_t silent = 0;      // not flagged, and another colour or status
  std::uint64_t misjudged = 0;   // flagged or refused inside, or not flagged outside
  std::uint64_t mismatches = 0;  // RTL and model of the unit differ
  std::uint64_t probes = 0;
  std::uint64_t cycles = 0;
  std::string message;  // of a mismatch or of the first pixel that is wrong; ends with a newline

  bool holds() const { return silent == 0 && misjudged == 0 && mismatches == 0; }
};

void add(PrunedCheck& into, const PrunedCheck& from);
nlohmann::ordered_json to_json(const PrunedCheck& check);
// Throws std::exception when it is no such text.
PrunedCheck check_from_json(const nlohmann::ordered_json& json);

// Co-simulates the unit of this build (tables/unit.h) on a frame, stops at a beat that differs, and compares its pixels
// with those of the full unit's model.
PrunedCheck check_pruned(const std::string& source, const GBuffer& gbuffer, const SamplerOptions& options,
                         const Texture& texture, const TextureMemory& memory, Progress* progress);

}  // namespace feline
