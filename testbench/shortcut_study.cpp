// SPDX-License-Identifier: Apache-2.0
#include "testbench/shortcut_study.h"

#include <algorithm>
#include <optional>
#include <type_traits>

#include "model/lookup.h"
#include "tables/pack.h"
#include "testbench/median.h"
#include "testbench/progress.h"
#include "testbench/thread_time.h"

namespace feline {
namespace {

struct Made {
  std::vector<AccumulateBeat<kDefaultConfig>> pixels;
  std::vector<PlanBeat<kDefaultConfig>> plans;
};

// Nanoseconds for all lookups; `sample` makes a pixel and hands its plan to a trace.
template <typename Sample>
double render(const GBuffer& gbuffer, Made& made, Sample sample) {
  const std::int64_t start = thread_nanoseconds();
  for (std::size_t i = 0; i < gbuffer.lookups.size(); ++i) {
    const auto keep = [&]<typename Beat>(const Beat& beat) {
      if constexpr (std::is_same_v<Beat, PlanBeat<kDefaultConfig>>) made.plans[i] = beat;
    };
    made.pixels[i] = sample(make_request<kDefaultConfig>(gbuffer.lookups[i], static_cast<std::int64_t>(i)), keep);
  }
  return static_cast<double>(thread_nanoseconds() - start);
}

bool same_bits(const Made& left, const Made& right) {
  for (std::size_t i = 0; i < left.pixels.size(); ++i) {
    if (!same(left.pixels[i], right.pixels[i]) || !same(left.plans[i], right.plans[i])) return false;
  }
  return true;
}

}  // namespace

bool ShortcutStudy::same() const {
  return straight.same && all.same && std::ranges::all_of(single, [](const Row& row) { return row.same; });
}

ShortcutStudy study_shortcuts(const GBuffer& gbuffer, const SamplerState<kDefaultConfig>& sampler,
                              const TextureMemory& memory, int runs) {
  struct Variant {
    ShortcutStudy::Row* row;
    std::optional<Shortcuts> shortcuts;  // none: stage by stage
    std::vector<double> times{};
  };
  ShortcutStudy study;
  study.plain.name = "plain";
  study.straight.name = "straight";
  study.all.name = "all";
  study.single.resize(kShortcutNames.size());
  std::vector<Variant> variants{{&study.plain, {}}, {&study.straight, kNoShortcuts}};
  for (std::size_t i = 0; i < kShortcutNames.size(); ++i) {
    study.single[i].name = kShortcutNames[i].name;
    Shortcuts alone = kNoShortcuts;
    alone.*kShortcutNames[i].is_on = true;
    variants.push_back({&study.single[i], alone});
  }
  variants.push_back({&study.all, Shortcuts{}});

  const std::size_t pixels = gbuffer.lookups.size();
  Made plain{std::vector<AccumulateBeat<kDefaultConfig>>(pixels), std::vector<PlanBeat<kDefaultConfig>>(pixels)};
  Made made = plain;
  Progress progress("timing", static_cast<std::uint64_t>(runs) * variants.size());
  for (int run = 0; run < runs; ++run) {
    for (Variant& variant : variants) {
      if (!variant.shortcuts) {
        variant.times.push_back(render(gbuffer, plain, [&](const auto& request, const auto& keep) {
          return sample<kDefaultConfig>(request, sampler, memory, keep);
        }));
      } else {
        ShortcutUnit<kDefaultConfig, const TextureMemory> unit(sampler, memory, *variant.shortcuts);
        variant.times.push_back(
            render(gbuffer, made, [&](const auto& request, const auto& keep) { return unit.sample(request, keep); }));
        variant.row->counts = unit.counts();
        variant.row->same = variant.row->same && same_bits(plain, made);
      }
      progress.advance(1);
    }
  }
  const auto median_ratio = [](std::vector<double> over, const std::vector<double>& under) {
    for (std::size_t i = 0; i < over.size(); ++i) over[i] /= under[i];
    return median(std::move(over));
  };
  for (const Variant& variant : variants) {
    variant.row->nanoseconds = median(variant.times) / static_cast<double>(pixels);
    variant.row->of_plain = median_ratio(variants[0].times, variant.times);
    variant.row->of_straight = median_ratio(variants[1].times, variant.times);
  }
  return study;
}

}  // namespace feline
