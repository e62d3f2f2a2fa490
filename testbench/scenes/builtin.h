// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/scenes/scene.h"

namespace feline {

// One file each; scenes() collects them.
Scene bricks_scene();
Scene checkerboard_scene();
Scene curves_scene();
Scene magnify_scene();
Scene runway_scene();
Scene sphere_scene();
Scene text_scene();
Scene window_scene();

// Textures that several scenes share.
MipLevel paint_checkerboard();
MipLevel paint_text();

}  // namespace feline
