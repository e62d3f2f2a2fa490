// SPDX-License-Identifier: Apache-2.0
// What tests/coverage.sh reads: Verilator's points, llvm-cov's text, bins, exclusions, the ratchet.
#include "testbench/coverage/bin_grid.h"
#include "testbench/coverage/exclusions.h"
#include "testbench/coverage/model_points.h"
#include "testbench/coverage/ratchet.h"
#include "testbench/coverage/rtl_points.h"
#include "tests/fuzz/fuzz.h"

namespace feline {
namespace {

using namespace coverage;

void check(const std::filesystem::path& file, std::size_t which) {
  SourceText sources(fuzz::directory());
  switch (which) {
    case 0: ratchet_of(read_rtl_points(file, sources)); break;
    case 1: ratchet_of(read_model_points(file, sources)); break;
    case 2: bin_points(read_bin_grids(file)); break;
    case 3: {
      std::vector<Point> points{{Kind::kRtlToggle, "u_group.status[2]", "rtl/feline_group.sv", 1, 0}};
      exclude(points, read_exclusions(file));
      break;
    }
    default: {
      const Ratchet ratchet = read_ratchet(file);
      fuzz::file_with("again", to_json(ratchet).dump());
      fuzz::require(read_ratchet(fuzz::directory() / "again") == ratchet, "to_json: the same again");
    }
  }
}

}  // namespace
}  // namespace feline

void feline::fuzz::run(Input input) {
  constexpr std::size_t kKindsOfFile = 5;
  const std::size_t which = input.choose(kKindsOfFile);
  const auto path = file_with("input", input.rest());
  file_with("source.h", "int a = 1;\nif (a) b;\n");
  accepts([&] { check(path, which); });
}
