// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/subject.h"
#include "testbench/shortcut_study.h"

namespace feline {
namespace {

struct ShortcutOptions {
  SubjectOptions subject;
  SamplerChoice sampler;
  int runs = 5;
  bool json = false;
};

// The row of a shortcut alone tells what it saved; the others tell nothing of the kind.
nlohmann::ordered_json to_json(const ShortcutStudy::Row& row, const ShortcutName* shortcut) {
  nlohmann::ordered_json json{{"name", row.name},
                              {"nanoseconds_a_pixel", row.nanoseconds},
                              {"times_plain", row.of_plain},
                              {"times_straight", row.of_straight},
                              {"same_bits", row.same}};
  if (shortcut != nullptr) {
    json["saved"] = row.counts.*shortcut->saved;
    json["unit"] = shortcut->unit;
  }
  return json;
}

std::string to_line(const ShortcutStudy::Row& row, const ShortcutName* shortcut) {
  const std::string saved =
      shortcut == nullptr ? "" : fmt::format("  {} {}", row.counts.*shortcut->saved, shortcut->unit);
  return fmt::format("{:<18} {:>9.1f} {:>12.2f} {:>15.2f}  {:<4}{}\n", row.name, row.nanoseconds, row.of_plain,
                     row.of_straight, row.same ? "same" : "DIFFER", saved);
}

int run_shortcuts(const ShortcutOptions& options) {
  const SamplerOptions choice = options.sampler.one();
  const Subject subject = options.subject.load(mip_edge(choice));
  const auto sampler = prepare_sampler(choice, subject);
  const ShortcutStudy study = study_shortcuts(subject.gbuffer, sampler, subject.memory, options.runs);
  nlohmann::ordered_json json{{"scene", subject.name},
                              {"width", subject.gbuffer.width},
                              {"height", subject.gbuffer.height},
                              {"mode", kModeNames[static_cast<std::size_t>(choice.mode)]},
                              {"runs", options.runs},
                              {"probes", study.straight.counts.probes},
                              {"same_bits", study.same()}};
  std::string text = fmt::format(
      "{}, {} x {}, mode {}, {} probes, {} runs\n{:<18} {:>9} {:>12} {:>15}  bits  left out\n", subject.name,
      subject.gbuffer.width, subject.gbuffer.height, kModeNames[static_cast<std::size_t>(choice.mode)],
      study.straight.counts.probes, options.runs, "shortcuts", "ns/pixel", "times plain", "times straight");
  const auto add = [&](const ShortcutStudy::Row& row, const ShortcutName* shortcut) {
    json["rows"].push_back(to_json(row, shortcut));
    text += to_line(row, shortcut);
  };
  add(study.plain, nullptr);
  add(study.straight, nullptr);
  for (std::size_t i = 0; i < study.single.size(); ++i) add(study.single[i], &kShortcutNames[i]);
  add(study.all, nullptr);
  fmt::print("{}", options.json ? json.dump(1) + "\n" : text);
  return study.same() ? kHolds : kBroken;
}

}  // namespace

void add_shortcuts(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ShortcutOptions>();
  CLI::App* command =
      program.add_subcommand("shortcuts", "what the model saves by leaving out what a lookup does not need");
  command->footer(
      "plain: stage by stage. straight: the stages run into each other, nothing else left out; each shortcut alone is\n"
      "added to that. Exit code 1 if a bit of a picture or plan differs from the plain one's.\n"
      "Example: feline shortcuts --scene bricks --size 512");
  options->subject.add_to(*command, true);
  options->sampler.add_to(*command, false);
  command->add_option("--runs", options->runs, "each times everything once; medians are told")
      ->check(whole_number(1, 1000))
      ->capture_default_str();
  command->add_flag("--json", options->json, "the figures as JSON");
  command->callback([options, &exit_code] { exit_code = run_shortcuts(*options); });
}

}  // namespace feline
