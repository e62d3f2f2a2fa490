// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "tables/emit.h"
#include "testbench/atomic_file.h"
#include "testbench/cosim/random_batches.h"
#include "testbench/error.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/subject.h"
#include "testbench/progress.h"
#include "testbench/scenes/scene.h"

namespace feline {
namespace {

struct VectorsOptions {
  SubjectOptions subject;
  SamplerChoice sampler;
  std::string stage = "unit";
  std::optional<std::uint64_t> random;
  std::uint64_t seed = 1;
  const CLI::Option* seed_option = nullptr;
  std::string output = ".";
  bool json = false;
};

// Comments that a reader of the file needs; $readmemh skips them.
template <typename Beat>
std::string header(const std::string& source) {
  std::string text = fmt::format("// {} beats, {} bits, highest first; fingerprint {:016x}, {}\n//", Beat::kName.view(),
                                 beat_width<Beat>(), fingerprint<kUnit>(), source);
  for_each_shape<Beat>([&](Name name, const Format& format, int count, bool is_array) {
    text += fmt::format(" {}{}:{}", name.view(), is_array ? fmt::format("[{}]", count) : "", notation(format));
  });
  return text + "\n";
}

void append_hex(std::string& text, std::uint32_t word, int digits) {
  for (int i = digits; i-- > 0;) text += "0123456789abcdef"[word >> (4 * i) & 15];
}

template <typename Beat>
std::string packed_line(const Beat& beat) {
  constexpr int kDigits = (beat_width<Beat>() + 3) / 4;
  std::array<std::uint32_t, beat_words<Beat>()> words{};
  pack(beat, words);
  std::string line;
  append_hex(line, words.back(), kDigits - 8 * (static_cast<int>(words.size()) - 1));
  for (std::size_t i = words.size() - 1; i-- > 0;) append_hex(line, words[i], 8);
  return line + "\n";
}

// The files of a run, those that are wanted: NAME.hex of each boundary, beat by beat as they come.
class VectorFiles {
 public:
  VectorFiles(std::filesystem::path directory, std::vector<std::string> wanted, std::string source)
      : directory_(std::move(directory)), wanted_(std::move(wanted)), source_(std::move(source)) {}

  template <typename Beat>
  void append(const Beat& beat) {
    const std::string name(Beat::kName.view());
    if (!wants(name)) return;
    const bool is_new = !files_.contains(name);
    OutputFiles::File& file = open(name);
    if (is_new) file.append(header<Beat>(source_));
    file.append(packed_line(beat));
  }

  void append_memory(const TextureMemory& memory) {
    if (!wants("memory")) return;
    OutputFiles::File& file = open("memory");
    file.append("// memory lines of 64 bytes, byte 63 first\n");
    for (std::size_t line = 0; line < memory.lines(); ++line) {
      const auto bytes = memory.line(static_cast<std::int64_t>(line));
      std::string text;
      for (std::size_t i = bytes.size(); i-- > 0;) append_hex(text, bytes[i], 2);
      file.append(text + "\n");
    }
  }

  void commit() { outputs_.commit(); }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& [name, file] : files_) names.push_back(name);
    return names;
  }
  std::filesystem::path path(const std::string& name) const { return directory_ / (name + ".hex"); }

 private:
  bool wants(const std::string& name) const {
    return wanted_.empty() || std::ranges::find(wanted_, name) != wanted_.end();
  }
  OutputFiles::File& open(const std::string& name) {
    auto& file = files_[name];
    if (file == nullptr) file = &outputs_.add(path(name));
    return *file;
  }

  std::filesystem::path directory_;
  std::vector<std::string> wanted_;  // none: all
  std::string source_;               // of the lookups: a seed or a scene
  OutputFiles outputs_;
  std::map<std::string, OutputFiles::File*> files_;
};

void append_batch(VectorFiles& files, const Batch& batch) {
  files.append(batch.sampler);
  Progress progress("writing vectors", batch.lookups.size());
  for (std::size_t i = 0; i < batch.lookups.size(); ++i) {
    sample<kUnit>(make_request<kUnit>(batch.lookups[i], static_cast<std::int64_t>(batch.first_lookup + i)),
                  batch.sampler, *batch.memory, [&](const auto& beat) { files.append(beat); });
    progress.advance(1);
  }
  files.append_memory(*batch.memory);
}

// The files that a stage's bench needs: what goes in, what comes out, and the state.
std::vector<std::string> wanted_files(const std::string& stage) {
  if (stage == "unit") return {};
  std::vector<std::string_view> legal(kStageNames.begin(), kStageNames.end());
  legal.emplace_back("unit");
  const std::size_t index = parse_name("--stage", stage, legal);
  std::vector<std::string> wanted{"sampler", index == 0 ? "request" : std::string(kStageNames[index - 1]), stage};
  if (stage == "fetch") wanted.emplace_back("memory");
  return wanted;
}

std::string scene_of(const VectorsOptions& options) {
  return options.subject.scene.empty() ? std::string(scenes().front().name) : options.subject.scene;
}

int run_vectors(const VectorsOptions& options) {
  const std::vector<std::string> wanted = wanted_files(options.stage);
  const std::filesystem::path directory = options.output;
  if (!std::filesystem::is_directory(directory)) {
    bad_input(options.output, "--output", "no directory", "a directory that exists");
  }
  check_writable(directory / "sampler.hex");
  const std::string source = options.random                    ? fmt::format("seed {}", options.seed)
                             : options.subject.gbuffer.empty() ? "scene " + scene_of(options)
                                                               : options.subject.gbuffer;
  VectorFiles files(directory, wanted, source);
  if (options.random) {
    options.subject.check_random();
    // One sampler and texture: a simulator without a driver loads its state once.
    RandomBatches batches(options.seed, *options.random);
    batches.keep_at_line_0();
    batches.set_choices(options.sampler.random_choices());
    append_batch(files, batches.make(0, *options.random));
  } else {
    refuse_given(std::array{options.seed_option}, "without --random");
    const SamplerOptions choice = options.sampler.one();
    const Subject subject = options.subject.load(mip_edge(choice));
    const auto sampler = prepare_sampler(choice, subject.texture, subject.memory);
    append_batch(files, {sampler, &subject.memory, subject.gbuffer.lookups, 0});
  }
  files.commit();
  nlohmann::ordered_json json{{"stage", options.stage}, {"fingerprint", fmt::format("{:016x}", fingerprint<kUnit>())}};
  if (options.random) json["seed"] = options.seed;
  for (const std::string& name : files.names()) {
    json["files"][name] = files.path(name).string();
    if (!options.json) fmt::print("{}\n", files.path(name).string());
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
  command
      ->add_option("--random", options->random,
                   "so many random and directed lookups under a random sampler, instead of a scene")
      ->check(whole_number(1, 1000000));
  options->seed_option = command->add_option("--seed", options->seed, "of the random lookups")
                             ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
                             ->capture_default_str();
  command->add_option("--output", options->output, "directory for the files")->capture_default_str();
  command->add_flag("--json", options->json, "tell what was written as JSON");
  options->subject.add_to(*command, true);
  options->sampler.add_to(*command, false);
  command->callback([options, &exit_code] { exit_code = run_vectors(*options); });
}

}  // namespace feline
