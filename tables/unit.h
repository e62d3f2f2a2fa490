// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/config.h"

namespace feline {

// The configuration of the RTL and of the model that it is compared with. A build for another unit than the default one
// names a header that defines it (testbench/prune/build.sh).
#ifdef FELINE_UNIT_HEADER
#include FELINE_UNIT_HEADER
#else
inline constexpr Config kUnit = kDefaultConfig;
#endif

}  // namespace feline
