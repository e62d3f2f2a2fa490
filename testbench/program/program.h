// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace feline {

// `feline` with these arguments: the exit code (README). Throws only where there is no memory to say so.
int run_program(int argc, char** argv);

}  // namespace feline
