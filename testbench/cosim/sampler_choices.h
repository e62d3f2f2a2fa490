// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tables/sampler_enums.h"

namespace feline {

// The samplers that random lookups may draw; all by default.
struct SamplerChoices {
  std::vector<Mode> modes{Mode::kNearest, Mode::kBilinear, Mode::kTrilinear, Mode::kExt, Mode::kSimple, Mode::kTable};
  std::vector<Kernel> kernels{Kernel::kBilinear, Kernel::kGaussian};
  std::vector<Wrap> wraps{Wrap::kRepeat, Wrap::kMirroredRepeat, Wrap::kClampToEdge, Wrap::kClampToBorder};
};

}  // namespace feline
