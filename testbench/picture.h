// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "model/unit.h"
#include "testbench/atomic_file.h"

namespace feline {

// What the unit makes of a G-buffer, row by row: the colour, and what the plan was.
struct Picture {
  int width = 0;
  int height = 0;
  bool srgb = false;  // the texture was sRGB: the picture is encoded again
  std::vector<AccumulateBeat<kDefaultConfig>> pixels;
  std::vector<PlanBeat<kDefaultConfig>> plans;
};

// 8 bit RGBA PNG: channels rounded to nearest; sRGB by the nearest code in linear light.
void write_picture(OutputFiles& outputs, const std::filesystem::path& path, const Picture& picture);
// Probes a pixel: 1 or none white, 2 light blue, 4 dark blue, 8 green, 16 red, blended between (Feline figures 33, 34).
std::array<int, 3> probe_colour(int probes);
void write_probe_map(OutputFiles& outputs, const std::filesystem::path& path, const Picture& picture);
// Level of detail: hues from red, level 0, to violet, the last level.
void write_level_map(OutputFiles& outputs, const std::filesystem::path& path, const Picture& picture, int last_level);

}  // namespace feline
