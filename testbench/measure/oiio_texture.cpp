// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/oiio_texture.h"

#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "testbench/error.h"
#include "testbench/measure/render_rows.h"

namespace feline {
namespace {

// A tiled, mip-mapped file, which is what OpenImageIO textures from; gone when this is.
class TextureFile {
 public:
  explicit TextureFile(const reference::MipMap& map) {
    std::error_code error;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
    std::string pattern = (parent / "feline-XXXXXX").string();
    if (error || mkdtemp(pattern.data()) == nullptr) {
      const char* const given = std::getenv("TMPDIR");
      bad_input("environment", "TMPDIR", given == nullptr ? "" : given, "a directory that can be written to");
    }
    directory_ = pattern;
    const std::unique_ptr<OIIO::ImageOutput> file = OIIO::ImageOutput::create("exr");
    for (std::size_t k = 0; file != nullptr && k < map.levels.size(); ++k) {
      const reference::Level& level = map.levels[k];
      OIIO::ImageSpec spec(level.width, level.height, 4, OIIO::TypeDesc::FLOAT);
      spec.tile_width = spec.tile_height = kTile;
      spec.attribute("textureformat", "Plain Texture");
      spec.attribute("compression", "none");
      const auto mode = k == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendMIPLevel;
      if (!file->open(path(), spec, mode) || !file->write_image(OIIO::TypeDesc::FLOAT, level.texels.data())) {
        throw std::runtime_error(fmt::format("{}: {}", path(), file->geterror()));
      }
    }
    if (file == nullptr || !file->close()) throw std::runtime_error(fmt::format("{}: {}", path(), OIIO::geterror()));
  }
  TextureFile(const TextureFile&) = delete;
  TextureFile& operator=(const TextureFile&) = delete;
  ~TextureFile() {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
  }
  std::string path() const { return (directory_ / "texture.exr").string(); }

 private:
  static constexpr int kTile = 64;
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
  const TextureFile file(map);
  // The shared one, as OpenImageIO 2.4 gives back its memory of any other as if it were of another type.
  OIIO::TextureSystem* const system = OIIO::TextureSystem::create(true);
  const OIIO::ustring name(file.path());
  OIIO::TextureSystem::TextureHandle* const handle = system->get_texture_handle(name);
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
    if (!system->texture(handle, nullptr, own, at.s, at.t, at.dsdx, at.dtdx, at.dsdy, at.dtdy, 4, result.data())) {
      failed = true;
    }
    reference::Colour colour{};
    for (std::size_t c = 0; c < 4; ++c) colour[c] = double{result[c]};
    return colour;
  };
  // The first pass reads the file's tiles, which is no pixel's time.
  render_rows(view, nullptr, look_up);
  Rendering rendering = render_rows(view, progress, look_up);
  system->invalidate(name);
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
