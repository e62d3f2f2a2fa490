// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "model/unit.h"
#include "tables/emit.h"
#include "testbench/error.h"
#include "testbench/program/commands.h"
#include "testbench/program/subject.h"

namespace feline {
namespace {

struct ExplainOptions {
  SubjectOptions subject;
  SamplerChoice sampler;
  std::vector<double> derivatives;
  std::vector<double> position{0.5, 0.5};
  std::vector<int> pixel;
};

// The ellipse of the two gradients, in double precision: Feline 2.1 and 3.1, without its clamps and probe limit.
struct IdealEllipse {
  double major, minor, degrees;
  double probes() const { return std::floor(2 * std::max(major, 1.0) / std::max(minor, 1.0) - 1 + 0.5); }
};

IdealEllipse ideal_ellipse(double dudx, double dvdx, double dudy, double dvdy) {
  // Singular values of the Jacobian; the larger comes first, the smaller from the determinant, which does not cancel.
  const double e = (dudx * dudx + dudy * dudy + dvdx * dvdx + dvdy * dvdy) / 2;
  const double f = (dudx * dudx + dudy * dudy - dvdx * dvdx - dvdy * dvdy) / 2;
  const double g = dudx * dvdx + dudy * dvdy;
  const double major = std::sqrt(e + std::hypot(f, g));
  const double minor = major == 0 ? 0 : std::abs(dudx * dvdy - dvdx * dudy) / major;
  constexpr double kDegrees = 57.29577951308232;
  return {major, minor, std::atan2(g, f) / 2 * kDegrees};
}

template <typename Beat>
void print_beat(const Beat& beat) {
  fmt::print("{}\n", Beat::kName.view());
  for (const FieldValue& value : field_values(beat)) {
    const std::uint64_t mask = (std::uint64_t{1} << value.format.width()) - 1;
    fmt::print("  {:<24}0x{:<14x}{:<22}{}, {}\n", value.name, static_cast<std::uint64_t>(value.raw) & mask,
               fmt::format("{:.12g}", value.format.value(value.raw)), notation(value.format), value.format.unit.view());
  }
}

void print_request(const Lookup& lookup) {
  fmt::print("request\n");
  const std::pair<const char*, float> operands[] = {{"s", lookup.s},       {"t", lookup.t},
                                                    {"dsdx", lookup.dsdx}, {"dtdx", lookup.dtdx},
                                                    {"dsdy", lookup.dsdy}, {"dtdy", lookup.dtdy}};
  for (const auto& [name, value] : operands) {
    fmt::print("  {:<24}0x{:08x}      {:<22}float32\n", name, std::bit_cast<std::uint32_t>(value),
               fmt::format("{:.9g}", value));
  }
}

double percent(double got, double want) { return want == 0 ? 0 : 100 * (got / want - 1); }

void print_comparison(const Lookup& lookup, const Subject& subject, const SamplerChoice& choice) {
  const double width = subject.texture.levels.front().width;
  const double height = subject.texture.levels.front().height;
  const IdealEllipse ideal =
      ideal_ellipse(lookup.dsdx * width, lookup.dtdx * height, lookup.dsdy * width, lookup.dtdy * height);
  fmt::print("\n{:<10}{:>14}{:>9}{:>14}{:>9}{:>12}{:>8}{:>8}\n", "footprint", "major, texels", "error", "minor, texels",
             "error", "degrees", "probes", "level");
  const double level =
      std::log2(std::max({ideal.minor, 1.0, 2 * std::max(ideal.major, 1.0) / (choice.max_probes + 1)}));
  fmt::print("{:<10}{:>14.3f}{:>9}{:>14.3f}{:>9}{:>12.2f}{:>8g}{:>8.3f}\n", "ideal", ideal.major, "", ideal.minor, "",
             ideal.degrees, ideal.probes(), level);
  SamplerOptions options = choice.one();
  for (const Mode mode : {Mode::kTrilinear, Mode::kExt, Mode::kSimple, Mode::kTable}) {
    options.mode = mode;
    const auto sampler = prepare_sampler(options, subject.texture, subject.memory);
    const auto shaped =
        footprint<kDefaultConfig>(group<kDefaultConfig>(make_request<kDefaultConfig>(lookup, 0), sampler), sampler);
    const auto planned = plan<kDefaultConfig>(shaped, sampler);
    const double unit = std::ldexp(1.0, static_cast<int>(shaped.exponent.raw()));
    const double major = shaped.major_radius.value() * unit;
    const double minor = shaped.minor_radius.value() * unit;
    const double degrees = std::atan2(shaped.major_v.value(), shaped.major_u.value()) * 57.29577951308232;
    fmt::print("{:<10}{:>14.3f}{:>8.2f}%{:>14.3f}{:>8.2f}%{:>12.2f}{:>8}{:>8.3f}\n",
               kModeNames[static_cast<std::size_t>(mode)], major, percent(major, ideal.major), minor,
               percent(minor, ideal.minor), degrees, planned.probes.raw(), planned.level_of_detail.value());
  }
}

// A texture for derivatives given by hand: their size is --size, and what is in it does not matter.
Subject blank_subject(const SubjectOptions& options) {
  const Size size = parse_size("--size", options.size);
  Subject subject;
  subject.name = "derivatives";
  subject.texture.format = TexelFormat::kR8;
  for (int k = 0; k < mip_count(size.width, size.height); ++k) {
    const int width = mip_size(size.width, k);
    const int height = mip_size(size.height, k);
    subject.texture.levels.push_back(
        {width, height,
         std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 128)});
  }
  subject.memory = layout_texture(subject.texture);
  return subject;
}

Lookup pixel_lookup(const ExplainOptions& options, const Subject& subject) {
  const GBuffer& gbuffer = subject.gbuffer;
  if (options.pixel.empty()) bad_input("command line", "--pixel", "nothing", "X,Y, or --derivatives instead");
  const int x = options.pixel[0];
  const int y = options.pixel[1];
  if (x < 0 || y < 0 || x >= gbuffer.width || y >= gbuffer.height) {
    bad_input("command line", "--pixel", fmt::format("{},{}", x, y),
              fmt::format("0,0 to {},{}", gbuffer.width - 1, gbuffer.height - 1));
  }
  return gbuffer
      .lookups[static_cast<std::size_t>(y) * static_cast<std::size_t>(gbuffer.width) + static_cast<std::size_t>(x)];
}

int run_explain(const ExplainOptions& options) {
  Subject subject;
  Lookup lookup;
  if (options.derivatives.empty()) {
    subject = options.subject.load();
    lookup = pixel_lookup(options, subject);
  } else {
    subject = options.subject.texture.empty() ? blank_subject(options.subject) : options.subject.load();
    const double width = subject.texture.levels.front().width;
    const double height = subject.texture.levels.front().height;
    lookup = {static_cast<float>(options.position[0]),
              static_cast<float>(options.position[1]),
              static_cast<float>(options.derivatives[0] / width),
              static_cast<float>(options.derivatives[1] / height),
              static_cast<float>(options.derivatives[2] / width),
              static_cast<float>(options.derivatives[3] / height)};
  }
  const auto sampler = prepare_sampler(options.sampler.one(), subject.texture, subject.memory);
  print_request(lookup);
  sample<kDefaultConfig>(make_request<kDefaultConfig>(lookup, 0), sampler, subject.memory,
                         [&]<typename Beat>(const Beat& beat) {
                           if constexpr (!std::is_same_v<Beat, RequestBeat<kDefaultConfig>>) print_beat(beat);
                         });
  print_comparison(lookup, subject, options.sampler);
  return kHolds;
}

}  // namespace

void add_explain(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = program.add_subcommand("explain", "one lookup: every stage, every field, and the ideal ellipse");
  command->footer(
      "Example: feline explain --derivatives 13,0,12,5 --size 256x256\n"
      "Example: feline explain --scene bricks --size 512 --pixel 100,40 --mode simple");
  command
      ->add_option("--derivatives", options->derivatives,
                   "du/dx,dv/dx,du/dy,dv/dy in texels a pixel; --size is then the texture's")
      ->delimiter(',')
      ->expected(4);
  command->add_option("--position", options->position, "s,t of the lookup, with --derivatives")
      ->delimiter(',')
      ->expected(2);
  command->add_option("--pixel", options->pixel, "X,Y in a scene or G-buffer")
      ->delimiter(',')
      ->expected(2)
      ->excludes("--derivatives");
  command->add_option("--scene", options->subject.scene, "built-in scene");
  options->subject.add_to(*command);
  options->sampler.add_to(*command, false);
  command->callback([options, &exit_code] {
    options->subject.periodic = options->sampler.repeats();
    exit_code = run_explain(*options);
  });
}

}  // namespace feline
