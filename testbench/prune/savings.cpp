// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/savings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "testbench/csv_field.h"
#include "testbench/prune/prune.h"

namespace feline {
namespace {

constexpr int kBitsPerByte = 8;

double per_pixel(std::uint64_t count, const Savings& savings) {
  return static_cast<double>(count) / static_cast<double>(savings.check.lookups);
}

// "simple_feline, repeat, ...", of the modes, wrap modes and whatever else can be left out.
std::vector<std::string_view> features_left(const Config& config) {
  std::vector<std::string_view> names;
  for (const FeatureField& each : kFeatureFields) {
    if (config.features.*each.field) names.push_back(each.name);
  }
  return names;
}

std::string what_is_left(const Config& config) {
  std::string text;
  for (const PartSize& part : part_sizes(config)) text += fmt::format("{} {}, ", part.have, part.what);
  return text + fmt::format("{} features", features_left(config).size());
}

double change_percent(double from, double to) { return 100 * (to - from) / from; }

}  // namespace

nlohmann::ordered_json savings_json(const std::vector<Savings>& all) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Savings& each : all) {
    json.push_back({{"scene", each.scene},
                    {"width", each.width},
                    {"height", each.height},
                    {"frames", each.frames},
                    {"left_out", left_out(each.config)},
                    {"configuration", config_to_json(each.config)},
                    {"check", to_json(each.check)},
                    {"holds", each.holds()},
                    {"gaussian", to_json(each.gaussian)},
                    {"box", to_json(each.box)},
                    {"full", to_json(each.full)},
                    {"pruned", to_json(each.pruned)}});
  }
  return json;
}

std::string savings_csv(const std::vector<Savings>& all) {
  std::string csv = "scene,width,height,frames,pixels,identical";
  for (const PartSize& part : part_sizes(kDefaultConfig)) csv += fmt::format(",{}", csv_field(std::string(part.what)));
  csv += ",features";
  for (const char* const unit : {"full", "pruned"}) {
    for (const char* const what : {"cells", "gates", "flip_flops", "rom_bits", "memory_bits", "multipliers"}) {
      csv += fmt::format(",{}_{}", unit, what);
    }
  }
  csv += ",probes,cycles,psnr_gaussian,psnr_box\n";
  for (const Savings& each : all) {
    csv += fmt::format("{},{},{},{},{},{}", csv_field(each.scene), each.width, each.height, each.frames,
                       each.check.lookups, each.check.identical);
    for (const PartSize& part : part_sizes(each.config)) csv += fmt::format(",{}", part.have);
    csv += fmt::format(",{}", csv_field(fmt::format("{}", fmt::join(features_left(each.config), " "))));
    for (const StageArea& area : {each.full, each.pruned}) {
      csv += fmt::format(",{},{},{},{},{},{}", area.cells, csv_field(area.gates), area.flip_flops, area.rom_bits,
                         area.memory_bits, area.multiplier_count());
    }
    csv += fmt::format(",{},{},{},{}\n", csv_field(per_pixel(each.check.probes, each)),
                       csv_field(per_pixel(each.check.cycles, each)), csv_field(each.gaussian.psnr()),
                       csv_field(each.box.psnr()));
  }
  return csv;
}

std::string savings_markdown(const std::vector<Savings>& all) {
  std::string text =
      "| scene | what is left | cells | NAND2 | ROM bytes | multipliers | cycles | Gaussian | box | identical pixels "
      "|\n"
      "|---|---|---|---|---|---|---|---|---|---|\n";
  if (!all.empty()) {
    const StageArea& full = all.front().full;
    text += fmt::format("| the full unit | {} | {} | {:.0f} | {} | {} |  |  |  |  |\n", what_is_left(kDefaultConfig),
                        full.cells, full.gates, full.rom_bits / kBitsPerByte, full.multiplier_count());
  }
  for (const Savings& each : all) {
    text += fmt::format(
        "| {} | {} | {} ({:+.0f} %) | {:.0f} ({:+.0f} %) | {} | {} | {:.1f} | {:.1f} dB | {:.1f} dB | {} of {} |\n",
        each.scene, what_is_left(each.config), each.pruned.cells,
        change_percent(static_cast<double>(each.full.cells), static_cast<double>(each.pruned.cells)), each.pruned.gates,
        change_percent(each.full.gates, each.pruned.gates), each.pruned.rom_bits / kBitsPerByte,
        each.pruned.multiplier_count(), per_pixel(each.check.cycles, each), each.gaussian.psnr(), each.box.psnr(),
        each.check.identical, each.check.lookups);
  }
  return text;
}

}  // namespace feline
