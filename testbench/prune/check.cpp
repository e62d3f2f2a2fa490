// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/check.h"

#include <fmt/format.h>

#include <mutex>

#include "model/unit.h"
#include "testbench/cosim/job.h"
#include "testbench/json_input.h"
#include "testbench/parallel.h"
#include "testbench/prune/prune.h"

namespace feline {
namespace {

constexpr Config kFull = kDefaultConfig;

constexpr std::array kCounts{
    std::pair{"lookups", &PrunedCheck::lookups},     std::pair{"refused", &PrunedCheck::refused},
    std::pair{"flagged", &PrunedCheck::flagged},     std::pair{"outside", &PrunedCheck::outside},
    std::pair{"identical", &PrunedCheck::identical}, std::pair{"silent", &PrunedCheck::silent},
    std::pair{"misjudged", &PrunedCheck::misjudged}, std::pair{"mismatches", &PrunedCheck::mismatches},
    std::pair{"probes", &PrunedCheck::probes},       std::pair{"cycles", &PrunedCheck::cycles}};

std::string describe(const std::string& source, std::uint64_t lookup, int width, std::string_view what,
                     const AccumulateBeat<kUnit>& got, const AccumulateBeat<kFull>& want) {
  std::string text = fmt::format("{}: pixel {}, {}: {}\n", source, lookup % static_cast<std::uint64_t>(width),
                                 lookup / static_cast<std::uint64_t>(width), what);
  for (std::size_t c = 0; c < 4; ++c) {
    text +=
        fmt::format("  {} {:#06x}, of the full unit {:#06x}\n", "rgba"[c], got.colour[c].raw(), want.colour[c].raw());
  }
  return text + fmt::format("  status {:#x}, of the full unit {:#x}\n", got.status.raw(), want.status.raw());
}

bool equal(const AccumulateBeat<kUnit>& got, const AccumulateBeat<kFull>& want) {
  if (got.status.raw() != want.status.raw()) return false;
  for (std::size_t c = 0; c < 4; ++c) {
    if (got.colour[c].raw() != want.colour[c].raw()) return false;
  }
  return true;
}

CosimResult run_unit(const std::string& source, const GBuffer& gbuffer, const SamplerState<kUnit>& sampler,
                     const TextureMemory& memory, Progress* progress) {
  CosimJob job;
  job.scene = source;
  job.mode = kModeNames[static_cast<std::size_t>(sampler.mode.raw())];
  job.kernel = kKernelNames[static_cast<std::size_t>(sampler.kernel.raw())];
  job.wrap = kWrapNames[static_cast<std::size_t>(sampler.wrap_s.raw())];
  job.command = "feline_pruned, the same";
  job.width = gbuffer.width;
  job.lookups = job.batch_lookups = gbuffer.lookups.size();
  job.batch = [&](std::uint64_t) { return Batch{sampler, &memory, gbuffer.lookups, 0}; };
  return run_job(job, make_fast_unit, {}, std::nullopt, true, progress);
}

}  // namespace

void add(PrunedCheck& into, const PrunedCheck& from) {
  for (const auto& [name, count] : kCounts) into.*count += from.*count;
  if (into.message.empty()) into.message = from.message;
}

nlohmann::ordered_json to_json(const PrunedCheck& check) {
  nlohmann::ordered_json json;
  for (const auto& [name, count] : kCounts) json[name] = check.*count;
  json["message"] = check.message;
  return json;
}

PrunedCheck check_from_json(const nlohmann::ordered_json& json) {
  PrunedCheck check;
  for (const auto& [name, count] : kCounts) check.*count = whole_from_json<std::uint64_t>(json.at(name));
  json.at("message").get_to(check.message);
  return check;
}

PrunedCheck check_pruned(const std::string& source, const GBuffer& gbuffer, const SamplerOptions& options,
                         const Texture& texture, const TextureMemory& memory, Progress* progress) {
  PrunedCheck check;
  check.lookups = gbuffer.lookups.size();
  const SamplerState<kFull> full = make_sampler<kFull>(options, texture, memory);
  SamplerState<kUnit> own;
  try {
    own = make_sampler<kUnit>(options, texture, memory);
  } catch (const SamplerError& error) {
    check.refused = check.lookups;
    for (const Lookup& lookup : gbuffer.lookups) {
      ++(is_within(needed_config(lookup, full, memory), kUnit) ? check.misjudged : check.outside);
    }
    if (check.misjudged != 0) check.message = fmt::format("{}: refused, and needs no more: {}\n", source, error.what());
    return check;
  }
  CosimResult result = run_unit(source, gbuffer, own, memory, progress);
  check.mismatches = result.mismatches;
  check.message = result.message;
  check.probes = result.probes;
  check.cycles = result.cycles;
  if (result.mismatches != 0) return check;

  std::mutex mutex;
  constexpr std::size_t kPart = 4096;
  const auto parts = static_cast<std::int64_t>((check.lookups + kPart - 1) / kPart);
  for_each_index(0, parts, [&](std::int64_t index) {
    const std::size_t first = static_cast<std::size_t>(index) * kPart;
    PrunedCheck part;
    for (std::size_t i = first; i < std::min(first + kPart, gbuffer.lookups.size()); ++i) {
      const auto& got = result.pixels[i];
      const auto want =
          sample<kFull>(make_request<kFull>(gbuffer.lookups[i], static_cast<std::int64_t>(i)), full, memory);
      const bool inside = is_within(needed_config(gbuffer.lookups[i], full, memory), kUnit);
      const bool flagged = (got.status.raw() & kUnsupported) != 0;
      const bool same = equal(got, want);
      part.outside += inside ? 0 : 1;
      part.flagged += flagged ? 1 : 0;
      part.identical += !flagged && same ? 1 : 0;
      part.silent += !flagged && !same ? 1 : 0;
      part.misjudged += flagged == inside ? 1 : 0;
      if (part.message.empty() && ((!flagged && !same) || flagged == inside)) {
        part.message = describe(source, i, gbuffer.width,
                                !same && !flagged ? "wrong, and not flagged"
                                : flagged         ? "flagged, though the unit has all that it needs"
                                                  : "not flagged, though the unit lacks what it needs",
                                got, want);
      }
    }
    const std::scoped_lock lock(mutex);
    add(check, part);
  });
  return check;
}

}  // namespace feline
