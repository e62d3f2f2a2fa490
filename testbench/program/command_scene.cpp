// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "testbench/error.h"
#include "testbench/program/commands.h"
#include "testbench/program/subject.h"
#include "testbench/scenes/scene.h"

namespace feline {
namespace {

struct SceneOptions {
  std::string scene;
  std::string size = "256";
  std::string output = ".";
  bool list = false;
};

int run_scene(const SceneOptions& options) {
  if (options.list) {
    for (const Scene& scene : scenes()) fmt::print("{:<14}{}\n", scene.name, scene.description);
    return kHolds;
  }
  const Scene& scene = find_scene(options.scene.empty() ? scenes().front().name : std::string_view(options.scene));
  const Size size = parse_size("--size", options.size);
  const std::filesystem::path directory = options.output;
  if (!std::filesystem::is_directory(directory)) {
    bad_input(options.output, "--output", "no directory", "a directory that exists");
  }
  const std::string stem(scene.name);
  const MipLevel level = scene.paint();
  const auto gbuffer_path = directory / (stem + ".exr");
  const auto texture_path = directory / (stem + "-texture.png");
  write_gbuffer(gbuffer_path, make_gbuffer(scene, size.width, size.height));
  write_png(texture_path, level.width, level.height, bytes_per_texel(scene.format),
            std::span<const std::uint8_t>(level.texels));
  fmt::print("{}\n{}{}\n", gbuffer_path.string(), texture_path.string(),
             scene.srgb ? "  (sRGB: give --srgb with it)" : "");
  return kHolds;
}

}  // namespace

void add_scene(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<SceneOptions>();
  CLI::App* command = program.add_subcommand("scene", "writes a built-in scene as a G-buffer and its texture");
  command->footer("Example: feline scene --scene bricks --size 512 --output /tmp");
  command->add_option("--scene", options->scene, "its name; --list tells them");
  command->add_option("--size", options->size, "picture size: N or WIDTHxHEIGHT")->capture_default_str();
  command->add_option("--output", options->output, "directory for NAME.exr and NAME-texture.png")
      ->capture_default_str();
  command->add_flag("--list", options->list, "tell the scenes and stop");
  command->callback([options, &exit_code] { exit_code = run_scene(*options); });
}

}  // namespace feline
