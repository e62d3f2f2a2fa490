// SPDX-License-Identifier: Apache-2.0
// Where libFuzzer comes in, the same for every target.
#include "tests/fuzz/fuzz.h"

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  feline::fuzz::run({data, size});
  return 0;
}
