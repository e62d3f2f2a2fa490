// SPDX-License-Identifier: Apache-2.0
#include "testbench/report/report.h"

#include <fmt/format.h>

namespace feline {

Report make_report(const Survey& survey) {
  Report report;
  for (const ExhibitResult& result : survey.results) {
    report.text +=
        fmt::format("{} {}x{} truth {} samples, error {:.2g} {:.2g}\n", result.plan.name, result.plan.width,
                    result.plan.height, result.truth ? result.truth->samples : 0,
                    result.truth ? result.truth->gaussian_error : 0, result.truth ? result.truth->box_error : 0);
    for (const Cell& cell : result.cells) {
      report.text += fmt::format(
          "  {:<42}{:7.2f}{:7.2f}  {:6.3f} {:7.0f} ns {:6.2f} probes {:7.1f} texels {:7.2f} cycles {:7.2f} rtl "
          "{:.4f}\n",
          cell.contestant, cell.gaussian.errors.psnr(), cell.box.errors.psnr(), cell.visible, cell.nanoseconds,
          cell.cost.probes, cell.cost.texels, cell.cost.cycles, cell.rtl_cycles.value_or(0),
          cell.gaussian.shimmer.value_or(0));
    }
    for (const Split& split : result.splits) {
      report.text += fmt::format("  split {:<10} feline {:.2e} table {:.2e} arithmetic {:.2e}\n", split.kernel,
                                 split.feline, split.table, split.arithmetic);
    }
  }
  return report;
}

}  // namespace feline
