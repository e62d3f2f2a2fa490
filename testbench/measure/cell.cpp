// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "testbench/json_input.h"
#include "testbench/measure/detail.h"
#include "testbench/measure/perception.h"
#include "testbench/page/html.h"

namespace feline {
namespace {

CellErrors pool(const std::vector<Rendering>& renderings, const std::vector<Truth>& truths,
                const FloatPicture Truth::*truth, const Exhibit& exhibit, const Detail& close) {
  CellErrors pooled;
  const auto frames = static_cast<double>(renderings.size());
  const int channels = exhibit.channels();
  for (std::size_t i = 0; i < renderings.size(); ++i) {
    const Errors errors = compare(renderings[i].picture, truths[i].*truth, channels);
    const double mean = pooled.errors.mean_square + errors.mean_square / frames;
    if (i == 0 || errors.worst > pooled.errors.worst) {
      pooled.errors = errors;
      pooled.worst_frame = static_cast<int>(i);
    }
    pooled.errors.mean_square = mean;
    pooled.butteraugli += perceptual_distance(crop(renderings[i].picture, close), crop(truths[i].*truth, close),
                                              exhibit.srgb(), channels) /
                          frames;
    if (i == 0) continue;
    pooled.shimmer =
        pooled.shimmer.value_or(0) + temporal_mean_square(renderings[i - 1].picture, truths[i - 1].*truth,
                                                          renderings[i].picture, truths[i].*truth, channels) /
                                         (frames - 1);
  }
  return pooled;
}

void add_pixel_means(Cell& cell, const std::vector<Rendering>& renderings) {
  double pixels = 0;
  for (const Rendering& rendering : renderings) {
    cell.nanoseconds += rendering.nanoseconds / static_cast<double>(renderings.size());
    cell.cost += rendering.cost;
    pixels += static_cast<double>(rendering.picture.pixels.size());
  }
  cell.cost = 1 / pixels * cell.cost;
}

// The probes' kernel changes no cycle, so that one measurement serves both.
double rtl_cycles_of(const Exhibit& exhibit, const SamplerOptions& options) {
  const std::string key =
      fmt::format("{} {} {}", static_cast<int>(options.mode), options.probes.blur_factor, options.probes.alias_factor);
  const auto known = exhibit.rtl_cycles.find(key);
  if (known != exhibit.rtl_cycles.end()) return known->second;
  return exhibit.rtl_cycles[key] = measure_rtl_cycles(exhibit.frames.front(), options);
}

nlohmann::ordered_json to_json(const CellErrors& errors) {
  nlohmann::ordered_json json = to_json(errors.errors);
  json["worst_frame"] = errors.worst_frame;
  json["butteraugli"] = errors.butteraugli;
  if (errors.shimmer) json["shimmer"] = *errors.shimmer;
  return json;
}

CellErrors cell_errors_from_json(const nlohmann::ordered_json& json) {
  CellErrors errors{errors_from_json(json), whole_from_json<int>(json.at("worst_frame")), std::nullopt,
                    json.at("butteraugli")};
  if (json.contains("shimmer")) errors.shimmer = json.at("shimmer").get<double>();
  return errors;
}

}  // namespace

Cell measure_cell(const Contestant& contestant, const Exhibit& exhibit, const std::vector<Truth>& truths,
                  const Focus& focus) {
  std::vector<Rendering> renderings;
  for (const View& view : exhibit.frames) renderings.push_back(contestant.render(view, nullptr));
  Cell cell;
  cell.exhibit = exhibit.frames.front().name;
  cell.contestant = contestant.name;
  cell.gaussian = pool(renderings, truths, &Truth::gaussian, exhibit, focus.quarter);
  cell.box = pool(renderings, truths, &Truth::box, exhibit, focus.quarter);
  add_pixel_means(cell, renderings);
  if (contestant.sampler) {
    cell.rtl_cycles = rtl_cycles_of(exhibit, *contestant.sampler);
  }
  const FloatPicture& picture = renderings.front().picture;
  const FloatPicture& truth = truths.front().gaussian;
  cell.detail_png = page::base64(detail_png(picture, focus.detail, exhibit.srgb(), exhibit.channels()));
  cell.difference_png = page::base64(detail_png(difference(picture, truth, kDifferenceGain), focus.detail, false, 3));
  if (std::ranges::any_of(renderings.front().probes, [](float probes) { return probes > 1; })) {
    cell.probes_png = page::base64(probes_png(renderings.front().probes, picture.width, focus.detail));
  }
  return cell;
}

nlohmann::ordered_json to_json(const Cell& cell) {
  nlohmann::ordered_json json{
      {"exhibit", cell.exhibit},    {"contestant", cell.contestant},   {"gaussian", to_json(cell.gaussian)},
      {"box", to_json(cell.box)},   {"nanoseconds", cell.nanoseconds}, {"probes", cell.cost.probes},
      {"texels", cell.cost.texels}, {"cycles", cell.cost.cycles},      {"stamp_cycles", cell.cost.stamp_cycles}};
  if (cell.rtl_cycles) json["rtl_cycles"] = *cell.rtl_cycles;
  json["detail_png"] = cell.detail_png;
  json["difference_png"] = cell.difference_png;
  json["probes_png"] = cell.probes_png;
  return json;
}

Cell cell_from_json(const nlohmann::ordered_json& json) {
  Cell cell;
  cell.exhibit = json.at("exhibit");
  cell.contestant = json.at("contestant");
  cell.gaussian = cell_errors_from_json(json.at("gaussian"));
  cell.box = cell_errors_from_json(json.at("box"));
  cell.nanoseconds = json.at("nanoseconds");
  cell.cost = {json.at("probes"), json.at("texels"), json.at("cycles"), json.at("stamp_cycles")};
  if (json.contains("rtl_cycles")) cell.rtl_cycles = json.at("rtl_cycles").get<double>();
  cell.detail_png = json.at("detail_png");
  cell.difference_png = json.at("difference_png");
  cell.probes_png = json.at("probes_png");
  return cell;
}

}  // namespace feline
