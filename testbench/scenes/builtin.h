// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/scenes/scene.h"

namespace feline {

// A file each, or each kind; scenes() collects them.
Scene bricks_scene();
Scene checkerboard_scene();
Scene curves_scene();
Scene magnify_scene();
Scene reflector_scene();
Scene repeat_scene();
Scene runway_low_scene();
Scene runway_middle_scene();
Scene runway_scene();
Scene runway_steep_scene();
Scene sphere_scene();
Scene spin_scene();
Scene tessellated_scene();
Scene text_scene();
Scene window_scene();

// Textures that several scenes share, or that have a file of their own.
MipLevel paint_bricks();
MipLevel paint_checkerboard();
MipLevel paint_curves();
MipLevel paint_environment();
MipLevel paint_text();

}  // namespace feline
