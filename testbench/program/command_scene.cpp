// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

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
  bool json = false;
};

int list_scenes(bool json) {
  nlohmann::ordered_json all;
  for (const Scene& scene : scenes()) {
    all.push_back({{"scene", scene.name}, {"description", scene.description}});
    if (!json) fmt::print("{:<14}{}\n", scene.name, scene.description);
  }
  if (json) fmt::print("{}\n", all.dump(1));
  return kHolds;
}

int run_scene(const SceneOptions& options) {
  if (options.list) return list_scenes(options.json);
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
  OutputFiles outputs;
  write_gbuffer(outputs, gbuffer_path, make_gbuffer(scene, size.width, size.height));
  write_png(outputs, texture_path, level.width, level.height, bytes_per_texel(scene.format),
            std::span<const std::uint8_t>(level.texels));
  outputs.commit();
  if (options.json) {
    const nlohmann::ordered_json json{{"scene", scene.name},
                                      {"width", size.width},
                                      {"height", size.height},
                                      {"gbuffer", gbuffer_path.string()},
                                      {"texture", texture_path.string()},
                                      {"srgb", scene.srgb}};
    fmt::print("{}\n", json.dump(1));
  } else {
    fmt::print("{}\n{}{}\n", gbuffer_path.string(), texture_path.string(),
               scene.srgb ? "  (sRGB: give --srgb with it)" : "");
  }
  return kHolds;
}

}  // namespace

void add_scene(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<SceneOptions>();
  CLI::App* command = program.add_subcommand("scene", "writes a built-in scene as a G-buffer and its texture");
  command->footer("Example: feline scene --scene bricks --size 512 --output /tmp");
  auto* const scene = command->add_option("--scene", options->scene, scene_names());
  auto* const size =
      command->add_option("--size", options->size, "picture size: N or WIDTHxHEIGHT")->capture_default_str();
  command->add_option("--output", options->output, "directory for NAME.exr and NAME-texture.png")
      ->capture_default_str();
  command->add_flag("--list", options->list, "tell the scenes and stop")->excludes(scene)->excludes(size);
  command->add_flag("--json", options->json, "tell what was written, or the list, as JSON");
  command->callback([options, &exit_code] { exit_code = run_scene(*options); });
}

}  // namespace feline
