// SPDX-License-Identifier: Apache-2.0
// `feline prove` as a user meets it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "testbench/run_lock.h"
#include "tests/testbench/feline_program.h"

namespace feline {
namespace {

constexpr const char* kSmall = "plan.weight_row,plan.choose_probes,walk.probe_weight,filter.kernel_weight";

// What the second engine and the proofs read, in the directory's `source`.
std::filesystem::path copy_sources(const TempDir& dir) {
  for (const char* const part : {"rtl", "tables", "testbench/prove", "testbench/stability", "model"}) {
    std::filesystem::create_directories((dir / "source" / part).parent_path());
    std::filesystem::copy(std::filesystem::path(FELINE_SOURCE_DIR) / part, dir / "source" / part,
                          std::filesystem::copy_options::recursive);
  }
  return dir / "source";
}

void replace_once(const std::filesystem::path& file, const std::string& original, const std::string& replacement) {
  std::string text = read_bytes(file);
  const std::size_t at = text.find(original);
  ASSERT_NE(at, std::string::npos) << original;
  text.replace(at, original.size(), replacement);
  write_bytes(file, text);
}

TEST(prove_program, proves_small_leaves_and_checks_the_certificate) {
  const TempDir dir;
  const std::string output = " --output " + quoted_path(dir, "proof");
  const Outcome outcome = run(std::string("prove --json --leaf ") + kSmall + output);
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto json = nlohmann::json::parse(outcome.text);
  ASSERT_EQ(json["leaves"].size(), 4U);
  EXPECT_EQ(nlohmann::json::parse(read_bytes(dir / "proof" / "certificate.json")), json);
  for (const auto& leaf : json["leaves"]) {
    EXPECT_EQ(leaf["mismatches"], (nlohmann::json{{"model", 0}, {"rtl", 0}, {"netlist", 0}})) << leaf;
    EXPECT_EQ(leaf["digest"].get<std::string>().size(), 32U);
  }
  EXPECT_EQ(json["leaves"][3]["errors"][0]["quantity"], "weight of the Gaussian kernel");

  const std::string certificate = quoted_path(dir, "proof/certificate.json");
  EXPECT_EQ(run("prove --check " + certificate + " --leaf " + kSmall).code, 0);
  const Outcome missing = run("prove --check " + certificate);
  EXPECT_EQ(missing.code, 1);
  EXPECT_NE(missing.text.find("missing: footprint.table: all of it"), std::string::npos) << missing.text;
  EXPECT_EQ(missing.text.find("walk.probe_weight"), std::string::npos) << missing.text;

  // The same once more, from the journal; and from nothing, the same bytes.
  const std::string bytes = read_bytes(dir / "proof" / "certificate.json");
  const Outcome again = run(std::string("prove --leaf ") + kSmall + output + " --against " + certificate);
  EXPECT_EQ(again.code, 0) << again.text;
  EXPECT_NE(again.text.find("0 inputs by model"), std::string::npos) << again.text;
  EXPECT_EQ(run(std::string("prove --leaf ") + kSmall + " --output " + quoted_path(dir, "fresh")).code, 0);
  EXPECT_EQ(read_bytes(dir / "fresh" / "certificate.json"), bytes);
  // One leaf again: what is there of the others stays.
  EXPECT_EQ(run("prove --leaf walk.probe_weight" + output).code, 0);
  EXPECT_EQ(read_bytes(dir / "proof" / "certificate.json"), bytes);
}

TEST(prove_program, the_certificate_that_is_checked_in_is_whole) {
  const Outcome outcome =
      run(std::string("prove --check '") + FELINE_SOURCE_DIR + "/testbench/prove/certificate.json'");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("complete: "), std::string::npos) << outcome.text;
}

TEST(prove_program, a_proof_holds_and_its_bug_is_found) {
  const TempDir dir;
  const Outcome outcome = run("prove --proof bit_length,spill_stream --output " + quoted_path(dir, "proof"));
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("bit_length               proved, and its controls found"), std::string::npos)
      << outcome.text;
  const std::string certificate = quoted_path(dir, "proof/certificate.json");
  EXPECT_EQ(run("prove --proof bit_length,spill_stream --check " + certificate).code, 0);
  const Outcome missing = run("prove --proof all --check " + certificate);
  EXPECT_EQ(missing.code, 1);
  EXPECT_NE(missing.text.find("missing: proof walk_stream"), std::string::npos) << missing.text;
}

// A proof of RTL that is broken does not hold; one whose bug changes nothing shows nothing.
TEST(prove_program, a_proof_of_broken_rtl_does_not_hold) {
  const TempDir dir;
  const std::filesystem::path file = copy_sources(dir) / "rtl/feline_spill_register.sv";
  replace_once(file, "assign ready_o = !spilled_q;", "assign ready_o = !spilled_q || ready_i;");
  const Outcome outcome = run("prove --proof spill_stream --source " + quoted_path(dir, "source") + " --output " +
                              quoted_path(dir, "proof"));
  EXPECT_EQ(outcome.code, 1) << outcome.text;
  EXPECT_NE(outcome.text.find("NOT PROVED: spill_stream"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("asserted in frame"), std::string::npos) << outcome.text;
}

// Another RTL in the netlist: the leaf, the witness and the input are told.
TEST(prove_program, a_wrong_netlist_is_told) {
  const TempDir dir;
  replace_once(copy_sources(dir) / "rtl/feline_probe_weight.sv", "distance + StepWidth'(1)",
               "distance + StepWidth'(2)");
  const Outcome outcome = run("prove --leaf walk.probe_weight --source " + quoted_path(dir, "source") + " --output " +
                              quoted_path(dir, "proof"));
  EXPECT_EQ(outcome.code, 1) << outcome.text;
  for (const char* const part : {"MISMATCH in leaf walk.probe_weight", "netlist against exact", "weight_row 0x"}) {
    EXPECT_NE(outcome.text.find(part), std::string::npos) << part << " in\n" << outcome.text;
  }
  const auto json = nlohmann::json::parse(read_bytes(dir / "proof" / "certificate.json"));
  EXPECT_GT(json["leaves"][0]["mismatches"]["netlist"], 0);
  EXPECT_EQ(json["leaves"][0]["mismatches"]["rtl"], 0);
  EXPECT_EQ(run("prove --check " + quoted_path(dir, "proof/certificate.json") + " --leaf walk").code, 1);
  // It is told again, as nothing of it is in the journal.
  EXPECT_EQ(run("prove --leaf walk.probe_weight --source " + quoted_path(dir, "source") + " --output " +
                quoted_path(dir, "proof"))
                .code,
            1);
}

// What the program does not prove by itself is nobody's certificate: neither of another model, though RTL and netlist
// are alike, nor of the one that it was built from.
TEST(prove_program, a_certificate_is_of_what_the_program_was_built_from) {
  const TempDir dir;
  const std::filesystem::path source = copy_sources(dir);
  const std::string leaf = "prove --leaf filter.kernel_weight ";
  const std::string other = " --source " + quoted_path(dir, "source");
  ASSERT_EQ(run(leaf + "--output " + quoted_path(dir, "own")).code, 0);
  const std::string own_check = leaf + "--check " + quoted_path(dir, "own/certificate.json");
  replace_once(source / "model/filter.h", "// The weight of the farther", "// What weight is of the farther");
  EXPECT_EQ(run(own_check + other).code, 0);
  replace_once(source / "model/filter.h", "if (!gaussian) return fraction;", "if (!gaussian) return 0 + fraction;");
  EXPECT_EQ(run(own_check + other).code, 1);
  EXPECT_EQ(run(leaf + other + " --output " + quoted_path(dir, "proof")).code, 0);
  for (const std::string& checked : {std::string(), other}) {
    std::string check = leaf;
    check += "--check " + quoted_path(dir, "proof/certificate.json");
    check += checked;
    const Outcome outcome = run(check);
    EXPECT_EQ(outcome.code, 1) << outcome.text;
    EXPECT_NE(outcome.text.find("other sources"), std::string::npos) << outcome.text;
  }
}

// Another run would write its certificate over this one's.
TEST(prove_program, is_of_one_run_at_a_time_in_a_directory) {
  const TempDir dir;
  std::filesystem::create_directories(dir / "proof");
  const RunLock lock(dir / "proof" / "lock");
  expect_refused(dir, "prove --leaf walk --output " + quoted_path(dir, "proof"), {"proof/lock", "one run at a time"});
}

TEST(prove_program, a_digest_that_comes_out_otherwise_is_told) {
  const TempDir dir;
  ASSERT_EQ(run("prove --leaf walk.probe_weight,filter.kernel_weight --output " + quoted_path(dir, "proof")).code, 0);
  auto json = nlohmann::ordered_json::parse(read_bytes(dir / "proof" / "certificate.json"));
  json["leaves"].erase(1);
  write_bytes(dir / "other.json", json.dump());
  const Outcome outcome = run("prove --leaf walk.probe_weight,filter.kernel_weight --output " +
                              quoted_path(dir, "proof") + " --against " + quoted_path(dir, "other.json"));
  EXPECT_EQ(outcome.code, 1) << outcome.text;
  EXPECT_NE(outcome.text.find("CHANGED: leaf filter.kernel_weight: not in"), std::string::npos) << outcome.text;
  json["leaves"][0]["sources"] = "0123456789abcdef";
  json["leaves"][0]["digest"] = nullptr;
  json["leaves"][0]["digests"][0] = nullptr;
  write_bytes(dir / "other.json", json.dump());
  // As JSON, too, what differs is told, beside it.
  EXPECT_NE(run("prove --json --leaf walk.probe_weight --output " + quoted_path(dir, "proof") + " --against " +
                quoted_path(dir, "other.json"))
                .text.find("CHANGED: leaf walk.probe_weight: sources"),
            std::string::npos);
  const Outcome changed = run("prove --leaf walk.probe_weight --output " + quoted_path(dir, "proof") + " --against " +
                              quoted_path(dir, "other.json"));
  EXPECT_EQ(changed.code, 1) << changed.text;
  EXPECT_NE(changed.text.find("CHANGED: leaf walk.probe_weight: sources"), std::string::npos) << changed.text;
  EXPECT_NE(changed.text.find("CHANGED: leaf walk.probe_weight, chunk 0"), std::string::npos) << changed.text;
}

TEST(prove_program, refuses_and_says_what_is_legal) {
  const TempDir dir;
  const std::string output = " --output " + quoted_path(dir, "proof");
  expect_refused(dir, "prove --leaf moon" + output, {"--leaf", "moon", "all, a stage, or leaves"});
  expect_refused(dir, "prove --leaf walk,walk" + output, {"--leaf", "walk"});
  expect_refused(dir, "prove --proof moon" + output, {"--proof", "moon", "walk_stream"});
  for (const char* const shard : {"1", "2/2", "-1/3", "1/0", "a/b", "1/2/3"}) {
    expect_refused(dir, std::string("prove --shard=") + shard + output, {"--shard", shard, "I/N, 0 <= I < N"});
  }
  expect_refused(dir, "prove --source /nonexistent --leaf walk --output /tmp", {"/nonexistent", "--source"});
  expect_refused(dir, "prove --list --shard 0/2", {"--shard", "--list"});
  expect_refused(dir, "prove --check /nonexistent.json", {"/nonexistent.json"});
  expect_refused(dir, "prove --merge " + quoted_path(dir, "m.json"), {"--merge", "--check"});
  expect_refused(dir, "prove --output /proc/proof", {"/proc/proof"});
  expect_refused(dir, "prove --leaf walk --output /tmp", {"yosys", "Debian package yosys"}, "PATH=/nonexistent");
}

// Killed as soon as some chunks are done, and started again, in two shards: the same certificate as in one go.
TEST(prove_program_long, killed_and_resumed_it_comes_to_the_same) {
  const TempDir dir;
  const std::string leaves = "prove --leaf plan.line_fraction,plan.level_of_radius";
  ASSERT_EQ(run(leaves + " --output " + quoted_path(dir, "whole")).code, 0);
  for (const int shard : {0, 1}) {
    const std::string name = "part" + std::to_string(shard);
    const std::string journal = quoted_path(dir, name + "/journal.jsonl");
    const std::string command = leaves + " --shard " + std::to_string(shard) + "/2 --output " + quoted_path(dir, name);
    for (const int lines : {5, 20}) {
      // `wait` comes after the kill, so that the lock is free.
      run(fmt::format(
          "{} >/dev/null & child=$!; until [ \"$(wc -l < {} 2>/dev/null)\" -ge {} ] 2>/dev/null; do sleep 0.1; "
          "done; kill -KILL $child; wait $child",
          command, journal, lines));
      EXPECT_FALSE(std::filesystem::exists(dir / name / "certificate.json"));
    }
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_EQ(outcome.text.find("; 0 chunks were done before"), std::string::npos) << outcome.text;
  }
  const std::string parts =
      quoted_path(dir, "part0/certificate.json") + " " + quoted_path(dir, "part1/certificate.json");
  const Outcome merged = run(leaves + " --check " + parts + " --merge " + quoted_path(dir, "merged.json"));
  EXPECT_EQ(merged.code, 0) << merged.text;
  EXPECT_EQ(read_bytes(dir / "merged.json"), read_bytes(dir / "whole" / "certificate.json"));
}

}  // namespace
}  // namespace feline
