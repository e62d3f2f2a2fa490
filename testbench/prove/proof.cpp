// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/proof.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <chrono>

#include "testbench/area/yosys.h"
#include "testbench/atomic_file.h"
#include "testbench/error.h"

namespace feline::prove {
namespace {

// Seconds until ABC gives up.
constexpr int kPatience = 600;

constexpr std::string_view kNeed = "proofs need it";

enum class Answer { kNever, kSometimes, kUnknown };

// Whether broken_o can be 1 in this Verilog; `said` is what ABC says of it.
Answer ask(const Proof& proof, const std::string& verilog, std::string& said) {
  const std::filesystem::path work = std::filesystem::temp_directory_path();
  const AtomicFile source(work / "feline-proof.sv");
  const AtomicFile circuit(work / "feline-proof.aig");
  write_text(source.temporary(), verilog);
  const bool has_state = proof.method == Proof::Method::kReachability;
  const std::string script = fmt::format(
      "read_verilog -sv -noautowire \"{0}\"\nhierarchy -check -top feline_proof_{1}\nproc\nflatten\nopt -full\n"
      "memory_map\nopt\ndffunmap\nsetundef -zero -undriven\nsetundef -zero\ntechmap\nopt -fast\ndffunmap\n"
      "setundef -zero\naigmap\nopt_clean -purge\nwrite_aiger {2} \"{3}\"",
      source.temporary().string(), proof.name, has_state ? "-zinit" : "", circuit.temporary().string());
  const page::Finished yosys = run_yosys({"-q", "-p", script}, kNeed);
  if (yosys.code != 0) throw InputError(fmt::format("yosys: exit code {}: {}", yosys.code, yosys.errors));
  const std::string commands =
      has_state
          ? fmt::format("read_aiger {}; strash; scleanup; scorr; pdr -T {}", circuit.temporary().string(), kPatience)
          : fmt::format("&r {}; &cec -m -C 1000000000 -T {}", circuit.temporary().string(), kPatience);
  const page::Finished abc = run_abc(commands, kNeed);
  const auto says = [&](std::string_view text) { return abc.output.find(text) != std::string::npos; };
  said = abc.output + abc.errors;
  if (abc.code != 0) return Answer::kUnknown;
  if (has_state ? says("Property proved") : says("Networks are equivalent")) return Answer::kNever;
  if (has_state ? says("was asserted in frame") : says("NOT EQUIVALENT")) return Answer::kSometimes;
  return Answer::kUnknown;
}

}  // namespace

ProofResult run_proof(const Proof& proof, const LeafSynthesis& synthesis) {
  using Verdict = ProofResult::Verdict;
  const auto start = std::chrono::steady_clock::now();
  ProofResult result;
  const auto decide = [&] {
    const Answer answer = ask(proof, synthesis.proof_text(proof.name, nullptr), result.said);
    if (answer != Answer::kNever) return answer == Answer::kSometimes ? Verdict::kBroken : Verdict::kUndecided;
    for (const Proof::Control& control : proof.controls) {
      const Answer with_bug = ask(proof, synthesis.proof_text(proof.name, &control), result.said);
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

std::string proof_hash(const Proof& proof, const LeafSynthesis& synthesis) {
  std::string all = fmt::format("{} ", proof.name) + synthesis.proof_text(proof.name, nullptr);
  for (const Proof::Control& control : proof.controls) {
    synthesis.proof_text(proof.name, &control);
    all += fmt::format(" {} {}", control.file, control.mutant);
  }
  return fmt::format("{:016x}", XXH3_64bits(all.data(), all.size()));
}

}  // namespace feline::prove
