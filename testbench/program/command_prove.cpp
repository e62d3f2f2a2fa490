// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>

#include "tables/unit.h"
#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/prove/campaign.h"
#include "testbench/run_lock.h"

namespace feline {
namespace {

struct ProveOptions {
  std::string leaves;
  std::string proofs;
  std::string shard = "0/1";
  std::string output = "feline-prove";
  std::string source = FELINE_SOURCE_DIR;
  std::string against;
  std::vector<std::string> check;
  std::string merge;
  bool list = false;
  bool json = false;
};

// The exact arithmetic is written for these numbers.
constexpr bool is_default_unit() {
  return kUnit.mantissa_bits == 8 && kUnit.exponent_bits == 6 && kUnit.table_rows == 16 && kUnit.table_columns == 16 &&
         kUnit.entry_bits == 8 && kUnit.subtexel_bits == 8 && kUnit.level_fraction_bits == 8 &&
         kUnit.weight_bits == 8 && kUnit.factor_bits == 8 && kUnit.reciprocal_bits == 16 && kUnit.line_bits == 12 &&
         kUnit.size_reciprocal_bits == 15 && kUnit.max_size_log2 == 14 && kUnit.guard_bits == 2 &&
         kUnit.channel_fraction_bits == 4 && kUnit.pixel_fraction_bits == 8 && kUnit.max_probes == 16 &&
         kUnit.max_levels == 16 && kUnit.least_range_log2 == 0 && kUnit.features == Features{} &&
         kUnit.table_cells == decltype(kUnit.table_cells){} && kUnit.weight_rows == decltype(kUnit.weight_rows){};
}

// Names of leaves, or of stages for all of theirs.
std::vector<const prove::Leaf*> chosen_leaves(const std::string& text) {
  std::vector<const prove::Leaf*> leaves;
  const std::vector<std::string> names = text == "all" ? std::vector<std::string>{} : split_list("--leaf", text);
  std::vector<bool> used(names.size(), false);
  for (const prove::Leaf& leaf : prove::all_leaves()) {
    bool wanted = names.empty();
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] != leaf.name && names[i] != leaf.stage()) continue;
      wanted = used[i] = true;
    }
    if (wanted) leaves.push_back(&leaf);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!used[i]) bad_input("command line", "--leaf", names[i], "all, a stage, or leaves of feline prove --list");
  }
  return leaves;
}

std::vector<const prove::Proof*> chosen_proofs(const std::string& text) {
  std::vector<std::string_view> names;
  for (const prove::Proof& proof : prove::all_proofs()) names.push_back(proof.name);
  std::vector<const prove::Proof*> proofs;
  if (text == "all") {
    for (const prove::Proof& proof : prove::all_proofs()) proofs.push_back(&proof);
    return proofs;
  }
  for (const std::string& name : split_list("--proof", text)) {
    proofs.push_back(&prove::all_proofs()[parse_name("--proof", name, names)]);
  }
  return proofs;
}

// What is to be proved: all, unless leaves or proofs are named; then these.
struct Chosen {
  std::vector<const prove::Leaf*> leaves;
  std::vector<const prove::Proof*> proofs;
};
Chosen choose(const ProveOptions& options) {
  const bool names_none = options.leaves.empty() && options.proofs.empty();
  Chosen chosen;
  if (names_none || !options.leaves.empty()) chosen.leaves = chosen_leaves(names_none ? "all" : options.leaves);
  if (names_none || !options.proofs.empty()) chosen.proofs = chosen_proofs(names_none ? "all" : options.proofs);
  return chosen;
}

void print_errors(const prove::Leaf& leaf, const prove::LeafCertificate& certificate) {
  for (std::size_t k = 0; k < certificate.worst.size(); ++k) {
    const prove::Worst& worst = certificate.worst[k];
    if (worst.value < 0) continue;
    std::vector<std::uint64_t> lane(leaf.input_words);
    leaf.domain.fill(worst.input, 1, lane.data());
    fmt::print("  {}: {:.6g} {} at {}\n", leaf.quantities[k].name, leaf.quantities[k].present(worst.value),
               leaf.quantities[k].unit, prove::describe_lane(leaf.inputs, lane.data()));
  }
}

int run_list(const Chosen& chosen) {
  for (const prove::Leaf* const leaf : chosen.leaves) {
    fmt::print("{:<24} {:>13} inputs, {}\n", leaf->name, leaf->domain.count, leaf->domain.text);
  }
  for (const prove::Proof* const proof : chosen.proofs) {
    fmt::print("{:<24} {:>20}, {}\n", proof->name, "proof", proof->claim);
  }
  return kHolds;
}

void check_fingerprint(const prove::Certificate& certificate, const std::string& file) {
  const std::string ours = prove::empty_certificate("").fingerprint;
  if (certificate.fingerprint != ours) {
    bad_input(file, "fingerprint", certificate.fingerprint, ours + ", as this program has it");
  }
}

int run_check(const ProveOptions& options, const Chosen& chosen) {
  const prove::LeafSynthesis synthesis(prove::read_sources(options.source), options.source);
  prove::Certificate merged = prove::read_certificate(options.check.front());
  check_fingerprint(merged, options.check.front());
  for (std::size_t i = 1; i < options.check.size(); ++i) {
    merged.merge(prove::read_certificate(options.check[i]), options.check[i]);
  }
  if (!options.merge.empty()) write_file_atomically(options.merge, prove::to_json(merged).dump(1) + "\n");
  const std::vector<std::string> missing = prove::missing_from(merged, chosen.leaves, chosen.proofs, &synthesis);
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"missing", missing}}.dump(1));
  } else {
    for (const std::string& line : missing) fmt::print("missing: {}\n", line);
    if (missing.empty()) {
      fmt::print("complete: {} leaves, every input, 0 mismatches; {} proofs\n", chosen.leaves.size(),
                 chosen.proofs.size());
    }
  }
  return missing.empty() ? kHolds : kBroken;
}

int run_prove(const ProveOptions& options, const Chosen& chosen) {
  if constexpr (!is_default_unit()) {
    throw InputError("tables/config.h: exact arithmetic is written for the default configuration: legal is that one");
  }
  const std::optional<prove::Shard> shard = prove::parse_shard(options.shard);
  if (!shard) bad_input("command line", "--shard", options.shard, "I/N, 0 <= I < N");
  std::optional<prove::Certificate> against;
  if (!options.against.empty()) {
    against = prove::read_certificate(options.against);
    check_fingerprint(*against, options.against);
  }
  const prove::LeafSynthesis synthesis(prove::read_sources(options.source), options.source);
  synthesis.version();
  const std::filesystem::path directory = options.output;
  prepare_directory(options.output, {"certificate.json", "journal.jsonl"});
  const RunLock lock(directory / "lock");
  const Cache cache(directory / "cache");
  const auto start = std::chrono::steady_clock::now();
  prove::Campaign campaign =
      prove::run_campaign(chosen.leaves, *shard, synthesis, cache, directory, against ? &*against : nullptr);
  const auto write_certificate = [&] {
    nlohmann::ordered_json json = prove::to_json(campaign.certificate);
    write_file_atomically(directory / "certificate.json", json.dump(1) + "\n");
    return json;
  };
  write_certificate();
  prove::run_proofs(chosen.proofs, *shard, synthesis, cache, against ? &*against : nullptr, campaign);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const nlohmann::ordered_json json = write_certificate();
  if (options.json) {
    fmt::print("{}\n", json.dump(1));
  } else {
    for (const prove::Leaf* const leaf : chosen.leaves) {
      const prove::LeafCertificate& certificate = campaign.certificate.leaves.at(leaf->name);
      fmt::print("{:<24} {:>13} inputs, {} of {} chunks, {} mismatches{}\n", leaf->name, leaf->domain.count,
                 certificate.digests.size(), leaf->chunks(), certificate.mismatch_count(),
                 certificate.is_complete(*leaf) ? ", digest " + certificate.digest() : "");
      if (const auto it = campaign.work.find(leaf->name); it != campaign.work.end()) {
        fmt::print("  {:.1f} ns an input on one processor\n",
                   it->second.seconds * 1e9 / static_cast<double>(it->second.inputs));
      }
      print_errors(*leaf, certificate);
    }
    for (const auto& [name, hash] : campaign.certificate.proofs) {
      const auto it = campaign.proof_seconds.find(name);
      fmt::print("{:<24} proved, and its controls found{}\n", name,
                 it == campaign.proof_seconds.end() ? "" : fmt::format(", {:.1f} s", it->second));
    }
    std::uint64_t inputs = 0;
    for (const auto& [name, work] : campaign.work) inputs += work.inputs;
    fmt::print("{} inputs by model, RTL, netlist and exact arithmetic in {:.0f} s; {} chunks were done before\n",
               inputs, seconds, campaign.resumed);
  }
  for (const std::string& text : campaign.disagreements) fmt::print(options.json ? stderr : stdout, "{}", text);
  return campaign.disagreements.empty() ? kHolds : kBroken;
}

}  // namespace

void add_prove(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ProveOptions>();
  CLI::App* command = program.add_subcommand(
      "prove",
      "enumerates every arithmetic leaf: RTL, netlist and model against exact arithmetic; proves the rest by SAT");
  command->footer(
      "Writes certificate.json, with all that this program has proved of these sources in the directory; goes on\n"
      "where it was stopped. Two engines evaluate the RTL: Verilator's code, and the netlist that Yosys makes, 8192\n"
      "inputs at once (Debian package yosys).\n"
      "Example: feline prove --leaf footprint --output proof; feline prove --check proof/certificate.json");
  command->add_option("--leaf", options->leaves,
                      "leaves or stages, with a comma between, or all; without it and --proof everything is proved");
  command->add_option("--proof", options->proofs, "proofs of all inputs at once, with a comma between, or all");
  command->add_option("--shard", options->shard, "I/N: every N-th chunk and proof, from the I-th")
      ->capture_default_str();
  command->add_option("--output", options->output, "directory for certificate and journal")->capture_default_str();
  command->add_option("--source", options->source, "sources of netlists and proofs, with rtl/")->capture_default_str();
  command->add_option("--against", options->against, "a certificate whose digests must come out again");
  auto* const check =
      command->add_option("--check", options->check, "certificates: what they lack, together, to prove all of --source")
          ->expected(1, 1000);
  for (const char* const other : {"--shard", "--output", "--against"}) check->excludes(command->get_option(other));
  command->add_option("--merge", options->merge, "with --check: writes all of them as one")->needs(check);
  auto* const list =
      command->add_flag("--list", options->list, "the leaves and proofs, and what they cover")->excludes(check);
  for (const char* const other : {"--shard", "--output", "--against"}) list->excludes(command->get_option(other));
  command->add_flag("--json", options->json, "the certificate, or what is missing, as JSON")->excludes(list);
  command->callback([options, &exit_code] {
    const Chosen chosen = choose(*options);
    exit_code = options->list             ? run_list(chosen)
                : !options->check.empty() ? run_check(*options, chosen)
                                          : run_prove(*options, chosen);
  });
}

}  // namespace feline
