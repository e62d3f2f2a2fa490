// SPDX-License-Identifier: Apache-2.0
#include "testbench/lazy_texture.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>
#include <unordered_set>

#include "tables/pack.h"
#include "testbench/render.h"
#include "tests/support/random.h"
#include "tests/testbench/run_program.h"
#include "tests/testbench/temp_dir.h"
#include "tests/testbench/tiled_file.h"

namespace feline {
namespace {

// Every line is that of the file loaded whole, in whatever order they are asked for.
void expect_same_lines(const std::filesystem::path& path, const ImageOptions& options = {}) {
  const Texture texture = load_texture(path, options);
  const TextureMemory memory = layout_texture(texture);
  const auto lazy = LazyTexture::open(path, options);
  ASSERT_TRUE(lazy);
  const TextureShape& shape = lazy->shape();
  EXPECT_EQ(shape.format, texture.format);
  EXPECT_EQ(shape.srgb, texture.srgb);
  EXPECT_EQ(shape.levels, static_cast<int>(texture.levels.size()));
  EXPECT_EQ(shape.level_base, memory.level_base);
  EXPECT_EQ(lazy->residency().tiles, 0);
  const SamplerOptions sampler;
  EXPECT_TRUE(
      same(make_sampler<kDefaultConfig>(sampler, shape), make_sampler<kDefaultConfig>(sampler, texture, memory)));
  Random random = random_for(path.filename().string());
  const auto lines = static_cast<std::int64_t>(memory.lines());
  const auto expect_same_line = [&](std::int64_t line) {
    ASSERT_TRUE(std::ranges::equal(lazy->line(line), memory.line(line))) << path << " line " << line;
  };
  for (int i = 0; i < 50; ++i) expect_same_line(random.below(lines));
  for (std::int64_t line = 0; line < lines; ++line) expect_same_line(line);
  const Residency residency = lazy->residency();
  EXPECT_EQ(residency.tiles, residency.whole_tiles);
  EXPECT_EQ(residency.levels, shape.levels);
  EXPECT_EQ(residency.whole_bytes, static_cast<std::int64_t>(memory.bytes.size()));
  EXPECT_GE(residency.bytes, residency.whole_bytes);
}

TEST(lazy_texture, lines_are_those_of_the_whole_file) {
  const TempDir dir;
  for (const auto& [width, height] : {std::pair{100, 60}, {64, 64}, {1, 37}, {300, 2}, {129, 65}}) {
    for (int channels = 1; channels <= 4; ++channels) {
      SCOPED_TRACE(fmt::format("{} x {} x {}", width, height, channels));
      const auto path = dir / fmt::format("{}-{}-{}.tif", width, height, channels);
      write_tiled(path, {width, height, channels, 16});
      expect_same_lines(path, {.srgb = channels == 3});
      expect_same_lines(path, {.format = TexelFormat::kRg8});
      expect_same_lines(path, {.format = TexelFormat::kRgba8});
    }
  }
}

TEST(lazy_texture, lines_of_other_kinds_of_files) {
  const TempDir dir;
  write_tiled(dir / "half.exr", {100, 60, 4, 20, 16, OIIO::TypeDesc::HALF, "zip"});
  expect_same_lines(dir / "half.exr");
  write_tiled(dir / "wide.tif", {100, 60, 3, 32, 16, OIIO::TypeDesc::UINT16});
  expect_same_lines(dir / "wide.tif");
  write_tiled(dir / "cut.tif", {100, 60, 1, 32, 3});
  expect_same_lines(dir / "cut.tif");
  ASSERT_EQ(run_program("oiiotool", "--pattern noise 200x90 4 -d uint8 -o " + (dir / "noise.tif").string()).code, 0);
  ASSERT_EQ(run_program("maketx", (dir / "noise.tif").string() + " -o " + (dir / "noise.tx").string()).code, 0);
  expect_same_lines(dir / "noise.tx");
}

TEST(lazy_texture, files_that_are_loaded_whole) {
  const TempDir dir;
  write_tiled(dir / "level.tif", {64, 64, 1, 16, 1});
  EXPECT_FALSE(LazyTexture::open(dir / "level.tif")) << "one level";
  write_tiled(dir / "odd.exr", {64, 64, 1, 18, 16, OIIO::TypeDesc::HALF, "zip"});
  EXPECT_FALSE(LazyTexture::open(dir / "odd.exr")) << "tiles that lines straddle";
  write_png(dir / "grey.png", 2, 2, 1, std::vector<std::uint8_t>{1, 2, 3, 4});
  EXPECT_FALSE(LazyTexture::open(dir / "grey.png")) << "no tiles";
}

TEST(lazy_texture, a_line_loads_its_tile_only) {
  const TempDir dir;
  write_tiled(dir / "a.tif", {256, 128, 1, 64});
  const auto lazy = LazyTexture::open(dir / "a.tif");
  ASSERT_TRUE(lazy);
  EXPECT_EQ(lazy->residency().whole_tiles, 8 + 2 + 7);
  EXPECT_EQ(lazy->residency().whole_levels, 9);
  const std::int64_t empty = lazy->residency().bytes;
  for (const std::int64_t line : {0, 15, 64, 15 * 64 + 15}) lazy->line(line);
  EXPECT_EQ(lazy->residency().tiles, 1);
  EXPECT_EQ(lazy->residency().bytes, empty + 64 * 64 * 4);
  lazy->line(16);
  EXPECT_EQ(lazy->residency().tiles, 2);
  lazy->line(lazy->shape().level_base[8]);
  EXPECT_EQ(lazy->residency().tiles, 3);
  EXPECT_EQ(lazy->residency().levels, 2);
  EXPECT_EQ(lazy->residency().bytes, empty + 2 * 64 * 64 * 4 + kLineBytes);
}

TEST(lazy_texture, corrupt_files) {
  const TempDir dir;
  write_tiled(dir / "a.tif", {256, 256, 1, 64, 16, OIIO::TypeDesc::UINT8, "none"});
  const std::string path = (dir / "a.tif").string();
  const auto lazy = LazyTexture::open(path);
  ASSERT_TRUE(lazy);
  std::filesystem::resize_file(path, 5000);
  EXPECT_NE(input_error([&] {
              for (std::int64_t line = 0; line < 4096; ++line) lazy->line(line);
            }).find(path + ": pixels: "),
            std::string::npos);
  EXPECT_NE(input_error([&] { LazyTexture::open(dir / "none.tx"); }).find("none.tx: open"), std::string::npos);
}

TEST(lazy_texture, program_renders_the_same_picture) {
  const TempDir dir;
  write_tiled(dir / "a.tif", {500, 300, 3, 64});
  const std::string common = "render --json --scene sphere --size 48 --map --texture " + (dir / "a.tif").string();
  const Outcome lazy = run_program(FELINE_PROGRAM, common + " --output " + (dir / "lazy.png").string());
  ASSERT_EQ(lazy.code, 0) << lazy.text;
  const Outcome whole =
      run_program(FELINE_PROGRAM, common + " --no-shortcuts --output " + (dir / "whole.png").string());
  ASSERT_EQ(whole.code, 0) << whole.text;
  for (const char* const name : {"", "-probes", "-levels"}) {
    EXPECT_EQ(read_bytes(dir / fmt::format("lazy{}.png", name)), read_bytes(dir / fmt::format("whole{}.png", name)));
  }
  EXPECT_GT(nlohmann::json::parse(lazy.text)["left_out"]["decoded_codes"], 0);
  EXPECT_EQ(nlohmann::json::parse(whole.text)["left_out"]["decoded_codes"], 0);
}

// A wall at a grazing angle, 8 texels a pixel along s and 1 along t, of which 5600 x 640 texels are seen.
GBuffer grazing_wall(int texture_size) {
  GBuffer gbuffer{700, 640, {}};
  const auto texels = [&](double count) { return static_cast<float>(count / texture_size); };
  for (int y = 0; y < gbuffer.height; ++y) {
    for (int x = 0; x < gbuffer.width; ++x) {
      gbuffer.lookups.push_back({texels(3000 + 8 * x), texels(7000.3 + y), texels(8), 0, 0, texels(1)});
    }
  }
  return gbuffer;
}

// A lazy texture that tells which lines were asked for.
struct WatchedTexture {
  LazyTexture& texture;
  std::unordered_set<std::int64_t> asked{};
  std::span<const std::uint8_t> line(std::int64_t index) {
    asked.insert(index);
    return texture.line(index);
  }
  bool opaque() const { return texture.opaque(); }
};

std::int64_t peak_of_children() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return usage.ru_maxrss * std::int64_t{1024};
}

TEST(lazy_texture, one_percent_of_a_large_texture_takes_one_percent_of_its_memory) {
  const TempDir dir;
  write_tiled(dir / "large.tif", {16384, 16384});
  const GBuffer gbuffer = grazing_wall(16384);
  const auto lazy = LazyTexture::open(dir / "large.tif");
  ASSERT_TRUE(lazy);
  SamplerOptions options;
  options.mode = Mode::kSimple;
  const auto state = make_sampler<kDefaultConfig>(options, lazy->shape());
  WatchedTexture watched{*lazy};
  ShortcutUnit<kDefaultConfig, WatchedTexture> unit(state, watched);
  for (std::size_t i = 0; i < gbuffer.lookups.size(); ++i) {
    unit.sample(make_request<kDefaultConfig>(gbuffer.lookups[i], 0));
  }
  const Residency residency = lazy->residency();
  const auto whole = static_cast<double>(residency.whole_bytes);
  EXPECT_EQ(residency.whole_bytes, std::int64_t{64} * 22369623);
  const double touched = static_cast<double>(watched.asked.size()) * kLineBytes / whole;
  const double resident = static_cast<double>(residency.bytes) / whole;
  EXPECT_NEAR(touched, 0.01, 0.001);
  EXPECT_LT(resident, 1.25 * touched);

  // The program as a whole: its peak over that of a picture with a small texture.
  write_gbuffer(dir / "wall.exr", gbuffer);
  write_tiled(dir / "small.tif", {64, 64});
  const auto run = [&](const std::string& texture) {
    return run_program(FELINE_PROGRAM, fmt::format("render --json --mode simple --gbuffer {} --texture {} --output {}",
                                                   (dir / "wall.exr").string(), (dir / texture).string(),
                                                   (dir / (texture + ".png")).string()));
  };
  ASSERT_EQ(run("small.tif").code, 0);
  const std::int64_t small_peak = peak_of_children();
  const Outcome outcome = run("large.tif");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const double growth = static_cast<double>(peak_of_children() - small_peak) / whole;
  EXPECT_EQ(nlohmann::json::parse(outcome.text)["texture_memory"]["bytes"], residency.bytes);
  EXPECT_LT(growth, 0.02);
  fmt::print("touched {:.3f} %, in memory {:.3f} %, the program's peak {:.3f} % of {} bytes\n", 100 * touched,
             100 * resident, 100 * growth, residency.whole_bytes);
}

}  // namespace
}  // namespace feline
