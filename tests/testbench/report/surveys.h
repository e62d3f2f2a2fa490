// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "testbench/measure/detail.h"
#include "testbench/measure/survey.h"
#include "testbench/page/html.h"

// Surveys that nobody measured.
namespace feline {

inline double mean_square_of(double psnr) { return std::pow(10, -psnr / 10); }

// A contestant with errors in decibels; against the box truth, unless said, as against the Gaussian.
inline Cell cell_of(std::string contestant, double gaussian, double probes = 1) {
  Cell cell;
  cell.exhibit = "made up";
  cell.contestant = std::move(contestant);
  cell.gaussian.errors = {mean_square_of(gaussian), 0.5, 3, 2};
  cell.box.errors = cell.gaussian.errors;
  cell.nanoseconds = 100 * probes;
  cell.cost = {probes, 8 * probes, probes, probes};
  const FloatPicture picture{2, 1, {{0, 0, 0, 1}, {1, 1, 1, 1}}};
  cell.detail_png = cell.difference_png = cell.probes_png = page::base64(picture_png(picture, false, 3));
  return cell;
}

inline ExhibitResult result_of(std::string name, std::vector<Cell> cells) {
  ExhibitResult result;
  result.plan.name = std::move(name);
  result.plan.description = "made up";
  result.plan.width = result.plan.height = 256;  // in name; the pictures are smaller
  TruthFacts facts;
  facts.gaussian_error = facts.box_error = 1e-4;
  facts.samples = 2;
  facts.focus = {{0, 0, 2}, {0, 0, 1}};
  facts.overview_png = facts.gaussian_png = facts.box_png = cells.empty() ? "" : cells.front().detail_png;
  result.truth = facts;
  result.cells = std::move(cells);
  return result;
}

inline Survey survey_of(std::vector<ExhibitResult> results) { return {std::move(results), 0}; }

}  // namespace feline
