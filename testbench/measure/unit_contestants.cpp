// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/unit_contestants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "model/unit.h"
#include "testbench/cosim/cosimulation.h"
#include "testbench/error.h"
#include "testbench/measure/render_rows.h"
#include "testbench/parallel.h"

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
  constexpr int kOneIn = 16;
  const auto sampler = sampler_of(options, view);
  const auto width = static_cast<std::size_t>(view.gbuffer.width);
  const int rows = (view.gbuffer.height + kOneIn - 1) / kOneIn;
  std::atomic<std::uint64_t> cycles = 0;
  std::atomic<bool> agree = true;
  for_each_index(0, rows, [&](std::int64_t number) {
    // The row before, if there is one, fills the cache.
    const int row = static_cast<int>(std::min<std::int64_t>(number * kOneIn + kOneIn / 2, view.gbuffer.height - 1));
    const std::size_t warming = row > 0 ? width : 0;
    const std::span<const Lookup> lookups =
        std::span(view.gbuffer.lookups).subspan(static_cast<std::size_t>(row) * width - warming, warming + width);
    Cosimulation cosimulation(make_fast_unit, Timing{});
    std::uint64_t begun = 0;
    const auto sink = [&](std::uint64_t lookup, const AccumulateBeat<kUnit>&) {
      if (lookup + 1 == warming) begun = cosimulation.cycles();
    };
    if (!cosimulation.run(Batch{sampler, &view.surface->memory, lookups, 0}, sink)) agree = false;
    cycles += cosimulation.cycles() - begun;
  });
  if (!agree) throw WitnessMismatch(fmt::format("{}: RTL and model differ; feline cosim says where", view.name));
  return static_cast<double>(cycles) / (static_cast<double>(rows) * static_cast<double>(width));
}

}  // namespace feline
