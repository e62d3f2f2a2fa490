// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>

#include "model/sampler.h"
#include "tables/pack.h"
#include "testbench/cosim/cosimulation.h"

namespace feline {

// A unit and a small texture, driven by hand: nothing judges what comes out.
struct Bench {
  Texture texture{TexelFormat::kR8, false, {{4, 4, std::vector<std::uint8_t>(16, 77)}}};
  TextureMemory memory = layout_texture(texture);
  std::unique_ptr<RtlUnit> unit;

  explicit Bench(const RtlFactory& factory, const Lookup& lookup = {0.5F, 0.5F, 0.1F, 0, 0, 0.1F}) : unit(factory(1)) {
    std::array<std::uint32_t, beat_words<SamplerState<kUnit>>()> sampler{};
    pack(make_sampler<kUnit>({}, texture, memory), sampler);
    unit->set_sampler(sampler);
    RtlUnit::Inputs inputs;
    inputs.reset = true;
    unit->cycle(inputs);
    unit->cycle(inputs);
    std::array<std::uint32_t, beat_words<RequestBeat<kUnit>>()> request{};
    pack(make_request<kUnit>(lookup, 1), request);
    unit->set_request(request);
    unit->set_memory_response(memory.line(0));
  }

  // Offers so many requests, all the same, answers memory if asked to, and never takes a pixel.
  RtlUnit::Outputs run(int cycles, bool memory_ready, int requests = 1) {
    RtlUnit::Outputs outputs;
    RtlUnit::Inputs inputs;
    int left = requests;
    for (int i = 0; i < cycles; ++i) {
      inputs.request_valid = left > 0;
      inputs.memory_request_ready = memory_ready;
      unit->cycle(inputs);
      outputs = unit->outputs();
      if (inputs.request_valid && outputs.request_ready) --left;
      inputs.memory_response_valid = memory_ready && outputs.memory_request_valid;
    }
    return outputs;
  }
};

}  // namespace feline
