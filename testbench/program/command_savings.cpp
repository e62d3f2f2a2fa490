// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

#include "testbench/area/synthesis.h"
#include "testbench/atomic_file.h"
#include "testbench/budget/gates.h"
#include "testbench/budget/measurement.h"
#include "testbench/error.h"
#include "testbench/parallel.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/subject.h"
#include "testbench/program/unit_program.h"
#include "testbench/prune/observe.h"
#include "testbench/prune/prune.h"
#include "testbench/prune/savings.h"
#include "testbench/scenes/scene.h"

namespace feline {
namespace {

struct SavingsOptions {
  std::string scenes = "all";
  std::string size = "256";
  std::string mode = "simple";
  std::string kernel = "bilinear";
  std::string source = FELINE_SOURCE_DIR;
  std::string library = kCellLibrary;
  std::string output = "feline-savings";
  std::uint64_t seed = 1;
  bool json = false;
};

// One scene of the table but for its areas: profile, unit, check of every frame, error.
class SceneWork {
 public:
  explicit SceneWork(const SavingsOptions& options) : options_(options), size_(parse_size("--size", options.size)) {
    candidate_.mode = static_cast<Mode>(parse_name("--mode", options.mode, kModeNames));
    candidate_.kernel = static_cast<Kernel>(parse_name("--kernel", options.kernel, kKernelNames));
  }

  std::filesystem::path directory(const Scene& scene) const {
    return std::filesystem::path(options_.output) / scene.name;
  }

  Savings of(const Scene& scene, const Cache& cache) const {
    const ExhibitPlan plan = plan_exhibit(scene, size_.width, size_.height);
    Savings savings;
    savings.scene = plan.name;
    savings.width = plan.width;
    savings.height = plan.height;
    savings.frames = plan.frame_count;
    const Profile profile = profile_of_all_frames(scene, plan);
    savings.config = pruned_config(profile);
    write_unit(directory(scene), savings.config, profile);
    savings.check =
        check_from_json(run_unit_program(options_.source, directory(scene).string(), "feline_pruned",
                                         {"--scene", plan.name, "--size", fmt::format("{}x{}", plan.width, plan.height),
                                          "--mode", options_.mode, "--kernel", options_.kernel}));
    BudgetSurveyOptions survey;
    survey.seed = options_.seed;
    const Measurement measured = BudgetScene(plan, survey, cache).measure(candidate_);
    savings.gaussian = measured.gaussian;
    savings.box = measured.box;
    return savings;
  }

 private:
  Profile profile_of_all_frames(const Scene& scene, const ExhibitPlan& plan) const {
    const Texture texture = scene.texture();
    const TextureMemory memory = layout_texture(texture);
    const ProfiledTexture profiled = profiled_texture(plan.name, texture);
    const auto sampler = make_sampler<kDefaultConfig>(sampler_options(candidate_), texture, memory);
    Profile profile;
    for (int i = 0; i < plan.frame_count; ++i) {
      const GBuffer gbuffer = make_gbuffer(frame(scene, i), plan.width, plan.height);
      observe(profile, plan.name, gbuffer.lookups, sampler, memory, profiled);
    }
    return profile;
  }

  const SavingsOptions& options_;
  Size size_;
  Candidate candidate_;
};

// All units and the full one, two minutes each, on all processors.
void synthesize(std::vector<Savings>& all, const Synthesis& synthesis, const std::string& full,
                const std::filesystem::path& rtl) {
  std::vector<std::string> sources{full};
  for (const Savings& each : all) sources.push_back(unit_source(each.config, rtl));
  std::vector<StageArea> areas(sources.size());
  Progress progress("synthesizing", sources.size());
  progress.show();
  for_each_index(0, static_cast<std::int64_t>(sources.size()), [&](std::int64_t number) {
    const auto i = static_cast<std::size_t>(number);
    areas[i] = synthesis.report(synthesis.unit(sources[i])).total();
    progress.advance(1);
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].full = areas[0];
    all[i].pruned = areas[i + 1];
  }
}

int run_savings(const SavingsOptions& options) {
  const std::vector<const Scene*> chosen = scene_list(options.scenes);
  const std::filesystem::path directory = options.output;
  const std::filesystem::path rtl = std::filesystem::path(options.source) / "rtl";
  // Complaints come before the work.
  const SceneWork work(options);
  const std::string full = unit_source(rtl, std::filesystem::path(options.source) / "tables" / "generated");
  (void)Synthesis(options.library, nullptr);
  prepare_directory(options.output, {"savings.json", "savings.csv", "savings.md"});
  for (const Scene* const scene : chosen) prepare_unit(work.directory(*scene));
  const Cache cache(directory / "cache");
  std::vector<Savings> all;
  for (const Scene* const scene : chosen) all.push_back(work.of(*scene, cache));
  synthesize(all, Synthesis(options.library, &cache), full, rtl);
  const std::string json = savings_json(all).dump(1) + "\n";
  const std::string table = savings_markdown(all);
  OutputFiles outputs;
  outputs.write(directory / "savings.json", json);
  outputs.write(directory / "savings.csv", savings_csv(all));
  outputs.write(directory / "savings.md", table);
  outputs.commit();
  fmt::print("{}", options.json ? json : table);
  for (const Savings& each : all) {
    if (!each.holds()) fmt::print(stderr, "feline: {}: not the full unit's pixels\n{}", each.scene, each.check.message);
  }
  return std::ranges::all_of(all, &Savings::holds) ? kHolds : kBroken;
}

}  // namespace

void add_savings(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<SavingsOptions>();
  CLI::App* command = program.add_subcommand("savings", "what pruning saves, scene by scene: a table");
  command->footer(
      "Of each scene: its pruned unit, built and compared with the full one over every pixel of every frame; cells,\n"
      "gates, ROM bytes and multipliers of both by synthesis; cycles; error against truth. Writes savings.md,\n"
      "savings.json, savings.csv and the units. About two minutes a scene; what is known already is not synthesized\n"
      "again. Needs Yosys and OSU's 180 nm cells (Debian packages yosys, qflow-tech-osu018).\n"
      "Example: feline savings --scene runway,bricks --size 128");
  command->add_option("--scene", options->scenes, scene_names() + "; a list a,b, or all")->capture_default_str();
  command->add_option("--size", options->size, "picture size: N or WIDTHxHEIGHT; a sequence's frames have half")
      ->capture_default_str();
  command->add_option("--mode", options->mode, fmt::format("{}", fmt::join(kModeNames, ", ")))->capture_default_str();
  command->add_option("--kernel", options->kernel, fmt::format("{}", fmt::join(kKernelNames, ", ")))
      ->capture_default_str();
  command->add_option("--output", options->output, "directory of the table and of a unit for each scene")
      ->capture_default_str();
  command->add_option("--source", options->source, "this project's sources, to build the units from")
      ->capture_default_str();
  command->add_option("--library", options->library, "Liberty file of the cells")->capture_default_str();
  command->add_option("--seed", options->seed, "of the ground truth's samples")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command->add_flag("--json", options->json, "print savings.json");
  command->callback([options, &exit_code] { exit_code = run_savings(*options); });
}

}  // namespace feline
