// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/lookup.h"
#include "tables/pack.h"
#include "testbench/program/subject.h"

namespace feline {

// An ellipse with what is planned for it, in texels of level 0: the ideal one, or a mode's.
struct PlannedEllipse {
  std::string name;
  double major = 0;    // texels
  double minor = 0;    // texels
  double degrees = 0;  // of the major axis, from u towards v
  double probes = 0;
  double level = 0;
};

// One lookup, every stage's every field in the order in which they are made, and the ellipses beside it.
struct Explanation {
  struct Beat {
    std::string stage;
    std::vector<FieldValue> fields;
  };
  Lookup lookup;
  std::vector<Beat> beats;
  PlannedEllipse ideal;
  std::vector<PlannedEllipse> modes;
};

// `texture` is what the lookup reads; options choose the sampler whose beats are told.
Explanation explain(const Lookup& lookup, const Subject& texture, const SamplerOptions& options);
std::string to_text(const Explanation& explanation);
nlohmann::ordered_json to_json(const Explanation& explanation);

}  // namespace feline
