// SPDX-License-Identifier: Apache-2.0
#include "model/reference/filters.h"

#include <algorithm>
#include <array>
#include <vector>

#include "model/reference/approximate_axes.h"
#include "model/reference/ewa.h"
#include "model/reference/ext.h"
#include "model/reference/feline.h"
#include "model/reference/isotropic.h"
#include "model/reference/rip.h"
#include "model/reference/texram.h"

namespace feline::reference {
namespace {

constexpr std::string_view kLecture = "CS248A lecture 4, 2025";
constexpr std::string_view kFeline = "WRL 99/1";
constexpr std::string_view kOlano = "Olano, Mukherjee, Dorbie 2001";
constexpr std::string_view kRip = "SGI runway demo, 1998";
constexpr int kMaxProbes = 16;

using MapFilter = Colour (*)(const MipMap&, const Lookup&, Cost&);

Filter isotropic(std::string name, std::string_view description, MapFilter function) {
  return {std::move(name), description, kLecture, {}, [function](const Images& images, const Pixel& pixel, Cost& cost) {
            return function(images.lanczos, pixel.lookup, cost);
          }};
}

Filter bicubic_row(std::string name, std::string_view description, const Cubic& cubic) {
  return {std::move(name), description, kLecture, {}, [cubic](const Images& images, const Pixel& pixel, Cost& cost) {
            return bicubic_filter(images.lanczos, cubic, pixel.lookup, cost);
          }};
}

Filter ewa_row(std::string name, std::string_view description, const EwaParameters& parameters) {
  return {std::move(name),
          description,
          kFeline,
          {},
          [parameters](const Images& images, const Pixel& pixel, Cost& cost) {
            return ewa_filter(images.box, parameters, pixel.lookup, cost);
          },
          Pyramid::kBox};
}

Filter vertex_based_row(std::string_view system_name, AxisSystem system, std::string_view pattern_name,
                        const ProbePattern& pattern) {
  return {"vertex_" + std::string(system_name) + "_" + std::string(pattern_name),
          "probes placed at vertices, blended in passes", kOlano, system,
          [pattern, alphas = blend_alphas(pattern.weights)](const Images& images, const Pixel& pixel, Cost& cost) {
            return vertex_based_filter(images.lanczos, pattern, alphas, pixel.axes, pixel.lookup, cost);
          }};
}

void add_vertex_based(std::vector<Filter>& all) {
  struct System {
    std::string_view name;
    AxisSystem system;
  };
  constexpr std::array<System, 3> kSystems{
      {{"ellipse", AxisSystem::kEllipse}, {"screen", AxisSystem::kScreen}, {"max", AxisSystem::kMax}}};
  for (const auto& [name, system] : kSystems) {
    all.push_back(vertex_based_row(name, system, "line", line_pattern(8)));
    all.push_back(vertex_based_row(name, system, "square", square_pattern(2)));
    all.push_back(vertex_based_row(name, system, "staggered", staggered_pattern()));
  }
}

void add_feline(std::vector<Filter>& all) {
  struct Variant {
    std::string_view name;
    std::string_view description;
    AxesFunction axes;
  };
  constexpr std::array<Variant, 3> kVariants{{{"ideal", "Feline with the exact ellipse", ellipse_axes<double>},
                                              {"simple", "Feline with Texram's guess of the ellipse", simple_axes},
                                              {"table", "Feline with the 16 x 16 table", table_axes}}};
  struct Set {
    std::string_view name;
    const FelineParameters* parameters;
  };
  constexpr std::array<Set, 3> kSets{
      {{"", &kExact}, {"_high_quality", &kHighQuality}, {"_high_efficiency", &kHighEfficiency}}};
  struct Kernel {
    std::string_view name;
    ProbeKernel kernel;
  };
  constexpr std::array<Kernel, 2> kKernels{{{"", ProbeKernel::kBilinear}, {"_gaussian", ProbeKernel::kGaussian}}};
  for (const auto& variant : kVariants) {
    for (const auto& set : kSets) {
      for (const auto& kernel : kKernels) {
        all.push_back({"feline_" + std::string(variant.name) + std::string(set.name) + std::string(kernel.name),
                       variant.description,
                       kFeline,
                       {},
                       [axes = variant.axes, parameters = *set.parameters, kernel = kernel.kernel](
                           const Images& images, const Pixel& pixel, Cost& cost) {
                         return feline_filter(images.lanczos, axes, parameters, kernel, pixel.lookup, cost);
                       }});
      }
    }
  }
}

std::vector<Filter> make_filters() {
  std::vector<Filter> all{
      isotropic("nearest", "the texel of level 0 that holds the point", nearest_filter),
      isotropic("nearest_mip", "the same of the nearest mip level", nearest_mip_filter),
      isotropic("bilinear", "2 x 2 texels of level 0", bilinear_filter),
      isotropic("bilinear_mip", "2 x 2 texels of the nearest mip level", bilinear_mip_filter),
      bicubic_row("catmull_rom", "4 x 4 texels of level 0, Catmull-Rom spline", kCatmullRom),
      bicubic_row("mitchell", "4 x 4 texels of level 0, Mitchell's cubic", kMitchell),
      isotropic("trilinear", "2 x 2 texels of two mip levels", trilinear_filter),
      {"ext",
       "the example of EXT_texture_filter_anisotropic",
       "EXT_texture_filter_anisotropic, 2000",
       {},
       [](const Images& images, const Pixel& pixel, Cost& cost) {
         return ext_filter(images.lanczos, kMaxProbes, pixel.lookup, cost);
       }},
      {"rip_polygon",
       "an image of fitting ratio for each polygon",
       kRip,
       {},
       [](const Images& images, const Pixel& pixel, Cost& cost) {
         return rip_polygon_filter(images.rip, pixel.polygon_middle, pixel.lookup, cost);
       },
       Pyramid::kRip},
      {"rip_pixel",
       "four images of fitting ratio for each pixel",
       kRip,
       {},
       [](const Images& images, const Pixel& pixel, Cost& cost) {
         return rip_pixel_filter(images.rip, pixel.lookup, cost);
       },
       Pyramid::kRip},
  };
  add_vertex_based(all);
  all.push_back({"texram",
                 "2^n equal probes on a short line",
                 kFeline,
                 {},
                 [](const Images& images, const Pixel& pixel, Cost& cost) {
                   return texram_filter(images.lanczos, kMaxProbes, pixel.lookup, cost);
                 }});
  add_feline(all);
  all.push_back({"feline_ideal_circles",
                 "the line of feline_ideal, with circles of texels for probes",
                 kFeline,
                 {},
                 [](const Images& images, const Pixel& pixel, Cost& cost) {
                   return feline_circles_filter(images.lanczos, kExact, pixel.lookup, cost);
                 }});
  all.push_back(ewa_row("ewa", "every texel inside the ellipse, mip-mapped", EwaParameters{}));
  all.push_back(ewa_row("ewa_level0", "every texel of level 0 inside the ellipse, of which 2^18 are the most",
                        EwaParameters{false, 0}));
  return all;
}

}  // namespace

std::span<const Filter> filters() {
  static const std::vector<Filter> all = make_filters();
  return all;
}

const Filter* find_filter(std::string_view name) {
  const auto found = std::ranges::find(filters(), name, &Filter::name);
  return found == filters().end() ? nullptr : &*found;
}

}  // namespace feline::reference
