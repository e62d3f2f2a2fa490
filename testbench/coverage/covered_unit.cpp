// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/covered_unit.h"

#include <Vfeline_covered.h>
#include <verilated_cov.h>

#include "testbench/cosim/verilated_unit.h"

namespace feline {
namespace {

class Covered : public VerilatedUnit<Vfeline_covered> {
 public:
  explicit Covered(std::uint64_t seed) : VerilatedUnit(seed) { context().coveragep()->forcePerInstance(true); }
  void forget() { context().coveragep()->zero(); }
  void write(const std::filesystem::path& to) { context().coveragep()->write(to.c_str()); }
};

}  // namespace

CoveredUnit make_covered_unit(std::uint64_t seed) {
  auto unit = std::make_unique<Covered>(seed);
  Covered* const covered = unit.get();
  return {std::move(unit), [covered] { covered->forget(); },
          [covered](const std::filesystem::path& to) { covered->write(to); }};
}

}  // namespace feline
