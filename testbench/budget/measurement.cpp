// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "testbench/json_input.h"
#include "testbench/measure/render_rows.h"
#include "testbench/measure/truth_store.h"
#include "testbench/thread_time.h"

namespace feline {
namespace {

// What pieces of work take, for the progress bar.
constexpr std::uint64_t kTruthShare = 1000;
constexpr std::uint64_t kVariantsShare = 4000;

struct UseField {
  std::string_view name;
  int VariantUse::*field;
};
constexpr std::array kUseNumbers{UseField{"least_exponent", &VariantUse::least_exponent},
                                 UseField{"greatest_exponent", &VariantUse::greatest_exponent},
                                 UseField{"position_bits", &VariantUse::position_bits},
                                 UseField{"wanted_probes", &VariantUse::wanted_probes},
                                 UseField{"coarsest_level", &VariantUse::coarsest_level},
                                 UseField{"derivatives", &VariantUse::derivatives}};
struct UseFlag {
  std::string_view name;
  bool VariantUse::*field;
};
constexpr std::array kUseFlags{UseFlag{"blends", &VariantUse::blends}, UseFlag{"linear", &VariantUse::linear},
                               UseFlag{"nearest", &VariantUse::nearest},
                               UseFlag{"translucent", &VariantUse::translucent}};

// Of one frame more of a sequence.
void pool(Errors& pooled, const Errors& errors, double share) {
  const double mean = pooled.mean_square + share * errors.mean_square;
  if (errors.worst > pooled.worst) pooled = errors;
  pooled.mean_square = mean;
}

}  // namespace

BudgetScene::BudgetScene(const ExhibitPlan& plan, const BudgetSurveyOptions& options, const Cache& cache)
    : plan_(plan), options_(options), cache_(cache) {}

nlohmann::ordered_json BudgetScene::to_json(const Raw& raw) {
  nlohmann::ordered_json use{{"probes", raw.use.probes}};
  for (const UseField& each : kUseNumbers) use[std::string(each.name)] = raw.use.*each.field;
  for (const UseFlag& each : kUseFlags) use[std::string(each.name)] = raw.use.*each.field;
  return {{"gaussian", feline::to_json(raw.gaussian)},
          {"box", feline::to_json(raw.box)},
          {"nanoseconds", raw.nanoseconds},
          {"use", use}};
}

BudgetScene::Raw BudgetScene::raw_from_json(const nlohmann::ordered_json& json) {
  Raw raw{errors_from_json(json.at("gaussian")), errors_from_json(json.at("box")), json.at("nanoseconds"), {}};
  const nlohmann::ordered_json& use = json.at("use");
  raw.use.probes = whole_from_json<std::uint64_t>(use.at("probes"));
  for (const UseField& each : kUseNumbers) raw.use.*each.field = whole_from_json<int>(use.at(std::string(each.name)));
  for (const UseFlag& each : kUseFlags) raw.use.*each.field = use.at(std::string(each.name));
  return raw;
}

std::string BudgetScene::key(const std::string& what) const {
  // As a report's, whose truths serve here.
  return cache_.key({what, plan_.identity, std::to_string(options_.strata), std::to_string(options_.seed)});
}

void BudgetScene::prepare(Progress* progress) {
  if (!exhibit_) exhibit_ = plan_.build();
  for (std::size_t i = truths_.size(); i < exhibit_->frames.size(); ++i) {
    const std::string name = key(fmt::format("truth {}", i));
    if (const auto stored = cache_.read(name)) {
      truths_.push_back(truth_from_bytes(*stored));
      continue;
    }
    truths_.push_back(compute_truth(exhibit_->frames[i], options_.strata, options_.seed + i, progress));
    cache_.write(name, to_bytes(truths_.back()));
  }
}

SamplerState<kDefaultConfig> BudgetScene::sampler_of(const Candidate& candidate) const {
  SamplerOptions options = sampler_options(candidate);
  const Surface& surface = *exhibit_->surface;
  const reference::Wrapping& wrapping = surface.images.lanczos.wrapping;
  options.wrap_s = wrapping.s;
  options.wrap_t = wrapping.t;
  for (std::size_t c = 0; c < 4; ++c) options.border[c] = double{wrapping.border[c]};
  return make_sampler<kDefaultConfig>(options, surface.texture, surface.memory);
}

BudgetScene::Raw BudgetScene::render(const Candidate& candidate, int runs) const {
  const Variant& variant = variant_of(candidate.widths);
  const SamplerState<kDefaultConfig> sampler = sampler_of(candidate);
  const double share = 1 / static_cast<double>(exhibit_->frames.size());
  Raw raw;
  // Tables that are made on first use are no pixel's time.
  if (VariantUse ignored; runs > 1) {
    const Lookup lookup;
    std::array<float, 4> colour{};
    variant.sample(sampler, exhibit_->surface->memory, {&lookup, 1}, {&colour, 1}, ignored);
  }
  std::vector<double> times;
  for (int run = 0; run < runs; ++run) {
    raw = Raw{};
    double time = 0;
    for (std::size_t i = 0; i < exhibit_->frames.size(); ++i) {
      const GBuffer& gbuffer = exhibit_->frames[i].gbuffer;
      FloatPicture picture{gbuffer.width, gbuffer.height, {}};
      picture.pixels.resize(gbuffer.lookups.size());
      const std::int64_t start = thread_nanoseconds();
      variant.sample(sampler, exhibit_->surface->memory, gbuffer.lookups, picture.pixels, raw.use);
      time += static_cast<double>(thread_nanoseconds() - start) / static_cast<double>(gbuffer.lookups.size());
      pool(raw.gaussian, compare(picture, truths_[i].gaussian, exhibit_->channels()), share);
      pool(raw.box, compare(picture, truths_[i].box, exhibit_->channels()), share);
    }
    times.push_back(share * time);
  }
  std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
  raw.nanoseconds = times[times.size() / 2];
  return raw;
}

Measurement BudgetScene::finish(const Candidate& candidate, const Raw& raw) const {
  const double pixels = double{static_cast<double>(plan_.width)} * plan_.height * plan_.frame_count;
  return {candidate,       raw.gaussian,
          raw.box,         static_cast<double>(raw.use.probes) / pixels,
          raw.nanoseconds, hardware_of(candidate, sampler_of(candidate), raw.use)};
}

Measurement BudgetScene::measure(const Candidate& candidate) {
  prepare(nullptr);
  return finish(candidate, render(candidate, options_.runs));
}

std::vector<Measurement> BudgetScene::measure_all(Progress& progress) {
  {
    Progress part(progress, kTruthShare,
                  static_cast<std::uint64_t>(plan_.width) * static_cast<std::uint64_t>(plan_.height) *
                      static_cast<std::uint64_t>(plan_.frame_count));
    prepare(&part);
  }
  const std::vector<Candidate> space = candidates_of(options_.space);
  // Indices into the space, by variant.
  std::map<const Variant*, std::vector<std::size_t>> by_variant;
  for (std::size_t i = 0; i < space.size(); ++i) by_variant[&variant_of(space[i].widths)].push_back(i);
  std::vector<std::vector<std::size_t>> batches;
  for (auto& [variant, indices] : by_variant) batches.push_back(std::move(indices));
  Progress part(progress, kVariantsShare, space.size());
  std::vector<Measurement> measurements(space.size());
  for_each_index(0, static_cast<std::int64_t>(batches.size()), [&](std::int64_t number) {
    const std::vector<std::size_t>& batch = batches[static_cast<std::size_t>(number)];
    std::string what = fmt::format("budget {}", options_.runs);
    for (const std::size_t i : batch) {
      what += fmt::format("; {}; {}", sampler_name(space[i]), widths_name(space[i]));
    }
    const std::string name = key(what);
    nlohmann::ordered_json results;
    if (const auto stored = cache_.read(name)) {
      results = nlohmann::ordered_json::parse(*stored);
      part.advance(batch.size());
    } else {
      for (const std::size_t i : batch) {
        results.push_back(to_json(render(space[i], options_.runs)));
        part.advance(1);
      }
      cache_.write(name, results.dump());
    }
    for (std::size_t k = 0; k < batch.size(); ++k) {
      measurements[batch[k]] = finish(space[batch[k]], raw_from_json(results.at(k)));
    }
  });
  return measurements;
}

}  // namespace feline
