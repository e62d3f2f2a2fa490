// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/reference/probe.h"
#include "model/sampler.h"
#include "testbench/measure/float_picture.h"
#include "testbench/measure/view.h"
#include "testbench/progress.h"

namespace feline {

// What a contestant makes of a view, and what it took.
struct Rendering {
  FloatPicture picture;
  std::vector<float> probes;  // a pixel
  reference::Cost cost;       // of all pixels; nothing where it cannot be told
  double nanoseconds = 0;     // of one thread, a pixel, on this machine
};

// Anything that textures a view: a filter of the papers, the unit in one of its modes, another library.
struct Contestant {
  enum class Kind : std::uint8_t { kReference, kUnit, kLibrary };
  std::string name;
  Kind kind = Kind::kReference;
  std::string description;
  std::string source;
  std::optional<SamplerOptions> sampler;  // of the unit
  std::function<Rendering(const View& view, Progress* progress)> render;
  reference::Pyramid pyramid = reference::Pyramid::kLanczos;  // of the surface's, the one that it reads
};

// Reference filters, then the unit as "unit_<mode>...", then "openimageio". The unit wraps as the surface does.
std::span<const Contestant> contestants();
const Contestant* find_contestant(std::string_view name);
std::string contestant_names();  // "nearest, bilinear, ...", for help
std::string filter_names();      // those that are not the unit

// Cycles a pixel of the Verilated unit over one row in 16, spread over the whole height, the row before it having
// filled the cache; each beat compared with the model. Throws WitnessMismatch when they differ. The probes' kernel
// changes nothing.
double measure_rtl_cycles(const View& view, const SamplerOptions& options);

}  // namespace feline
