// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/proof.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <chrono>

#include "testbench/area/yosys.h"
#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/text_file.h"

namespace feline::prove {
namespace {

// Seconds until ABC gives up.
constexpr int kPatience = 600;
// It looks at the time in places only.
constexpr int kGrace = 60;

constexpr std::string_view kNeed = "proofs need it";

// How ABC is asked about a circuit {0} for {1} seconds at most, and what it then says.
struct Engine {
  std::string_view name;
  std::string_view commands;
  std::string_view never;
  std::string_view begins;  // also said, of the first cycles alone
  std::string_view sometimes;
};
constexpr Engine kEngines[]{
    {"abc &cec", "&r {0}; &cec -m -C 1000000000 -T {1}", "Networks are equivalent", "", "NOT EQUIVALENT"},
    {"abc pdr", "read_aiger {0}; strash; scleanup; scorr; pdr -T {1}", "Property proved", "", "was asserted in frame"},
    {"abc ind", "read_aiger {0}; strash; scleanup; scorr; bmc3 -F 3 -T {1}; ind -F 2 -T {1}", "Networks are equivalent",
     "No output asserted in 3 frames", "was asserted in frame"},
};

// Verilog {0} of a proof {1} as a circuit {3}; registers begin at zero, or {2} is empty.
constexpr std::string_view kCircuit =
    "read_verilog -sv -noautowire \"{0}\"\nhierarchy -check -top feline_proof_{1}\nproc\nflatten\nopt -full\n"
    "memory_map\nopt\ndffunmap\nsetundef -zero -undriven\nsetundef -zero\ntechmap\nopt -fast\ndffunmap\n"
    "setundef -zero\naigmap\nopt_clean -purge\nwrite_aiger {2} \"{3}\"";
std::string_view aiger_option(const Proof& proof) {
  return proof.method == Proof::Method::kEquivalence ? "" : "-zinit";
}

enum class Answer { kNever, kSometimes, kUnknown };

std::string proof_text(const Proof& proof, const LeafSynthesis& synthesis, const Proof::Control* control) {
  return synthesis.proof_text(proof.name, control, proof.registers == Proof::Registers::kWires);
}

// Whether broken_o can be 1 in this Verilog; `said` is what ABC says of it.
Answer ask(const Proof& proof, const std::string& verilog, std::string& said) {
  const std::filesystem::path work = std::filesystem::temp_directory_path();
  const AtomicFile source(work / "feline-proof.sv");
  const AtomicFile circuit(work / "feline-proof.aig");
  write_text(source.temporary(), verilog);
  const Engine& engine = kEngines[static_cast<std::size_t>(proof.method)];
  const std::string script = fmt::format(fmt::runtime(kCircuit), source.temporary().string(), proof.name,
                                         aiger_option(proof), circuit.temporary().string());
  const Finished yosys = run_yosys({"-q", "-p", script}, kNeed);
  if (yosys.code != 0) throw InputError(fmt::format("yosys: exit code {}: {}", yosys.code, yosys.errors));
  const Finished abc = run_abc(fmt::format(fmt::runtime(engine.commands), circuit.temporary().string(), kPatience),
                               kNeed, kPatience + kGrace);
  said = abc.output + abc.errors;
  const auto says = [&](std::string_view text) { return said.find(text) != std::string::npos; };
  if (abc.code != 0) return Answer::kUnknown;
  if (says(engine.sometimes)) return Answer::kSometimes;
  if (says(engine.never) && says(engine.begins)) return Answer::kNever;
  return Answer::kUnknown;
}

}  // namespace

ProofResult run_proof(const Proof& proof, const LeafSynthesis& synthesis) {
  using Verdict = ProofResult::Verdict;
  const auto start = std::chrono::steady_clock::now();
  ProofResult result;
  const auto decide = [&] {
    const Answer answer = ask(proof, proof_text(proof, synthesis, nullptr), result.said);
    if (answer != Answer::kNever) return answer == Answer::kSometimes ? Verdict::kBroken : Verdict::kUndecided;
    for (const Proof::Control& control : proof.controls) {
      const Answer with_bug = ask(proof, proof_text(proof, synthesis, &control), result.said);
      if (with_bug == Answer::kSometimes) continue;
      result.said += fmt::format("control: {}: {}\n", control.file, control.mutant);
      return with_bug == Answer::kNever ? Verdict::kControlNotFound : Verdict::kUndecided;
    }
    return Verdict::kHolds;
  };
  result.verdict = decide();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::string_view method_name(const Proof& proof) { return kEngines[static_cast<std::size_t>(proof.method)].name; }

std::string proof_hash(const Proof& proof, const LeafSynthesis& synthesis) {
  std::string all = fmt::format("{} {} {} {} ", proof.name, kEngines[static_cast<std::size_t>(proof.method)].commands,
                                kCircuit, aiger_option(proof)) +
                    proof_text(proof, synthesis, nullptr);
  for (const Proof::Control& control : proof.controls) {
    proof_text(proof, synthesis, &control);
    all += fmt::format(" {} {} {}", control.file, control.original, control.mutant);
  }
  return fmt::format("{:016x}", XXH3_64bits(all.data(), all.size()));
}

}  // namespace feline::prove
