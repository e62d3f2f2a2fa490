// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/rtl_leaf.h"

#include <Vfeline_leaf_align.h>
#include <Vfeline_leaf_axis_texels.h>
#include <Vfeline_leaf_choose_probes.h>
#include <Vfeline_leaf_clamp_radii.h>
#include <Vfeline_leaf_decode_texel.h>
#include <Vfeline_leaf_filter_texels.h>
#include <Vfeline_leaf_fit_radius.h>
#include <Vfeline_leaf_footprint.h>
#include <Vfeline_leaf_half_step.h>
#include <Vfeline_leaf_half_step_factor.h>
#include <Vfeline_leaf_interpolate_texels.h>
#include <Vfeline_leaf_kernel_weight.h>
#include <Vfeline_leaf_level_lines.h>
#include <Vfeline_leaf_level_of_radius.h>
#include <Vfeline_leaf_level_size.h>
#include <Vfeline_leaf_line_fraction.h>
#include <Vfeline_leaf_position.h>
#include <Vfeline_leaf_probe_position.h>
#include <Vfeline_leaf_probe_weight.h>
#include <Vfeline_leaf_sampled_level.h>
#include <Vfeline_leaf_texture_product.h>
#include <Vfeline_leaf_wanted_probes.h>
#include <Vfeline_leaf_weigh_colour.h>
#include <Vfeline_leaf_weight_row.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace feline::prove {
namespace {

// Verilator gives ports of up to 64 bits as integers, and wider ones as arrays of 32-bit words.
template <typename Port>
constexpr std::size_t port_words() {
  return (sizeof(Port) + 7) / 8;
}

template <typename Port>
void store(Port& port, const std::uint64_t* words) {
  if constexpr (std::is_integral_v<Port>) {
    port = static_cast<Port>(words[0]);
  } else {
    for (std::size_t i = 0; i < sizeof(Port) / 4; ++i) {
      port[i] = static_cast<std::uint32_t>(words[i / 2] >> (i % 2 * 32));
    }
  }
}

template <typename Port>
void load(const Port& port, std::uint64_t* words) {
  if constexpr (std::is_integral_v<Port>) {
    words[0] = port;
  } else {
    std::fill_n(words, port_words<Port>(), 0);
    for (std::size_t i = 0; i < sizeof(Port) / 4; ++i) words[i / 2] |= std::uint64_t{port[i]} << (i % 2 * 32);
  }
}

template <typename Verilated>
class VerilatedLeaf : public RtlLeaf {
 public:
  void evaluate(const std::uint64_t* inputs, std::uint64_t* outputs, std::size_t count) override {
    constexpr std::size_t kInputWords = port_words<std::remove_reference_t<decltype(leaf_.inputs_i)>>();
    constexpr std::size_t kOutputWords = port_words<std::remove_reference_t<decltype(leaf_.outputs_o)>>();
    for (std::size_t i = 0; i < count; ++i) {
      store(leaf_.inputs_i, inputs + i * kInputWords);
      leaf_.eval();
      load(leaf_.outputs_o, outputs + i * kOutputWords);
    }
  }

 private:
  VerilatedContext context_;
  Verilated leaf_{&context_};
};

template <typename Verilated>
std::unique_ptr<RtlLeaf> make() {
  return std::make_unique<VerilatedLeaf<Verilated>>();
}

struct Maker {
  std::string_view name;
  std::unique_ptr<RtlLeaf> (*make)();
};
constexpr std::array kMakers{Maker{"align", &make<Vfeline_leaf_align>},
                             Maker{"axis_texels", &make<Vfeline_leaf_axis_texels>},
                             Maker{"choose_probes", &make<Vfeline_leaf_choose_probes>},
                             Maker{"clamp_radii", &make<Vfeline_leaf_clamp_radii>},
                             Maker{"decode_texel", &make<Vfeline_leaf_decode_texel>},
                             Maker{"filter_texels", &make<Vfeline_leaf_filter_texels>},
                             Maker{"fit_radius", &make<Vfeline_leaf_fit_radius>},
                             Maker{"footprint", &make<Vfeline_leaf_footprint>},
                             Maker{"half_step", &make<Vfeline_leaf_half_step>},
                             Maker{"half_step_factor", &make<Vfeline_leaf_half_step_factor>},
                             Maker{"interpolate_texels", &make<Vfeline_leaf_interpolate_texels>},
                             Maker{"kernel_weight", &make<Vfeline_leaf_kernel_weight>},
                             Maker{"level_lines", &make<Vfeline_leaf_level_lines>},
                             Maker{"level_of_radius", &make<Vfeline_leaf_level_of_radius>},
                             Maker{"level_size", &make<Vfeline_leaf_level_size>},
                             Maker{"line_fraction", &make<Vfeline_leaf_line_fraction>},
                             Maker{"position", &make<Vfeline_leaf_position>},
                             Maker{"probe_position", &make<Vfeline_leaf_probe_position>},
                             Maker{"probe_weight", &make<Vfeline_leaf_probe_weight>},
                             Maker{"sampled_level", &make<Vfeline_leaf_sampled_level>},
                             Maker{"texture_product", &make<Vfeline_leaf_texture_product>},
                             Maker{"wanted_probes", &make<Vfeline_leaf_wanted_probes>},
                             Maker{"weigh_colour", &make<Vfeline_leaf_weigh_colour>},
                             Maker{"weight_row", &make<Vfeline_leaf_weight_row>}};

}  // namespace

std::unique_ptr<RtlLeaf> make_rtl_leaf(std::string_view name) {
  const auto* const maker = std::ranges::find(kMakers, name, &Maker::name);
  return maker == kMakers.end() ? nullptr : maker->make();
}

std::string_view verilator_version() { return Verilated::productVersion(); }

}  // namespace feline::prove
