// SPDX-License-Identifier: Apache-2.0
// G-buffers: what is taken is finite unless it may be otherwise, and the same after writing and reading.
#include <cmath>
#include <cstring>

#include "testbench/gbuffer.h"
#include "tests/fuzz/images.h"

namespace feline {
namespace {

bool is_finite(const Lookup& lookup) {
  return std::isfinite(lookup.s) && std::isfinite(lookup.t) && std::isfinite(lookup.dsdx) &&
         std::isfinite(lookup.dtdx) && std::isfinite(lookup.dsdy) && std::isfinite(lookup.dtdy);
}

void check(const GBuffer& gbuffer, const GBufferOptions& options) {
  fuzz::require(
      gbuffer.lookups.size() == static_cast<std::size_t>(gbuffer.width) * static_cast<std::size_t>(gbuffer.height),
      "read_gbuffer: a lookup a pixel");
  fuzz::require(options.allow_non_finite || std::ranges::all_of(gbuffer.lookups, is_finite), "read_gbuffer: finite");
  const auto path = fuzz::directory() / "written.exr";
  write_gbuffer(path, gbuffer);
  const GBuffer again = read_gbuffer(path, options);
  fuzz::require(
      again.width == gbuffer.width && again.height == gbuffer.height &&
          std::memcmp(again.lookups.data(), gbuffer.lookups.data(), gbuffer.lookups.size() * sizeof(Lookup)) == 0,
      "write_gbuffer: every bit pattern");
}

}  // namespace
}  // namespace feline

void feline::fuzz::run(Input input) {
  limit_openimageio();
  const GBufferOptions options{input.choose(2) != 0};
  const auto path = file_with("gbuffer.exr", input.rest());
  accepts([&] {
    if (is_small(path, input.rest())) check(read_gbuffer(path, options), options);
  });
}
