// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/page/gnuplot.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/subject.h"
#include "testbench/prune/observe.h"
#include "testbench/prune/profile_json.h"
#include "testbench/prune/profile_page.h"
#include "testbench/prune/profile_text.h"
#include "testbench/scenes/scene.h"

namespace feline {
namespace {

struct ProfileOptions {
  std::string scenes;
  std::vector<std::string> gbuffers;
  std::vector<std::string> textures;
  SubjectOptions texture;  // how texture files are read
  std::string size = "256";
  bool allow_non_finite = false;
  SamplerChoice sampler;
  std::vector<std::string> merged;
  std::string output;
  bool json = false;
};

// A texture in memory under the samplers that want its mip levels made this way.
struct LoadedTexture {
  Texture texture;
  TextureMemory memory;
  ProfiledTexture profiled;
};

// The texture of the frames at hand, each of its mip chains loaded when a sampler first wants it.
class CurrentTexture {
 public:
  using Load = std::function<Texture(MipEdge)>;

  // Nothing is loaded again when the path is the last one's.
  void choose(const std::string& path, const std::string& name, Load load) {
    if (path == path_) return;
    path_ = path;
    name_ = name;
    load_ = std::move(load);
    loaded_.clear();
  }
  const LoadedTexture& get(MipEdge edge) {
    auto& entry = loaded_[edge];
    if (!entry) {
      entry.emplace();
      entry->texture = load_(edge);
      entry->memory = layout_texture(entry->texture);
      entry->profiled = profiled_texture(name_, entry->texture);
    }
    return *entry;
  }

 private:
  std::string path_;
  std::string name_;
  Load load_;
  std::map<MipEdge, std::optional<LoadedTexture>> loaded_;
};

// Files as they are, directories as the .exr files in them, in order.
std::vector<std::filesystem::path> expand(const std::vector<std::string>& given) {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path path : given) {
    if (!std::filesystem::exists(path)) bad_input(path.string(), "--gbuffer", "no such file", "EXR files");
    if (!std::filesystem::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    std::vector<std::filesystem::path> within;
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
      if (entry.path().extension() == ".exr") within.push_back(entry.path());
    }
    if (within.empty()) bad_input(path.string(), "--gbuffer", "a directory without .exr files", "one that has some");
    std::ranges::sort(within);
    files.insert(files.end(), within.begin(), within.end());
  }
  return files;
}

// What is to be profiled, checked before anything is.
struct ProfilePlan {
  std::vector<const Scene*> scenes;
  Size size;
  std::vector<std::filesystem::path> files;  // G-buffers
  std::vector<SamplerOptions> samplers;
};

ProfilePlan plan_profile(const ProfileOptions& options) {
  ProfilePlan plan;
  plan.samplers = options.sampler.combinations();
  plan.size = parse_size("--size", options.size);
  if (options.scenes == "all") {
    for (const Scene& scene : scenes()) plan.scenes.push_back(&scene);
  } else if (!options.scenes.empty()) {
    for (const std::string& name : split_list("--scene", options.scenes)) plan.scenes.push_back(&find_scene(name));
  } else if (options.gbuffers.empty() && options.merged.empty()) {
    plan.scenes.push_back(&scenes().front());
  }
  plan.files = expand(options.gbuffers);
  const std::size_t textures = options.textures.size();
  if (!plan.files.empty() && textures != 1 && textures != plan.files.size()) {
    const std::string one = plan.files.size() == 1 ? "one file" : "one file, or one for each G-buffer";
    bad_input("command line", "--texture", textures == 0 ? "nothing" : fmt::format("{} files", textures),
              fmt::format("{}: {}", one, plan.files.size()));
  }
  for (const std::filesystem::path texture : options.textures) {
    if (!std::filesystem::exists(texture))
      bad_input(texture.string(), "--texture", "no such file", "image or .tx files");
  }
  return plan;
}

// The frames of a sequence are one source: "frame_0017" is of "frame_#".
std::string source_name(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t last = stem.find_last_not_of("0123456789");
  if (last == std::string::npos) return "#";
  return last + 1 == stem.size() ? stem : stem.substr(0, last + 1) + "#";
}

constexpr std::uint64_t kShare = 1024;  // of the progress, a frame

// One frame under every sampler asked for.
void observe_frame(Profile& profile, const std::string& source, const GBuffer& gbuffer, CurrentTexture& texture,
                   const std::vector<SamplerOptions>& samplers, Progress& progress) {
  Progress part(progress, kShare, gbuffer.lookups.size() * samplers.size());
  for (const SamplerOptions& options : samplers) {
    const LoadedTexture& loaded = texture.get(mip_edge(options));
    const auto sampler = prepare_sampler(options, loaded.texture, loaded.memory);
    observe(profile, source, gbuffer.lookups, sampler, loaded.memory, loaded.profiled, &part);
  }
}

void profile_scenes(Profile& profile, const ProfilePlan& plan) {
  std::uint64_t frames = 0;
  for (const Scene* const scene : plan.scenes) frames += static_cast<std::uint64_t>(frame_count(*scene));
  Progress progress("profiling", frames * kShare);
  for (const Scene* const scene : plan.scenes) {
    const std::string name(scene->name);
    CurrentTexture texture;
    texture.choose(name, name, [&](MipEdge edge) { return scene->texture(MipFilter::kLanczos, edge); });
    for (int i = 0; i < frame_count(*scene); ++i) {
      const GBuffer gbuffer = make_gbuffer(frame(*scene, i), plan.size.width, plan.size.height);
      observe_frame(profile, name, gbuffer, texture, plan.samplers, progress);
    }
  }
}

// One frame in memory at a time, and one texture.
void profile_files(Profile& profile, const ProfilePlan& plan, const ProfileOptions& options) {
  Progress progress("profiling", plan.files.size() * kShare);
  CurrentTexture texture;
  for (std::size_t i = 0; i < plan.files.size(); ++i) {
    SubjectOptions subject = options.texture;
    subject.texture = options.textures[options.textures.size() == 1 ? 0 : i];
    const std::string name = std::filesystem::path(subject.texture).stem().string();
    texture.choose(subject.texture, name, [subject](MipEdge edge) { return subject.load_texture_only(edge); });
    const GBuffer gbuffer = read_gbuffer(plan.files[i], {options.allow_non_finite});
    observe_frame(profile, source_name(plan.files[i]), gbuffer, texture, plan.samplers, progress);
  }
}

int run_profile(const ProfileOptions& options) {
  const ProfilePlan plan = plan_profile(options);
  Profile profile;
  for (const std::string& file : options.merged) merge(profile, read_profile(file));
  const std::filesystem::path directory = options.output;
  if (!options.output.empty()) {
    page::check_gnuplot();
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) bad_input(options.output, "--output", error.message(), "a directory, or where one can be made");
    for (const char* const name : {"profile.json", "profile.html"}) check_writable(directory / name);
  }
  if (!plan.scenes.empty()) profile_scenes(profile, plan);
  if (!plan.files.empty()) profile_files(profile, plan, options);
  const std::string json = profile_to_json(profile);
  if (!options.output.empty()) {
    OutputFiles outputs;
    outputs.write(directory / "profile.json", json);
    outputs.write(directory / "profile.html", profile_page(profile));
    outputs.commit();
  }
  fmt::print("{}", options.json ? json : profile_to_text(profile));
  if (!options.output.empty() && !options.json) fmt::print("{0}/profile.html\n{0}/profile.json\n", directory.string());
  return kHolds;
}

}  // namespace

void add_profile(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ProfileOptions>();
  CLI::App* command = program.add_subcommand("profile", "which parts of the unit scenes reach, and how often");
  command->footer(
      "Of a sequence one frame is in memory at a time. Profiles merge, so that a library of scenes is one profile.\n"
      "Example: feline profile --gbuffer frames/*.exr --texture photo.png --mode simple,table --output profile");
  auto* const scene = command->add_option("--scene", options->scenes,
                                          scene_names() + "; a list a,b, or all; every frame of a sequence");
  auto* const gbuffer = command
                            ->add_option("--gbuffer", options->gbuffers,
                                         "EXR files with channels s, t, dsdx, dtdx, dsdy, dtdy, or directories of them")
                            ->excludes(scene);
  auto* const texture =
      command->add_option("--texture", options->textures, "image or .tx file for them: one, or one for each")
          ->needs(gbuffer);
  command->add_option("--size", options->size, "picture size of a scene: N or WIDTHxHEIGHT")
      ->capture_default_str()
      ->excludes(gbuffer);
  command->add_flag("--allow-non-finite", options->allow_non_finite, "take G-buffers with NaN or infinity in them")
      ->needs(gbuffer);
  command
      ->add_option("--mip-filter", options->texture.mip_filter,
                   "makes a texture file's mip levels: lanczos (radius 3) or box")
      ->capture_default_str()
      ->needs(texture);
  command
      ->add_option("--texture-format", options->texture.format,
                   "r8, rg8 or rgba8, instead of what the files' channels say")
      ->needs(texture);
  command->add_flag("--srgb", options->texture.srgb, "the texture files' colours are sRGB encoded")->needs(texture);
  options->sampler.add_to(*command, true);
  command->add_option("--merge", options->merged, "profile.json files to add");
  command->add_option("--output", options->output, "directory for profile.html and profile.json");
  command->add_flag("--json", options->json, "print profile.json");
  command->callback([options, &exit_code] { exit_code = run_profile(*options); });
}

}  // namespace feline
