// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/measure/survey.h"

namespace feline {

// One row a scene and contestant, RFC 4180; after more than one scene, rows of all together, whose scene is "all".
// Empty: not told, or infinite, as the PSNR of a picture without error is.
std::string to_csv(const Survey& survey);

}  // namespace feline
