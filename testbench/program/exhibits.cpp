// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/exhibits.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "testbench/error.h"
#include "testbench/image.h"
#include "testbench/program/command_line.h"
#include "testbench/program/subject.h"
#include "testbench/scenes/scene.h"

namespace feline {

ExhibitPlan ExhibitOptions::own() const {
  if (gbuffer.empty() || texture.empty()) {
    bad_input("command line", gbuffer.empty() ? "--gbuffer" : "--texture", "nothing",
              "a file: a G-buffer and a texture go together");
  }
  const auto wraps = static_cast<Wrap>(parse_name("--wrap", wrap, kWrapNames));
  ImageOptions image;
  image.srgb = srgb;
  image.mip_edge = wraps == Wrap::kRepeat ? MipEdge::kRepeat : MipEdge::kClamp;
  return plan_exhibit(gbuffer, texture, image, wraps);
}

std::vector<ExhibitPlan> ExhibitOptions::plans() const {
  if (!gbuffer.empty() || !texture.empty()) return {own()};
  const Size sides = parse_size("--size", size);
  std::vector<ExhibitPlan> chosen;
  for (const Scene* const scene : scene_list(scenes)) {
    chosen.push_back(plan_exhibit(*scene, sides.width, sides.height));
  }
  return chosen;
}

void ExhibitOptions::add_to(CLI::App& command) {
  auto* const scene =
      command.add_option("--scene", scenes, scene_names() + "; a list a,b, or all")->capture_default_str();
  auto* const sides =
      command.add_option("--size", size, "picture size: N or WIDTHxHEIGHT; a sequence's frames have half")
          ->capture_default_str();
  auto* const view =
      command.add_option("--gbuffer", gbuffer, "EXR with channels s, t, dsdx, dtdx, dsdy, dtdy: your own view")
          ->excludes(scene)
          ->excludes(sides);
  auto* const image = command.add_option("--texture", texture, "image or .tx file for it")->needs(view);
  command.add_flag("--srgb", srgb, "the texture file's colours are sRGB encoded")->needs(image);
  command.add_option("--wrap", wrap, fmt::format("of it: {}", fmt::join(kWrapNames, ", ")))->needs(image);
}

}  // namespace feline
