// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "tables/emit.h"
#include "testbench/atomic_file.h"
#include "testbench/cosim/random_batches.h"
#include "testbench/error.h"
#include "testbench/program/commands.h"
#include "testbench/program/subject.h"

namespace feline {
namespace {

struct VectorsOptions {
  SubjectOptions subject;
  SamplerChoice sampler;
  std::string stage = "unit";
  std::optional<std::uint64_t> random;
  std::uint64_t seed = 1;
  std::string output = ".";
  bool json = false;
};

std::string hex_line(std::span<const std::uint32_t> words, int width) {
  std::string digits;
  for (std::size_t i = words.size(); i-- > 0;) digits += fmt::format("{:08x}", words[i]);
  return digits.substr(digits.size() - static_cast<std::size_t>((width + 3) / 4)) + "\n";
}

template <typename Beat>
std::string packed_line(const Beat& beat) {
  std::array<std::uint32_t, beat_words<Beat>()> words{};
  pack(beat, words);
  return hex_line(words, beat_width<Beat>());
}

// Comments that a reader of the file needs; $readmemh skips them.
template <typename Beat>
std::string header(std::uint64_t seed) {
  std::string text = fmt::format("// {} beats, {} bits, highest first; fingerprint {:016x}, seed {}\n//",
                                 Beat::kName.view(), beat_width<Beat>(), fingerprint<kUnit>(), seed);
  for_each_shape<Beat>([&](Name name, const Format& format, int count, bool is_array) {
    text += fmt::format(" {}{}:{}", name.view(), is_array ? fmt::format("[{}]", count) : "", notation(format));
  });
  return text + "\n";
}

using Files = std::map<std::string, std::string>;

template <typename Beat>
void append(Files& files, std::uint64_t seed, const Beat& beat) {
  std::string& text = files[std::string(Beat::kName.view())];
  if (text.empty()) text = header<Beat>(seed);
  text += packed_line(beat);
}

void append_batch(Files& files, std::uint64_t seed, const Batch& batch) {
  append(files, seed, batch.sampler);
  for (std::size_t i = 0; i < batch.lookups.size(); ++i) {
    sample<kUnit>(make_request<kUnit>(batch.lookups[i], static_cast<std::int64_t>(batch.first_lookup + i)),
                  batch.sampler, *batch.memory, [&](const auto& beat) { append(files, seed, beat); });
  }
}

std::string memory_text(const TextureMemory& memory) {
  std::string text = "// memory lines of 64 bytes, byte 63 first\n";
  for (std::size_t line = 0; line < memory.lines(); ++line) {
    const auto bytes = memory.line(static_cast<std::int64_t>(line));
    for (std::size_t i = bytes.size(); i-- > 0;) text += fmt::format("{:02x}", bytes[i]);
    text += '\n';
  }
  return text;
}

// The files that a stage's bench needs: what goes in, what comes out, and the state.
std::vector<std::string> wanted_files(const std::string& stage) {
  if (stage == "unit") return {};
  const std::size_t index = parse_name("--stage", stage, kStageNames);
  std::vector<std::string> wanted{"sampler", index == 0 ? "request" : std::string(kStageNames[index - 1]), stage};
  if (stage == "fetch") wanted.emplace_back("memory");
  return wanted;
}

int run_vectors(const VectorsOptions& options) {
  const std::vector<std::string> wanted = wanted_files(options.stage);
  const std::filesystem::path directory = options.output;
  if (!std::filesystem::is_directory(directory)) {
    bad_input(options.output, "--output", "no directory", "a directory that exists");
  }
  Files files;
  if (options.random) {
    options.subject.check_random();
    // One sampler and texture: a simulator without a driver loads its state once.
    RandomBatches batches(options.seed, *options.random);
    batches.set_choices(options.sampler.random_choices());
    const Batch batch = batches.make(0, *options.random);
    append_batch(files, options.seed, batch);
    files["memory"] = memory_text(*batch.memory);
  } else {
    const Subject subject = options.subject.load();
    const auto sampler = prepare_sampler(options.sampler.one(), subject.texture, subject.memory);
    append_batch(files, options.seed, {sampler, &subject.memory, subject.gbuffer.lookups, 0});
    files["memory"] = memory_text(subject.memory);
  }
  nlohmann::ordered_json json{{"stage", options.stage}, {"fingerprint", fmt::format("{:016x}", fingerprint<kUnit>())}};
  if (options.random) json["seed"] = options.seed;
  for (const auto& [name, text] : files) {
    if (!wanted.empty() && std::ranges::find(wanted, name) == wanted.end()) continue;
    const auto path = directory / (name + ".hex");
    write_file_atomically(path, text);
    json["files"][name] = path.string();
    if (!options.json) fmt::print("{}\n", path.string());
  }
  if (options.json) fmt::print("{}\n", json.dump(1));
  return kHolds;
}

}  // namespace

void add_vectors(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<VectorsOptions>();
  CLI::App* command = program.add_subcommand("vectors", "golden vectors of a stage or of the unit, for any simulator");
  command->footer(
      "Writes one $readmemh file a stage boundary, beats in order: request, group, ... accumulate, and\n"
      "sampler and memory. Field layout: feline_pkg.sv and the first lines of each file.\n"
      "Example: feline vectors --stage plan --random 1000 --mode table --output /tmp");
  command->add_option("--stage", options->stage, "a stage, or unit for all boundaries")->capture_default_str();
  command->add_option("--random", options->random,
                      "so many random and directed lookups under a random sampler, instead of a scene");
  command->add_option("--seed", options->seed, "of the random lookups")->capture_default_str();
  command->add_option("--output", options->output, "directory for the files")->capture_default_str();
  command->add_flag("--json", options->json, "tell what was written as JSON");
  command->add_option("--scene", options->subject.scene, "built-in scene");
  options->subject.add_to(*command);
  options->sampler.add_to(*command, false);
  command->callback([options, &exit_code] {
    options->subject.periodic = options->sampler.repeats();
    exit_code = run_vectors(*options);
  });
}

}  // namespace feline
