// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "testbench/atomic_file.h"
#include "testbench/error.h"

namespace feline {
namespace {

// The part of a batch that lies in the range; may be empty.
Batch cut(Batch batch, const ReplayRange& range) {
  // After the last one the unit must be empty.
  const std::uint64_t end = batch.first_lookup + batch.lookups.size();
  const std::uint64_t first = std::clamp(range.first, batch.first_lookup, end);
  const std::uint64_t last = std::clamp(range.last + 1, first, end);
  batch.lookups = batch.lookups.subspan(first - batch.first_lookup, last - first);
  batch.first_lookup = first;
  batch.same_texture_follows = batch.same_texture_follows && range.last >= end;
  return batch;
}

struct Pass {
  std::unique_ptr<Cosimulation> simulation;
  bool holds = true;
};

Pass run_range(const CosimJob& job, const RtlFactory& factory, const ReplayRange& range,
               const std::optional<WaveWindow>& wave, const PixelSink& sink, Progress* progress) {
  Pass pass{std::make_unique<Cosimulation>(factory, job.timing), true};
  if (wave) pass.simulation->set_wave(*wave);
  const PixelSink counted = [&](std::uint64_t lookup, const AccumulateBeat<kUnit>& pixel) {
    if (sink) sink(lookup, pixel);
    progress->advance(1);
  };
  for (std::uint64_t b = range.first / job.batch_lookups; b <= range.last / job.batch_lookups && pass.holds; ++b) {
    pass.holds = pass.simulation->run(cut(job.batch(b), range), progress == nullptr ? sink : counted);
  }
  return pass;
}

// The smallest range that shows the mismatch again: the lookup alone, else its batch so far, else everything so far.
ReplayRange smallest_range(const CosimJob& job, const RtlFactory& factory, const ReplayRange& run,
                           const Mismatch& mismatch) {
  const std::uint64_t batch_first = mismatch.lookup / job.batch_lookups * job.batch_lookups;
  // What makes a wrong beat may have been let in after the lookup whose beat it is.
  constexpr std::uint64_t kInFlight = 64;
  const std::uint64_t until = std::min(mismatch.lookup + kInFlight, run.last);
  for (const ReplayRange range :
       {ReplayRange{mismatch.lookup, mismatch.lookup}, ReplayRange{std::max(batch_first, run.first), until},
        ReplayRange{run.first, until}}) {
    const Pass pass = run_range(job, factory, range, std::nullopt, {}, nullptr);
    if (!pass.holds && pass.simulation->mismatch()->stage == mismatch.stage) return range;
  }
  return run;
}

// The waveform around the mismatch, by running the range again; says where it is, or why it is not.
std::string write_wave(const CosimJob& job, const FollowUp& follow_up, const RtlFactory& factory,
                       const ReplayRange& range) {
  constexpr std::uint64_t kBefore = 64;
  constexpr std::uint64_t kAfter = 16;
  const Pass again = run_range(job, factory, range, std::nullopt, {}, nullptr);
  if (again.holds) return "  waveform: none, the mismatch does not show again\n";
  const std::uint64_t cycle = again.simulation->mismatch()->cycle;
  try {
    AtomicFile wave(follow_up.wave);
    const WaveWindow window{wave.temporary(), cycle > kBefore ? cycle - kBefore : 0, cycle + kAfter};
    run_range(job, follow_up.trace, range, window, {}, nullptr);
    wave.commit();
    return fmt::format("  waveform: {}, cycles {} to {}\n", follow_up.wave.string(), window.first_cycle,
                       window.last_cycle);
  } catch (const InputError& error) {
    return fmt::format("  waveform: not written: {}\n", error.what());
  }
}

std::string follow(const CosimJob& job, const RtlFactory& factory, const FollowUp& follow_up, const ReplayRange& run,
                   const Mismatch& mismatch) {
  std::string message = describe_mismatch(mismatch, job);
  const ReplayRange range = smallest_range(job, factory, run, mismatch);
  if (follow_up.trace) message += write_wave(job, follow_up, factory, range);
  message += range.first == range.last
                 ? fmt::format("  replay: {} --replay {}\n", job.command, range.first)
                 : fmt::format("  replay: {} --replay {}:{}\n", job.command, range.first, range.last);
  return message;
}

}  // namespace

CosimResult run_job(const CosimJob& job, const RtlFactory& factory, const FollowUp& follow_up,
                    const std::optional<ReplayRange>& replay, bool keep_pixels, Progress* progress) {
  const auto start = std::chrono::steady_clock::now();
  CosimResult result;
  const ReplayRange range = replay.value_or(ReplayRange{0, job.lookups - 1});
  PixelSink sink;
  if (keep_pixels) {
    result.pixels.reserve(job.lookups);
    sink = [&](std::uint64_t, const AccumulateBeat<kUnit>& pixel) { result.pixels.push_back(pixel); };
  }
  const Pass pass = run_range(job, factory, range, std::nullopt, sink, progress);
  result.beats = pass.simulation->beats();
  result.lookups = result.beats[static_cast<std::size_t>(Stage::kAccumulate)];
  result.probes = result.beats[static_cast<std::size_t>(Stage::kWalk)];
  result.cycles = pass.simulation->cycles();
  result.resets = pass.simulation->resets();
  result.memory_reads = pass.simulation->memory_reads();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!pass.holds) {
    result.mismatches = 1;
    result.message = follow(job, factory, follow_up, range, *pass.simulation->mismatch());
  }
  return result;
}

}  // namespace feline
