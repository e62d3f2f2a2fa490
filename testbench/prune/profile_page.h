// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/prune/profile.h"

namespace feline {

// The profile as a page of one file: what is reached and what never, plots, and heat maps of the ellipse table, of
// mantissas, of the weight table and of the textures. Throws InputError when there is no gnuplot.
std::string profile_page(const Profile& profile);

}  // namespace feline
