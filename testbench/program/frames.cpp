// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "testbench/error.h"
#include "testbench/program/command_line.h"
#include "testbench/scenes/scene.h"

namespace feline {
namespace {

struct LoadedTexture {
  int number = 0;
  Texture texture;
  TextureMemory memory;
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
  const std::string& name() const { return name_; }
  const LoadedTexture& get(MipEdge edge) {
    auto& entry = loaded_[edge];
    if (!entry) {
      entry.emplace();
      entry->number = ++number_;
      entry->texture = load_(edge);
      entry->memory = layout_texture(entry->texture);
    }
    return *entry;
  }

 private:
  std::string path_;
  std::string name_;
  Load load_;
  int number_ = 0;
  std::map<MipEdge, std::optional<LoadedTexture>> loaded_;
};

// The frames of a sequence are one source: "frame_0017" is of "frame_#".
std::string source_name(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t last = stem.find_last_not_of("0123456789");
  if (last == std::string::npos) return "#";
  return last + 1 == stem.size() ? stem : stem.substr(0, last + 1) + "#";
}

// Of a scene's frames those that are asked for: all, N, or FIRST:LAST.
NumberRange frame_range(const Scene& scene, const std::string& text) {
  const auto count = static_cast<std::uint64_t>(frame_count(scene));
  if (text == "all") return {0, count - 1};
  const auto range = parse_range(text, count);
  if (range) return *range;
  bad_input("command line", "--frames", text,
            fmt::format("all, a frame or FIRST:LAST, 0 to {} of {}", count - 1, scene.name));
}

constexpr std::uint64_t kShare = 1024;  // of the progress, a visit

}  // namespace

std::vector<std::filesystem::path> FrameOptions::files() const {
  // Files as they are, directories as the .exr files in them, in order.
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path path : gbuffers_) {
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

std::vector<const Scene*> FrameOptions::chosen_scenes() const {
  return scenes_.empty() ? std::vector<const Scene*>{} : scene_list(scenes_);
}

void FrameOptions::choose_default_scene() { scenes_ = scenes().front().name; }

void FrameOptions::check() const {
  sampler_.combinations();
  parse_size("--size", size_);
  for (const Scene* const scene : chosen_scenes()) frame_range(*scene, frames_);
  const std::size_t gbuffers = files().size();
  const std::size_t textures = textures_.size();
  if (gbuffers != 0 && textures != 1 && textures != gbuffers) {
    const std::string one = gbuffers == 1 ? "one file" : "one file, or one for each G-buffer";
    bad_input("command line", "--texture", textures == 0 ? "nothing" : fmt::format("{} files", textures),
              fmt::format("{}: {}", one, gbuffers));
  }
  for (const std::filesystem::path texture : textures_) {
    if (!std::filesystem::exists(texture))
      bad_input(texture.string(), "--texture", "no such file", "image or .tx files");
  }
}

std::uint64_t FrameOptions::visits() const {
  std::uint64_t frames = files().size();
  for (const Scene* const scene : chosen_scenes()) {
    const NumberRange range = frame_range(*scene, frames_);
    frames += range.last - range.first + 1;
  }
  return frames * sampler_.combinations().size();
}

void FrameOptions::for_each(const std::string& what, const Visit& visit) const {
  check();
  const std::vector<SamplerOptions> samplers = sampler_.combinations();
  const Size size = parse_size("--size", size_);
  Progress progress(what, visits() * kShare);
  CurrentTexture texture;
  const auto visit_all = [&](const std::string& source, const GBuffer& gbuffer) {
    for (const SamplerOptions& sampler : samplers) {
      const LoadedTexture& loaded = texture.get(mip_edge(sampler));
      Progress part(progress, kShare, gbuffer.lookups.size());
      visit({source, gbuffer, texture.name(), loaded.number, loaded.texture, loaded.memory, sampler}, part);
    }
  };
  for (const Scene* const scene : chosen_scenes()) {
    const std::string name(scene->name);
    texture.choose(name, name, [scene](MipEdge edge) { return scene->texture(MipFilter::kLanczos, edge); });
    const NumberRange range = frame_range(*scene, frames_);
    for (std::uint64_t i = range.first; i <= range.last; ++i) {
      visit_all(name, make_gbuffer(frame(*scene, static_cast<int>(i)), size.width, size.height));
    }
  }
  const std::vector<std::filesystem::path> gbuffers = files();
  for (std::size_t i = 0; i < gbuffers.size(); ++i) {
    SubjectOptions subject = texture_;
    subject.texture = textures_[textures_.size() == 1 ? 0 : i];
    const std::string name = std::filesystem::path(subject.texture).stem().string();
    texture.choose(subject.texture, name, [subject](MipEdge edge) { return subject.load_texture_only(edge); });
    visit_all(source_name(gbuffers[i]), read_gbuffer(gbuffers[i], {allow_non_finite_}));
  }
}

void FrameOptions::add_to(CLI::App& command) {
  auto* const scene =
      command.add_option("--scene", scenes_, scene_names() + "; a list a,b, or all; every frame of a sequence");
  auto* const gbuffer = command
                            .add_option("--gbuffer", gbuffers_,
                                        "EXR files with channels s, t, dsdx, dtdx, dsdy, dtdy, or directories of them")
                            ->excludes(scene);
  auto* const texture =
      command.add_option("--texture", textures_, "image or .tx file for them: one, or one for each")->needs(gbuffer);
  command.add_option("--frames", frames_, "of a scene that is a sequence: all, one by its number, or FIRST:LAST")
      ->capture_default_str()
      ->excludes(gbuffer);
  command.add_option("--size", size_, "picture size of a scene: N or WIDTHxHEIGHT")
      ->capture_default_str()
      ->excludes(gbuffer);
  command.add_flag("--allow-non-finite", allow_non_finite_, "take G-buffers with NaN or infinity in them")
      ->needs(gbuffer);
  command
      .add_option("--mip-filter", texture_.mip_filter, "makes a texture file's mip levels: lanczos (radius 3) or box")
      ->capture_default_str()
      ->needs(texture);
  command.add_option("--texture-format", texture_.format, "r8, rg8 or rgba8, instead of what the files' channels say")
      ->needs(texture);
  command.add_flag("--srgb", texture_.srgb, "the texture files' colours are sRGB encoded")->needs(texture);
  sampler_.add_to(command, true);
}

}  // namespace feline
