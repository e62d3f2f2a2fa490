// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/explanation.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/unit.h"
#include "tables/emit.h"

namespace feline {
namespace {

constexpr double kDegrees = 57.29577951308232;

// The ellipse of the two gradients, in double precision: Feline 2.1 and 3.1; probes without the limit, level with it,
// biased and clamped as the modes' are.
PlannedEllipse ideal_ellipse(const Lookup& lookup, const Texture& texture, const SamplerOptions& options) {
  const double width = texture.levels.front().width;
  const double height = texture.levels.front().height;
  const double dudx = lookup.dsdx * width;
  const double dvdx = lookup.dtdx * height;
  const double dudy = lookup.dsdy * width;
  const double dvdy = lookup.dtdy * height;
  // Singular values of the Jacobian; the larger comes first, the smaller from the determinant, which does not cancel.
  const double e = (dudx * dudx + dudy * dudy + dvdx * dvdx + dvdy * dvdy) / 2;
  const double f = (dudx * dudx + dudy * dudy - dvdx * dvdx - dvdy * dvdy) / 2;
  const double g = dudx * dvdx + dudy * dvdy;
  PlannedEllipse ideal;
  ideal.name = "ideal";
  ideal.major = std::sqrt(e + std::hypot(f, g));
  ideal.minor = ideal.major == 0 ? 0 : std::abs(dudx * dvdy - dvdx * dudy) / ideal.major;
  ideal.degrees = std::atan2(g, f) / 2 * kDegrees;
  const double major = std::max(ideal.major, 1.0);
  const double minor = std::max(ideal.minor, 1.0);
  ideal.probes = std::floor(2 * major / minor - 1 + 0.5);
  const double base = std::log2(std::max(minor, 2 * major / (options.max_probes + 1)));
  const double last = static_cast<double>(texture.levels.size()) - 1;
  ideal.level = std::min(std::clamp(base + options.level_bias, options.min_level, options.max_level), last);
  return ideal;
}

PlannedEllipse mode_ellipse(Mode mode, const Lookup& lookup, const Subject& texture, SamplerOptions options) {
  options.mode = mode;
  const auto sampler = prepare_sampler(options, texture.texture, texture.memory);
  const auto shaped =
      footprint<kDefaultConfig>(group<kDefaultConfig>(make_request<kDefaultConfig>(lookup, 0), sampler), sampler);
  const auto planned = plan<kDefaultConfig>(shaped, sampler);
  const double unit = std::ldexp(1.0, static_cast<int>(shaped.exponent.raw()));
  PlannedEllipse ellipse;
  ellipse.name = kModeNames[static_cast<std::size_t>(mode)];
  ellipse.major = shaped.major_radius.value() * unit;
  ellipse.minor = shaped.minor_radius.value() * unit;
  ellipse.degrees = std::atan2(shaped.major_v.value(), shaped.major_u.value()) * kDegrees;
  ellipse.probes = planned.probes.value();
  ellipse.level = planned.level_of_detail.value();
  return ellipse;
}

// How far `got` is off, in percent of `want`, or a dash where that says nothing.
std::string percent(double got, double want) {
  const double off = 100 * (got / want - 1);
  return std::isfinite(off) && std::isfinite(want) ? fmt::format("{:.2f}%", off) : "-";
}

std::string texels(double radius) {
  if (!std::isfinite(radius)) return "no bound";
  return radius < 1e7 ? fmt::format("{:.3f}", radius) : fmt::format("{:.4e}", radius);
}

// A dash where a number says nothing.
std::string or_dash(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

struct Operand {
  const char* name;
  float Lookup::*member;
};
constexpr std::array<Operand, 6> kOperands{{{"s", &Lookup::s},
                                            {"t", &Lookup::t},
                                            {"dsdx", &Lookup::dsdx},
                                            {"dtdx", &Lookup::dtdx},
                                            {"dsdy", &Lookup::dsdy},
                                            {"dtdy", &Lookup::dtdy}}};

}  // namespace

Explanation explain(const Lookup& lookup, const Subject& texture, const SamplerOptions& options) {
  Explanation explanation;
  explanation.lookup = lookup;
  const auto sampler = prepare_sampler(options, texture.texture, texture.memory);
  sample<kDefaultConfig>(make_request<kDefaultConfig>(lookup, 0), sampler, texture.memory,
                         [&]<typename Beat>(const Beat& beat) {
                           if constexpr (!std::is_same_v<Beat, RequestBeat<kDefaultConfig>>) {
                             explanation.beats.push_back({std::string(Beat::kName.view()), field_values(beat)});
                           }
                         });
  explanation.ideal = ideal_ellipse(lookup, texture.texture, options);
  for (const Mode mode : {Mode::kTrilinear, Mode::kExt, Mode::kSimple, Mode::kTable}) {
    explanation.modes.push_back(mode_ellipse(mode, lookup, texture, options));
  }
  return explanation;
}

std::string to_text(const Explanation& explanation) {
  std::string out = "request\n";
  for (const auto& [name, member] : kOperands) {
    const float value = explanation.lookup.*member;
    out += fmt::format("  {:<24}0x{:08x}      {:<22}float32\n", name, std::bit_cast<std::uint32_t>(value),
                       fmt::format("{:.9g}", value));
  }
  for (const auto& [stage, fields] : explanation.beats) {
    out += stage + "\n";
    for (const FieldValue& field : fields) {
      out += fmt::format("  {:<24}{:<16}{:<22}{}, {}\n", field.name, hex_text(field),
                         fmt::format("{:.12g}", field.format.value(field.raw)), notation(field.format),
                         field.format.unit.view());
    }
  }
  const PlannedEllipse& ideal = explanation.ideal;
  out += fmt::format("\n{:<10} {:>14} {:>9} {:>14} {:>9} {:>10} {:>8} {:>8}\n", "footprint", "major, texels", "error",
                     "minor, texels", "error", "degrees", "probes", "level");
  out += fmt::format("{:<10} {:>14} {:>9} {:>14} {:>9} {:>10} {:>8} {:>8}\n", ideal.name, texels(ideal.major), "",
                     texels(ideal.minor), "", or_dash(ideal.degrees, 2), or_dash(ideal.probes, 0),
                     or_dash(ideal.level, 3));
  for (const PlannedEllipse& mode : explanation.modes) {
    out += fmt::format("{:<10} {:>14} {:>9} {:>14} {:>9} {:>10} {:>8} {:>8}\n", mode.name, texels(mode.major),
                       percent(mode.major, ideal.major), texels(mode.minor), percent(mode.minor, ideal.minor),
                       or_dash(mode.degrees, 2), or_dash(mode.probes, 0), or_dash(mode.level, 3));
  }
  return out;
}

nlohmann::ordered_json to_json(const Explanation& explanation) {
  nlohmann::ordered_json json;
  for (const auto& [name, member] : kOperands) {
    const float value = explanation.lookup.*member;
    json["request"][name] = {{"hex", fmt::format("0x{:08x}", std::bit_cast<std::uint32_t>(value))}, {"value", value}};
  }
  for (const auto& [stage, fields] : explanation.beats) {
    nlohmann::ordered_json beat{{"stage", stage}};
    for (const FieldValue& field : fields) {
      beat["fields"][field.name] = {{"hex", hex_text(field)},
                                    {"value", field.format.value(field.raw)},
                                    {"format", notation(field.format)},
                                    {"unit", field.format.unit.view()}};
    }
    json["beats"].push_back(std::move(beat));
  }
  const auto ellipse = [](const PlannedEllipse& of) {
    return nlohmann::ordered_json{{"name", of.name},       {"major", of.major},   {"minor", of.minor},
                                  {"degrees", of.degrees}, {"probes", of.probes}, {"level", of.level}};
  };
  json["footprints"].push_back(ellipse(explanation.ideal));
  for (const PlannedEllipse& mode : explanation.modes) json["footprints"].push_back(ellipse(mode));
  return json;
}

}  // namespace feline
