// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "testbench/area/area.h"
#include "testbench/measure/cache.h"

namespace feline {

// Debian's package qflow-tech-osu018: OSU's cells for TSMC's 180 nm.
inline constexpr const char* kCellLibrary = "/usr/share/qflow/tech/osu018/osu018_stdcells.lib";

// The text of every module in a directory of RTL. Throws InputError naming `--source` when there are none.
std::string modules_text(const std::filesystem::path& rtl);

// The unit's whole text, package first. Throws InputError when a file of it is missing.
std::string unit_source(const std::filesystem::path& rtl, const std::filesystem::path& generated);

// Yosys and a library of cells; results are kept in a cache, if there is one.
class Synthesis {
 public:
  // Throws InputError, which says what to install, when there is no Yosys or no such library with a NAND2X1.
  Synthesis(std::filesystem::path library, const Cache* cache);

  // The stage, or "spill", alone: whatever is on its ports may be anything, and every output is needed.
  StageArea stage(const std::string& source, const std::string& name) const;

  // All stages of the unit as it is used, without the pins that watch its stages: constants and what nobody needs go
  // away across stages. The number of cells of a unit is this one's total.
  std::vector<StageArea> unit(const std::string& source) const;

  AreaReport report(std::vector<StageArea> stages) const;

 private:
  std::vector<StageArea> run(const std::string& source, const std::string& commands) const;

  std::filesystem::path library_;
  const Cache* cache_;
  std::string version_;
  std::string library_text_;
};

}  // namespace feline
