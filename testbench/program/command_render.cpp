// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "testbench/cosim/job.h"
#include "testbench/error.h"
#include "testbench/measure/contestant.h"
#include "testbench/measure/detail.h"
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
  std::string filter;
  std::string output = "picture.png";
  bool no_shortcuts = false;
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

// The model's picture, and what was left out of it.
struct ModelRendering {
  Picture picture;
  ShortcutCounts counts;
  Residency residency;
};

ModelRendering render_by_model(const RenderOptions& options, Subject& subject,
                               const SamplerState<kDefaultConfig>& sampler) {
  ModelRendering rendering;
  if (subject.lazy) {
    rendering.picture = render_shortcuts(subject.gbuffer, sampler, *subject.lazy, rendering.counts);
    rendering.residency = subject.lazy->residency();
    return rendering;
  }
  rendering.picture = options.no_shortcuts
                          ? render_model(subject.gbuffer, sampler, subject.memory)
                          : render_shortcuts(subject.gbuffer, sampler, subject.memory, rendering.counts);
  const auto bytes = static_cast<std::int64_t>(subject.memory.bytes.size());
  const auto levels = static_cast<std::int64_t>(subject.texture.levels.size());
  rendering.residency = {0, 0, levels, levels, bytes, bytes};
  return rendering;
}

nlohmann::ordered_json to_json(const ModelRendering& rendering) {
  nlohmann::ordered_json json;
  for (const ShortcutName& shortcut : kShortcutNames) {
    json["left_out"][std::string(shortcut.name)] = rendering.counts.*shortcut.saved;
  }
  const Residency& residency = rendering.residency;
  json["texture_memory"] = {{"file_tiles", residency.tiles}, {"of_file_tiles", residency.whole_tiles},
                            {"levels", residency.levels},    {"of_levels", residency.whole_levels},
                            {"bytes", residency.bytes},      {"of_bytes", residency.whole_bytes}};
  return json;
}

std::string to_text(const ModelRendering& rendering) {
  std::vector<std::string> parts;
  for (const ShortcutName& shortcut : kShortcutNames) {
    const std::int64_t saved = rendering.counts.*shortcut.saved;
    if (saved != 0) parts.push_back(fmt::format("{} {}", saved, shortcut.unit));
  }
  const Residency& residency = rendering.residency;
  return fmt::format(
      "left out: {}\ntexture memory: {} of {} levels, {:.2f} % of {} bytes\n",
      parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", ")), residency.levels, residency.whole_levels,
      100 * static_cast<double>(residency.bytes) / static_cast<double>(residency.whole_bytes), residency.whole_bytes);
}

void tell_written(const RenderOptions& options, nlohmann::ordered_json json,
                  const std::vector<std::filesystem::path>& written) {
  if (options.json) {
    constexpr std::array<const char*, 3> kKeys{"picture", "probe_map", "level_map"};
    for (std::size_t i = 0; i < written.size(); ++i) json[kKeys[i]] = written[i].string();
    fmt::print("{}\n", json.dump(1));
    return;
  }
  for (const auto& path : written) fmt::print("{}\n", path.string());
}

// By a filter in floating point instead of the unit.
int run_filter(const RenderOptions& options) {
  const Contestant* const contestant = find_contestant(options.filter);
  if (contestant == nullptr || contestant->kind == Contestant::Kind::kUnit) {
    bad_input("command line", "--filter", options.filter, "one of " + filter_names());
  }
  if (options.map && contestant->kind == Contestant::Kind::kLibrary) {
    bad_input("command line", "--map", "given", "nothing with this filter, which tells no probes");
  }
  options.sampler.check_filter();
  if (options.subject.allow_non_finite) {
    bad_input("command line", "--allow-non-finite", "given", "nothing together with --filter");
  }
  const SamplerOptions choice = options.sampler.one();
  const bool coloured = std::ranges::any_of(choice.border, [](double channel) { return channel != 0; });
  if (coloured && contestant->kind == Contestant::Kind::kLibrary) {
    bad_input("command line", "--border", fmt::format("{}", fmt::join(choice.border, ",")),
              "0,0,0,0 with this filter, whose border is black");
  }
  Subject subject = options.subject.load(mip_edge(choice));
  reference::Wrapping wrapping{choice.wrap_s, choice.wrap_t, {}};
  for (std::size_t c = 0; c < 4; ++c) wrapping.border[c] = static_cast<float>(choice.border[c]);
  const Surface surface =
      make_surface(std::move(subject.texture), wrapping, mip_edge(choice), std::span(&contestant->pyramid, 1));
  const int width = subject.gbuffer.width;
  const int height = subject.gbuffer.height;
  const View view = options.subject.gbuffer.empty() ? make_view(find_scene(subject.name), surface, width, height)
                                                    : make_view(subject.name, surface, std::move(subject.gbuffer));
  Progress progress("rendering", view.gbuffer.lookups.size());
  const Rendering rendering = contestant->render(view, &progress);
  const std::filesystem::path path = options.output;
  std::vector<std::filesystem::path> written{path};
  OutputFiles outputs;
  write_picture(outputs, path, rendering.picture, surface.texture.srgb);
  if (options.map) {
    written.push_back(beside(path, "probes"));
    outputs.write(written.back(), probes_png(rendering.probes, width, {0, 0, std::max(width, height)}));
  }
  outputs.commit();
  tell_written(options,
               {{"width", width},
                {"height", height},
                {"probes", rendering.cost.probes},
                {"texels", rendering.cost.texels},
                {"cycles", rendering.cost.cycles},
                {"nanoseconds_a_pixel", rendering.nanoseconds},
                {"scene", view.name},
                {"filter", contestant->name}},
               written);
  return kHolds;
}

int run_render(const RenderOptions& options) {
  const std::string extension = std::filesystem::path(options.output).extension().string();
  if (!extension.empty() && extension != ".png") bad_input(options.output, "--output", extension, "a .png file");
  if (!options.filter.empty()) {
    check_writable(options.output);
    return run_filter(options);
  }
  const bool rtl = parse_name("--engine", options.engine, kEngineNames) == 1;
  check_writable(options.output);
  const SamplerOptions choice = options.sampler.one();
  if (rtl && options.no_shortcuts) {
    bad_input("command line", "--no-shortcuts", "given", "nothing together with --engine rtl");
  }
  Subject subject = rtl || options.no_shortcuts ? options.subject.load(mip_edge(choice))
                                                : options.subject.load_lazily(mip_edge(choice));
  const auto sampler = prepare_sampler(choice, subject);
  bool holds = true;
  ModelRendering rendering;
  if (rtl) {
    rendering.picture = render_rtl(subject, choice, options.cosim_command, holds);
  } else {
    rendering = render_by_model(options, subject, sampler);
  }
  if (!holds) return kBroken;
  const Picture& picture = rendering.picture;
  const std::filesystem::path path = options.output;
  std::vector<std::filesystem::path> written{path};
  OutputFiles outputs;
  write_picture(outputs, path, picture);
  if (options.map) {
    written.insert(written.end(), {beside(path, "probes"), beside(path, "levels")});
    write_probe_map(outputs, written[1], picture);
    write_level_map(outputs, written[2], picture, static_cast<int>(sampler.last_level.raw()));
  }
  outputs.commit();
  auto json = to_json(picture);
  json["scene"] = subject.name;
  json["mode"] = kModeNames[static_cast<std::size_t>(choice.mode)];
  json["engine"] = options.engine;
  if (!rtl) json.update(to_json(rendering));
  tell_written(options, std::move(json), written);
  if (!rtl && !options.json) fmt::print("{}", to_text(rendering));
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
  command->footer(
      "The model leaves out what a lookup does not need, and loads of a texture file with tiles and MIP levels of its\n"
      "own (maketx makes one) only what is touched; any other file is loaded whole. Neither changes a bit.\n"
      "Example: feline render --scene window --mode table --size 512 --output window.png --map");
  options->subject.add_to(*command, true);
  options->sampler.add_to(*command, false);
  auto* const engine = command->add_option("--engine", options->engine, "model or rtl")->capture_default_str();
  auto* const plain = command->add_flag("--no-shortcuts", options->no_shortcuts,
                                        "every stage of every probe, and the whole texture: the same picture, slower");
  command->add_option("--filter", options->filter, "in floating point, instead of the unit: " + filter_names())
      ->excludes(engine)
      ->excludes(plain);
  command->add_option("--output", options->output, "PNG to write")->capture_default_str();
  command->add_flag("--map", options->map, "write maps of probes and levels beside it");
  command->add_flag("--json", options->json, "tell what was written, and figures, as JSON");
  command->callback([options, &exit_code] { exit_code = run_render(*options); });
}

}  // namespace feline
