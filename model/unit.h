// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/accumulate.h"
#include "model/address.h"
#include "model/fetch.h"
#include "model/filter.h"
#include "model/footprint.h"
#include "model/group.h"
#include "model/plan.h"
#include "model/walk.h"

namespace feline {

// Ignores every beat; the compiler leaves nothing of it.
struct NoTrace {
  template <typename Beat>
  void operator()(const Beat&) const {}
};

// The unit: one lookup through the eight stages. `trace` is called with each beat in the order in which it is made.
template <Config kConfig, typename Trace = NoTrace>
AccumulateBeat<kConfig> sample(const RequestBeat<kConfig>& request, const SamplerState<kConfig>& sampler,
                               const TextureMemory& memory, Trace&& trace = {}) {
  trace(request);
  const GroupBeat<kConfig> grouped = group<kConfig>(request, sampler);
  trace(grouped);
  const FootprintBeat<kConfig> shaped = footprint<kConfig>(grouped, sampler);
  trace(shaped);
  const PlanBeat<kConfig> planned = plan<kConfig>(shaped, sampler);
  trace(planned);
  Accumulator<kConfig> sum{};
  for (std::int64_t probe = 0;; ++probe) {
    const WalkBeat<kConfig> walked = walk<kConfig>(planned, probe);
    trace(walked);
    const AddressBeat<kConfig> addressed = address<kConfig>(walked, sampler);
    trace(addressed);
    const FetchBeat<kConfig> fetched = fetch<kConfig>(addressed, sampler, memory);
    trace(fetched);
    const FilterBeat<kConfig> filtered = filter<kConfig>(fetched, sampler);
    trace(filtered);
    if (const auto pixel = accumulate<kConfig>(filtered, sum)) {
      trace(*pixel);
      return *pixel;
    }
  }
}

}  // namespace feline
