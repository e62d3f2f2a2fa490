// SPDX-License-Identifier: Apache-2.0
#include "testbench/area/activity.h"

#include <fmt/format.h>

#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/json_input.h"

namespace feline {
namespace {

constexpr std::array kCounts{std::pair{"register_toggles", &StageToggles::registers},
                             std::pair{"net_toggles", &StageToggles::nets},
                             std::pair{"memory_toggles", &StageToggles::memories}};

StageToggles total(const Activity& activity) {
  StageToggles all{"all"};
  for (const StageToggles& stage : activity.stages) {
    for (const auto& [name, count] : kCounts) all.*count += stage.*count;
  }
  return all;
}

}  // namespace

void add(Activity& into, const Activity& from) {
  into.lookups += from.lookups;
  into.probes += from.probes;
  into.cycles += from.cycles;
  if (into.stages.empty()) {
    into.stages = from.stages;
    return;
  }
  for (std::size_t i = 0; i < into.stages.size(); ++i) {
    for (const auto& [name, count] : kCounts) into.stages[i].*count += from.stages[i].*count;
  }
}

Activity measure_activity(const Batch& batch, const Timing& timing, const RtlFactory& trace, Progress* progress) {
  // Before it registers hold anything.
  constexpr std::uint64_t kResetCycles = 2;
  // Never committed, and so removed at the end, or when the program is killed.
  const AtomicFile wave(std::filesystem::temp_directory_path() / "feline-activity.fst");
  Activity activity;
  {
    Cosimulation simulation(trace, timing);
    simulation.set_wave({wave.temporary(), kResetCycles, WaveWindow::kToTheEnd});
    const bool holds = simulation.run(batch, [&](std::uint64_t, const AccumulateBeat<kUnit>&) {
      if (progress != nullptr) progress->advance(1);
    });
    if (!holds) throw WitnessMismatch("RTL and model differ; feline cosim tells where");
    activity.lookups = simulation.beats()[static_cast<std::size_t>(Stage::kAccumulate)];
    activity.probes = simulation.beats()[static_cast<std::size_t>(Stage::kWalk)];
    activity.cycles = simulation.cycles() - kResetCycles;
  }
  activity.stages = count_toggles(wave.temporary());
  return activity;
}

nlohmann::ordered_json to_json(const Activity& activity) {
  nlohmann::ordered_json json{{"lookups", activity.lookups}, {"probes", activity.probes}, {"cycles", activity.cycles}};
  const auto add_stage = [&](nlohmann::ordered_json& into, const StageToggles& stage) {
    into["stage"] = stage.stage;
    for (const auto& [name, count] : kCounts) into[name] = stage.*count;
  };
  for (const StageToggles& stage : activity.stages) add_stage(json["stages"].emplace_back(), stage);
  add_stage(json["total"], total(activity));
  return json;
}

Activity activity_from_json(const nlohmann::ordered_json& json) {
  Activity activity;
  activity.lookups = whole_from_json<std::uint64_t>(json.at("lookups"));
  activity.probes = whole_from_json<std::uint64_t>(json.at("probes"));
  activity.cycles = whole_from_json<std::uint64_t>(json.at("cycles"));
  for (const auto& each : json.at("stages")) {
    StageToggles& stage = activity.stages.emplace_back();
    each.at("stage").get_to(stage.stage);
    for (const auto& [name, count] : kCounts) stage.*count = whole_from_json<std::uint64_t>(each.at(name));
  }
  return activity;
}

std::string to_text(const Activity& activity) {
  const auto pixels = static_cast<double>(activity.lookups);
  const auto by_pixel = [&](std::uint64_t count) { return static_cast<double>(count) / pixels; };
  std::string text = fmt::format("{:<11}{:>22}{:>10}{:>10}\n", "stage", "toggles a pixel: flops", "nets", "memories");
  const auto line = [&](const StageToggles& stage) {
    text += fmt::format("{:<11}{:>22.1f}{:>10.1f}{:>10.1f}\n", stage.stage, by_pixel(stage.registers),
                        by_pixel(stage.nets), by_pixel(stage.memories));
  };
  for (const StageToggles& stage : activity.stages) line(stage);
  line(total(activity));
  return text + fmt::format("{} pixels, {:.2f} probes and {:.2f} cycles a pixel\n", activity.lookups,
                            by_pixel(activity.probes), by_pixel(activity.cycles));
}

}  // namespace feline
