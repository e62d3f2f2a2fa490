// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/memory.h"
#include "model/shortcuts.h"
#include "testbench/gbuffer.h"

namespace feline {

// What shortcuts save on one picture. Times are of one thread's processor, medians over the runs; ratios are medians of
// each run's own, so that what disturbs a run disturbs both its times.
struct ShortcutStudy {
  struct Row {
    std::string name;
    double nanoseconds = 0;  // a pixel
    double of_plain = 0;     // plain time over this one: above 1 is faster
    double of_straight = 0;  // the same of the stages run into each other with every shortcut off
    bool same = true;        // every pixel and plan, bit for bit
    ShortcutCounts counts;
  };
  Row plain;                // stage by stage
  Row straight;             // every shortcut off
  std::vector<Row> single;  // each shortcut alone, in the order of kShortcutNames
  Row all;
  bool same() const;
};

// runs >= 1: each times every row once, in turn.
ShortcutStudy study_shortcuts(const GBuffer& gbuffer, const SamplerState<kDefaultConfig>& sampler,
                              const TextureMemory& memory, int runs);

}  // namespace feline
