// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "testbench/measure/exhibit.h"

namespace feline {

// The command line's exhibits: built-in scenes, or a G-buffer and a texture of the user's own.
struct ExhibitOptions {
  std::string scenes;
  std::string size;
  std::string gbuffer{};
  std::string texture{};
  bool srgb = false;
  std::string wrap = "repeat";

  // What was set before is the default.
  void add_to(CLI::App& command);
  // Throws InputError for whatever is wrong, unreadable files included.
  std::vector<ExhibitPlan> plans() const;

 private:
  ExhibitPlan own() const;
};

}  // namespace feline
