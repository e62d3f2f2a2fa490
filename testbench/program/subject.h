// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/memory.h"
#include "model/sampler.h"
#include "testbench/cosim/sampler_choices.h"
#include "testbench/gbuffer.h"
#include "testbench/image.h"
#include "testbench/lazy_texture.h"

namespace feline {

// What is looked at: lookups and the texture they look into.
struct Subject {
  std::string name;
  GBuffer gbuffer;
  Texture texture;
  TextureMemory memory;
  std::unique_ptr<LazyTexture> lazy;  // instead of texture and memory, from load_lazily only
};

// The command line's part of it: a built-in scene, a user's own files, or one of each.
struct SubjectOptions {
  std::string scene;
  std::string gbuffer;
  std::string texture;
  std::string size = "256";
  std::string mip_filter = "lanczos";
  std::string format;
  bool srgb = false;
  bool allow_non_finite = false;

  // A command whose --scene takes a list adds that option itself.
  void add_to(CLI::App& command, bool with_scene);
  // Throws InputError when anything here was chosen: random lookups bring their own textures.
  void check_random() const;
  // What lies beyond an edge while mip levels are made is as the sampler wraps.
  Subject load(const std::string& scene_name, MipEdge edge) const;
  Subject load(MipEdge edge) const { return load(scene, edge); }
  // As load, but a texture file with tiles and MIP levels of its own is loaded as it is touched.
  Subject load_lazily(MipEdge edge) const;
  // Of all this only --texture and its options; --size is then the texture's own.
  Texture load_texture_only(MipEdge edge) const;
  // Throws InputError when anything but the texture and its options was chosen.
  void check_texture_only() const;

 private:
  // The subject without its texture.
  Subject load_view(const std::string& scene_name) const;
  void load_whole_texture(Subject& subject, const std::string& scene_name, MipEdge edge) const;
  ImageOptions image_options(MipEdge edge) const;

  const CLI::Option* size_ = nullptr;
  const CLI::Option* filter_ = nullptr;
  std::vector<const CLI::Option*> view_;           // of the lookups
  std::vector<const CLI::Option*> texture_parts_;  // of the texture: nothing without --texture
  std::vector<const CLI::Option*> options_;        // all of them
};

// "512" or "512x256"; InputError unless both are 1 .. 16384.
struct Size {
  int width = 0;
  int height = 0;
};
Size parse_size(const std::string& option, const std::string& text);

// The command line's sampler. Lists are for cosim, which runs every combination; "all" is every one.
struct SamplerChoice {
  std::string modes = "table";
  std::string kernels = "bilinear";
  std::string wraps = "repeat";
  std::string wrap_t;  // as wraps, if empty
  std::string magnify;
  std::string parameters = "exact";
  std::string rounding;
  std::optional<double> length_factor, blur_factor, alias_factor;
  int max_probes = kDefaultConfig.max_probes;
  double bias = 0;
  double min_level = 0;
  std::optional<double> max_level;
  std::vector<double> border;

  void add_to(CLI::App& command, bool lists);
  // Every combination asked for, in the order mode, kernel, wrap.
  std::vector<SamplerOptions> combinations() const;
  SamplerOptions one() const { return combinations().front(); }
  // A filter in floating point knows wraps and the border only. Throws InputError when anything else was chosen.
  void check_filter() const;
  // For random samplers: of modes, kernels and wraps what was asked for, and of what was not, everything. Throws
  // InputError when anything else was chosen.
  SamplerChoices random_choices() const;
  std::string modes_of_random() const { return mode_->count() != 0 ? modes : "random"; }
  std::string kernels_of_random() const { return kernel_->count() != 0 ? kernels : "random"; }
  std::string wraps_of_random() const { return wrap_->count() != 0 ? wraps : "random"; }

 private:
  bool lists_ = false;
  const CLI::Option* mode_ = nullptr;
  const CLI::Option* kernel_ = nullptr;
  const CLI::Option* wrap_ = nullptr;
  std::vector<const CLI::Option*> others_;
  std::vector<const CLI::Option*> of_unit_;  // those of others_ that only the unit has
};

// Mip levels of a texture that repeats have no seam.
constexpr MipEdge mip_edge(const SamplerOptions& options) {
  return options.wrap_s == Wrap::kRepeat && options.wrap_t == Wrap::kRepeat ? MipEdge::kRepeat : MipEdge::kClamp;
}

// Of both axes: "repeat", or "repeat-clamp_to_edge" where they differ.
std::string wrap_name(const SamplerOptions& choice);

// "bricks, curves, ...", for help.
std::string scene_names();

// make_sampler with its complaint turned into an InputError.
SamplerState<kDefaultConfig> prepare_sampler(const SamplerOptions& options, const Texture& texture,
                                             const TextureMemory& memory);
SamplerState<kDefaultConfig> prepare_sampler(const SamplerOptions& options, const Subject& subject);

}  // namespace feline
