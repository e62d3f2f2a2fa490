// SPDX-License-Identifier: Apache-2.0
// What a command makes of its sampler's and its frames' options, one argument a line: samplers that the unit takes.
#include <CLI/CLI.hpp>

#include "testbench/program/frames.h"
#include "testbench/program/subject.h"
#include "tests/fuzz/fuzz.h"

namespace feline {
namespace {

const Texture& texture() {
  static const Texture made{TexelFormat::kR8, false, {{2, 2, {0, 1, 2, 3}}, {1, 1, {1}}}};
  return made;
}

std::vector<std::string> arguments_of(fuzz::Input& input) {
  std::vector<std::string> arguments;
  while (!input.rest().empty()) arguments.emplace_back(input.part('\n'));
  // CLI11 takes the last first.
  std::ranges::reverse(arguments);
  return arguments;
}

void check_samplers(const SamplerChoice& choice) {
  static const TextureMemory memory = layout_texture(texture());
  fuzz::accepts([&] {
    for (const SamplerOptions& options : choice.combinations()) {
      wrap_name(options);
      prepare_sampler(options, texture(), memory);
    }
  });
  fuzz::accepts([&] { choice.random_choices(); });
  fuzz::accepts([&] { choice.check_filter(); });
}

void check_view(const SubjectOptions& subject) {
  fuzz::accepts([&] { subject.check_random(); });
  fuzz::accepts([&] { subject.check_texture_only(); });
  fuzz::accepts([&] {
    const Size size = parse_size("--size", subject.size);
    fuzz::require(size.width >= 1 && size.width <= kMaxImageSize && size.height >= 1 && size.height <= kMaxImageSize,
                  "parse_size: sides of 1 to kMaxImageSize");
  });
}

template <typename Add, typename Check>
void parse(const std::vector<std::string>& arguments, Add add, Check check) {
  CLI::App command("command");
  add(command);
  if (fuzz::accepts<CLI::ParseError>([&] { command.parse(std::vector<std::string>(arguments)); })) check();
}

}  // namespace
}  // namespace feline

void feline::fuzz::run(Input input) {
  const std::size_t kind = input.choose(4);
  const std::vector<std::string> arguments = arguments_of(input);
  if (kind == 3) {
    FrameOptions frames;
    parse(
        arguments, [&](CLI::App& command) { frames.add_to(command); },
        [&] {
          // Names of files may be too long for the system.
          accepts<std::filesystem::filesystem_error>([&] {
            accepts([&] {
              frames.check();
              frames.visits();
            });
          });
        });
  } else if (kind == 2) {
    SubjectOptions subject;
    parse(
        arguments, [&](CLI::App& command) { subject.add_to(command, true); }, [&] { check_view(subject); });
  } else {
    SamplerChoice sampler;
    parse(
        arguments, [&](CLI::App& command) { sampler.add_to(command, kind == 1); }, [&] { check_samplers(sampler); });
  }
}
