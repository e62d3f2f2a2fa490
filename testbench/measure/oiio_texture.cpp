// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/oiio_texture.h"

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "testbench/measure/render_rows.h"

namespace feline {
namespace {

// A tiled, mip-mapped file, which is what OpenImageIO textures from; gone when this is.
class TextureFile {
 public:
  explicit TextureFile(const reference::Level& level) {
    std::string pattern = (std::filesystem::temp_directory_path() / "feline-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw std::runtime_error(fmt::format("{}: no temporary directory", pattern));
    directory_ = pattern;
    const OIIO::ImageSpec spec(level.width, level.height, 4, OIIO::TypeDesc::FLOAT);
    // OpenImageIO takes no constant texels, and does not change them.
    const OIIO::ImageBuf base(spec, const_cast<reference::Texel*>(level.texels.data()));
    OIIO::ImageSpec config;
    config.attribute("maketx:filtername", "lanczos3");
    config.attribute("maketx:wrap", "periodic");
    if (!OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, base, path(), config)) {
      throw std::runtime_error(fmt::format("{}: {}", path(), OIIO::geterror()));
    }
  }
  TextureFile(const TextureFile&) = delete;
  TextureFile& operator=(const TextureFile&) = delete;
  ~TextureFile() {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
  }
  std::string path() const { return (directory_ / "texture.tx").string(); }

 private:
  std::filesystem::path directory_;
};

OIIO::TextureOpt::Wrap to_oiio(Wrap wrap) {
  switch (wrap) {
    case Wrap::kRepeat: return OIIO::TextureOpt::WrapPeriodic;
    case Wrap::kMirroredRepeat: return OIIO::TextureOpt::WrapMirror;
    case Wrap::kClampToEdge: return OIIO::TextureOpt::WrapClamp;
    case Wrap::kClampToBorder: return OIIO::TextureOpt::WrapBlack;
  }
  return OIIO::TextureOpt::WrapDefault;
}

Rendering render_oiio(const View& view, Progress* progress) {
  const reference::MipMap& map = view.surface->images.lanczos;
  const TextureFile file(map.base());
  const std::shared_ptr<OIIO::TextureSystem> system(
      OIIO::TextureSystem::create(false), [](OIIO::TextureSystem* made) { OIIO::TextureSystem::destroy(made); });
  const OIIO::ustring name(file.path());
  OIIO::TextureOpt options;
  options.swrap = to_oiio(map.wrapping.s);
  options.twrap = to_oiio(map.wrapping.t);
  options.mipmode = OIIO::TextureOpt::MipModeAniso;
  options.interpmode = OIIO::TextureOpt::InterpBilinear;
  options.anisotropic = 16;
  std::atomic<bool> failed = false;
  const auto look_up = [&](std::size_t i, reference::Cost&) {
    const Lookup& at = view.gbuffer.lookups[i];
    OIIO::TextureOpt own = options;
    std::array<float, 4> result{};
    if (!system->texture(name, own, at.s, at.t, at.dsdx, at.dtdx, at.dsdy, at.dtdy, 4, result.data())) failed = true;
    reference::Colour colour{};
    for (std::size_t c = 0; c < 4; ++c) colour[c] = double{result[c]};
    return colour;
  };
  // The first pass reads the file's tiles, which is no pixel's time.
  render_rows(view, nullptr, look_up);
  Rendering rendering = render_rows(view, progress, look_up);
  if (failed) throw std::runtime_error(fmt::format("OpenImageIO: {}", system->geterror()));
  rendering.probes.clear();
  return rendering;
}

}  // namespace

Contestant oiio_contestant() {
  return {"openimageio",
          Contestant::Kind::kLibrary,
          "OpenImageIO's anisotropic texture(), bilinear, 16:1",
          "OpenImageIO " + std::to_string(OIIO_VERSION_MAJOR) + "." + std::to_string(OIIO_VERSION_MINOR),
          {},
          render_oiio};
}

}  // namespace feline
