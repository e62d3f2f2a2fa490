// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace feline {

// How often bits of a stage changed.
struct StageToggles {
  std::string stage;            // "spill" between walk and address; "rest" for what belongs to no stage
  std::uint64_t registers = 0;  // of flip-flops: signals ..._q
  std::uint64_t nets = 0;       // of every signal that the stage drives, registers among them, memories not
  std::uint64_t memories = 0;   // of words of memories, as the texel cache's
};

// Counts the toggles in a waveform (FST) of the unit, from its first instant to its end, stages in the order of the
// unit. A signal with several names counts once. Throws InputError when it cannot be read, std::runtime_error when the
// unit is not in it.
std::vector<StageToggles> count_toggles(const std::filesystem::path& wave);

}  // namespace feline
