// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "testbench/gbuffer.h"
#include "testbench/program/subject.h"
#include "testbench/progress.h"

namespace feline {

struct Scene;

// One frame of what is looked at, under one sampler. References are valid during the visit only.
struct Frame {
  std::string source;  // of the frames of a sequence the same
  const GBuffer& gbuffer;
  std::string texture_name;
  int texture_number;  // another one for every texture and mip chain that is loaded
  const Texture& texture;
  const TextureMemory& memory;
  const SamplerOptions& sampler;
};

// The command line's frames: built-in scenes with all of their frames, or G-buffers and textures in files, each under
// every sampler asked for. One G-buffer and one texture are in memory at a time.
class FrameOptions {
 public:
  void add_to(CLI::App& command);
  bool given() const { return !scenes_.empty() || !gbuffers_.empty(); }
  // Without scenes and G-buffers the default scene's.
  void choose_default_scene();
  // Throws InputError for whatever is wrong that can be seen before a file is read.
  void check() const;
  // How often for_each visits.
  std::uint64_t visits() const;
  // The progress is the visit's part of the whole.
  using Visit = std::function<void(const Frame& frame, Progress& progress)>;
  void for_each(const std::string& what, const Visit& visit) const;

 private:
  std::vector<const Scene*> chosen_scenes() const;
  std::vector<std::filesystem::path> files() const;

  std::string scenes_;
  std::vector<std::string> gbuffers_;
  std::vector<std::string> textures_;
  SubjectOptions texture_;  // how texture files are read
  std::string size_ = "256";
  std::string frames_ = "all";
  bool allow_non_finite_ = false;
  SamplerChoice sampler_;
};

}  // namespace feline
