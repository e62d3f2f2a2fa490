// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/subjects.h"

#include <type_traits>

#include "model/unit.h"

namespace feline::stability {
namespace {

template <typename T>
reference::Gradients<T> in_texels(const Case& of) {
  const T width = T(texture_of(of).width());
  const T height = T(texture_of(of).height());
  const Lookup& at = of.lookup;
  return {{T(at.dsdx) * width, T(at.dtdx) * height}, {T(at.dsdy) * width, T(at.dtdy) * height}};
}

template <typename T>
Outcome evaluate_formulas(bool printed, const Case& of) {
  const TestTexture& texture = texture_of(of);
  const reference::Gradients<T> gradients = in_texels<T>(of);
  const reference::Axes<T> axes = printed ? reference::printed_axes(reference::ellipse_coefficients(gradients, T(0)))
                                          : reference::ellipse_axes(gradients);
  const Line<T> line = plan_line(axes, texture.last_level());
  Outcome outcome;
  outcome.major = axes.major_radius;
  outcome.minor = axes.minor_radius;
  outcome.axis_u = axes.major.u;
  outcome.axis_v = axes.major.v;
  outcome.raw_level = line.level;
  outcome.level = clamped_level(line.level, texture.last_level());
  outcome.probes = line.probes;
  outcome.colour = line_colour(texture.texture(), line, T(of.lookup.s), T(of.lookup.t));
  return outcome;
}

// The level that plan clamps, from the parts of which plan is made.
double raw_level(const FootprintBeat<kDefaultConfig>& footprint, Mode mode,
                 const SamplerState<kDefaultConfig>& sampler) {
  const ClampedRadii radii = clamp_radii<kDefaultConfig>(footprint, mode, sampler.length_factor.raw());
  const ProbeChoice choice = choose_probes<kDefaultConfig>(radii, mode, sampler);
  const std::int64_t fitted = fit_minor_radius<kDefaultConfig>(radii, mode, choice, sampler);
  return level_of_radius<kDefaultConfig>(fitted, footprint.exponent.raw()).value();
}

Outcome evaluate_unit(Mode mode, const Case& of) {
  const TestTexture& texture = texture_of(of);
  const SamplerState<kDefaultConfig>& sampler = mode == Mode::kSimple ? texture.simple() : texture.table();
  Outcome outcome;
  const auto observe = [&]<typename Beat>(const Beat& beat) {
    if constexpr (std::is_same_v<Beat, FootprintBeat<kDefaultConfig>>) {
      const int exponent = static_cast<int>(beat.exponent.raw());
      outcome.major = std::ldexp(beat.major_radius.value(), exponent);
      outcome.minor = std::ldexp(beat.minor_radius.value(), exponent);
      outcome.axis_u = beat.major_u.value();
      outcome.axis_v = beat.major_v.value();
      outcome.raw_level = raw_level(beat, mode, sampler);
    } else if constexpr (std::is_same_v<Beat, PlanBeat<kDefaultConfig>>) {
      outcome.level = beat.level_of_detail.value();
      outcome.probes = static_cast<int>(beat.probes.raw());
    }
  };
  const auto pixel =
      sample<kDefaultConfig>(make_request<kDefaultConfig>(of.lookup, 0), sampler, texture.memory(), observe);
  outcome.colour = pixel.colour[0].value();
  outcome.status = pixel.status.raw();
  return outcome;
}

void finish(Truth& truth, const Case& of) {
  const TestTexture& texture = texture_of(of);
  truth.level = clamped_level(truth.line.level, texture.last_level());
  truth.colour = line_colour(texture.texture(), truth.line, Real(of.lookup.s), Real(of.lookup.t));
}

}  // namespace

Outcome evaluate(Subject subject, const Case& of) {
  switch (subject) {
    case Subject::kPrintedFloat32: return evaluate_formulas<float>(true, of);
    case Subject::kPrintedDouble: return evaluate_formulas<double>(true, of);
    case Subject::kStableFloat32: return evaluate_formulas<float>(false, of);
    case Subject::kStableDouble: return evaluate_formulas<double>(false, of);
    case Subject::kUnitSimple: return evaluate_unit(Mode::kSimple, of);
    case Subject::kUnitTable: return evaluate_unit(Mode::kTable, of);
  }
  return {};
}

Truth exact(const Case& of) {
  Truth truth;
  truth.ellipse = exact_ellipse(in_texels<Real>(of));
  const auto& [major, minor, angle, has_axis] = truth.ellipse;
  truth.axes = {{major * cos(angle), major * sin(angle)}, major, minor};
  truth.line = plan_line(truth.axes, texture_of(of).last_level());
  finish(truth, of);
  return truth;
}

Truth with_probes(const Truth& truth, const Case& of, int probes) {
  Truth other = truth;
  other.line = plan_line(truth.axes, texture_of(of).last_level(), probes);
  finish(other, of);
  return other;
}

Branches branches(const Case& of) {
  const SamplerState<kDefaultConfig>& sampler = texture_of(of).table();
  const auto grouped = group<kDefaultConfig>(make_request<kDefaultConfig>(of.lookup, 0), sampler);
  Branches all;
  all.mantissas = {grouped.dudx.raw(), grouped.dvdx.raw(), grouped.dudy.raw(), grouped.dvdy.raw()};
  all.exponent = grouped.exponent.raw();
  const Gradients gradients = gradients_of<kDefaultConfig>(grouped);
  const TableCell cell = table_cell<kDefaultConfig>(gradients);
  all.x_is_longer = gradients.longer_is_x;
  all.row = cell.row;
  all.column = cell.column;
  return all;
}

}  // namespace feline::stability
