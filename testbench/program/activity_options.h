// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/area/activity.h"
#include "testbench/program/frames.h"

namespace feline {

// The command line of what counts toggles: which frames, and the time that the memory takes.
struct ActivityOptions {
  FrameOptions frames;
  Timing timing;

  void add_to(CLI::App& command);
  // Of the unit of this build, on all frames. Throws InputError when it cannot sample them.
  Activity measure() const;
};

}  // namespace feline
