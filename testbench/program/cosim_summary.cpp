// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/cosim_summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace feline {
namespace {

nlohmann::ordered_json run_json(const CosimJob& job, const CosimResult& result) {
  nlohmann::ordered_json beats;
  for (std::size_t stage = 0; stage < kStageCount; ++stage)
    beats[std::string(kStageNames[stage])] = result.beats[stage];
  return {{"scene", job.scene},       {"mode", job.mode},        {"kernel", job.kernel},
          {"wrap", job.wrap},         {"seed", job.timing.seed}, {"lookups", result.lookups},
          {"probes", result.probes},  {"beats", beats},          {"mismatches", result.mismatches},
          {"cycles", result.cycles},  {"resets", result.resets}, {"memory_reads", result.memory_reads},
          {"seconds", result.seconds}};
}

std::string joined(const CosimSummary& summary, std::string CosimJob::*field) {
  std::vector<std::string> seen;
  for (const auto& [job, result] : summary.runs) {
    if (std::ranges::find(seen, job->*field) == seen.end()) seen.push_back(job->*field);
  }
  return fmt::format("{}", fmt::join(seen, ","));
}

void add(CosimResult& sum, const CosimResult& result) {
  sum.lookups += result.lookups;
  sum.probes += result.probes;
  sum.mismatches += result.mismatches;
  sum.cycles += result.cycles;
  sum.resets += result.resets;
  sum.memory_reads += result.memory_reads;
  for (std::size_t stage = 0; stage < kStageCount; ++stage) sum.beats[stage] += result.beats[stage];
}

CosimResult total(const CosimSummary& summary) {
  CosimResult sum;
  for (const auto& [job, result] : summary.runs) add(sum, *result);
  sum.seconds = summary.seconds;
  return sum;
}

std::string row(const CosimJob& job, const CosimResult& result) {
  const double lookups = static_cast<double>(std::max<std::uint64_t>(result.lookups, 1));
  const double probes = static_cast<double>(std::max<std::uint64_t>(result.probes, 1));
  return fmt::format("{:<14} {:<10} {:<9} {:<16}{:>10}{:>12}{:>8.2f}{:>12}{:>8.2f}{:>12}\n", job.scene, job.mode,
                     job.kernel, job.wrap, result.lookups, result.probes, static_cast<double>(result.probes) / lookups,
                     result.cycles, static_cast<double>(result.cycles) / probes, result.mismatches);
}

bool same_row(const CosimJob& one, const CosimJob& other) {
  return one.scene == other.scene && one.mode == other.mode && one.kernel == other.kernel && one.wrap == other.wrap;
}

}  // namespace

bool CosimSummary::holds() const {
  return std::ranges::all_of(runs, [](const Run& run) { return run.result->mismatches == 0; });
}

std::string to_text(const CosimSummary& summary) {
  std::string out = fmt::format("{:<14} {:<10} {:<9} {:<16}{:>10}{:>12}{:>8}{:>12}{:>8}{:>12}\n", "scene", "mode",
                                "kernel", "wrap", "lookups", "probes", "a pixel", "cycles", "a probe", "mismatches");
  for (std::size_t i = 0; i < summary.runs.size();) {
    const CosimJob& job = *summary.runs[i].job;
    CosimResult together;
    for (; i < summary.runs.size() && same_row(*summary.runs[i].job, job); ++i) add(together, *summary.runs[i].result);
    out += row(job, together);
  }
  const CosimResult sum = total(summary);
  std::uint64_t beats = 0;
  for (const auto count : sum.beats) beats += count;
  out +=
      fmt::format("{}: {} beats of {} stages compared, {} mismatches, {} lookups, {} cycles,{} {:.1f} s, seed {}\n",
                  summary.holds() ? "RTL and model agree" : "RTL AND MODEL DIFFER", beats, kStageCount, sum.mismatches,
                  sum.lookups, sum.cycles, sum.resets == 0 ? "" : fmt::format(" {} resets,", sum.resets),
                  summary.seconds, summary.runs.front().job->timing.seed);
  return out;
}

nlohmann::ordered_json to_json(const CosimSummary& summary) {
  CosimJob all = *summary.runs.front().job;
  all.scene = joined(summary, &CosimJob::scene);
  all.mode = joined(summary, &CosimJob::mode);
  all.kernel = joined(summary, &CosimJob::kernel);
  all.wrap = joined(summary, &CosimJob::wrap);
  auto json = run_json(all, total(summary));
  for (const auto& [job, result] : summary.runs) json["runs"].push_back(run_json(*job, *result));
  return json;
}

}  // namespace feline
