// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <atomic>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "testbench/atomic_file.h"
#include "testbench/cosim/job.h"
#include "testbench/cosim/random_batches.h"
#include "testbench/error.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/cosim_summary.h"
#include "testbench/program/subject.h"
#include "testbench/program/timing_options.h"
#include "testbench/render.h"
#include "testbench/scenes/scene.h"

namespace feline {
namespace {

struct CosimOptions {
  SubjectOptions subject;
  SamplerChoice sampler;
  std::string scenes;
  std::optional<std::uint64_t> random;
  Timing timing;
  std::string replay;
  std::string output;
  std::string wave = "feline-mismatch.fst";
  const CLI::Option* wave_option = nullptr;
  bool no_wave = false;
  bool vary = false;
  bool json = false;
  unsigned jobs = 0;
  std::string command_line;  // without --replay
};

// Everything a job's batches refer to lives as long as the job.
struct PreparedJob {
  CosimJob job;
  std::shared_ptr<const Subject> subject;
  SamplerState<kUnit> sampler;
};

std::optional<ReplayRange> parse_replay(const std::string& text, std::uint64_t lookups) {
  if (text.empty()) return std::nullopt;
  const auto range = parse_range(text, lookups);
  if (!range) bad_input("command line", "--replay", text, fmt::format("a lookup or FIRST:LAST, 0 to {}", lookups - 1));
  return ReplayRange{range->first, range->last};
}

PreparedJob scene_job(const CosimOptions& options, const std::shared_ptr<const Subject>& subject,
                      const SamplerOptions& choice, const std::string& command) {
  PreparedJob prepared;
  prepared.subject = subject;
  prepared.sampler = prepare_sampler(choice, subject->texture, subject->memory);
  CosimJob& job = prepared.job;
  job.scene = subject->name;
  job.mode = kModeNames[static_cast<std::size_t>(choice.mode)];
  job.kernel = kKernelNames[static_cast<std::size_t>(choice.kernel)];
  job.wrap = wrap_name(choice);
  job.timing = options.timing;
  job.command = command;
  job.width = subject->gbuffer.width;
  job.lookups = job.batch_lookups = subject->gbuffer.lookups.size();
  job.batch = [subject, sampler = prepared.sampler](std::uint64_t) {
    return Batch{sampler, &subject->memory, subject->gbuffer.lookups, 0};
  };
  return prepared;
}

// Lookups of a unit that was made anew, its registers in another random state.
constexpr std::uint64_t kPartLookups = 1000000;

// Random lookups: one run of many batches, each under another sampler.
PreparedJob random_job(const CosimOptions& options, std::uint64_t lookups, std::uint64_t seed) {
  constexpr std::uint64_t kBatchLookups = 256;
  PreparedJob prepared;
  CosimJob& job = prepared.job;
  job.scene = "random";
  job.mode = options.sampler.modes_of_random();
  job.kernel = options.sampler.kernels_of_random();
  job.wrap = options.sampler.wraps_of_random();
  job.timing = options.timing;
  job.timing.seed = seed;
  job.command = fmt::format("{} --random {} --seed {}", options.command_line, lookups, seed);
  job.lookups = lookups;
  job.batch_lookups = kBatchLookups;
  const auto batches = std::make_shared<RandomBatches>(seed, kBatchLookups);
  if (options.vary) batches->vary_conditions();
  batches->set_choices(options.sampler.random_choices());
  job.batch = [batches, lookups = job.lookups](std::uint64_t number) { return batches->make(number, lookups); };
  return prepared;
}

std::vector<PreparedJob> random_jobs(const CosimOptions& options) {
  std::vector<PreparedJob> jobs;
  for (std::uint64_t first = 0; first < *options.random; first += kPartLookups) {
    const std::uint64_t part = first / kPartLookups;
    jobs.push_back(random_job(options, std::min(kPartLookups, *options.random - first),
                              part == 0 ? options.timing.seed : derived_seed(options.timing.seed, part)));
  }
  return jobs;
}

std::string run_name(const CosimJob& job) {
  return fmt::format("{}-{}-{}-{}", job.scene, job.mode, job.kernel, job.wrap);
}

Picture to_picture(const PreparedJob& prepared, CosimResult& result) {
  // The pixels are the RTL's own; the plans are the model's, which co-simulation has compared.
  Picture picture = render_model(prepared.subject->gbuffer, prepared.sampler, prepared.subject->memory);
  picture.pixels = std::move(result.pixels);
  return picture;
}

void write_outputs(const CosimOptions& options, const std::vector<PreparedJob>& jobs, std::vector<CosimResult>& results,
                   const CosimSummary& summary) {
  const std::filesystem::path directory = options.output;
  OutputFiles outputs;
  std::string written;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!jobs[i].subject || results[i].mismatches != 0 || !options.replay.empty()) continue;
    const CosimJob& job = jobs[i].job;
    const std::string stem = run_name(job);
    const Picture picture = to_picture(jobs[i], results[i]);
    const std::filesystem::path colours = directory / (stem + ".png");
    const std::filesystem::path probes = directory / (stem + "-probes.png");
    write_picture(outputs, colours, picture);
    write_probe_map(outputs, probes, picture);
    written += colours.string() + "\n" + probes.string() + "\n";
  }
  outputs.write(directory / "summary.txt", to_text(summary));
  outputs.write(directory / "summary.json", to_json(summary).dump(1) + "\n");
  outputs.commit();
  // Standard output is the JSON's alone.
  fmt::print(options.json ? stderr : stdout, "{}{}\n", written, (directory / "summary.json").string());
}

// The scenes of a command line; one without a name is the default scene, or no scene at all.
std::vector<std::string> chosen_scene_names(const std::string& text) {
  if (text.empty()) return {""};
  std::vector<std::string> names;
  for (const Scene* const scene : scene_list(text)) names.emplace_back(scene->name);
  return names;
}

std::vector<PreparedJob> prepare_jobs(const CosimOptions& options) {
  if (options.random) {
    if (!options.scenes.empty()) bad_input("command line", "--scene", options.scenes, "nothing together with --random");
    options.subject.check_random();
    if (!options.replay.empty() && *options.random > kPartLookups) {
      bad_input("command line", "--replay", options.replay,
                fmt::format("with --random up to {}: the command that a mismatch prints", kPartLookups));
    }
    return random_jobs(options);
  }
  if (options.vary) bad_input("command line", "--vary", "no --random", "only with --random");
  std::vector<PreparedJob> jobs;
  for (const std::string& name : chosen_scene_names(options.scenes)) {
    std::map<MipEdge, std::shared_ptr<const Subject>> subjects;
    for (const SamplerOptions& choice : options.sampler.combinations()) {
      auto& subject = subjects[mip_edge(choice)];
      if (!subject) subject = std::make_shared<const Subject>(options.subject.load(name, mip_edge(choice)));
      std::string command = options.command_line;
      if (!name.empty()) command += fmt::format(" --scene {}", name);
      command += fmt::format(" --mode {} --kernel {} --wrap {}", kModeNames[static_cast<std::size_t>(choice.mode)],
                             kKernelNames[static_cast<std::size_t>(choice.kernel)],
                             kWrapNames[static_cast<std::size_t>(choice.wrap_s)]);
      jobs.push_back(scene_job(options, subject, choice, command));
    }
  }
  return jobs;
}

// Runs side by side must not write the same waveform.
std::filesystem::path wave_of(const CosimOptions& options, const CosimJob& job, bool alone) {
  std::filesystem::path wave = options.wave;
  if (alone) return wave;
  const std::string name = options.random ? fmt::format("random-{}", job.timing.seed) : run_name(job);
  return wave.parent_path() / fmt::format("{}-{}{}", wave.stem().string(), name, wave.extension().string());
}

std::vector<CosimResult> run_all(const CosimOptions& options, const std::vector<PreparedJob>& jobs) {
  std::uint64_t lookups = 0;
  const auto replay = parse_replay(options.replay, jobs.front().job.lookups);
  for (const auto& prepared : jobs) lookups += replay ? replay->last - replay->first + 1 : prepared.job.lookups;
  Progress progress("co-simulating", lookups);
  std::vector<CosimResult> results(jobs.size());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      try {
        FollowUp follow_up;
        if (!options.no_wave) follow_up = {make_trace_unit, wave_of(options, jobs[i].job, jobs.size() == 1)};
        // Random lookups make no picture.
        const bool keep_pixels = !options.output.empty() && jobs[i].subject != nullptr;
        results[i] = run_job(jobs[i].job, make_fast_unit, follow_up, replay, keep_pixels, &progress);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        failure = std::current_exception();
      }
    }
  };
  const unsigned wanted = options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < std::min<std::size_t>(wanted, jobs.size()); ++i) threads.emplace_back(work);
  for (auto& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
  return results;
}

int run_cosim(const CosimOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  if (!options.output.empty()) {
    if (!std::filesystem::is_directory(options.output)) {
      bad_input(options.output, "--output", "no directory", "a directory that exists");
    }
    check_writable(std::filesystem::path(options.output) / "summary.json");
  }
  if (options.wave_option->count() != 0 && !options.no_wave) check_writable(options.wave);
  const auto jobs = prepare_jobs(options);
  auto results = run_all(options, jobs);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  CosimSummary summary{{}, seconds};
  for (std::size_t i = 0; i < jobs.size(); ++i) summary.runs.push_back({&jobs[i].job, &results[i]});
  for (const auto& result : results) fmt::print(stderr, "{}", result.message);
  fmt::print("{}", options.json ? to_json(summary).dump(1) + "\n" : to_text(summary));
  if (!options.output.empty()) write_outputs(options, jobs, results, summary);
  return summary.holds() ? kHolds : kBroken;
}

// The command line again, without what a replay chooses anew.
std::string replayable(const std::vector<std::string>& arguments) {
  constexpr std::array<std::string_view, 5> kOfRandom{"--replay", "--output", "--scene", "--random", "--seed"};
  constexpr std::array<std::string_view, 6> kOfScenes{"--replay", "--output", "--scene",
                                                      "--mode",   "--kernel", "--wrap"};
  const bool random = std::ranges::any_of(arguments, [](const auto& a) { return a.starts_with("--random"); });
  return repeat_command(arguments, {random ? std::span<const std::string_view>(kOfRandom) : kOfScenes, {}});
}

}  // namespace

void add_cosim(CLI::App& program, int& exit_code, const std::vector<std::string>& arguments) {
  auto options = std::make_shared<CosimOptions>();
  options->command_line = replayable(arguments);
  CLI::App* command =
      program.add_subcommand("cosim", "compares the RTL with the model on a scene, every stage's every beat");
  command->footer(
      "Stops a run at the first wrong stage: prints the field, the stage's inputs, a waveform and a replay command.\n"
      "Example: feline cosim --scene bricks --mode simple,table --size 512 --stalls 0.2 --memory-latency 50");
  command->add_option("--scene", options->scenes, scene_names() + "; a list a,b, or all");
  options->subject.add_to(*command, false);
  options->sampler.add_to(*command, true);
  command->add_option("--random", options->random, "so many random and directed lookups under random samplers instead")
      ->check(whole_number(1, std::uint64_t{1} << 40));
  const TimingOptions timing = add_timing(*command, options->timing, "stalls, power-up state and random lookups");
  command
      ->add_flag("--vary", options->vary,
                 "with --random: other stalls, memory latencies of 0 to 1000 cycles and resets for every batch of 256")
      ->excludes(timing.memory_latency)
      ->excludes(timing.stalls);
  command->add_option("--replay", options->replay, "only this lookup, or FIRST:LAST");
  command->add_option("--output", options->output, "directory for pictures, probe maps and the summary");
  options->wave_option =
      command->add_option("--wave", options->wave, "waveform (FST) around a mismatch; of several runs, one each")
          ->capture_default_str();
  command->add_flag("--no-wave", options->no_wave, "write no waveform");
  command->add_option("--jobs", options->jobs, "runs side by side; 0: as many as there are processors")
      ->check(whole_number(0, 1024))
      ->capture_default_str();
  command->add_flag("--json", options->json, "the summary as JSON");
  command->callback([options, &exit_code] { exit_code = run_cosim(*options); });
}

}  // namespace feline
