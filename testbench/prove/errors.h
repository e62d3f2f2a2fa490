// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/prove/leaf.h"

// How far a leaf's outputs are from real arithmetic on its own inputs: what 8 bits and tables cost, apart from what the
// inputs have lost before. Measured in double; the worst are found again at 200 bits by the tests.
namespace feline::prove {

// Of the exact ellipse of the four mantissas (Feline 2.1): both radii, in parts of the exact major radius; the level of
// detail, with both minor radii widened as 16 probes would; the major axis' angle where the ellipse is at least twice
// as long as wide.
std::vector<Quantity> ellipse_quantities();
void measure_ellipse(const std::uint64_t* inputs, const std::uint64_t* outputs, std::size_t count, double* errors);

std::vector<Quantity> level_quantities();
void measure_level(const std::uint64_t* inputs, const std::uint64_t* outputs, std::size_t count, double* errors);

// Of the row's own weights before they are rounded.
std::vector<Quantity> weight_quantities();
void measure_weight(const std::uint64_t* inputs, const std::uint64_t* outputs, std::size_t count, double* errors);

std::vector<Quantity> kernel_quantities();
void measure_kernel(const std::uint64_t* inputs, const std::uint64_t* outputs, std::size_t count, double* errors);

std::vector<Quantity> colour_quantities();
void measure_colour(const std::uint64_t* inputs, const std::uint64_t* outputs, std::size_t count, double* errors);

}  // namespace feline::prove
