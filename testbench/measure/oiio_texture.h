// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/measure/contestant.h"

namespace feline {

// OpenImageIO's own anisotropic texture(): bilinear probes, 16:1, on the surface's own mip levels, in float32. Neither
// probes nor texels are told.
Contestant oiio_contestant();

}  // namespace feline
