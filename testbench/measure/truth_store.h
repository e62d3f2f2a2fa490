// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "testbench/measure/truth.h"

namespace feline {

// Truths as bytes for the cache: what this program wrote on this machine.
std::string to_bytes(const Truth& truth);
// Throws std::runtime_error when the bytes are no truth.
Truth truth_from_bytes(std::string_view bytes);

}  // namespace feline
