// SPDX-License-Identifier: Apache-2.0
// Breaks the RTL in one place at a time: each fault is caught, the stage named is the one that is broken, and the
// replay command shows it again.
#include <gtest/gtest.h>

#include "testbench/cosim/job.h"
#include "testbench/cosim/random_batches.h"
#include "tests/rtl/fault.h"
#include "tests/rtl/faulty_unit.h"

namespace feline {
namespace {

CosimJob random_job(std::uint64_t lookups) {
  constexpr std::uint64_t kBatchLookups = 256;
  CosimJob job;
  job.scene = job.mode = job.kernel = job.wrap = "random";
  job.timing = {5, 0.1, 1};
  job.command = "feline cosim --random 200000";
  job.lookups = lookups;
  job.batch_lookups = kBatchLookups;
  job.batch = [batches = std::make_shared<RandomBatches>(job.timing.seed, kBatchLookups),
               lookups](std::uint64_t number) { return batches->make(number, lookups); };
  return job;
}

std::string stage_of_message(const std::string& message) {
  const std::string start = "MISMATCH at stage ";
  if (!message.starts_with(start)) return "none: " + message;
  return message.substr(start.size(), message.find(',') - start.size());
}

// The range behind --replay.
std::optional<ReplayRange> range_of(const std::string& message) {
  const std::size_t at = message.find("--replay ");
  if (at == std::string::npos) return std::nullopt;
  ReplayRange range;
  std::size_t used = 0;
  const std::string text = message.substr(at + 9);
  range.first = range.last = std::stoull(text, &used);
  if (text[used] == ':') range.last = std::stoull(text.substr(used + 1));
  return range;
}

// One test a fault, in the suite of the stage that must be named: rtl.plan.catches_step_sign_lost.
class FaultTest : public testing::Test {
 public:
  explicit FaultTest(const Fault& fault) : fault_(fault) {}
  ~FaultTest() override { set_fault(0); }

  void TestBody() override {
    set_fault(fault_.number);
    const CosimJob job = random_job(200000);
    const CosimResult result = run_job(job, make_faulty_unit, {}, std::nullopt, false, nullptr);
    ASSERT_EQ(result.mismatches, 1U) << fault_.what << " was not caught";
    EXPECT_EQ(stage_of_message(result.message), fault_.stage) << result.message;
    const auto replay = range_of(result.message);
    ASSERT_TRUE(replay) << result.message;
    const CosimResult again = run_job(job, make_faulty_unit, {}, replay, false, nullptr);
    ASSERT_EQ(again.mismatches, 1U) << result.message;
    EXPECT_EQ(stage_of_message(again.message), fault_.stage);
  }

 private:
  Fault fault_;
};

const bool kRegistered = [] {
  for (const Fault& fault : kFaults) {
    testing::RegisterTest(fault.stage, (std::string("catches_") + fault.what).c_str(), nullptr, nullptr, __FILE__,
                          __LINE__, [fault]() -> FaultTest* { return new FaultTest(fault); });
  }
  return true;
}();

TEST(faults, there_are_enough) {
  EXPECT_TRUE(kRegistered);
  EXPECT_GE(std::size(kFaults), 20U);
}

TEST(faults, none_means_agreement) {
  set_fault(0);
  const CosimResult result = run_job(random_job(5000), make_faulty_unit, {}, std::nullopt, false, nullptr);
  EXPECT_EQ(result.mismatches, 0U) << result.message;
  EXPECT_EQ(result.lookups, 5000U);
}

}  // namespace
}  // namespace feline
