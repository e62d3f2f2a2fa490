// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/measure/contestant.h"

namespace feline {

// OpenImageIO's own anisotropic texture(): bilinear probes, 16:1, mip levels by its lanczos3, all in float32. Neither
// probes nor texels are told.
Contestant oiio_contestant();

}  // namespace feline
