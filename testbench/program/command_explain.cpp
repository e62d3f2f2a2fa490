// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "testbench/error.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/explanation.h"

namespace feline {
namespace {

struct ExplainOptions {
  SubjectOptions subject;
  SamplerChoice sampler;
  std::vector<double> derivatives;
  std::vector<double> position{0.5, 0.5};
  const CLI::Option* position_option = nullptr;
  std::vector<int> pixel;
  bool json = false;
};

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
  const SamplerOptions choice = options.sampler.one();
  Subject subject;
  Lookup lookup;
  if (options.derivatives.empty()) {
    refuse_given(std::array{options.position_option}, "without --derivatives");
    subject = options.subject.load(mip_edge(choice));
    lookup = pixel_lookup(options, subject);
  } else {
    options.subject.check_texture_only();
    subject = options.subject.texture.empty() ? blank_subject(options.subject) : Subject{};
    if (!options.subject.texture.empty()) {
      subject.texture = options.subject.load_texture_only(mip_edge(choice));
      subject.memory = layout_texture(subject.texture);
    }
    const double width = subject.texture.levels.front().width;
    const double height = subject.texture.levels.front().height;
    lookup = {static_cast<float>(options.position[0]),
              static_cast<float>(options.position[1]),
              static_cast<float>(options.derivatives[0] / width),
              static_cast<float>(options.derivatives[1] / height),
              static_cast<float>(options.derivatives[2] / width),
              static_cast<float>(options.derivatives[3] / height)};
  }
  const Explanation explanation = explain(lookup, subject, choice);
  fmt::print("{}", options.json ? to_json(explanation).dump(1) + "\n" : to_text(explanation));
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
      ->expected(4)
      ->check(float32());
  options->position_option =
      command->add_option("--position", options->position, "s,t of the lookup, with --derivatives")
          ->delimiter(',')
          ->expected(2)
          ->check(float32());
  command->add_option("--pixel", options->pixel, "X,Y in a scene or G-buffer")
      ->delimiter(',')
      ->expected(2)
      ->check(whole_number(0, kMaxImageSize - 1))
      ->excludes("--derivatives");
  options->subject.add_to(*command, true);
  options->sampler.add_to(*command, false);
  command->add_flag("--json", options->json, "the same as JSON");
  command->callback([options, &exit_code] { exit_code = run_explain(*options); });
}

}  // namespace feline
