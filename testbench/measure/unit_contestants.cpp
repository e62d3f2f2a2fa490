// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/unit_contestants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

#include "model/unit.h"
#include "testbench/cosim/cosimulation.h"
#include "testbench/measure/render_rows.h"

namespace feline {
namespace {

SamplerState<kDefaultConfig> sampler_of(SamplerOptions options, const View& view) {
  const reference::Wrapping& wrapping = view.surface->images.lanczos.wrapping;
  options.wrap_s = wrapping.s;
  options.wrap_t = wrapping.t;
  for (std::size_t c = 0; c < 4; ++c) options.border[c] = double{wrapping.border[c]};
  return make_sampler<kDefaultConfig>(options, view.surface->texture, view.surface->memory);
}

Rendering render_unit(const SamplerOptions& options, const View& view, Progress* progress) {
  using F = Formats<kDefaultConfig>;
  const auto sampler = sampler_of(options, view);
  return render_rows(view, progress, [&](std::size_t i, reference::Cost& cost) {
    const auto pixel = sample<kDefaultConfig>(
        make_request<kDefaultConfig>(view.gbuffer.lookups[i], 0), sampler, view.surface->memory,
        [&]<typename Beat>(const Beat& beat) {
          if constexpr (std::is_same_v<Beat, FetchBeat<kDefaultConfig>>) {
            cost.add(1, (beat.linear.raw() == 0 ? 1 : 4) * (beat.level_fraction.raw() == 0 ? 1 : 2), 1);
          }
        });
    reference::Colour colour{};
    for (std::size_t c = 0; c < 4; ++c) colour[c] = F::kPixel.value(pixel.colour[c].raw()) / 255;
    return colour;
  });
}

Contestant unit_contestant(const std::string& suffix, const std::string& description, const SamplerOptions& options) {
  Contestant contestant{"unit_" + suffix, Contestant::Kind::kUnit, description, "this project", options, {}};
  contestant.render = [options](const View& view, Progress* progress) { return render_unit(options, view, progress); };
  return contestant;
}

}  // namespace

std::vector<Contestant> unit_contestants() {
  std::vector<Contestant> all;
  for (const Mode mode : {Mode::kNearest, Mode::kBilinear, Mode::kTrilinear, Mode::kExt}) {
    SamplerOptions options;
    options.mode = mode;
    options.magnify = mode == Mode::kNearest ? Magnify::kNearest : Magnify::kLinear;
    const auto name = kModeNames[static_cast<std::size_t>(mode)];
    all.push_back(unit_contestant(std::string(name), fmt::format("the 8-bit unit, mode {}", name), options));
  }
  struct Set {
    std::string_view name;
    const ProbeParameters* parameters;
  };
  constexpr std::array<Set, 3> kSets{
      {{"", &kExact}, {"_high_quality", &kHighQuality}, {"_high_efficiency", &kHighEfficiency}}};
  for (const Mode mode : {Mode::kSimple, Mode::kTable}) {
    for (const auto& [set_name, parameters] : kSets) {
      for (const Kernel kernel : {Kernel::kBilinear, Kernel::kGaussian}) {
        SamplerOptions options;
        options.mode = mode;
        options.kernel = kernel;
        options.probes = *parameters;
        const auto name = kModeNames[static_cast<std::size_t>(mode)];
        all.push_back(
            unit_contestant(fmt::format("{}{}{}", name, set_name, kernel == Kernel::kGaussian ? "_gaussian" : ""),
                            fmt::format("the 8-bit unit, {} Feline", name), options));
      }
    }
  }
  return all;
}

double measure_rtl_cycles(const View& view, const SamplerOptions& options) {
  constexpr int kRows = 4;
  constexpr int kOneIn = 16;
  const auto sampler = sampler_of(options, view);
  const auto width = static_cast<std::ptrdiff_t>(view.gbuffer.width);
  const int stripes = (view.gbuffer.height + kRows * kOneIn - 1) / (kRows * kOneIn);
  std::atomic<std::uint64_t> cycles = 0;
  std::atomic<std::size_t> pixels = 0;
  std::atomic<bool> agree = true;
  OIIO::parallel_for(0, stripes, [&](std::int64_t stripe) {
    const std::int64_t first = stripe * kRows * kOneIn;
    const std::int64_t rows = std::min<std::int64_t>(kRows, view.gbuffer.height - first);
    const std::span<const Lookup> lookups(view.gbuffer.lookups.begin() + first * width,
                                          static_cast<std::size_t>(rows * width));
    Cosimulation cosimulation(make_fast_unit, Timing{});
    if (!cosimulation.run(Batch{sampler, &view.surface->memory, lookups, 0})) agree = false;
    cycles += cosimulation.cycles();
    pixels += lookups.size();
  });
  if (!agree) {
    throw std::runtime_error(fmt::format("{0}: RTL and model differ; feline cosim --scene {0} says where", view.name));
  }
  return static_cast<double>(cycles) / static_cast<double>(pixels);
}

}  // namespace feline
