// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "testbench/cosim/job.h"
#include "testbench/error.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/subject.h"
#include "testbench/render.h"

namespace feline {
namespace {

struct RenderOptions {
  SubjectOptions subject;
  SamplerChoice sampler;
  std::string engine = "model";
  std::string output = "picture.png";
  bool map = false;
  bool json = false;
  std::string cosim_command;  // the same lookups, for a replay
};

constexpr std::array<std::string_view, 2> kEngineNames{"model", "rtl"};

// The pixels are the RTL's own; the maps show the plans, which co-simulation compares.
Picture render_rtl(const Subject& subject, const SamplerOptions& choice, const std::string& command, bool& holds) {
  const auto sampler = prepare_sampler(choice, subject.texture, subject.memory);
  CosimJob job;
  job.scene = subject.name;
  job.width = subject.gbuffer.width;
  job.lookups = job.batch_lookups = subject.gbuffer.lookups.size();
  job.mode = kModeNames[static_cast<std::size_t>(choice.mode)];
  job.kernel = kKernelNames[static_cast<std::size_t>(choice.kernel)];
  job.wrap = wrap_name(choice);
  job.command = command;
  job.batch = [&](std::uint64_t) { return Batch{sampler, &subject.memory, subject.gbuffer.lookups, 0}; };
  Progress progress("rendering", job.lookups);
  CosimResult result = run_job(job, make_fast_unit, {}, std::nullopt, true, &progress);
  holds = result.mismatches == 0;
  fmt::print(stderr, "{}", result.message);
  Picture picture = render_model(subject.gbuffer, sampler, subject.memory);
  picture.pixels = std::move(result.pixels);
  return picture;
}

std::filesystem::path beside(const std::filesystem::path& path, std::string_view suffix) {
  return path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), suffix, path.extension().string());
}

// Figures of the picture: its size, the probes and how many lookups raised each status bit.
nlohmann::ordered_json to_json(const Picture& picture) {
  std::int64_t probes = 0;
  std::array<std::int64_t, kStatusNames.size()> raised{};
  for (const auto& plan : picture.plans) {
    probes += plan.probes.raw();
    for (std::size_t bit = 0; bit < raised.size(); ++bit) raised[bit] += plan.status.raw() >> bit & 1;
  }
  nlohmann::ordered_json json{{"width", picture.width}, {"height", picture.height}, {"probes", probes}};
  for (std::size_t bit = 0; bit < raised.size(); ++bit) json["status"][std::string(kStatusNames[bit])] = raised[bit];
  return json;
}

int run_render(const RenderOptions& options) {
  const std::string extension = std::filesystem::path(options.output).extension().string();
  if (!extension.empty() && extension != ".png") bad_input(options.output, "--output", extension, "a .png file");
  const bool rtl = parse_name("--engine", options.engine, kEngineNames) == 1;
  check_writable(options.output);
  const SamplerOptions choice = options.sampler.one();
  const Subject subject = options.subject.load(mip_edge(choice));
  const auto sampler = prepare_sampler(choice, subject.texture, subject.memory);
  bool holds = true;
  const Picture picture = rtl ? render_rtl(subject, choice, options.cosim_command, holds)
                              : render_model(subject.gbuffer, sampler, subject.memory);
  if (!holds) return kBroken;
  const std::filesystem::path path = options.output;
  const std::filesystem::path probe_map = beside(path, "probes");
  const std::filesystem::path level_map = beside(path, "levels");
  OutputFiles outputs;
  write_picture(outputs, path, picture);
  if (options.map) {
    write_probe_map(outputs, probe_map, picture);
    write_level_map(outputs, level_map, picture, static_cast<int>(sampler.last_level.raw()));
  }
  outputs.commit();
  if (options.json) {
    auto json = to_json(picture);
    json["scene"] = subject.name;
    json["mode"] = kModeNames[static_cast<std::size_t>(choice.mode)];
    json["engine"] = options.engine;
    json["picture"] = path.string();
    if (options.map) json.update({{"probe_map", probe_map.string()}, {"level_map", level_map.string()}});
    fmt::print("{}\n", json.dump(1));
    return kHolds;
  }
  fmt::print("{}\n", path.string());
  if (options.map) fmt::print("{}\n{}\n", probe_map.string(), level_map.string());
  return kHolds;
}

}  // namespace

void add_render(CLI::App& program, int& exit_code, const std::vector<std::string>& arguments) {
  auto options = std::make_shared<RenderOptions>();
  constexpr std::array<std::string_view, 2> kOptions{"--engine", "--output"};
  constexpr std::array<std::string_view, 2> kFlags{"--map", "--json"};
  if (arguments.size() > 1) {
    std::vector<std::string> as_cosim = arguments;
    as_cosim[1] = "cosim";
    options->cosim_command = repeat_command(as_cosim, {kOptions, kFlags});
  }
  CLI::App* command = program.add_subcommand("render", "makes a picture of a G-buffer and a texture");
  command->footer("Example: feline render --scene window --mode table --size 512 --output window.png --map");
  options->subject.add_to(*command, true);
  options->sampler.add_to(*command, false);
  command->add_option("--engine", options->engine, "model or rtl")->capture_default_str();
  command->add_option("--output", options->output, "PNG to write")->capture_default_str();
  command->add_flag("--map", options->map, "write maps of probes and levels beside it");
  command->add_flag("--json", options->json, "tell what was written, and figures, as JSON");
  command->callback([options, &exit_code] { exit_code = run_render(*options); });
}

}  // namespace feline
