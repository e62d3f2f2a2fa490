// SPDX-License-Identifier: Apache-2.0
// Image files as textures, through this project's limits.
#include <array>

#include "model/sampler.h"
#include "testbench/image.h"
#include "tests/fuzz/images.h"

namespace feline {
namespace {

constexpr std::array<const char*, 8> kNames{"image.png", "image.tif", "image.exr", "image.tga",
                                            "image.bmp", "image.ppm", "image.hdr", "image.jpg"};

ImageOptions chosen_options(fuzz::Input& input) {
  ImageOptions options;
  const std::size_t flags = input.choose(8);
  options.srgb = (flags & 1) != 0;
  options.mip_filter = (flags & 2) != 0 ? MipFilter::kBox : MipFilter::kLanczos;
  options.mip_edge = (flags & 4) != 0 ? MipEdge::kRepeat : MipEdge::kClamp;
  if (const std::size_t format = input.choose(4); format != 0) options.format = static_cast<TexelFormat>(format - 1);
  return options;
}

void check(const Texture& texture, const ImageOptions& options) {
  fuzz::require(!options.format || texture.format == *options.format, "load_texture: the format that was asked for");
  fuzz::require(texture.srgb == options.srgb, "load_texture: srgb as it was asked for");
  // Throws SamplerError for a chain of other sizes.
  make_sampler<kDefaultConfig>({}, texture, layout_texture(texture));
}

}  // namespace
}  // namespace feline

// "LeakSanitizer: 31 byte(s) leaked in 1 allocation(s)": libpng leaves OpenImageIO 2.4.7's reader at the end of a file
// that is cut short by longjmp, with a message in it. Only slow unwinding finds who that is.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" const char* __lsan_default_suppressions() { return "leak:PNGInput::PngReadCallback\n"; }
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" const char* __asan_default_options() { return "fast_unwind_on_malloc=0"; }

void feline::fuzz::run(Input input) {
  limit_openimageio();
  const char* const name = input.choose<const char* const>(kNames);
  const ImageOptions options = chosen_options(input);
  const auto path = file_with(name, input.rest());
  accepts([&] {
    if (is_small(path, input.rest())) check(load_texture(path, options), options);
  });
}
