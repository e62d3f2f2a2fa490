// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "testbench/cosim/cosimulation.h"
#include "testbench/coverage/bin_grid.h"

namespace feline::coverage {

// The functional bins of lookups: which of every table cell, weight row, probe count, level pair, wrap and size, class
// of float32 and combination of modes the lookups of a suite reach, by the beats that the model makes of them.
class LookupBins {
 public:
  LookupBins();
  // All lookups of a batch, which comes right after the one before it: the unit is not reset.
  void observe(const Batch& batch);
  // One lookup, as if alone; true where it reaches a bin that none did before.
  bool observe(const Lookup& lookup, const SamplerState<kUnit>& sampler, const TextureMemory& memory);
  // The next batch comes after a reset.
  void forget_mode() { mode_before_.reset(); }

  const std::vector<BinGrid>& grids() const { return grids_; }

 private:
  class Recorder;
  std::vector<BinGrid> grids_;
  std::optional<std::size_t> mode_before_;
};

}  // namespace feline::coverage
