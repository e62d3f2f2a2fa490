// SPDX-License-Identifier: Apache-2.0
#include "testbench/report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "testbench/page/html.h"
#include "testbench/report/standing.h"
#include "testbench/report/tables.h"

namespace feline {
namespace {

// Whose pictures are shown where more are measured than these.
constexpr std::array<std::string_view, 16> kPrincipal{"nearest",
                                                      "trilinear",
                                                      "ext",
                                                      "rip_pixel",
                                                      "vertex_max_staggered",
                                                      "texram",
                                                      "feline_ideal",
                                                      "feline_simple",
                                                      "feline_simple_high_quality",
                                                      "feline_simple_high_quality_gaussian",
                                                      "feline_simple_high_efficiency",
                                                      "feline_table",
                                                      "unit_table",
                                                      "unit_table_gaussian",
                                                      "ewa",
                                                      "openimageio"};

std::string introduction(const Survey& survey) {
  std::string html = page::paragraph(
      "What does each filter cost, and how wrong is it? Every filter of the papers in double precision, the "
      "bit-accurate 8-bit unit in its modes, and OpenImageIO, on the same lookups.");
  html += page::bullets(std::array<std::string, 6>{
      "Truth: the bilinear surface through level 0, sampled where each point of the pixel filter really projects. The "
      "Gaussian exp(-2 r^2) ends at a radius of one pixel; the box is one pixel wide. Errors are given against both, "
      "because the order of the filters turns with the truth.",
      "Errors: PSNR in decibels below full, root mean square (RMSE) and worst channel, in linear light, without the "
      "outermost pixels; where no truth is named, the Gaussian. Butteraugli: libjxl's perceptual distance from the "
      "Gaussian truth (3-norm, 80 cd/m^2), of which about 1 can just be seen, in the quarter of the picture where "
      "trilinear filtering fails most. Shimmer: RMS change of the error from one frame of a sequence to the next.",
      "Nanoseconds: processor time of one thread, in double precision and without vector instructions; EWA computes "
      "its exponentials, of which a table of 128 would make it faster; interpolating the axes of vertex-based filters "
      "is the rasteriser's and not counted. The unit's are those of its C++ model, and say nothing of hardware.",
      "Cycles and texels: of hardware that reads eight texels a cycle, a probe each (Feline, section 4), before any "
      "cache. EWA's are those of its realistic stamp; report.json has the optimistic count, too.",
      "RTL cycles: measured on the Verilated unit with its small blocking cache behind 20 cycles of latency, on one in "
      "16 rows, every beat compared with the model.",
      "Green figures lie on a Pareto front: nothing is both cheaper and nearer to one of the truths."});
  if (survey.missing != 0) {
    html += page::paragraph(fmt::format(
        "Not complete: {} pieces of work were not begun within the budget. The same command goes on with them.",
        survey.missing));
  }
  return html;
}

page::Tone tone_of(Verdict verdict) {
  return verdict == Verdict::kHolds          ? page::Tone::kGood
         : verdict == Verdict::kContradicted ? page::Tone::kBad
                                             : page::Tone::kPlain;
}

std::string claims_section(const std::vector<Claim>& claims) {
  std::string html = page::heading(2, "What the papers say, measured");
  page::Table table;
  table.columns = {{"claim"}, {"verdict"}, {"source"}};
  for (const Claim& claim : claims) {
    table.rows.push_back({{claim.name}, {verdict_text(claim), tone_of(claim.verdict)}, {claim.source}});
  }
  html += page::table(table);
  for (const Claim& claim : claims) {
    if (claim.measured.empty()) continue;
    std::string details = page::paragraph(claim.statement);
    details += page::bullets(claim.measured);
    if (claim.verdict == Verdict::kContradicted && !claim.reason.empty()) details += page::paragraph(claim.reason);
    html += page::fold(claim.name, details);
  }
  html += page::paragraph("Contradicted elsewhere, where no scene is needed (tests/model/reference):");
  html += page::bullets(std::array<std::string, 4>{
      "WRL 99/1, 2.3: Texram's line is shorter than the ellipse by nearly a factor of four. The limit is 2 sqrt(2) = "
      "2.83: the major radius is at most sqrt(|x|^2 + |y|^2) (texram_test).",
      "Olano 2001, table 2, Max: taken for each coordinate, as printed, gradients (a, 0), (0, b) collapse to (a, b), "
      "(0, 0). Here the longer and the shorter gradient are meant (vertex_based_test).",
      "Olano 2001, section 3: the square pattern is best. With exact axes at each pixel the staggered one is, and the "
      "line is better than the square; their judgement is of interpolated axes in motion (quality_test).",
      "WRL 99/1, figures 33 and 34: Simple takes two to four probes, Table up to 16. It depends on the scene: feline "
      "figure feline_33_34 shows two (figure_test)."});
  return html;
}

std::string unit_section(const Survey& survey) {
  page::Table table;
  table.caption =
      "RMSE x 1000 from each picture to the next, and the worst pixel of the unit against the Gaussian truth";
  table.columns = {{"scene"},
                   {"probes"},
                   {"truth to Feline, exact ellipse", true},
                   {"to the 16 x 16 table", true},
                   {"to 8 bits", true},
                   {"unit less double, dB", true},
                   {"worst pixel", true},
                   {"at"}};
  for (const ExhibitResult& result : survey.results) {
    for (const Split& split : result.splits) {
      const std::string suffix = split.kernel == "gaussian" ? "_gaussian" : "";
      const Cell* const unit = find_cell(result, "unit_table" + suffix);
      const Cell* const real = find_cell(result, "feline_table" + suffix);
      const auto rmse = [](double mean_square) {
        return page::Cell{fmt::format("{:.2f}", 1000 * std::sqrt(mean_square))};
      };
      std::vector<page::Cell> row{
          {result.plan.name}, {split.kernel}, rmse(split.feline), rmse(split.table), rmse(split.arithmetic)};
      if (unit != nullptr && real != nullptr) {
        const double apart = psnr_ahead(unit->gaussian, real->gaussian);
        const UnitVerdict verdict = judge_unit(result.plan, *real, *unit);
        row.push_back({fmt::format("{:+.3f}", apart), verdict == UnitVerdict::kHolds    ? page::Tone::kGood
                                                      : verdict == UnitVerdict::kBroken ? page::Tone::kBad
                                                                                        : page::Tone::kPlain});
        row.push_back({fmt::format("{:.3f}", unit->gaussian.errors.worst)});
        row.push_back({worst_pixel(result.plan, unit->gaussian)});
      } else {
        row.insert(row.end(), 3, page::Cell{});
      }
      table.rows.push_back(std::move(row));
    }
  }
  if (table.rows.empty()) return {};
  return page::heading(2, "Where the unit's error comes from") + page::table(table);
}

std::string picture_of(const Cell& cell) {
  std::string html = page::png(cell.detail_png, cell.contestant, true) +
                     page::png(cell.difference_png, cell.contestant + ", difference from the truth", true);
  if (!cell.probes_png.empty()) html += page::png(cell.probes_png, cell.contestant + ", probes a pixel", true);
  return page::figure(html, fmt::format("{}: {} dB", cell.contestant, decibels(cell.gaussian.errors.psnr())));
}

std::string pictures(const ExhibitResult& result) {
  std::vector<std::string> shown;
  const TruthFacts& truth = *result.truth;
  shown.push_back(page::figure(page::png(truth.gaussian_png, "Gaussian truth", true), "Gaussian truth"));
  shown.push_back(page::figure(page::png(truth.box_png, "box truth", true), "box truth"));
  const bool few = result.cells.size() <= kPrincipal.size();
  for (const Cell& cell : result.cells) {
    if (few || std::ranges::find(kPrincipal, cell.contestant) != kPrincipal.end()) shown.push_back(picture_of(cell));
  }
  std::string html = page::paragraph(fmt::format(
      "Where trilinear filtering fails most: {0} x {0} pixels at ({1}, {2}). Beneath each picture its difference from "
      "the Gaussian truth, four times amplified around grey, and its probes a pixel: 1 white, 2 light blue, 4 dark "
      "blue, 8 green, 16 red.{3}",
      truth.focus.detail.size, truth.focus.detail.left, truth.focus.detail.top,
      few ? "" : " Other filters: feline report --filter NAME,..."));
  return html + page::thumbnails(shown);
}

std::string exhibit_section(const ExhibitResult& result) {
  std::string html = page::heading(2, result.plan.name);
  html += page::paragraph(
      fmt::format("{}; {} x {} pixels{}.", result.plan.description, result.plan.width, result.plan.height,
                  result.plan.frame_count > 1 ? fmt::format(", {} frames", result.plan.frame_count) : std::string()));
  if (!result.truth) return html + page::paragraph("Not measured within the budget.");
  std::string truth = fmt::format(
      "Truth: {} samples a pixel, pi times as many for the Gaussian, projected {}; its own standard error is {:.2g} "
      "(Gaussian) and {:.2g} (box) of full",
      result.truth->samples, result.plan.perspective ? "exactly" : "affinely, as a G-buffer knows no more",
      result.truth->gaussian_error, result.truth->box_error);
  if (result.truth->gaussian_error > 0 && result.truth->box_error > 0) {
    truth += fmt::format(", so that a PSNR above {:.0f} and {:.0f} dB says nothing",
                         -20 * std::log10(result.truth->gaussian_error), -20 * std::log10(result.truth->box_error));
  }
  html += page::paragraph(truth + ".");
  html += page::gallery(standing_plots(result.plan.name, result.cells));
  html += page::table(standing_table(result.cells));
  html += page::fold("The whole picture",
                     page::figure(page::png(result.truth->overview_png, result.plan.name, false), "Gaussian truth"));
  return html + pictures(result);
}

}  // namespace

std::string report_page(const Survey& survey, const std::vector<Claim>& claims) {
  std::string html = introduction(survey);
  if (survey.results.size() > 1) {
    const std::vector<Cell> pooled = pool_exhibits(survey);
    if (!pooled.empty()) {
      html += page::heading(2, "All scenes together");
      html += page::gallery(standing_plots("all", pooled)) + page::table(standing_table(pooled));
    }
  }
  html += claims_section(claims) + unit_section(survey);
  for (const ExhibitResult& result : survey.results) html += exhibit_section(result);
  return page::document("Feline: error against run time", html);
}

}  // namespace feline
