// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/program.h"

// NOLINTNEXTLINE(bugprone-exception-escape): only where there is no memory to say so
int main(int argc, char** argv) { return feline::run_program(argc, argv); }
